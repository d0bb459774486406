// SPDX-License-Identifier: MIT
// Assigner plugin of the HULKs (SPL, released code of 2024): the striker by message (claims.hpp), all others by number
// (dealing.hpp). It wants the sender `hulks_sender`, which says claims at once and repeats those of the striker.
//
// Which task is the striker's, a parameter names. A list of roles without that role, as one of searchers, is dealt by
// number alone. A teammate that says that it plays a task of this list which this robot does not know keeps it: then
// the two would count the tasks differently.
//
// When packets run out the team is only silent, as published: who hears no claim and sees the ball claims.
//
// Not here: the roles of penalty kicks, the five seconds for which a replacement of the keeper stays one, and that
// roles are kept during free kicks of an unknown side.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <plugins/assigners/task_order.hpp>
#include <regista/assigner.hpp>
#include <regista/host.hpp>
#include <regista/mailbox.hpp>
#include <regista/told.hpp>

#include "../negotiation/bids.hpp"
#include "../negotiation/standing_offer.hpp"
#include "claims.hpp"
#include "dealing.hpp"
#include "own_eyes.hpp"
#include "word.hpp"

namespace {

struct Hulks {
  static constexpr auto id = "hulks", version = "1.0.0",
                        summary =
                            "The striker claims its role by message with its time to the ball, the rest by number";
  static constexpr unsigned reads = REGISTA_READS_TIMES;
  static constexpr bool negotiates = true;

  hulks::Settings settings;
  std::string striker, keeper = "goalkeeper";
  static constexpr std::tuple parameters{
      regista::text("striker", &Hulks::striker,
                    "Role that is claimed by message, a list without it is dealt by number alone; empty: the most "
                    "important task that is not the keeper's"),
      regista::text("keeper", &Hulks::keeper, "Role of the lowest number; in a list without it nobody keeps the goal"),
      regista::within(
          &Hulks::settings,
          regista::real("memory", &hulks::Settings::memory, {0.1, 60.0}, "s",
                        "A robot that has not seen the ball for so long does not see it any more (assumption; the "
                        "HULKs' filter forgets a ball 0.6 s after it should have been seen and after 20 s elsewhere)")
              .tunable(),
          regista::real("trust", &hulks::Settings::trust, {0.1, 60.0}, "s",
                        "A striker that does not see the ball has lost it when no teammate has seen it for so long; "
                        "HULKs 2024: 1")
              .tunable(),
          regista::real("time_out", &hulks::Settings::time_out, {0.1, 60.0}, "s",
                        "A robot that hears no claim for so long claims when it sees the ball; HULKs 2024: 3")
              .tunable(),
          regista::real("lapse", &hulks::Settings::lapse, {0.1, 3600.0}, "s",
                        "A striker that says nothing for so long loses the role to the highest number (assumption)"))};

  static constexpr double standing = 0.5, at_once = 1.0;  // urgency: hulks_sender repeats the one and says the other

  hulks::Claims claims;
  negotiation::StandingOffer offer;
  int own = 0;
  std::vector<std::string> names;  // of roles
  std::vector<int> lists;          // the list that a role stands in, as the number of its first role
  hulks::OwnEyes eyes;
  regista::Told told;
  std::uint32_t reach = hulks::never;
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint32_t> order;
  std::vector<std::int32_t> columns;

  void setup(const regista::Environment& environment, const regista::Host& host) {
    told = regista::Told(host);
    own = environment->own_number;
    claims.reserve(static_cast<int>(environment->team_size));
    const regista::Span<regista::Role> roles = environment.roles();
    for (std::size_t i = 0; i < roles.size(); ++i) {
      names.emplace_back(roles[i].name);
      std::size_t first = 0;
      while (std::string_view(roles[first].list) != roles[i].list) ++first;
      lists.push_back(static_cast<int>(first));
    }
    bytes.reserve(hulks::word_bytes(roles.size()));
    offer.setup(host.mailbox(), hulks::word_bytes(roles.size()));
    order.reserve(roles.size());
    columns.reserve(environment->team_size);
  }
  void reset(std::uint64_t) {
    claims.forget();
    offer.forget();
    eyes.forget();
  }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    const regista::Span<std::int32_t> active = frame.world().active();
    const regista::Span<regista::Task> tasks = frame.tasks();
    assignment::by_importance(tasks, order);
    const std::int32_t keepers = column_of_role(tasks, keeper);
    const std::int32_t strikers = striker.empty() ? most_important_but(keepers) : column_of_role(tasks, striker);
    const int first = highest_that_may(utilities, active, strikers);
    decide(frame, utilities, active, strikers, first);

    columns.assign(out.size(), regista::Assignment::no_task);
    const std::int32_t taken = seat_striker(tasks, utilities, active, strikers, first);
    seat_others(frame, tasks, active);
    hulks::deal({utilities.data(), utilities.rows(), utilities.columns(), utilities.stride()},
                hulks::order_of_dealing(order, keepers == taken ? -1 : keepers, taken), columns);
    for (std::size_t row = 0; row < out.size(); ++row) out[row] = columns[row];
    say(frame, tasks, strikers);
  }

  void receive(const regista::Message& message) {
    if (const auto word = hulks::read(message.bytes(), names.size())) {
      claims.hear(message.sender(), *word, message.time_sent(), message.time_heard());
    }
  }
  void transmitted(std::uint64_t handle) {
    if (offer.gone(handle)) claims.has_told();
  }
  void dropped(std::uint64_t handle) { offer.gone(handle); }

  std::string describe(std::span<const std::uint8_t> said) const {
    const auto word = hulks::read(said, names.size());
    if (!word) return "no word of this team";
    if (!word->claims) return "has lost the ball";
    return "claims " + names[static_cast<std::size_t>(word->task)] + ", " + std::to_string(word->time) +
           " ms from the ball";
  }

 private:
  std::int32_t column_of_role(const regista::Span<regista::Task>& tasks, const std::string& name) const {
    for (std::size_t column = 0; column < tasks.size(); ++column) {
      if (names[static_cast<std::size_t>(tasks[column].id)] == name) return static_cast<std::int32_t>(column);
    }
    return -1;
  }
  std::int32_t most_important_but(std::int32_t column) const {
    for (const std::uint32_t each : order) {
      if (static_cast<std::int32_t>(each) != column) return static_cast<std::int32_t>(each);
    }
    return -1;
  }

  // As in Ready and Set, where the highest number is the striker.
  static int highest_that_may(const regista::UtilityMatrix& utilities, const regista::Span<std::int32_t>& active,
                              std::int32_t column) {
    if (column < 0) return hulks::nobody;
    for (std::size_t row = active.size(); row > 0; --row) {
      if (may(utilities, row - 1, column)) return active[row - 1];
    }
    return hulks::nobody;
  }
  static bool may(const regista::UtilityMatrix& utilities, std::size_t row, std::int32_t column) {
    return utilities(row, static_cast<std::size_t>(column)) != regista::UtilityMatrix::forbidden;
  }

  void decide(const regista::Frame& frame, const regista::UtilityMatrix& utilities,
              const regista::Span<std::int32_t>& active, std::int32_t column, int first) {
    const regista::World mine = frame.mine(), common = frame.common();
    hulks::Now now;
    now.time = frame.time();
    now.number = own;
    now.first = first;
    const std::size_t row = negotiation::row_of(active, own);
    now.playing = mine.game().phase == REGISTA_PHASE_PLAYING;
    now.takes_part = row < active.size();
    if (now.takes_part && column >= 0 && may(utilities, row, column)) {
      const double milliseconds = 1000.0 * frame.time_to_task(row, static_cast<std::size_t>(column));
      now.reach = static_cast<std::uint32_t>(std::clamp(std::round(milliseconds), 0.0, hulks::never - 1.0));
    }
    reach = now.reach;
    const auto sighting = [&](const regista::World& world) {
      return world.ball_known() ? std::optional(now.time - world.ball().age) : std::nullopt;
    };
    eyes.look(now.time, told.sees_ball(), sighting(mine), sighting(common));
    now.sees_ball = mine.ball_known() && eyes.saw_within(settings.memory, now.time);
    now.trusts_ball = now.sees_ball || (mine.ball_known() && mine.ball().age <= settings.trust);
    claims.decide(settings, now, [&](int number) { return negotiation::row_of(active, number) < active.size(); });
  }

  // Gives the striker its task, and returns the column that is gone by that, or -1. A claim of a task that is not among
  // these counts for nothing here: seat_others() looks at what its sender plays.
  std::int32_t seat_striker(const regista::Span<regista::Task>& tasks, const regista::UtilityMatrix& utilities,
                            const regista::Span<std::int32_t>& active, std::int32_t strikers, int first) {
    int number = claims.striker(own);
    std::int32_t column = strikers;
    if (number == hulks::nobody) {
      number = first;
    } else if (number != own) {
      const std::size_t claimed = negotiation::column_of(tasks, claims.claimed_task());
      column = claimed < tasks.size() ? static_cast<std::int32_t>(claimed) : -1;
    }
    const std::size_t row = negotiation::row_of(active, number);
    if (row == active.size() || column < 0) return -1;
    if (may(utilities, row, column)) {
      columns[row] = column;
      return column;
    }
    if (number == own) return -1;
    columns[row] = regista::Assignment::unknown_task;  // it does what it must not, as far as this robot knows
    return column;
  }

  void seat_others(const regista::Frame& frame, const regista::Span<regista::Task>& tasks,
                   const regista::Span<std::int32_t>& active) {
    if (tasks.empty()) return;
    const int list = lists[static_cast<std::size_t>(tasks[0].id)];
    for (std::size_t row = 0; row < active.size(); ++row) {
      const regista::Robot& robot = frame.world().robot(active[row]);
      if (robot.number == own || columns[row] != regista::Assignment::no_task) continue;
      const bool is_of_list = robot.role >= 0 && static_cast<std::size_t>(robot.role) < lists.size() &&
                              lists[static_cast<std::size_t>(robot.role)] == list;
      if (!is_of_list || robot.age > settings.lapse) continue;
      if (negotiation::column_of(tasks, robot.role) == tasks.size()) {
        columns[row] = regista::Assignment::unknown_task;
      }
    }
  }

  void say(const regista::Frame& frame, const regista::Span<regista::Task>& tasks, std::int32_t strikers) {
    hulks::Word word;
    word.claims = claims.part() == hulks::Part::striker && strikers >= 0;
    if (!word.claims && !(claims.part() == hulks::Part::loser && claims.has_news())) return offer.withdraw();
    if (word.claims) {
      word.time = reach;
      word.task = tasks[static_cast<std::size_t>(strikers)].id;
    }
    hulks::write(word, names.size(), bytes);
    offer.say(bytes, frame.time(), claims.has_news() ? at_once : standing);
  }
};

}  // namespace

REGISTA_PLUGIN(Hulks, regista::assigner)
