// SPDX-License-Identifier: MIT
// A host for the mailbox that records what an instance offers and answers as the real one does. It has no extensions.
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

  explicit RecordingHost(std::uint32_t bytes_free = 64, Growth growth = {});
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
                      std::int32_t medium, std::uint64_t replaces);

  Grown<regista_host> raw_;
  std::uint32_t bytes_free_;
  std::uint64_t last_handle_ = 0;
  double time_ = 0.0;
};

}  // namespace regista::testkit
