// SPDX-License-Identifier: MIT
// The functions that a plugin calls.
#include <regista/testkit/recording_host.hpp>

namespace regista::testkit {

RecordingHost::RecordingHost(std::uint32_t bytes_free, Growth growth) : bytes_free_(bytes_free) {
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
  raw.extension = [](void*, const char*) -> const void* { return nullptr; };
  raw_ = Grown<regista_host>(raw, growth);
}

std::uint64_t RecordingHost::offer(const std::uint8_t* bytes, std::uint32_t count, double urgency, double expiry,
                                   std::int32_t medium, std::uint64_t replaces) {
  const bool sound =
      count <= bytes_free_ && urgency >= 0.0 && urgency <= 1.0 && medium == REGISTA_MEDIUM_RADIO && expiry > time_;
  if (!sound) return ++refused, 0;
  offers.push_back({++last_handle_, {bytes, bytes + count}, urgency, expiry, medium, replaces});
  return last_handle_;
}

}  // namespace regista::testkit
