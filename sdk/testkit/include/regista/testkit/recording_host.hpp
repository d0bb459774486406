// SPDX-License-Identifier: MIT
// A host for the mailbox that records what an instance offers and answers as the real one does.
#pragma once

#include <cstdint>
#include <vector>

#include <regista/testkit/storage.hpp>

namespace regista::testkit {

class RecordingHost {
 public:
  struct Offered {
    std::uint64_t handle;
    std::vector<std::uint8_t> bytes;
    double urgency, expiry;
    std::int32_t medium;
    std::uint64_t replaces;  // 0 = none
    bool withdrawn = false;
  };

  explicit RecordingHost(std::uint32_t bytes_free = 64, Growth growth = {}) : bytes_free_(bytes_free) {
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
    raw_ = Grown<regista_host>(raw, growth);
  }
  RecordingHost(const RecordingHost&) = delete;
  RecordingHost& operator=(const RecordingHost&) = delete;

  const regista_host* raw() const { return &raw_.get(); }
  void set_bytes_free(std::uint32_t bytes) { bytes_free_ = bytes; }
  // Match time, against which an offer may be expired already.
  void set_time(double seconds) { time_ = seconds; }

  std::vector<Offered> offers;  // accepted, in order
  unsigned refused = 0;

 private:
  std::uint64_t offer(const std::uint8_t* bytes, std::uint32_t count, double urgency, double expiry,
                      std::int32_t medium, std::uint64_t replaces) {
    const bool sound =
        count <= bytes_free_ && urgency >= 0.0 && urgency <= 1.0 && medium == REGISTA_MEDIUM_RADIO && expiry > time_;
    if (!sound) return ++refused, 0;
    offers.push_back({++last_handle_, {bytes, bytes + count}, urgency, expiry, medium, replaces});
    return last_handle_;
  }

  Grown<regista_host> raw_;
  std::uint32_t bytes_free_;
  std::uint64_t last_handle_ = 0;
  double time_ = 0.0;
};

}  // namespace regista::testkit
