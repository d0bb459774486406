// SPDX-License-Identifier: MIT
// Behaviours that break one promise each.
#include <limits>
#include <stdexcept>

#include "bad.hpp"

namespace {

using regista::Action;
using regista::Body;
using regista::Frame;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

void walk_to(Action& out, double x, double y) {
  out.motion = REGISTA_MOTION_WALK_TO;
  out.pose[0] = x;
  out.pose[1] = y;
}

// Of the usual kinds of kick, the first.
void kick(Action& out, double distance, double direction = 0.0) {
  out.kick = 0;
  out.kick_distance = distance;
  out.kick_direction = direction;
}

struct WalksNowhere : bad::Described {
  static constexpr auto id = "walks_nowhere";
  void act(const Frame&, const Body&, Action& out) { walk_to(out, nan, 0.0); }
};
struct WalksTooFar : bad::Described {
  static constexpr auto id = "walks_too_far";
  void act(const Frame&, const Body&, Action& out) { walk_to(out, 0.0, -2e4); }
};
struct FacesNowhere : bad::Described {
  static constexpr auto id = "faces_nowhere";
  void act(const Frame&, const Body&, Action& out) { out.pose[2] = infinity; }
};
struct EndlesslyFast : bad::Described {
  static constexpr auto id = "endlessly_fast";
  void act(const Frame&, const Body&, Action& out) {
    out.motion = REGISTA_MOTION_VELOCITY;
    out.velocity[0] = infinity;
  }
};
struct NoSuchMotion : bad::Described {
  static constexpr auto id = "no_such_motion";
  void act(const Frame&, const Body&, Action& out) { out.motion = 3; }
};
struct NoSuchWalk : bad::Described {
  static constexpr auto id = "no_such_walk";
  void act(const Frame&, const Body&, Action& out) { out.walk = 8; }
};
struct NoSuchFlag : bad::Described {
  static constexpr auto id = "no_such_flag";
  void act(const Frame&, const Body&, Action& out) { out.flags = 2; }
};
struct LooksBehindItself : bad::Described {
  static constexpr auto id = "looks_behind_itself";
  void act(const Frame&, const Body&, Action& out) { out.gaze = 3.5; }
};
struct LooksNowhere : bad::Described {
  static constexpr auto id = "looks_nowhere";
  void act(const Frame&, const Body&, Action& out) { out.gaze = nan; }
};
struct TellsNoTarget : bad::Described {
  static constexpr auto id = "tells_no_target";
  void act(const Frame&, const Body&, Action& out) {
    out.flags = REGISTA_ACTION_TARGET;
    out.target[1] = nan;
  }
};
struct NoSuchKick : bad::Described {
  static constexpr auto id = "no_such_kick";
  void act(const Frame&, const Body&, Action& out) {
    kick(out, 2.0);
    out.kick = 3;
  }
};
struct NegativeKick : bad::Described {
  static constexpr auto id = "negative_kick";
  void act(const Frame&, const Body&, Action& out) { out.kick = -2; }
};
// A robot need not have any.
struct ReliesOnKicks : bad::Described {
  static constexpr auto id = "relies_on_kicks";
  double distance = 0.0;
  void setup(const regista::Environment& environment) {
    for (const regista::Kick& each : environment.kicks()) {
      distance = each.minimum_distance;
      break;
    }
  }
  void act(const Frame&, const Body&, Action& out) { kick(out, distance); }
};
struct KicksTooFar : bad::Described {
  static constexpr auto id = "kicks_too_far";
  void act(const Frame&, const Body&, Action& out) { kick(out, 4.6); }
};
struct KicksNoDistance : bad::Described {
  static constexpr auto id = "kicks_no_distance";
  void act(const Frame&, const Body&, Action& out) { kick(out, nan); }
};
struct KicksFullTurn : bad::Described {
  static constexpr auto id = "kicks_full_turn";
  void act(const Frame&, const Body&, Action& out) { kick(out, 2.0, 6.0); }
};
struct AvoidsNegatively : bad::Described {
  static constexpr auto id = "avoids_negatively";
  void act(const Frame&, const Body&, Action& out) { regista::avoid(out, 1.0, 2.0, -0.1); }
};
struct AvoidsNothing : bad::Described {
  static constexpr auto id = "avoids_nothing";
  void act(const Frame&, const Body&, Action& out) { regista::avoid(out, nan, 2.0, 0.1); }
};
struct AvoidsTooMany : bad::Described {
  static constexpr auto id = "avoids_too_many";
  void act(const Frame&, const Body&, Action& out) {
    for (int k = 0; k <= REGISTA_MOST_AVOIDED; ++k) regista::avoid(out, k, 0.0, 0.1);
  }
};
struct CountsTooManyDiscs : bad::Described {
  static constexpr auto id = "counts_too_many_discs";
  void act(const Frame&, const Body&, Action& out) { out.avoid_count = REGISTA_MOST_AVOIDED + 1; }
};
struct WritesPastTheDiscs : bad::Described {
  static constexpr auto id = "writes_past_the_discs";
  static std::int32_t call(void*, const regista_frame*, const regista_body*, regista_action* out, regista_error*) {
    regista_disc* volatile discs = out->avoid;  // volatile: no compiler shall see where this goes
    discs[REGISTA_MOST_AVOIDED] = {0.0, 0.0, 0.1};
    return REGISTA_OK;
  }
};
struct ChangesTheSize : bad::Described {
  static constexpr auto id = "changes_the_size";
  void act(const Frame&, const Body&, Action& out) { out = {}; }
};
struct ScribblesBody : bad::Described {
  static constexpr auto id = "scribbles_body";
  void act(const Frame&, const Body& body, Action&) { const_cast<regista_body*>(body.operator->())->pose[0] += 1.0; }
};
struct ScribblesRobotsNear : bad::Described {
  static constexpr auto id = "scribbles_robots_near";
  void act(const Frame&, const Body& body, Action&) {
    for (const regista::Point& robot : body.robots_near()) const_cast<regista::Point&>(robot).x = 0.0;
  }
};
struct WhollyUpright : bad::Described {
  static constexpr auto id = "wholly_upright";
  void act(const Frame&, const Body& body, Action&) {
    if (body.is(REGISTA_BODY_FALLEN)) throw std::runtime_error("lies");
  }
};
struct NeedsATask : bad::Described {
  static constexpr auto id = "needs_a_task";
  void act(const Frame& frame, const Body& body, Action& out) {
    if (body.task(frame) == nullptr) throw std::runtime_error("no task");
    walk_to(out, body.task(frame)->after[0], 0.0);
  }
};
struct RemembersTheBall : bad::Described {
  static constexpr auto id = "remembers_the_ball";
  bool seen = false;
  void act(const Frame&, const Body& body, Action& out) {
    out.gaze = seen ? 1.0 : 0.0;
    seen = seen || body.is(REGISTA_BODY_BALL_REFUTED);
  }
};
struct CountsDecisions : bad::Described {
  static constexpr auto id = "counts_decisions";
  void act(const Frame&, const Body&, Action& out) {
    static int decisions = 0;
    walk_to(out, decisions++ % 100, 0.0);
  }
};
struct KeepsTheKicks : bad::Described {
  static constexpr auto id = "keeps_the_kicks";
  const regista_kick* kept = nullptr;
  void setup(const regista::Environment& environment) {
    if (!environment.kicks().empty()) kept = &environment.kicks()[0];
  }
  void act(const Frame&, const Body&, Action& out) {
    if (kept != nullptr) kick(out, kept->minimum_distance);
  }
};
struct StepsByKickSize : bad::Described {
  static constexpr auto id = "steps_by_kick_size";
  double speed = 0.0;
  void setup(const regista::Environment& environment) {
    const auto* kicks = static_cast<const regista_kick*>(environment->kicks.data);
    for (std::uint32_t i = 0; i < environment->kicks.count; ++i) speed += kicks[i].duration;
  }
  void act(const Frame&, const Body&, Action& out) { out.velocity[0] = speed; }
};
struct StepsByPointSize : bad::Described {
  static constexpr auto id = "steps_by_point_size";
  void act(const Frame&, const Body& body, Action& out) {
    const auto* robots = static_cast<const regista_point*>(body->robots_near.data);
    for (std::uint32_t i = 0; i < body->robots_near.count; ++i) out.velocity[0] += robots[i].x;
  }
};
struct RefusesLargerBodies : bad::Described {
  static constexpr auto id = "refuses_larger_bodies";
  void act(const Frame&, const Body& body, Action&) {
    if (body->size != sizeof(regista_body)) throw std::runtime_error("a body of another size");
  }
};
struct RefusesLargerActions : bad::Described {
  static constexpr auto id = "refuses_larger_actions";
  void act(const Frame&, const Body&, Action& out) {
    if (out.size != sizeof(regista_action)) throw std::runtime_error("an action of another size");
  }
};

template <class Class>
using Sound = regista::Plugin<Class, regista::behaviour>;  // in its glue

}  // namespace

REGISTA_PLUGINS(Sound<WalksNowhere>, Sound<WalksTooFar>, Sound<FacesNowhere>, Sound<EndlesslyFast>, Sound<NoSuchMotion>,
                Sound<NoSuchWalk>, Sound<NoSuchFlag>, Sound<LooksBehindItself>, Sound<LooksNowhere>,
                Sound<TellsNoTarget>, Sound<NoSuchKick>, Sound<NegativeKick>, Sound<ReliesOnKicks>, Sound<KicksTooFar>,
                Sound<KicksNoDistance>, Sound<KicksFullTurn>, Sound<AvoidsNegatively>, Sound<AvoidsNothing>,
                Sound<AvoidsTooMany>, Sound<CountsTooManyDiscs>,
                regista::Plugin<WritesPastTheDiscs, bad::bare_behaviour>, Sound<ChangesTheSize>, Sound<ScribblesBody>,
                Sound<ScribblesRobotsNear>, Sound<WhollyUpright>, Sound<NeedsATask>, Sound<RemembersTheBall>,
                Sound<CountsDecisions>, Sound<KeepsTheKicks>, Sound<StepsByKickSize>, Sound<StepsByPointSize>,
                Sound<RefusesLargerBodies>, Sound<RefusesLargerActions>)
