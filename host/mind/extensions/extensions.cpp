// SPDX-License-Identifier: MIT
#include "mind/extensions/extensions.hpp"

namespace regista::mind {

InstanceExtensions::InstanceExtensions(Extensions& owner, const plugin::Found& plugin, std::span<const int> metrics,
                                       int place)
    : owner_(&owner), plugin_(&plugin), metrics_(metrics), place_(place) {
  log_use_.plugin = draw_use_.plugin = plugin.descriptor->id;
  log_use_.place = draw_use_.place = place;
  log_ = {sizeof log_, 0, this, [](void* context, std::int32_t level, const char* text, std::uint32_t length) {
            auto& self = *static_cast<InstanceExtensions*>(context);
            if (text == nullptr) length = 0;
            if (!self.owner_->muted_) self.owner_->log_.write(self.log_use_, level, {text, length});
          }};
  draw_ = {sizeof draw_, 0, this,
           [](void* context) -> std::int32_t {
             return static_cast<InstanceExtensions*>(context)->owner_->drawings_.wanted() ? 1 : 0;
           },
           [](void* context, const regista_shape* shape) {
             auto& self = *static_cast<InstanceExtensions*>(context);
             if (shape != nullptr && !self.owner_->muted_) self.owner_->drawings_.draw(self.draw_use_, *shape);
           }};
  metric_reports_ = {sizeof metric_reports_, 0, this, [](void* context, std::uint32_t metric, double value) {
                       auto& self = *static_cast<InstanceExtensions*>(context);
                       if (!self.owner_->muted_) {
                         self.owner_->metrics_.report(*self.plugin_, self.metrics_, self.place_, metric, value);
                       }
                     }};
  pass_ = {sizeof pass_, 0, this, [](void* context, std::int32_t receiver) {
             auto& self = *static_cast<InstanceExtensions*>(context);
             if (!self.owner_->muted_) self.owner_->pass_ = {self.plugin_, receiver};
           }};
}

const void* InstanceExtensions::find(std::string_view id) const {
  if (id == REGISTA_LOG_EXTENSION) return &log_;
  if (id == REGISTA_DRAW_EXTENSION) return &draw_;
  if (id == REGISTA_METRIC_EXTENSION) return &metric_reports_;
  if (id == REGISTA_PASS_EXTENSION) return &pass_;
  return nullptr;
}

void InstanceExtensions::begin_decision() { log_use_.lines = draw_use_.shapes = draw_use_.points = 0; }

const InstanceExtensions& Extensions::open(const plugin::Found& plugin, std::span<const int> metrics) {
  return *instances_.emplace_back(
      std::make_unique<InstanceExtensions>(*this, plugin, metrics, static_cast<int>(instances_.size())));
}

void Extensions::begin(double time) {
  log_.begin(time);
  drawings_.begin();
  pass_.reset();
  for (const auto& each : instances_) each->begin_decision();
}

}  // namespace regista::mind
