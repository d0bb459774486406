// SPDX-License-Identifier: MIT
// The situations, group by group.
#include <regista/testkit/scenes.hpp>

#include <algorithm>
#include <string>
#include <utility>

#include <regista/testkit/dice.hpp>
#include <regista/testkit/frame_builder.hpp>

namespace regista::testkit {

namespace {

class SceneRow {
 public:
  explicit SceneRow(int team_size) : size_(team_size), own_(own_number(team_size)) {}

  std::vector<Scene> take() { return std::move(scenes_); }

  void add(std::string name, FrameBuilder scene) {
    const auto tick = static_cast<std::uint64_t>(scenes_.size());
    scenes_.push_back(scene.name(std::to_string(size_) + " robots: " + name)
                          .tick(tick)
                          .time(0.1 * static_cast<double>(tick))
                          .build());
  }

  FrameBuilder empty() const { return FrameBuilder{}.team_size(size_).own(own_); }

  // Robots where `place` puts them.
  template <class Place>
  FrameBuilder robots(FrameBuilder scene, const Place& place) const {
    for (int n = 1; n <= size_; ++n) {
      const auto [x, y] = place(n);
      scene.robot(n).at(x, y).heading(0.5 * n - 1.5);
    }
    return scene;
  }
  FrameBuilder spread() const {
    return robots(empty(),
                  [](int n) { return std::pair(-4.0 + 0.6 * n, (n % 2 == 0 ? 1.0 : -1.0) * (0.3 + 0.2 * n)); });
  }
  static FrameBuilder tasks(FrameBuilder scene, int count) {
    for (int j = 0; j < count; ++j) {
      scene.task(j).at(-3.5 + 0.7 * j, 0.8 * ((j % 3) - 1)).heading(0.3 * j - 1.0);
      if (j == 0) scene.required().only_for(1);
      if (j == 1) scene.required();
    }
    return scene;
  }
  static FrameBuilder opponents(FrameBuilder scene, int count) {
    for (int k = 0; k < count; ++k) {
      scene.opponent(3.8 - 0.7 * k, 2.0 - 0.37 * ((k * 5) % 11)).velocity(-0.1, 0.02 * k).age(0.3 * k);
    }
    return scene;
  }
  static FrameBuilder waypoints(FrameBuilder scene) {
    return scene.waypoint(1, 2)
        .waypoint(2, -1, 0.4)
        .waypoint(-1.5, 0.5, 0.0)
        .waypoint(2, -1, 0.7, 0, 1)
        .edge(0, 1)
        .edge(1, 2);
  }
  FrameBuilder usual() const { return waypoints(opponents(tasks(spread(), size_), 5)).ball(0.5, 0.3); }

  int size() const { return size_; }

 private:
  int size_, own_;
  std::vector<Scene> scenes_;
};

void add_formations(SceneRow& c) {
  c.add("usual", c.usual());
  c.add("none active", SceneRow::tasks(c.empty(), 4).ball(0, 0));
  c.add("nothing at all", c.empty().no_ball());
  c.add("one robot", SceneRow::tasks(c.empty().robot(c.size()).at(-1, 1), 3).ball(1, 0));
  c.add("the own robot alone", SceneRow::opponents(SceneRow::tasks(c.empty().robot(own_number(c.size())), 3), 3));
  const auto at_centre = [](int) { return std::pair(0.0, 0.0); };
  const auto in_line = [](int n) { return std::pair(-4.0 + n, 0.0); };
  c.add("all robots at one place", SceneRow::tasks(c.robots(c.empty(), at_centre), c.size()).ball(0, 0));
  c.add("everything at one place",
        c.robots(c.empty(), at_centre).task(0).task(1).task(2).opponent(0, 0).ball(0, 0).waypoint(0, 0).waypoint(0, 0));
  c.add("robots in line", SceneRow::tasks(c.robots(c.empty(), in_line), c.size()).ball(2, 0));
  c.add("everything in line", c.robots(c.empty(), in_line)
                                  .task(0)
                                  .at(1, 0)
                                  .task(1)
                                  .at(2, 0)
                                  .opponent(-1, 0)
                                  .opponent(1, 0)
                                  .opponent(3, 0)
                                  .ball(2.5, 0)
                                  .waypoint(0.5, 0)
                                  .waypoint(1.5, 0));
}

void add_tasks(SceneRow& c) {
  c.add("more tasks than robots", SceneRow::opponents(SceneRow::tasks(c.spread(), 12), 4).ball(0, 1));
  c.add("one task", SceneRow::opponents(SceneRow::tasks(c.spread(), 1), 4).ball(0, 1));
  c.add("no tasks", SceneRow::waypoints(SceneRow::opponents(c.spread(), 4)).ball(0, 1));
  c.add("no waypoints", SceneRow::opponents(SceneRow::tasks(c.spread(), 5), 4).ball(0, 1));
  FrameBuilder offset = c.usual();
  offset.task(12).at(1, 1).after(1.3, 1.4).group(0).task(13).at(-1, -1).after(-0.8, -0.6).group(0);
  c.add("tasks moved by the offset, in groups", offset);
  FrameBuilder held = c.usual();
  for (int n = 1; n <= c.size(); ++n) held.previous(n, n - 1).robot(n).role(n - 1).since(0.0);
  c.add("roles are held", held);
  FrameBuilder twice = c.usual();
  for (int n = 1; n <= c.size(); ++n) twice.previous(n, 1).robot(n).role(1).since(0.0);
  c.add("all hold one role", twice);
}

void add_opponents(SceneRow& c) {
  c.add("no opponents", SceneRow::tasks(c.spread(), 5).ball(0, 0));
  c.add("11 opponents", SceneRow::opponents(SceneRow::tasks(c.spread(), 5), 11).ball(0, 0));
  FrameBuilder coincident = SceneRow::tasks(c.spread(), 5).ball(1, 1);
  for (int k = 0; k < 6; ++k) coincident.opponent(1.5, -0.5);
  c.add("opponents at one place", coincident);
  FrameBuilder circle = SceneRow::tasks(c.spread(), 5).ball(1, 1);
  for (const double s : {-1.0, 1.0}) circle.opponent(1.0 + s, 0).opponent(1.0, s).opponent(1.0 + 0.6 * s, 0.8 * s);
  c.add("opponents on a circle", circle);
  c.add(
      "opponents at the posts and the halfway line's ends",
      SceneRow::tasks(c.spread(), 5).opponent(4.5, 0.8).opponent(4.5, -0.8).opponent(0, 3).opponent(0, -3).ball(0, 0));
  c.add("unlikely, old opponents",
        SceneRow::tasks(c.spread(), 5).opponent(1, 1).weight(1e-9).age(1e6).opponent(-1, 2).weight(0.5).age(1e3));
}

void add_ball_and_game(SceneRow& c) {
  const FrameBuilder base = SceneRow::waypoints(SceneRow::opponents(SceneRow::tasks(c.spread(), c.size()), 5));
  c.add("ball unknown", FrameBuilder(base).no_ball());
  for (const double x : {-4.5, 4.5}) {
    for (const double y : {-3.0, 3.0}) {
      c.add(std::string("ball in the corner ") + (x < 0 ? "behind" : "ahead") + (y < 0 ? " right" : " left"),
            FrameBuilder(base).ball(x, y));
    }
  }
  c.add("ball rolls fast", FrameBuilder(base).ball(-2, 1).ball_velocity(8, -6));
  c.add("ball long unseen", FrameBuilder(base).ball(1, 1).ball_age(1e5));
  for (const int phase : {REGISTA_PHASE_INITIAL, REGISTA_PHASE_READY, REGISTA_PHASE_SET, REGISTA_PHASE_FINISHED}) {
    c.add("phase " + std::to_string(phase), FrameBuilder(base).phase(phase, 3.0).ball(0, 0));
  }
  for (int play = REGISTA_SET_PLAY_KICK_OFF; play <= REGISTA_SET_PLAY_PENALTY_KICK; ++play) {
    c.add("set play " + std::to_string(play), FrameBuilder(base).set_play(play, play % 2 == 0).ball(2, 2));
  }
  regista_game late{};
  late.phase = REGISTA_PHASE_PLAYING;
  late.half = 2;
  late.opponent_score = 9;
  late.phase_time = 590.0;
  c.add("the last second", FrameBuilder(base).game(late).ball(-4, 0));
}

void add_absurd(SceneRow& c) {
  FrameBuilder penalised = SceneRow::opponents(SceneRow::tasks(c.spread(), 5), 3).ball(0, 0);
  FrameBuilder fallen = penalised, old = penalised;
  for (int n = 1; n <= c.size(); ++n) {
    penalised.robot(n).penalised();
    fallen.robot(n).fallen(5.0);
    old.robot(n).age(1e6).target(1, 1);
  }
  c.add("all penalised", penalised);
  c.add("all fallen", fallen);
  c.add("news of robots are very old", old.ball_age(1e6));
  FrameBuilder far = c.usual();
  for (int n = 1; n <= c.size(); ++n)
    far.robot(n).at(n % 2 == 0 ? 1e3 : -1e3, n % 3 == 0 ? 1e3 : -1e3).target(-1e3, 1e3);
  far.opponent(1e3, 1e3).opponent(-1e3, 1e3).task(12).at(1e3, -1e3).ball(-1e3, 1e3);
  c.add("far outside", far);
  c.add("close together", c.robots(c.usual(), [](int n) { return std::pair(1e-9 * n, 0.0); }));
  c.add("the common world differs", c.usual().knowledge(REGISTA_COMMON).common([](WorldBuilder& w) {
    w.robot(1).at(-1, -2).inactive().no_opponents().opponent(0.3, 0.4).ball(-3, -1).ball_age(3.0);
  }));
  c.add("the common world has no ball and one opponent more",
        c.usual().common([](WorldBuilder& w) { w.no_ball().opponent(2.5, 2.5).robot(1).age(2.0); }));
}

void add_chance(SceneRow& c, std::uint64_t seed) {
  Dice dice = Dice::with(seed, static_cast<std::uint64_t>(c.size()));
  for (int k = 0; k < 12; ++k) {
    FrameBuilder scene = c.empty();
    for (int n = 1; n <= c.size(); ++n) {
      if (dice.chance(0.15)) continue;
      const double x = dice.real(-4.5, 4.5), y = dice.real(-3, 3);
      const int role = dice.integer(-1, 11);
      scene.robot(n).at(x, y).heading(dice.real(-3.14, 3.14)).age(dice.real(0, 20)).role(role);
      if (dice.chance(0.1)) scene.penalised();
    }
    const int tasks = dice.integer(0, 12), opponents = dice.integer(0, 9);
    for (int j = 0; j < tasks; ++j) {
      const double x = dice.real(-4.5, 4.5), y = dice.real(-3, 3);
      scene.task(j).at(x, y);
    }
    for (int j = 0; j < opponents; ++j) {
      const double x = dice.real(-4.5, 4.5), y = dice.real(-3, 3);
      scene.opponent(x, y).age(dice.real(0, 8));
    }
    const double x = dice.real(-4.5, 4.5), y = dice.real(-3, 3);
    if (dice.chance(0.7)) scene.ball(x, y).ball_age(dice.real(0, 6));
    c.add("by chance, number " + std::to_string(k), scene.knowledge(dice.integer(0, 1)));
  }
}

}  // namespace

std::vector<Scene> scenes(int team_size, std::uint64_t seed) {
  SceneRow scenario(team_size);
  add_formations(scenario);
  add_tasks(scenario);
  add_opponents(scenario);
  add_ball_and_game(scenario);
  add_absurd(scenario);
  add_chance(scenario, seed);
  return scenario.take();
}

}  // namespace regista::testkit
