// SPDX-License-Identifier: MIT
#include "mind/extensions/extensions.hpp"

#include <regista/extensions/known_size.hpp>

#include <cstring>
#include <utility>

namespace regista::mind {
namespace {

regista_told_packet as_told(const Report& report) {
  regista_told_packet out{};
  out.flags =
      (report.ball ? std::uint32_t{REGISTA_TOLD_BALL} : 0u) | (report.fallen ? std::uint32_t{REGISTA_TOLD_FALLEN} : 0u);
  out.time_sent = report.time_sent;
  out.pose[0] = report.pose.x;
  out.pose[1] = report.pose.y;
  out.pose[2] = report.pose.heading;
  const auto put = [](const Vector2d& from, double* to) { to[0] = from.x(), to[1] = from.y(); };
  put(report.velocity, out.velocity);
  put(report.target, out.target);
  out.role = report.role;
  out.context = report.context;
  out.role_since = report.role_since;
  if (report.ball) {
    put(report.ball->position, out.ball);
    put(report.ball->velocity, out.ball_velocity);
    out.ball_age = report.ball->age;
  }
  return out;
}

}  // namespace

// Fills the function tables. `context` points to this object, and plugins pass it to each function.
InstanceExtensions::InstanceExtensions(Extensions& owner, const plugin::Found& plugin, std::span<const int> metrics,
                                       int place)
    : owner_(&owner), plugin_(&plugin), metrics_(metrics), place_(place) {
  log_use_.plugin = draw_use_.plugin = plugin.descriptor->id;
  log_use_.place = draw_use_.place = place;
  log_ = {sizeof log_, 0, this, [](void* context, std::int32_t level, const char* text, std::uint32_t length) {
            InstanceExtensions& self = of(context);
            self.begin_call();
            // Ignores lines beyond the limit. The log has already reported that the instance exceeds the limit.
            if (self.owner_->muted_ || self.log_use_.lines > REGISTA_LOG_MOST_LINES) return;
            // A plugin may give a wrong length, so strnlen() stops at the end of the string.
            const std::size_t most = std::min<std::size_t>(length, REGISTA_LOG_MOST_BYTES + 1);
            self.owner_->log_.write(self.log_use_, level, {text, text == nullptr ? 0 : strnlen(text, most)});
          }};
  draw_ = {sizeof draw_, 0, this,
           [](void* context) -> std::int32_t { return of(context).owner_->drawings_.wanted() ? 1 : 0; },
           [](void* context, const regista_shape* shape) {
             InstanceExtensions& self = of(context);
             self.begin_call();
             if (shape != nullptr && !self.owner_->muted_) self.owner_->drawings_.draw(self.draw_use_, *shape);
           }};
  metric_reports_ = {sizeof metric_reports_, 0, this, [](void* context, std::uint32_t metric, double value) {
                       InstanceExtensions& self = of(context);
                       if (self.owner_->muted_) return;
                       self.owner_->metrics_.report(*self.plugin_, self.metrics_, self.place_, metric, value);
                     }};
  pass_ = {sizeof pass_, 0, this, [](void* context, std::int32_t receiver) {
             InstanceExtensions& self = of(context);
             if (!self.owner_->muted_) self.owner_->pass_ = {self.plugin_, receiver};
           }};
  told_ = {sizeof told_,
           0,
           this,
           [](void* context, std::int32_t number, regista_told_packet* out) -> std::int32_t {
             const Answers& answers = of(context).owner_->answers_;
             const Report* const report = answers.packet ? answers.packet(number) : nullptr;
             if (report == nullptr) return 0;
             write_known(as_told(*report), out);
             return 1;
           },
           [](void* context) -> std::int32_t {
             const Answers& answers = of(context).owner_->answers_;
             return answers.sees_ball && answers.sees_ball() ? 1 : 0;
           },
           [](void* context) -> std::int32_t {
             const std::optional<MeantPass>& pass = of(context).owner_->pass_;
             return pass ? pass->receiver : 0;
           }};
  roles_ = {sizeof roles_, 0, this, [](void* context, std::int32_t id, regista_role_facts* out) -> std::int32_t {
              const RoleFacts& roles = of(context).owner_->roles_;
              regista_role_facts facts{};
              if (!roles || !roles(id, facts)) return 0;
              write_known(facts, out);
              return 1;
            }};
  budget_ = {sizeof budget_, 0, this, [](void* context, regista_budget* out) {
               const Answers& answers = of(context).owner_->answers_;
               write_known(answers.budget ? answers.budget() : regista_budget{}, out);
             }};
}

const void* InstanceExtensions::find(std::string_view id) const {
  if (id == REGISTA_LOG_EXTENSION) return &log_;
  if (id == REGISTA_DRAW_EXTENSION) return &draw_;
  if (id == REGISTA_METRIC_EXTENSION) return &metric_reports_;
  if (id == REGISTA_PASS_EXTENSION) return &pass_;
  if (id == REGISTA_TOLD_EXTENSION) return &told_;
  if (id == REGISTA_BUDGET_EXTENSION) return &budget_;
  if (id == REGISTA_ROLES_EXTENSION) return &roles_;
  return nullptr;
}

void InstanceExtensions::begin_call() {
  if (std::exchange(counted_in_, owner_->decision_) != owner_->decision_)
    log_use_.lines = draw_use_.shapes = draw_use_.points = 0;
}

const InstanceExtensions& Extensions::open(const plugin::Found& plugin, std::span<const int> metrics) {
  return *instances_.emplace_back(
      std::make_unique<InstanceExtensions>(*this, plugin, metrics, static_cast<int>(instances_.size())));
}

void Extensions::begin(double time) {
  log_.begin(time);
  drawings_.begin();
  pass_.reset();
  ++decision_;
}

}  // namespace regista::mind
