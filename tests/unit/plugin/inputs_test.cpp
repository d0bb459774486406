// SPDX-License-Identifier: MIT
// A plugin that writes to what it was given to read, part by part.
#include "plugin/call_inputs.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "plugin/kinds.hpp"
#include "plugin/predictor.hpp"
#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

template <class T>
T& writable(const T* input) {
  return *const_cast<T*>(input);
}
template <class T>
T& element(const regista_span& span) {
  return writable(static_cast<const T*>(span.data));
}

// Two worlds with something in every part.
struct FullScene {
  struct World {
    std::vector<regista_robot> robots = std::vector<regista_robot>(5);
    std::vector<regista_opponent> opponents = std::vector<regista_opponent>(2);
    std::vector<std::int32_t> active{1, 2, 3, 4, 5};
    regista_game game{};
    regista_ball ball{};
    regista_world raw{};
    World() {
      game.size = sizeof game;
      ball.size = sizeof ball;
      raw.size = sizeof raw;
      raw.game = &game;
      raw.ball = &ball;
      raw.robots = {robots.data(), 5, sizeof(regista_robot)};
      raw.opponents = {opponents.data(), 2, sizeof(regista_opponent)};
      raw.active = {active.data(), 5, sizeof(std::int32_t)};
    }
  };
  World mine, common;
  std::vector<regista_task> tasks = std::vector<regista_task>(7);
  std::vector<regista_waypoint> waypoints = std::vector<regista_waypoint>(3);
  std::vector<regista_edge> edges = std::vector<regista_edge>(2);
  std::vector<std::int32_t> previous = std::vector<std::int32_t>(5);
  std::vector<double> times = std::vector<double>(5 * 7);
  regista_frame frame{};
  FullScene() {
    frame.size = sizeof frame;
    frame.mine = &mine.raw;
    frame.common = &common.raw;
    frame.tasks = {tasks.data(), 7, sizeof(regista_task)};
    frame.waypoints = {waypoints.data(), 3, sizeof(regista_waypoint)};
    frame.edges = {edges.data(), 2, sizeof(regista_edge)};
    frame.previous = {previous.data(), 5, sizeof(std::int32_t)};
    frame.time_to_task = {times.data(), 5, 7, 7, 0};
  }
};

class InputsTest : public PuppetTest {
 protected:
  static std::shared_ptr<Instance> instance(bool compares, const regista_descriptor& descriptor, unsigned subject = 0) {
    static const Caller watched{"paper", 3, 417, {nullptr, 0, Inspection::always, nullptr, true}},
        unwatched{"paper", 3, 417, {nullptr, 0}};
    const Parameters parameters = resolve(descriptor, use(descriptor.id));
    auto out = std::make_shared<Instance>(Found{"puppet.so", &descriptor}, parameters, environment(subject), nullptr,
                                          compares ? &watched : &unwatched);
    out->reset(1);
    return out;
  }
  static std::shared_ptr<Instance> puppet(bool compares = true, unsigned subject = 0) {
    static const regista_descriptor descriptor = Puppet::descriptor();
    return instance(compares, descriptor, subject);
  }
  static std::string changed(const std::string& call, const std::string& part) {
    return Puppet::failure(call + ": changed its input: " + part);
  }

  // What a context that does this to its frame ends in.
  static std::string held(void (*change)(const regista_frame*), bool compares = true) {
    change_ = change;
    Puppet::context.holds = [](void*, const regista_frame* frame, std::int32_t*, regista_error*) {
      change_(frame);
      return Puppet::ok;
    };
    FullScene scene;
    return message_of([&] { Context(puppet(compares)).holds(scene.frame); });
  }
  static inline void (*change_)(const regista_frame*);
};

TEST_F(InputsTest, NamesEachPartOfTheFrame) {
  using F = const regista_frame*;
  EXPECT_EQ(held([](F) {}), "");
  EXPECT_EQ(held([](F f) { writable(f).time = 1.0; }), changed("holds", "frame"));
  EXPECT_EQ(held([](F f) { writable(f).mine = nullptr; }), changed("holds", "frame"));  // and is not followed
  EXPECT_EQ(held([](F f) { writable(f->mine->ball).age = 1.0; }), changed("holds", "frame.mine"));
  EXPECT_EQ(held([](F f) { writable(f->mine).robots.data = nullptr; }), changed("holds", "frame.mine"));
  EXPECT_EQ(held([](F f) { (&element<regista_robot>(f->mine->robots))[4].pose[2] = 1.0; }),
            changed("holds", "frame.mine.robots"));
  EXPECT_EQ(held([](F f) { (&element<regista_opponent>(f->mine->opponents))[1].age = 1.0; }),
            changed("holds", "frame.mine.opponents"));
  EXPECT_EQ(held([](F f) { element<std::int32_t>(f->mine->active) = 9; }), changed("holds", "frame.mine.active"));
  EXPECT_EQ(held([](F f) { writable(f->common->game).half = 2; }), changed("holds", "frame.common"));
  EXPECT_EQ(held([](F f) { element<regista_robot>(f->common->robots).number = 8; }),
            changed("holds", "frame.common.robots"));
  EXPECT_EQ(held([](F f) { element<regista_opponent>(f->common->opponents).label = 8; }),
            changed("holds", "frame.common.opponents"));
  EXPECT_EQ(held([](F f) { element<std::int32_t>(f->common->active) = 9; }), changed("holds", "frame.common.active"));
  EXPECT_EQ(held([](F f) { (&element<regista_task>(f->tasks))[6].after[1] = 1.0; }), changed("holds", "frame.tasks"));
  EXPECT_EQ(held([](F f) { element<regista_waypoint>(f->waypoints).x = 1.0; }), changed("holds", "frame.waypoints"));
  EXPECT_EQ(held([](F f) { element<regista_edge>(f->edges).to = 2; }), changed("holds", "frame.edges"));
  EXPECT_EQ(held([](F f) { element<std::int32_t>(f->previous) = 2; }), changed("holds", "frame.previous"));
  EXPECT_EQ(held([](F f) { const_cast<double&>(f->time_to_task.values[34]) = 1.0; }),
            changed("holds", "frame.time_to_task"));
}

TEST_F(InputsTest, AreComparedOnlyWhereThatIsAskedFor) {
  EXPECT_EQ(held([](const regista_frame* f) { writable(f).time = 1.0; }, false), "");
}

TEST_F(InputsTest, OfAPredictor) {
  Puppet::predictor.predict = [](void*, double, const regista_motion* motion, const regista_frame* last,
                                 regista_error*) {
    if (motion != nullptr) writable(motion).x = 3.0;
    if (last != nullptr) element<std::int32_t>(last->previous) = 3;
    return Puppet::ok;
  };
  Puppet::predictor.correct = [](void*, regista_span measured, const regista_visible_area* area, regista_error*) {
    if (measured.count > 0) {
      element<regista_measurement>(measured).kind = 3;
    } else {
      writable(area).range_ball = 3.0;
    }
    return Puppet::ok;
  };
  Puppet::predictor.absorb = [](void*, regista_span tracks, double, regista_error*) {
    element<regista_track>(tracks).x = 3.0;
    return Puppet::ok;
  };
  Predictor predictor(puppet(true, REGISTA_SUBJECT_BALL));
  FullScene scene;
  const regista_motion motion{};
  const regista_visible_area area{};
  const std::array<regista_measurement, 2> measured{};
  const std::array<regista_track, 2> told{};
  EXPECT_EQ(message_of([&] { predictor.predict(0.1, nullptr, nullptr); }), "");
  EXPECT_EQ(message_of([&] { predictor.predict(0.1, &motion, nullptr); }), changed("predict", "motion"));
  EXPECT_EQ(message_of([&] { predictor.predict(0.1, nullptr, &scene.frame); }), changed("predict", "last.previous"));
  EXPECT_EQ(message_of([&] { predictor.correct(measured, area); }), changed("correct", "measurements"));
  EXPECT_EQ(message_of([&] { predictor.correct({}, area); }), changed("correct", "area"));
  EXPECT_EQ(message_of([&] { predictor.absorb(told, 0.1); }), changed("absorb", "tracks"));
}

TEST_F(InputsTest, OfUtilityAndAssigner) {
  FullScene scene;
  Matrix matrix(5, 7, 1.0);
  std::array<std::int32_t, 5> out{};
  Puppet::utility.score = [](void*, const regista_frame*, const regista_matrix_room* to, regista_error*) {
    to->values[0] = 2.0;  // that is its answer
    writable(to).stride = 1;
    return Puppet::ok;
  };
  EXPECT_EQ(message_of([&] { Utility(puppet()).score(scene.frame, 5, 7); }), changed("score", "out"));
  Puppet::assigner.assign = [](void*, const regista_frame*, const regista_matrix* utilities, std::int32_t*,
                               regista_error*) {
    const_cast<double&>(utilities->values[3]) = 7.0;
    return Puppet::ok;
  };
  EXPECT_EQ(message_of([&] { Assigner(puppet()).assign(scene.frame, matrix.raw, out); }),
            changed("assign", "utilities.values"));
}

TEST_F(InputsTest, OfASenderAndAMailbox) {
  FullScene scene;
  static int which;
  Puppet::sender.decide = [](void*, const regista_frame*, regista_span events, regista_span offers,
                             const regista_budget* budget, regista_send*, regista_error*) {
    if (which == 0) element<regista_event>(events).value = 1.0;
    if (which == 1) element<regista_offer>(offers).bytes = 1;
    if (which == 2) writable(budget).packets_left = 1;
    return Puppet::ok;
  };
  const std::array<const char*, 3> parts{"events", "offers", "budget"};
  for (which = 0; which < 3; ++which) {
    const std::array<regista_event, 1> events{};
    const std::array<regista_offer, 1> offers{};
    const regista_budget budget{};
    EXPECT_EQ(message_of([&] { Sender(puppet()).decide(scene.frame, events, offers, budget); }),
              changed("decide", parts[static_cast<std::size_t>(which)]));
  }
  Puppet::mailbox.receive = [](void*, const regista_message* message, regista_error*) {
    writable(message->bytes) = 9;
    return Puppet::ok;
  };
  const std::array<std::uint8_t, 6> bytes{};
  const regista_message message{2, REGISTA_MEDIUM_RADIO, 1.0, 1.5, bytes.data(), 6, 0};
  EXPECT_EQ(message_of([&] { Mailbox::of(puppet())->receive(message); }), changed("receive", "message.bytes"));
}

TEST_F(InputsTest, OfCreate) {
  static regista_descriptor descriptor;
  descriptor = Puppet::descriptor();
  descriptor.create = [](const regista_environment* environment, const regista_host*, regista_span,
                         regista_error*) -> void* {
    writable(environment).goal_width = 9.0;
    return &descriptor;
  };
  EXPECT_EQ(message_of([] { instance(true, descriptor); }), changed("create", "environment"));
  EXPECT_EQ(message_of([] { instance(false, descriptor); }), "");
}

TEST_F(InputsTest, OfCreatesValues) {
  static const regista_parameter speed{
      sizeof(regista_parameter), REGISTA_TYPE_REAL, "speed", "m/s", "How fast", 0.0, 1.0, 0.5, nullptr, nullptr, 0, 0};
  static regista_descriptor descriptor;
  descriptor = Puppet::descriptor();
  descriptor.parameter_count = 1;
  descriptor.parameters = &speed;
  descriptor.create = [](const regista_environment*, const regista_host*, regista_span values,
                         regista_error*) -> void* {
    EXPECT_EQ(values.count, 1u);
    EXPECT_EQ(values.stride, sizeof(regista_value));
    element<regista_value>(values).number = 0.75;
    return &descriptor;
  };
  EXPECT_NE(message_of([] { instance(true, descriptor); }), "");
}

TEST(Inputs, ReachRolesAndTheirNames) {
  std::string name = "striker", list = "playing";
  std::array<regista_role, 2> roles{{{name.c_str(), list.c_str(), 0, 0}, {name.c_str(), list.c_str(), 1, 0}}};
  std::array<regista_landmark, 2> landmarks{};
  regista_environment all = environment();
  all.roles = {roles.data(), 2, sizeof(regista_role)};
  all.landmarks = {landmarks.data(), 2, sizeof(regista_landmark)};
  Inputs inputs;
  inputs.add("environment", &all);
  EXPECT_EQ(inputs.changed(), "");
  name[0] = 'S';
  EXPECT_EQ(inputs.changed(), "environment.roles.name");
  name[0] = 's';
  list[0] = 'P';
  EXPECT_EQ(inputs.changed(), "environment.roles.list");
  landmarks[1].y = 1.0;
  EXPECT_EQ(inputs.changed(), "environment.landmarks");
}

}  // namespace
}  // namespace regista::plugin::test
