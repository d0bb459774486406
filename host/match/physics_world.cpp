// SPDX-License-Identifier: MIT
#include "match/physics_world.hpp"

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace regista::match {
namespace {

constexpr int velocity_iterations = 8, position_iterations = 3;
constexpr float step_seconds = static_cast<float>(physics_step);
constexpr double ball_stops_below = 0.01;       // m/s
constexpr float ball_bounces_above = 0.02f;     // m/s; at a lower relative speed the ball does not bounce
constexpr float robots_bounce_above = 1000.0f;  // m/s; so high that robots never bounce off robots

enum Category : std::uint16_t { border = 1, goal = 2, robot_torso = 4, ball_shape = 8 };

b2Vec2 to_box2d(Vector v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

// Box2D calls this listener for every contact that it solved in a step. Box2D has no cheaper list of all touches.
class Touches : public b2ContactListener {
 public:
  explicit Touches(int robots) : ball_(robots) {}

  void begin_step() {
    contacts_ = {};
    hardest_ = 0.0f;
  }
  const Contacts& contacts() const { return contacts_; }

  void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
    int a = id_of(contact->GetFixtureA()), b = id_of(contact->GetFixtureB());
    if (a < 0 || b < 0) {  // one body is the border or a goal
      const int other = std::max(a, b);
      if (other >= 0 && other != ball_) contacts_.robots_on_walls |= only(other);
      return;
    }
    if (a != ball_ && b != ball_) {
      contacts_.robots_on_robots |= only(a) | only(b);
      if (contacts_.pair_count < static_cast<int>(contacts_.pairs.size())) {
        contacts_.pairs[static_cast<std::size_t>(contacts_.pair_count++)] = {static_cast<std::int8_t>(a),
                                                                             static_cast<std::int8_t>(b)};
      }
      return;
    }
    const int robot = a == ball_ ? b : a;
    contacts_.robots_on_ball |= only(robot);
    const float hardness = impulse->normalImpulses[0];
    if (contacts_.hardest_on_ball < 0 || hardness > hardest_) {
      contacts_.hardest_on_ball = robot;
      hardest_ = hardness;
    }
  }

 private:
  // The user data of a body is id + 1; 0 marks a body without an id.
  static int id_of(b2Fixture* fixture) { return static_cast<int>(fixture->GetBody()->GetUserData().pointer) - 1; }

  Contacts contacts_;
  int ball_;
  float hardest_ = 0.0f;
};

}  // namespace

struct PhysicsWorld::World {
  b2World box2d{b2Vec2_zero};
  Touches touches;
  std::vector<b2Body*> bodies;  // robots by id, then the ball; owned by box2d
  std::vector<BodyState> states;
  config::BallSize ball_size;
  PhysicsLog* log = nullptr;

  World(const config::FieldSize& field, const config::BallSize& ball, std::span<const config::Body> robots)
      : touches(static_cast<int>(robots.size())), ball_size(ball) {
    box2d.SetContactListener(&touches);
    build_border(field);
    build_goal(field, 1.0);
    build_goal(field, -1.0);
    for (const auto& robot : robots) add_robot(robot);
    add_ball();
    states.resize(bodies.size());
    observe();
  }

  b2Body& body(int id) { return *bodies[at(id)]; }
  b2Body& ball() { return *bodies.back(); }
  int ball_id() const { return static_cast<int>(bodies.size()) - 1; }

  void add_static(const b2Shape& shape, Category category, float restitution) {
    const b2BodyDef definition;
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.friction = 0.0f;
    fixture.restitution = restitution;
    fixture.restitutionThreshold = robots_bounce_above;
    fixture.filter.categoryBits = category;
    fixture.filter.maskBits = robot_torso | ball_shape;
    box2d.CreateBody(&definition)->CreateFixture(&fixture);
  }

  void add_wall(Vector from, Vector to, Category category) {
    b2EdgeShape edge;
    edge.SetTwoSided(to_box2d(from), to_box2d(to));
    add_static(edge, category, 0.0f);
  }

  void build_border(const config::FieldSize& field) {
    const double x = field.length / 2.0 + field.border_strip, y = field.width / 2.0 + field.border_strip;
    add_wall({-x, -y}, {x, -y}, border);
    add_wall({x, -y}, {x, y}, border);
    add_wall({x, y}, {-x, y}, border);
    add_wall({-x, y}, {-x, -y}, border);
  }

  void build_goal(const config::FieldSize& field, double direction) {
    const double line = direction * field.length / 2.0, back = line + direction * field.goal_depth;
    const double post = (field.goal_width + field.post_diameter) / 2.0;
    for (const double y : {-post, post}) {
      b2CircleShape circle;
      circle.m_p = to_box2d({line, y});
      circle.m_radius = static_cast<float>(field.post_diameter / 2.0);
      add_static(circle, goal, static_cast<float>(ball_size.restitution));
    }
    add_wall({line, -post}, {back, -post}, goal);
    add_wall({back, -post}, {back, post}, goal);
    add_wall({back, post}, {line, post}, goal);
  }

  void add_dynamic(const b2BodyDef& base, double radius, double mass, float restitution, float threshold,
                   Category category, std::uint16_t collides_with) {
    b2BodyDef definition = base;
    definition.type = b2_dynamicBody;
    definition.userData.pointer = bodies.size() + 1;
    b2CircleShape circle;
    circle.m_radius = static_cast<float>(radius);
    b2FixtureDef fixture;
    fixture.shape = &circle;
    fixture.density = static_cast<float>(mass / (std::numbers::pi * radius * radius));
    fixture.friction = 0.0f;
    fixture.restitution = restitution;
    fixture.restitutionThreshold = threshold;
    fixture.filter.categoryBits = category;
    fixture.filter.maskBits = collides_with;
    bodies.push_back(box2d.CreateBody(&definition));
    bodies.back()->CreateFixture(&fixture);
  }

  void add_robot(const config::Body& robot) {
    add_dynamic({}, robot.radius, robot.mass, static_cast<float>(ball_size.restitution), robots_bounce_above,
                robot_torso, border | goal | robot_torso | ball_shape);
  }

  void add_ball() {
    b2BodyDef definition;
    definition.bullet = true;
    definition.fixedRotation = true;
    add_dynamic(definition, ball_size.diameter / 2.0, ball_size.mass, 0.0f, ball_bounces_above, ball_shape,
                border | goal | robot_torso);
  }

  void note(int id, Operation::Kind kind, b2Vec2 value, float turn) {
    if (log == nullptr) return;
    log->operations.push_back({static_cast<std::uint16_t>(id), kind, value.x, value.y, turn});
  }

  void set_velocity(int id, b2Vec2 velocity, float turn) {
    b2Body& moved = body(id);
    moved.SetLinearVelocity(velocity);
    moved.SetAngularVelocity(turn);
    note(id, Operation::Kind::velocity, velocity, turn);
  }

  void set_pose(int id, b2Vec2 position, float heading) {
    b2Body& moved = body(id);
    moved.SetTransform(position, heading);
    moved.SetLinearVelocity(b2Vec2_zero);
    moved.SetAngularVelocity(0.0f);
    moved.SetAwake(true);
    note(id, Operation::Kind::place, position, heading);
  }

  // Rolling friction is a constant deceleration a. Half of the deceleration acts before and half after the positions
  // move. The rolling distance is then exactly v^2 / (2 a), except for the last step.
  void brake_ball(bool last_half) {
    const b2Vec2 velocity = ball().GetLinearVelocity();
    if (velocity.x == 0.0f && velocity.y == 0.0f) return;
    const double speed = std::hypot(velocity.x, velocity.y);
    const double left = speed - ball_size.rolling_deceleration * physics_step / 2.0;
    const bool stops = left <= 0.0 || (last_half && left < ball_stops_below);
    const float scale = stops ? 0.0f : static_cast<float>(left / speed);
    set_velocity(ball_id(), scale * velocity, 0.0f);
  }

  void observe(std::size_t i) {
    const b2Body& body = *bodies[i];
    const b2Transform& transform = body.GetTransform();
    const b2Vec2 velocity = body.GetLinearVelocity();
    states[i] = {transform.p.x, transform.p.y, body.GetAngle(), transform.q.c,
                 transform.q.s, velocity.x,    velocity.y,      body.GetAngularVelocity()};
  }
  void observe() {
    for (std::size_t i = 0; i < bodies.size(); ++i) observe(i);
  }

  void require_finite(int id, double x, double y, double turn) const {
    if (std::isfinite(x) && std::isfinite(y) && std::isfinite(turn)) return;
    throw std::invalid_argument("arena: value that is not finite for " +
                                (id == ball_id() ? std::string("the ball") : "robot id " + std::to_string(id)));
  }
};

PhysicsWorld::PhysicsWorld(const config::FieldSize& field, const config::BallSize& ball,
                           std::span<const config::Body> robots)
    : world_(std::make_unique<World>(field, ball, robots)), states_(world_->states) {}
PhysicsWorld::~PhysicsWorld() = default;
PhysicsWorld::PhysicsWorld(PhysicsWorld&&) noexcept = default;

void PhysicsWorld::drive(int robot, Vector velocity, double turn, double acceleration, double turn_acceleration) {
  world_->require_finite(robot, velocity.x, velocity.y, turn);
  const BodyState& now = world_->states[at(robot)];
  Vector change{velocity.x - now.vx, velocity.y - now.vy};
  double turn_change = turn - now.turn;
  // A velocity that the robot has (in float, as Box2D stores it) is not set again, so that a resting robot can sleep.
  if (static_cast<float>(velocity.x) == now.vx && static_cast<float>(velocity.y) == now.vy &&
      static_cast<float>(turn) == now.turn) {
    return;
  }
  const double most = acceleration * physics_step, size = squared_length(change);
  if (size > most * most) change = most / std::sqrt(size) * change;
  const double most_turn = turn_acceleration * physics_step;
  turn_change = std::fmin(std::fmax(turn_change, -most_turn), most_turn);
  world_->set_velocity(robot, to_box2d({now.vx + change.x, now.vy + change.y}),
                       static_cast<float>(now.turn + turn_change));
}

void PhysicsWorld::place(int robot, const mind::Pose& pose) {
  world_->require_finite(robot, pose.x, pose.y, pose.heading);
  world_->set_pose(robot, to_box2d({pose.x, pose.y}), static_cast<float>(pose.heading));
  world_->observe(at(robot));
}

void PhysicsWorld::place_ball(Vector position) {
  world_->require_finite(world_->ball_id(), position.x, position.y, 0.0);
  world_->set_pose(world_->ball_id(), to_box2d(position), 0.0f);
  world_->observe(static_cast<std::size_t>(world_->ball_id()));
}

void PhysicsWorld::kick(Vector ball_velocity) {
  world_->require_finite(world_->ball_id(), ball_velocity.x, ball_velocity.y, 0.0);
  world_->set_velocity(world_->ball_id(), to_box2d(ball_velocity), 0.0f);
  world_->observe(static_cast<std::size_t>(world_->ball_id()));
}

void PhysicsWorld::step() {
  World& world = *world_;
  world.touches.begin_step();
  world.brake_ball(false);
  if (world.log != nullptr) {
    world.log->step_ends.push_back(static_cast<std::uint32_t>(world.log->operations.size()));
  }
  world.box2d.Step(step_seconds, velocity_iterations, position_iterations);
  world.brake_ball(true);
  world.observe();
}

const Contacts& PhysicsWorld::contacts() const { return world_->touches.contacts(); }
void PhysicsWorld::record(PhysicsLog* log) { world_->log = log; }

void PhysicsWorld::replay(const PhysicsLog& log) {
  World& world = *world_;
  std::size_t done = 0;
  for (const std::uint32_t end : log.step_ends) {
    for (; done < end; ++done) {
      const Operation& operation = log.operations[done];
      const b2Vec2 value(operation.x, operation.y);
      if (operation.kind == Operation::Kind::velocity) {
        world.set_velocity(operation.body, value, operation.turn);
      } else {
        world.set_pose(operation.body, value, operation.turn);
      }
    }
    world.box2d.Step(step_seconds, velocity_iterations, position_iterations);
  }
  world.observe();
}

}  // namespace regista::match

// Box2D reads the clock about a hundred times a step for its own profile. These calls would take an eighth of a match's
// time. These weak definitions replace the library's functions and read no clock. A benchmark can replace them.
[[gnu::weak]] b2Timer::b2Timer() { Reset(); }
[[gnu::weak]] void b2Timer::Reset() { m_start_sec = m_start_usec = 0; }
[[gnu::weak]] float b2Timer::GetMilliseconds() const { return 0.0f; }
