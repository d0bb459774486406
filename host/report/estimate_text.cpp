// SPDX-License-Identifier: MIT
#include "report/estimate_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/number.hpp"

namespace regista::report {
namespace {

double shown_margin(const std::optional<statistics::Interval>& interval) {
  return interval && has_width(*interval) ? (interval->high - interval->low) / 2.0 : 0.0;
}

// An end beside nought must not look as if it were nought.
std::string end_text(double end, double margin) {
  const std::string text = rounded(end, margin);
  return end != 0.0 && shows_nothing(end, text) ? rounded(end, std::abs(end)) : text;
}

std::string ends_text(const std::optional<statistics::Interval>& interval) {
  if (!interval || !has_width(*interval)) return {};
  const double margin = shown_margin(interval);
  return fmt::format(" [{}, {}]", end_text(interval->low, margin), end_text(interval->high, margin));
}

}  // namespace

std::string interval_text(const statistics::Interval& interval, int digits) {
  return fmt::format("[{}, {}]", fixed(interval.low, digits), fixed(interval.high, digits));
}

std::string signed_interval_text(const statistics::Interval& interval, int digits) {
  const auto bound = [digits](double value) {
    return std::isfinite(value) ? with_sign(value, digits) : std::string(value < 0.0 ? "-∞" : "∞");
  };
  return fmt::format("[{}, {}]", bound(interval.low), bound(interval.high));
}

std::string signed_text(const statistics::Estimate& estimate, int digits) {
  if (!std::isfinite(estimate.value)) return estimate.value < 0.0 ? "-∞" : "∞";
  const std::string value = with_sign(estimate.value, digits);
  if (estimate.interval.unbounded()) return value + " (no interval)";
  return fmt::format("{} {}", value, signed_interval_text(estimate.interval, digits));
}

std::string with_margin(const statistics::Estimate& estimate) {
  const std::string value = fixed(estimate.value, 2);
  if (estimate.interval.bounded()) return fmt::format("{} +/- {:.2f}", value, estimate.margin());
  if (estimate.interval.unbounded()) return value + " (no interval)";
  return fmt::format("{} {}", value, interval_text(estimate.interval, 2));
}

double half_width(const std::optional<statistics::Interval>& interval) {
  return interval ? (interval->high - interval->low) / 2.0 : 0.0;
}

std::string rounded(double value, double margin) {
  const double size = margin > 0.0 ? margin : std::abs(value) / 10.0;
  const int digits = size > 0.0 ? std::clamp(1 - static_cast<int>(std::floor(std::log10(size))), 0, 6) : 2;
  return fixed(value, digits);
}

std::string rounded_with_sign(double value, double margin) {
  const std::string text = rounded(value, std::isfinite(margin) ? margin : 0.0);
  return text.starts_with('-') ? text : '+' + text;
}

std::string estimate_text(const study::MeanEstimate& estimate) {
  if (estimate.pairs == 0) return "-";
  if (!estimate.interval) return rounded(estimate.mean, 0.0);
  const double margin = half_width(estimate.interval);
  return fmt::format("{} ± {}", rounded(estimate.mean, margin), rounded(margin, margin));
}

bool has_width(const statistics::Interval& interval) {
  constexpr double rounding = 1e-9;
  return interval.bounded() &&
         interval.high - interval.low > rounding * std::max(std::abs(interval.low), std::abs(interval.high));
}

std::string with_interval(const study::MeanEstimate& estimate) {
  if (estimate.pairs == 0) return "-";
  return rounded(estimate.mean, shown_margin(estimate.interval)) + ends_text(estimate.interval);
}

std::string signed_with_interval(const statistics::Estimate& estimate) {
  return rounded_with_sign(estimate.value, shown_margin(estimate.interval)) + ends_text(estimate.interval);
}

std::string signed_with_interval(const study::MeanEstimate& difference) {
  if (difference.pairs == 0) return "-";
  return rounded_with_sign(difference.mean, shown_margin(difference.interval)) + ends_text(difference.interval);
}

}  // namespace regista::report
