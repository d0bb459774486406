// SPDX-License-Identifier: MIT
// Utilities, contexts and senders that break one promise each.
#include <array>
#include <limits>
#include <stdexcept>

#include "bad.hpp"

namespace {

using regista::Frame;
using regista::Utilities;

struct NotANumber : bad::Described {
  static constexpr auto id = "not_a_number";
  void score(const Frame& frame, Utilities out) {
    const double d = frame.world().ball().position[0];
    out(0, 0) = (d - d) / (d - d);
  }
};
struct Infinite : bad::Described {
  static constexpr auto id = "infinite";
  void score(const Frame&, Utilities out) { out(out.rows() - 1, 0) = std::numeric_limits<double>::infinity(); }
};
struct Negative : bad::Described {
  static constexpr auto id = "negative";
  void score(const Frame&, Utilities out) { out(0, out.columns() - 1) = -1e-12; }
};
// Believes that rows follow each other without a gap.
struct NoGap : bad::Described {
  static constexpr auto id = "no_gap";
  void score(const Frame&, Utilities out) {
    for (std::size_t k = 0; k < out.rows() * out.columns(); ++k) out.data()[k] = static_cast<double>(k);
  }
};
struct StepsBySize : bad::Described {
  static constexpr auto id = "steps_by_size";
  void score(const Frame& frame, Utilities out) {
    const regista_span& span = frame.raw().tasks;
    const auto* tasks = static_cast<const regista_task*>(span.data);
    for (std::size_t j = 0; j < out.columns(); ++j) out(0, j) = tasks[j].priority >= 0 ? tasks[j].priority : 1.0;
  }
};
struct RefusesLargerFrames : bad::Described {
  static constexpr auto id = "refuses_larger_frames";
  void score(const Frame& frame, Utilities) {
    if (frame.raw().size != sizeof(regista_frame)) throw std::runtime_error("a frame of another size");
  }
};
struct KeepsTheEnvironment : bad::Described {
  static constexpr auto id = "keeps_the_environment";
  const regista_environment* kept = nullptr;
  void setup(const regista::Environment& environment) { kept = &environment.raw(); }
  void score(const Frame&, Utilities out) { out(0, 0) = kept->field_length; }
};
// Values of parameters may be longer than it knows.
struct StepsByValueSize : bad::Described {
  static constexpr auto id = "steps_by_value_size";
  double first = 1.0, second = 2.0;
  static constexpr std::tuple parameters{
      regista::real("first", &StepsByValueSize::first, {0.0, 10.0}, "1", "One number"),
      regista::real("second", &StepsByValueSize::second, {0.0, 10.0}, "1", "Another")};
  void score(const Frame&, Utilities out) { out(0, 0) = first + second; }

  // The usual descriptor, but for the values.
  static const regista_descriptor* descriptor() {
    static const regista_descriptor built = [] {
      regista_descriptor d = *regista::Plugin<StepsByValueSize, regista::utility>::descriptor();
      d.create = [](const regista_environment*, const regista_host*, regista_span values, regista_error*) -> void* {
        const auto* const array = static_cast<const regista_value*>(values.data);
        auto* const out = new StepsByValueSize;
        out->first = array[0].number;
        out->second = array[1].number;
        return out;
      };
      return d;
    }();
    return &built;
  }
};
struct FirstOpponentCounts : bad::Described {
  static constexpr auto id = "first_opponent_counts";
  void score(const Frame& frame, Utilities out) {
    const auto opponents = frame.world().opponents();
    if (!opponents.empty()) out(0, 0) = 10.0 + opponents[0].weight + opponents[0].age;
  }
};

struct AnswersTwo : bad::Described {
  static constexpr auto id = "answers_two";
  static std::int32_t call(void*, const regista_frame*, std::int32_t* out, regista_error*) {
    return *out = 2, REGISTA_OK;
  }
};
struct AnswersNothing : bad::Described {
  static constexpr auto id = "answers_nothing";
  static std::int32_t call(void*, const regista_frame*, std::int32_t*, regista_error*) { return REGISTA_OK; }
};
struct Remembers : bad::Described {
  static constexpr auto id = "remembers";
  bool seen = false;
  bool holds(const Frame& frame) { return seen = seen || !frame.world().ball_known(); }
};
struct ScribblesWorld : bad::Described {
  static constexpr auto id = "scribbles_world";
  bool holds(const Frame& frame) {
    const_cast<regista::Game&>(frame.mine().game()).own_score = 10;
    return false;
  }
};

struct RefusesLargerGames : bad::Described {
  static constexpr auto id = "refuses_larger_games";
  bool holds(const Frame& frame) {
    if (frame.mine().game().size != sizeof(regista_game)) throw std::runtime_error("a game of another size");
    return true;
  }
};
struct RefusesLargerBalls : bad::Described {
  static constexpr auto id = "refuses_larger_balls";
  bool holds(const Frame& frame) {
    if (frame.common().ball().size != sizeof(regista_ball)) throw std::runtime_error("a ball of another size");
    return true;
  }
};

template <class Fill>
std::int32_t send(regista_send* out, Fill fill) {
  out->send = 1;
  out->reason = REGISTA_EVENT_PERIOD;
  fill();
  return REGISTA_OK;
}
struct SendsTwo : bad::Described {
  static constexpr auto id = "sends_two";
  static std::int32_t call(void*, const regista_frame*, regista_span, regista_span, const regista_budget*,
                           regista_send* out, regista_error*) {
    return send(out, [&] { out->send = 2; });
  }
};
struct NoSuchReason : bad::Described {
  static constexpr auto id = "no_such_reason";
  std::optional<int> decide(const Frame&, const regista::SendQuery&, regista::Grants) { return REGISTA_EVENT_COUNT; }
};
struct NoSuchOwnReason : bad::Described {
  static constexpr auto id = "no_such_own_reason";
  static constexpr std::array<const char*, 1> reasons{"lost_bid"};
  std::optional<int> decide(const Frame&, const regista::SendQuery&, regista::Grants) { return regista::own_reason(1); }
};
struct GrantsTheUnoffered : bad::Described {
  static constexpr auto id = "grants_the_unoffered";
  std::optional<int> decide(const Frame&, const regista::SendQuery& query, regista::Grants out) {
    if (query.offers.empty()) return std::nullopt;
    regista::Offer offer = query.offers[0];
    offer.handle += 1;
    out.grant(offer);
    return REGISTA_EVENT_OFFER;
  }
};
struct GrantsTwice : bad::Described {
  static constexpr auto id = "grants_twice";
  std::optional<int> decide(const Frame&, const regista::SendQuery& query, regista::Grants out) {
    for (std::size_t k = 0; k < query.offers.size(); ++k) out.grant(query.offers[0]);
    return REGISTA_EVENT_OFFER;
  }
};
struct GrantsTooMany : bad::Described {
  static constexpr auto id = "grants_too_many";
  static std::int32_t call(void*, const regista_frame*, regista_span, regista_span offers, const regista_budget*,
                           regista_send* out, regista_error*) {
    return send(out, [&] { out->granted_count = offers.count + 1; });
  }
};
struct GrantsPastTheEnd : bad::Described {
  static constexpr auto id = "grants_past_the_end";
  static std::int32_t call(void*, const regista_frame*, regista_span, regista_span offers, const regista_budget*,
                           regista_send* out, regista_error*) {
    return send(out, [&] { out->granted[offers.count] = 1; });
  }
};

}  // namespace

REGISTA_PLUGINS(regista::Plugin<NotANumber, regista::utility>, regista::Plugin<Infinite, regista::utility>,
                regista::Plugin<Negative, regista::utility>, regista::Plugin<NoGap, regista::utility>,
                regista::Plugin<StepsBySize, regista::utility>, regista::Plugin<RefusesLargerFrames, regista::utility>,
                regista::Plugin<KeepsTheEnvironment, regista::utility>, StepsByValueSize,
                regista::Plugin<RefusesLargerGames, regista::context>,
                regista::Plugin<RefusesLargerBalls, regista::context>,
                regista::Plugin<NoSuchOwnReason, regista::sender>,
                regista::Plugin<FirstOpponentCounts, regista::utility>, regista::Plugin<AnswersTwo, bad::bare_context>,
                regista::Plugin<AnswersNothing, bad::bare_context>, regista::Plugin<Remembers, regista::context>,
                regista::Plugin<ScribblesWorld, regista::context>, regista::Plugin<SendsTwo, bad::bare_sender>,
                regista::Plugin<NoSuchReason, regista::sender>, regista::Plugin<GrantsTheUnoffered, regista::sender>,
                regista::Plugin<GrantsTwice, regista::sender>, regista::Plugin<GrantsTooMany, bad::bare_sender>,
                regista::Plugin<GrantsPastTheEnd, bad::bare_sender>)
