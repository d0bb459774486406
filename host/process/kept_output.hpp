// SPDX-License-Identifier: MIT
// What a worker wrote to standard error: the beginning and the end of it, however much there was.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace regista::process {

class KeptOutput {
 public:
  void add(std::string_view text);
  // "...", with a line in the middle that says how many bytes are left out.
  std::string text() const;

 private:
  static constexpr std::size_t most_each = 4096;  // bytes of the beginning, and of the end
  std::string first_, last_;
  std::uint64_t left_out_ = 0;
};

}  // namespace regista::process
