// SPDX-License-Identifier: MIT
#include "process/kept_output.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace regista::process {

void KeptOutput::add(std::string_view text) {
  const std::size_t room = most_each - first_.size();
  first_.append(text.substr(0, room));
  text.remove_prefix(std::min(room, text.size()));
  last_.append(text);
  if (last_.size() <= most_each) return;
  const std::size_t too_many = last_.size() - most_each;
  left_out_ += too_many;
  last_.erase(0, too_many);
}

std::string KeptOutput::text() const {
  if (left_out_ == 0) return first_ + last_;
  return fmt::format("{}\n[{} bytes are left out]\n{}", first_, left_out_, last_);
}

}  // namespace regista::process
