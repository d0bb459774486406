// SPDX-License-Identifier: MIT
#include "report/fingerprint.hpp"

#include <fmt/format.h>

#include "plugin/content_hash.hpp"

namespace regista::report {

void Fingerprint::take(std::uint64_t index, const campaign::Decided& decided) {
  std::string line = fmt::format("{} {} {}:{} {}", text_, index, decided.score[0], decided.score[1], decided.hash);
  if (decided.failure) line += campaign::to_json(*decided.failure);
  if (decided.set_aside()) line += " set aside";
  text_ = plugin::content_hash(line);
}

}  // namespace regista::report
