// SPDX-License-Identifier: MIT
// Writes numbers and estimates of all reports as text, as JSON and as fields of CSV. A number whose digits are all zero
// gets no minus, because "-0.00" would look like a finding.
#pragma once

#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "statistics/moments.hpp"
#include "study/paired_estimates.hpp"

namespace regista::report {

using Json = nlohmann::ordered_json;

// Returns whether all digits in the text of a number are zero.
inline bool shows_nothing(double value, const std::string& text) {
  return std::isfinite(value) && text.find_first_of("123456789") == std::string::npos;
}

// Formats a number with `digits` decimals: "12.50", "-0.07", "-inf".
inline std::string fixed(double value, int digits) {
  std::string out = fmt::format("{:.{}f}", value, digits);
  return out.front() == '-' && shows_nothing(value, out) ? out.substr(1) : out;
}

// Formats like fixed(), with a plus sign for positive numbers and zero: "+0.159".
inline std::string with_sign(double value, int digits) {
  std::string out = fmt::format("{:+.{}f}", value, digits);
  if (shows_nothing(value, out)) out.front() = '+';
  return out;
}

inline std::string p_text(double p) { return p < 0.0001 ? "p < 0.0001" : fmt::format("p = {:.2g}", p); }

// --- Estimates. The parameter `digits` is the number of decimals. Functions without this parameter choose the number
// of decimals by the width of the interval.

// "[-0.07, 0.12]"
std::string interval_text(const statistics::Interval& interval, int digits);
// "[-0.07, +0.12]"; an infinite end is ∞.
std::string signed_interval_text(const statistics::Interval& interval, int digits);
// "+0.03 [-0.07, +0.12]"; with one bound "+0.03 (at least -0.07)" or "at least -0.07"; else "+0.03 (no interval)".
std::string signed_text(const statistics::Estimate& estimate, int digits);
// "12.50 +/- 3.10". An estimate that lacks a bound has the form of signed_text(), but without a plus sign.
std::string with_margin(const statistics::Estimate& estimate);

double half_width(const std::optional<statistics::Interval>& interval);  // 0 without an interval
// Rounds to a number of decimals that fits `margin`, half the width of the interval. No exponent: "12.3", "0.045".
std::string rounded(double value, double margin);
std::string rounded_with_sign(double value, double margin);  // like rounded(), with a plus before a number >= 0
// "3.21 ± 0.40"; "3.21" without an interval, "-" without pairs.
std::string estimate_text(const study::MeanEstimate& estimate);

// Returns whether the interval has two ends that differ by more than rounding.
bool has_width(const statistics::Interval& interval);
// "0.85 [0.40, 1.30]"; "0.85" if the interval has no width, "-" without pairs.
std::string with_interval(const study::MeanEstimate& estimate);
// "+0.85 [0.40, 1.30]"
std::string signed_with_interval(const statistics::Estimate& estimate);
std::string signed_with_interval(const study::MeanEstimate& difference);

// These functions write null for a missing value and for an infinite number, because JSON has no infinity.
Json json_number(double value);
Json json_or_null(const std::optional<double>& value);
Json json_of(const statistics::Interval& interval);
Json json_of(const study::MeanEstimate& estimate);

// Returns the document as text with a newline at the end: in one line, or with `indent` spaces per level. File names
// may contain bytes that are not UTF-8; the function replaces them.
std::string text_of(const Json& json, int indent = -1);

// Returns a text as a field of CSV (RFC 4180). Not for numbers. A spreadsheet program runs a field as a formula if the
// field begins with = + - @, a tab or a carriage return. So such a field gets a ' in front (OWASP, "CSV Injection").
inline std::string csv_field(std::string_view text) {
  std::string out;
  if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos) out += '\'';
  out += text;
  const bool blanks = out.starts_with(' ') || out.ends_with(' ') || out.ends_with('\t');  // readers cut them off
  if (!blanks && out.find_first_of(",\"\r\n") == std::string::npos) return out;
  std::string quoted = "\"";
  for (const char c : out) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace regista::report
