// SPDX-License-Identifier: MIT
// The simplest sound plugin of each kind: what every contract suite must accept.
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <regista/assigner.hpp>
#include <regista/behaviour.hpp>
#include <regista/context.hpp>
#include <regista/positioner.hpp>
#include <regista/predictor.hpp>
#include <regista/sender.hpp>
#include <regista/utility.hpp>

namespace {

struct FirstFree {
  static constexpr auto id = "first_free", version = "1.0.0", summary = "Each robot takes the first task open to it";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  std::vector<char> taken;

  void assign(const regista::Frame&, regista::UtilityMatrix u, regista::Assignment out) {
    taken.assign(u.columns(), 0);
    for (std::size_t i = 0; i < u.rows(); ++i) {
      for (std::size_t j = 0; j < u.columns() && out[i] == regista::Assignment::no_task; ++j) {
        if (taken[j] || u(i, j) == regista::UtilityMatrix::forbidden) continue;
        taken[j] = 1;
        out[i] = static_cast<std::int32_t>(j);
      }
    }
  }
};

struct Nearness {
  static constexpr auto id = "nearness", version = "1.0.0", summary = "One over one plus distance";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  double scale = 1.0;
  bool squared = false;
  static constexpr std::tuple parameters{
      regista::real("scale", &Nearness::scale, {0.1, 10.0}, "m", "Distance at which half is left").tunable(),
      regista::boolean("squared", &Nearness::squared, "Falls off with the square")};

  void score(const regista::Frame& frame, regista::Utilities out) {
    const regista::World world = frame.world();
    for (std::size_t i = 0; i < out.rows(); ++i) {
      const regista::Robot& robot = world.robot(world.active()[i]);
      for (std::size_t j = 0; j < out.columns(); ++j) {
        const regista::Task& task = frame.tasks()[j];
        const double d = std::hypot(task.after[0] - robot.pose[0], task.after[1] - robot.pose[1]) / scale;
        out(i, j) = 1.0 / (1.0 + (squared ? d * d : d));
      }
    }
  }
};

struct BallSeen {
  static constexpr auto id = "ball_seen", version = "1.0.0", summary = "Someone knows where the ball is";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  bool holds(const regista::Frame& frame) { return frame.world().ball_known(); }
};

struct AtTheBall {
  static constexpr auto id = "at_the_ball", version = "1.0.0", summary = "Two points about the ball, on the field";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  double x_limit = 0.0, y_limit = 0.0;
  void setup(const regista::Environment& e) {
    x_limit = e->field_length / 2;
    y_limit = e->field_width / 2;
  }
  void place(const regista::Frame& frame, regista::Placement out) {
    if (!frame.world().ball_known()) return;
    const double* ball = frame.world().ball().position;
    const double x = std::clamp(ball[0], -x_limit, x_limit), y = std::clamp(ball[1], -y_limit, y_limit);
    const std::uint32_t a = out.point(x, y), b = out.point(x, -y, 0.5);
    out.edge(a, b);
  }
};

struct EverySecond {
  static constexpr auto id = "every_second", version = "1.0.0", summary = "A packet a second, with every offer";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr std::array<const char*, 2> reasons{"short_of_time", "second"};
  std::optional<int> decide(const regista::Frame&, const regista::SendQuery& query, regista::Grants out) {
    if (query.budget.packets_left <= 0 || query.budget.since_own < 1.0) return std::nullopt;
    for (const regista::Offer& offer : query.offers) out.grant(offer);
    return query.budget.since_own > 10.0 ? REGISTA_EVENT_PERIOD : regista::own_reason(1);
  }
};

// Walks to its task, around whom it sees, and kicks what it can.
struct ToThePlace {
  static constexpr auto id = "to_the_place", version = "1.0.0", summary = "Walks to its task, and kicks what it can";
  static constexpr unsigned reads = REGISTA_READS_FACINGS;
  static constexpr unsigned purposes = REGISTA_BEHAVIOUR_PLAYS_BALL | REGISTA_BEHAVIOUR_SEARCHES;
  double space = 0.4, reach = 0.0;
  static constexpr std::tuple parameters{
      regista::real("space", &ToThePlace::space, {0.0, 1.0}, "m", "Way around robots")};
  std::vector<double> distances;  // of each kind of kick
  void setup(const regista::Environment& e) {
    reach = e->kick_reach;
    for (const regista::Kick& kick : e.kicks())
      distances.push_back(0.5 * (kick.minimum_distance + kick.maximum_distance));
  }
  void act(const regista::Frame& frame, const regista::Body& body, regista::Action& out) {
    const regista::Task* task = body.task(frame);
    if (task == nullptr || body.is(REGISTA_BODY_FALLEN)) return;
    out.motion = REGISTA_MOTION_WALK_TO;
    std::copy(task->after, task->after + 3, out.pose);
    for (const regista::Point& robot : body.robots_near()) {
      if (out.avoid_count < REGISTA_MOST_AVOIDED) regista::avoid(out, robot.x, robot.y, space);
    }
    const double* ball = frame.mine().ball().position;
    const bool near = std::hypot(ball[0] - body->pose[0], ball[1] - body->pose[1]) < reach;
    if (distances.empty() || !near || !body.is(REGISTA_BODY_SEES_BALL)) return;
    out.kick = static_cast<std::int32_t>(frame.tick() % distances.size());
    out.kick_distance = distances[static_cast<std::size_t>(out.kick)];
  }
};

// Believes the last that it was told, and trusts it less and less.
struct LastNews {
  static constexpr auto id = "last_news", version = "1.0.0", summary = "Where it was last measured";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr unsigned subjects =
      REGISTA_SUBJECT_SELF | REGISTA_SUBJECT_BALL | REGISTA_SUBJECT_OPPONENTS | REGISTA_SUBJECT_TEAMMATES;
  std::vector<regista::Track> now;
  unsigned subject = 0;
  int own = 0, next = 1;

  void setup(const regista::Environment& e) {
    subject = e->subject;
    own = e->own_number;
  }
  void reset(std::uint64_t) {
    now.clear();
    next = 1;
    if (subject == REGISTA_SUBJECT_SELF) now.push_back(fresh(own, 0.0, 0.0));
  }
  regista::Track fresh(int label, double x, double y) const {
    regista::Track t{};
    t.label = label;
    t.x = x;
    t.y = y;
    t.weight = 1.0;
    for (const std::size_t i : {0u, 2u}) t.covariance[i] = 0.1;
    if (is_pose()) {
      t.pose.heading_variance = t.pose.velocity_variance = 0.1;
    } else {
      for (const std::size_t i : {4u, 6u}) t.motion[i] = 0.1;
    }
    return t;
  }
  bool is_pose() const { return (subject & (REGISTA_SUBJECT_SELF | REGISTA_SUBJECT_TEAMMATES)) != 0; }
  regista::Track later(regista::Track t, double dt) const {
    t.age += dt;
    for (const std::size_t i : {0u, 2u}) t.covariance[i] += 0.01 * dt;
    if (is_pose()) t.pose.heading_variance += 0.01 * dt;
    return t;
  }
  regista::Track track_at(const regista::Track& told, double age) const { return later(told, age); }
  void predict(double dt, const regista::Motion*, const regista::Frame*) {
    for (regista::Track& t : now) t = later(t, dt);
  }
  void correct(regista::Span<regista::Measurement> measured, const regista::VisibleArea&) {
    for (const regista::Measurement& m : measured) {
      if (m.kind == REGISTA_MEASURED_POSE) {
        now = {fresh(own, m.position[0], m.position[1])};
      } else if (m.kind == REGISTA_MEASURED_BALL) {
        now = {fresh(1, m.position[0], m.position[1])};
      } else if (m.kind == REGISTA_MEASURED_ROBOT) {
        const auto near = std::find_if(now.begin(), now.end(), [&](const regista::Track& t) {
          return std::hypot(t.x - m.position[0], t.y - m.position[1]) < 1.0;
        });
        if (near == now.end()) {
          if (now.size() == 32) now.erase(now.begin());
          now.push_back(fresh(next++, m.position[0], m.position[1]));
        } else {
          *near = fresh(near->label, m.position[0], m.position[1]);
        }
      }
    }
  }
  void absorb(regista::Span<regista::Track> said, double age) {
    if (subject != REGISTA_SUBJECT_TEAMMATES) now.clear();
    for (regista::Track t : said) {
      t.age += age;
      const auto place = std::lower_bound(now.begin(), now.end(), t.label,
                                          [](const regista::Track& a, int label) { return a.label < label; });
      if (place != now.end() && place->label == t.label) {
        *place = t;
      } else {
        now.insert(place, t);
      }
      next = std::max(next, t.label + 1);
    }
  }
  void tracks(regista::Tracks out) const {
    for (const regista::Track& t : now) out.add(t);
  }
};

// One parameter of each type; scores tell their values.
struct Everything {
  enum class Form { square, round };
  static constexpr std::array<const char*, 2> forms{"square", "round"};
  static constexpr auto id = "everything", version = "1.0.0", summary = "Shows its parameters";
  double reach = 1.5;
  int depth = 2;
  bool deep = false;
  Form form = Form::round;
  std::string word = "hello", map;
  static constexpr std::tuple parameters{regista::real("reach", &Everything::reach, {0.0, 3.0}, "m", "How far"),
                                         regista::integer("depth", &Everything::depth, {0.0, 4.0}, "1", "How deep"),
                                         regista::boolean("deep", &Everything::deep, "Whether it is deep"),
                                         regista::choice("form", &Everything::form, forms, "Which form"),
                                         regista::text("word", &Everything::word, "What it says"),
                                         regista::file("map", &Everything::map, "What it reads")};
  void score(const regista::Frame&, regista::Utilities out) {
    const double shown[] = {reach,
                            1.0 * depth,
                            deep ? 1.0 : 0.0,
                            form == Form::round ? 1.0 : 0.0,
                            static_cast<double>(word.size()),
                            static_cast<double>(map.size())};
    for (std::size_t j = 0; j < std::min<std::size_t>(out.columns(), 6); ++j) out(0, j) = shown[j];
  }
};

struct SevenNumbers {
  static constexpr auto id = "seven_numbers", version = "1.0.0", summary = "Many parameters";
  double a = 1, b = 1, c = 1, d = 1, e = 1, f = 1, g = 1;
  static constexpr regista::Range range{0.0, 2.0};
  static constexpr std::tuple parameters{regista::real("a", &SevenNumbers::a, range, "1", "First"),
                                         regista::real("b", &SevenNumbers::b, range, "1", "Second"),
                                         regista::real("c", &SevenNumbers::c, range, "1", "Third"),
                                         regista::real("d", &SevenNumbers::d, range, "1", "Fourth"),
                                         regista::real("e", &SevenNumbers::e, range, "1", "Fifth"),
                                         regista::real("f", &SevenNumbers::f, range, "1", "Sixth"),
                                         regista::real("g", &SevenNumbers::g, range, "1", "Seventh")};
  void score(const regista::Frame&, regista::Utilities out) { out(0, 0) = a + b + c + d + e + f + g; }
};

// Tells its number and how many bytes it heard. The last offer replaces the one before, unless that has left.
struct Talker {
  static constexpr auto id = "talker", version = "1.0.0", summary = "First free, and talks";
  FirstFree assigner;
  regista::Mailbox mailbox;
  std::uint8_t own = 0, heard = 0;
  std::uint64_t pending = 0;

  void setup(const regista::Environment& environment, regista::Mailbox way_out) {
    if (environment->own_number > static_cast<int>(environment->team_size)) throw std::runtime_error("no such number");
    own = static_cast<std::uint8_t>(environment->own_number);
    mailbox = way_out;
  }
  void reset(std::uint64_t) {
    heard = 0;
    pending = 0;
  }
  void assign(const regista::Frame& frame, regista::UtilityMatrix u, regista::Assignment out) {
    assigner.assign(frame, u, out);
    const std::array<std::uint8_t, 2> said{own, heard};
    const std::uint64_t handle = mailbox.offer(said, 0.5, frame.time() + 5.0, pending);
    if (handle != 0) pending = handle;
  }
  void receive(const regista::Message& message) { heard = static_cast<std::uint8_t>(message.bytes().size()); }
  void transmitted(std::uint64_t handle) {
    if (handle == pending) pending = 0;
  }
};

}  // namespace

REGISTA_PLUGINS(regista::Plugin<FirstFree, regista::assigner>, regista::Plugin<Nearness, regista::utility>,
                regista::Plugin<BallSeen, regista::context>, regista::Plugin<AtTheBall, regista::positioner>,
                regista::Plugin<EverySecond, regista::sender>, regista::Plugin<LastNews, regista::predictor>,
                regista::Plugin<Everything, regista::utility>, regista::Plugin<SevenNumbers, regista::utility>,
                regista::Plugin<Talker, regista::assigner>, regista::Plugin<ToThePlace, regista::behaviour>)
