// SPDX-License-Identifier: MIT
// Every buffer that a plugin writes to, written past its end and before its beginning by so many bytes.
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "plugin/kinds.hpp"
#include "plugin/predictor.hpp"
#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

// What to write where: `bytes` behind the end of a buffer, or before its beginning.
int bytes;
bool below;

void overflow(void* buffer, std::size_t size) {
  char* const begin = static_cast<char*>(buffer);
  std::memset(below ? begin - bytes : begin + size, 0x5a, static_cast<std::size_t>(bytes));
}

void overflow(const regista_room& room) { overflow(room.data, std::size_t{room.capacity} * room.stride); }

class OverflowTest : public PuppetTest {
 protected:
  static constexpr std::uint32_t rows = 5, columns = 7;

  // `run` leads to one overflow of `what` in `call`.
  template <class Run>
  static void expect(const std::string& call, const std::string& what, Run run) {
    for (const bool strict : {false, true}) {
      Puppet::looks_closely = strict;
      for (const int size : {4, 8, 60, 256}) {
        for (const bool before : {false, true}) {
          bytes = size;
          below = before;
          EXPECT_EQ(message_of(run),
                    Puppet::failure(call + ": wrote " + (before ? "before the beginning" : "past the end") +
                                    " of its answer: " + what))
              << size << " bytes, looked at " << (strict ? "closely" : "as usual");
        }
      }
    }
  }
  static void holds() { Context(Puppet::instance()).holds(Scene().frame); }
  static void place() {
    Placement out;
    Positioner(Puppet::instance()).place(Scene().frame, out);
  }
  static void tracks() { Predictor(Puppet::instance(REGISTA_SUBJECT_BALL)).tracks(); }
  static void assign() {
    Matrix utilities(rows, columns, 1.0);
    std::array<std::int32_t, rows> out{};
    Assigner(Puppet::instance()).assign(Scene().frame, utilities.raw, out);
  }
  static void decide() {
    const regista_budget budget{};
    const std::array<regista_offer, 3> offers{};
    Sender(Puppet::instance()).decide(Scene().frame, {}, offers, budget);
  }
};

TEST_F(OverflowTest, OfAnAssignersColumns) {
  Puppet::assigner.assign = [](void*, const regista_frame*, const regista_matrix*, std::int32_t* out, regista_error*) {
    overflow(out, rows * sizeof *out);
    return Puppet::ok;
  };
  expect("assign", "columns", assign);
}

TEST_F(OverflowTest, OfAUtilitysMatrix) {
  Puppet::utility.score = [](void*, const regista_frame*, const regista_matrix_room* out, regista_error*) {
    overflow(out->values, std::size_t{out->rows} * out->columns * sizeof(double));
    return Puppet::ok;
  };
  expect("score", "utilities", [] { Utility(Puppet::instance()).score(Scene().frame, rows, columns); });
}

TEST_F(OverflowTest, OfAPredictorsTracks) {
  Puppet::predictor.tracks = [](void*, regista_room* out, regista_error*) {
    overflow(*out);
    return Puppet::ok;
  };
  expect("tracks", "tracks", tracks);
  Puppet::predictor.tracks = [](void*, regista_room* out, regista_error*) {
    overflow(out, sizeof *out);
    return Puppet::ok;
  };
  expect("tracks", "number of tracks", tracks);
}

TEST_F(OverflowTest, OfAContextsAnswer) {
  Puppet::context.holds = [](void*, const regista_frame*, std::int32_t* out, regista_error*) {
    overflow(out, sizeof *out);
    return Puppet::ok;
  };
  expect("holds", "whether it holds", holds);
}

TEST_F(OverflowTest, OfEachPartOfAPlacement) {
  using Place = decltype(regista_positioner::place);
  const auto each = [](const char* what, Place call) {
    Puppet::positioner.place = call;
    expect("place", what, place);
  };
  each("points", [](void*, const regista_frame*, regista_placement* out, regista_error*) {
    overflow(out->points);
    return Puppet::ok;
  });
  each("edges", [](void*, const regista_frame*, regista_placement* out, regista_error*) {
    overflow(out->edges);
    return Puppet::ok;
  });
  each("cells", [](void*, const regista_frame*, regista_placement* out, regista_error*) {
    overflow(out->cells);
    return Puppet::ok;
  });
  each("vertices", [](void*, const regista_frame*, regista_placement* out, regista_error*) {
    overflow(out->vertices);
    return Puppet::ok;
  });
  each("the placement itself", [](void*, const regista_frame*, regista_placement* out, regista_error*) {
    overflow(out, sizeof *out);
    return Puppet::ok;
  });
}

TEST_F(OverflowTest, OfASendersAnswer) {
  Puppet::sender.decide = [](void*, const regista_frame*, regista_span, regista_span, const regista_budget*,
                             regista_send* out, regista_error*) {
    overflow(out, sizeof *out);
    return Puppet::ok;
  };
  expect("decide", "whether to send", decide);
  Puppet::sender.decide = [](void*, const regista_frame*, regista_span, regista_span offers, const regista_budget*,
                             regista_send* out, regista_error*) {
    overflow(out->granted, offers.count * sizeof *out->granted);
    return Puppet::ok;
  };
  expect("decide", "granted handles", decide);
}

TEST_F(OverflowTest, OfTheErrorsTextInAnyCall) {
  const auto write = [](regista_error* error) { overflow(error, sizeof *error); };
  static const auto wrote = write;
  const std::string what = "the error's text";
  Puppet::context.holds = [](void*, const regista_frame*, std::int32_t*, regista_error* error) {
    wrote(error);
    return Puppet::ok;
  };
  expect("holds", what, holds);
  Puppet::context.holds = [](void*, const regista_frame*, std::int32_t*, regista_error* error) -> std::int32_t {
    std::memset(error->text, 'a', sizeof error->text);
    wrote(error);
    return REGISTA_FAILED;
  };
  expect("holds", what, holds);
  Puppet::predictor.predict = [](void*, double, const regista_motion*, const regista_frame*, regista_error* error) {
    wrote(error);
    return Puppet::ok;
  };
  expect("predict", what, [] { Predictor(Puppet::instance(REGISTA_SUBJECT_BALL)).predict(0.1, nullptr, nullptr); });
  Puppet::mailbox.receive = [](void*, const regista_message*, regista_error* error) {
    wrote(error);
    return Puppet::ok;
  };
  expect("receive", what, [] { Mailbox::of(Puppet::instance())->receive({}); });

  static regista_descriptor descriptor;
  const auto instance = [] { instance_of({"puppet.so", &descriptor}); };
  descriptor = Puppet::descriptor();
  descriptor.reset = [](void*, std::uint64_t, regista_error* error) {
    wrote(error);
    return Puppet::ok;
  };
  expect("reset", what, instance);
  descriptor = Puppet::descriptor();
  descriptor.create = [](const regista_environment*, const regista_host*, regista_span, regista_error* error) -> void* {
    wrote(error);
    return nullptr;
  };
  expect("create", what, instance);
}

// Pointers and capacities of the struct are the plugin's to spoil; the answer is read where it was to be written.
TEST_F(OverflowTest, SpoiltPointersAreNotFollowed) {
  Puppet::positioner.place = [](void*, const regista_frame*, regista_placement* out, regista_error*) {
    *static_cast<regista_waypoint*>(out->points.data) = {1.0, 2.0, 1.0, -1, 0};
    out->points = {nullptr, 0, 1, 1, 7};
    out->vertices.data = reinterpret_cast<void*>(8);
    out->vertices.capacity = out->vertices.stride = 0;
    return Puppet::ok;
  };
  Placement placement;
  Positioner(Puppet::instance()).place(Scene().frame, placement);
  ASSERT_EQ(placement.points.size(), 1u);
  EXPECT_EQ(placement.points[0].y, 2.0);

  Puppet::predictor.tracks = [](void*, regista_room* out, regista_error*) {
    regista_track& track = *static_cast<regista_track*>(out->data);
    track = {};
    track.weight = 0.25;
    *out = {nullptr, 0, 1, 1, 7};
    return Puppet::ok;
  };
  Predictor predictor(Puppet::instance(REGISTA_SUBJECT_BALL));
  const std::span<const regista_track> seen = predictor.tracks();
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_EQ(seen[0].weight, 0.25);

  static std::uint64_t elsewhere[1];
  Puppet::sender.decide = [](void*, const regista_frame*, regista_span, regista_span, const regista_budget*,
                             regista_send* out, regista_error*) {
    out->granted = elsewhere;
    return Puppet::ok;
  };
  EXPECT_EQ(message_of(decide), "");
}

// Where the edge of the pattern is over, only a close look finds it.
TEST_F(OverflowTest, BehindTheEdge) {
  Puppet::context.holds = [](void*, const regista_frame*, std::int32_t* out, regista_error*) {
    out[5] = 7;
    return Puppet::ok;
  };
  EXPECT_EQ(message_of(holds), Puppet::failure("holds: wrote past the end of its answer: whether it holds"));
}

// Among many calls of several plugins that share their rooms, whoever wrote pays, at once.
TEST_F(OverflowTest, TheNextOneDoesNotPay) {
  static int when;
  static AnswerBuffers rooms;
  Caller caller{"paper", 3, 0, {}, &rooms};
  static regista_descriptor innocent, guilty;
  innocent = guilty = Puppet::descriptor();
  innocent.id = "innocent";
  guilty.id = "guilty";
  static int calls;
  bytes = 4;
  below = false;
  for (when = 1; when < 200; when += 13) {
    calls = 0;
    Puppet::context.holds = [](void*, const regista_frame*, std::int32_t* out, regista_error*) {
      if (++calls == when * 2) overflow(out, sizeof *out);
      return Puppet::ok;
    };
    const auto context = [&](const regista_descriptor& of) {
      return Context(
          std::make_shared<Instance>(Found{"x.so", &of}, resolve(of, use("puppet")), environment(), nullptr, &caller));
    };
    Context first = context(innocent), second = context(guilty);
    std::string message;
    for (caller.tick = 1; message.empty() && caller.tick < 300; ++caller.tick) {
      message = message_of([&] {
        caller.begin_decision();
        first.holds(Scene().frame);
        second.holds(Scene().frame);
      });
    }
    EXPECT_EQ(message, "plugin guilty (x.so) of team paper, robot 3, tick " + std::to_string(when) +
                           ": holds: wrote past the end of its answer: whether it holds");
    rooms.holds.mend();
  }
}

}  // namespace
}  // namespace regista::plugin::test
