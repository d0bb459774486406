// SPDX-License-Identifier: MIT
// The functions that a plugin calls.
#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <regista/extensions/known_size.hpp>
#include <regista/testkit/recording_host.hpp>

namespace regista::testkit {

namespace {

// What is allocated while it lives is the host's own.
class OwnAllocations {
 public:
  explicit OwnAllocations(RecordingHost& host) : host_(host), before_(now()) {}
  ~OwnAllocations() { host_.own_allocations += now() - before_; }
  OwnAllocations(const OwnAllocations&) = delete;
  OwnAllocations& operator=(const OwnAllocations&) = delete;

 private:
  std::size_t now() const { return host_.allocated == nullptr ? 0 : host_.allocated(); }
  RecordingHost& host_;
  std::size_t before_;
};

}  // namespace

RecordingHost::RecordingHost(std::uint32_t bytes_free, const Layout& layout)
    : layout_(layout), bytes_free_(bytes_free) {
  regista_host raw{};
  raw.context = this;
  raw.offer = [](void* context, const std::uint8_t* bytes, std::uint32_t count, double urgency, double expiry,
                 std::int32_t medium, std::uint64_t replaces) {
    return static_cast<RecordingHost*>(context)->offer(bytes, count, urgency, expiry, medium, replaces);
  };
  raw.withdraw = [](void* context, std::uint64_t handle) {
    for (Offered& each : static_cast<RecordingHost*>(context)->offers) {
      if (each.handle == handle) each.withdrawn = true;
    }
  };
  raw.bytes_free = [](void* context) { return static_cast<RecordingHost*>(context)->bytes_free_; };
  raw.extension = [](void* context, const char* id) {
    return static_cast<const RecordingHost*>(context)->extension(id);
  };
  log_ = {sizeof log_, 0, this, [](void* context, std::int32_t level, const char* text, std::uint32_t length) {
            auto* const host = static_cast<RecordingHost*>(context);
            const OwnAllocations own(*host);
            host->log.push_back({level, {text, length}});
          }};
  draw_ = {sizeof draw_, 0, this, [](void*) -> std::int32_t { return 1; },
           [](void* context, const regista_shape* shape) {
             if (shape != nullptr) static_cast<RecordingHost*>(context)->draw(*shape);
           }};
  reports_ = {sizeof reports_, 0, this, [](void* context, std::uint32_t metric, double value) {
                static_cast<RecordingHost*>(context)->report(metric, value);
              }};
  pass_ = {sizeof pass_, 0, this, [](void* context, std::int32_t meant) {
             auto* const host = static_cast<RecordingHost*>(context);
             const OwnAllocations own(*host);
             if (meant < 1) host->break_rule("pass: meant for robot " + std::to_string(meant));
             host->receivers.push_back(meant);
           }};
  told_ = {sizeof told_,
           0,
           this,
           [](void* context, std::int32_t number, regista_told_packet* out) -> std::int32_t {
             const auto* const host = static_cast<const RecordingHost*>(context);
             if (number < 1 || static_cast<std::size_t>(number) > host->told.size()) return 0;
             const auto& packet = host->told[static_cast<std::size_t>(number - 1)];
             if (packet) write_known(*packet, out);
             return packet ? 1 : 0;
           },
           [](void* context) -> std::int32_t { return static_cast<const RecordingHost*>(context)->sees_ball ? 1 : 0; },
           [](void* context) -> std::int32_t { return static_cast<const RecordingHost*>(context)->receiver; }};
  roles_ = {sizeof roles_, 0, this, [](void* context, std::int32_t id, regista_role_facts* out) -> std::int32_t {
              const auto& all = static_cast<const RecordingHost*>(context)->roles;
              if (id < 0 || static_cast<std::size_t>(id) >= all.size()) return 0;
              write_known(all[static_cast<std::size_t>(id)], out);
              return 1;
            }};
  budget_ = {sizeof budget_, 0, this, [](void* context, regista_budget* out) {
               write_known(static_cast<const RecordingHost*>(context)->budget, out);
             }};
  raw_ = Grown<regista_host>(raw, layout);
  raw_.make_read_only();
}

regista_budget RecordingHost::whole_budget() {
  regista_budget out{};
  out.size = sizeof out;
  out.packets_left = 1200;
  out.line = 1154.0;  // at the first whistle
  out.match_time_left = 1200.0;
  out.since_own = out.since_team = 5.0;
  out.bytes_free = 64;
  out.share = 1.0;
  return out;
}

const void* RecordingHost::extension(const char* id) const {
  const std::string_view name = id;
  if (name == REGISTA_LOG_EXTENSION) return &log_;
  if (name == REGISTA_DRAW_EXTENSION) return &draw_;
  if (name == REGISTA_METRIC_EXTENSION) return &reports_;
  if (name == REGISTA_PASS_EXTENSION) return &pass_;
  if (name == REGISTA_TOLD_EXTENSION) return &told_;
  if (name == REGISTA_BUDGET_EXTENSION) return &budget_;
  if (name == REGISTA_ROLES_EXTENSION) return &roles_;
  return nullptr;
}

void RecordingHost::set_metrics(const regista_descriptor& plugin) {
  const void* const found = plugin.extension == nullptr ? nullptr : plugin.extension(REGISTA_METRIC_EXTENSION);
  metric_count_ = found == nullptr ? 0 : static_cast<const regista_metrics*>(found)->count;
}

std::string RecordingHost::take_broken() { return std::exchange(broken_, {}); }

void RecordingHost::break_rule(std::string rule) {
  if (broken_.empty()) broken_ = std::move(rule);
}

void RecordingHost::draw(const regista_shape& shape) {
  const OwnAllocations own(*this);
  ++shapes;
  if (shape.size < sizeof shape) return break_rule("drew a shape whose size field says " + std::to_string(shape.size));
  if (shape.layer == nullptr || *shape.layer == '\0') return break_rule("drew a shape that names no layer");
  const std::string layer = std::string("drew in layer ") + shape.layer + ' ';
  if (shape.shape < REGISTA_SHAPE_POINTS || shape.shape > REGISTA_SHAPE_TEXT) {
    return break_rule(layer + "a shape that does not exist: " + std::to_string(shape.shape));
  }
  if (shape.shape == REGISTA_SHAPE_TEXT && shape.text == nullptr) return break_rule(layer + "a text that is null");
  if (shape.count == 0 || shape.points == nullptr) return break_rule(layer + "a shape without points");
  if (shape.count > REGISTA_DRAW_MOST_POINTS) {
    return break_rule(layer + "a shape of " + std::to_string(shape.count) + " points");
  }
  if (!(shape.width >= 0.0 && shape.width <= 10.0)) return break_rule(layer + "a shape without a sound width");
  for (std::uint32_t i = 0; i < shape.count; ++i) {
    if (!(std::abs(shape.points[i].x) <= 1e4 && std::abs(shape.points[i].y) <= 1e4)) {
      return break_rule(layer + "a point that is nowhere");
    }
  }
}

void RecordingHost::report(std::uint32_t metric, double value) {
  const OwnAllocations own(*this);
  if (metric >= metric_count_) {
    return break_rule("reported metric " + std::to_string(metric) + " of " + std::to_string(metric_count_));
  }
  if (!(std::abs(value) <= 1e9)) {
    return break_rule("reported " + std::to_string(value) + " as metric " + std::to_string(metric));
  }
  reports.push_back({metric, value});
}

std::uint64_t RecordingHost::offer(const std::uint8_t* bytes, std::uint32_t count, double urgency, double expiry,
                                   std::int32_t medium, std::uint64_t replaces) {
  const OwnAllocations own(*this);
  const bool sound =
      count <= bytes_free_ && urgency >= 0.0 && urgency <= 1.0 && medium == REGISTA_MEDIUM_RADIO && expiry > time_;
  const auto earlier = std::ranges::find_if(
      offers, [replaces](const Offered& each) { return replaces != 0 && each.handle == replaces && each.waits(); });
  const auto waiting = static_cast<std::size_t>(std::ranges::count_if(offers, &Offered::waits));
  const bool full = earlier == offers.end() && waiting >= most_pending_;
  if (!sound || full) return ++refused, 0;
  if (earlier != offers.end()) earlier->replaced = true;
  offers.push_back({++last_handle_, {bytes, bytes + count}, urgency, expiry, medium, replaces});
  return last_handle_;
}

}  // namespace regista::testkit
