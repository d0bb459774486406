// SPDX-License-Identifier: MIT
// Numbers of a report as text. A minus stands before no number of which all digits shown are zero: it would look like a
// finding.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

namespace regista::report {

inline bool shows_nothing(double value, const std::string& text) {
  return std::isfinite(value) && text.find_first_of("123456789") == std::string::npos;
}

// With so many digits behind the point: "12.50", "-0.07", "-inf".
inline std::string fixed(double value, int digits) {
  std::string out = fmt::format("{:.{}f}", value, digits);
  return out.front() == '-' && shows_nothing(value, out) ? out.substr(1) : out;
}

// The same, with a plus before what is not negative: "+0.159".
inline std::string with_sign(double value, int digits) {
  std::string out = fmt::format("{:+.{}f}", value, digits);
  if (shows_nothing(value, out)) out.front() = '+';
  return out;
}

inline std::string p_text(double p) { return p < 0.0001 ? "p < 0.0001" : fmt::format("p = {:.2g}", p); }

}  // namespace regista::report
