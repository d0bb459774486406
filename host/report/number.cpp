// SPDX-License-Identifier: MIT
#include "report/number.hpp"

#include <algorithm>
#include <functional>

#include "texts/json.hpp"

namespace regista::report {
namespace {

double shown_margin(const std::optional<statistics::Interval>& interval) {
  return interval && has_width(*interval) ? half_width(interval) : 0.0;
}

// Formats an end of an interval. If the rounded end looks like zero but is not zero, it gets more decimals.
std::string end_text(double end, double margin) {
  const std::string text = rounded(end, margin);
  return end != 0.0 && shows_nothing(end, text) ? rounded(end, std::abs(end)) : text;
}

std::string ends_text(const std::optional<statistics::Interval>& interval) {
  if (!interval || !has_width(*interval)) return {};
  const double margin = shown_margin(interval);
  return fmt::format(" [{}, {}]", end_text(interval->low, margin), end_text(interval->high, margin));
}

// Writes an estimate that has only one bound: "12.5 (at least 10.2)", or "at least 10.2" if the value is infinite.
std::string bound_text(const statistics::Estimate& estimate, const std::function<std::string(double)>& number) {
  const auto [low, high] = estimate.interval;
  const std::string bound = std::isfinite(low) ? "at least " + number(low) : "at most " + number(high);
  return std::isfinite(estimate.value) ? fmt::format("{} ({})", number(estimate.value), bound) : bound;
}

std::string number_text(const statistics::Estimate& estimate, const std::function<std::string(double)>& number) {
  if (!estimate.interval.unbounded()) return bound_text(estimate, number);
  if (!std::isfinite(estimate.value)) return estimate.value < 0.0 ? "-∞" : "∞";
  return number(estimate.value) + " (no interval)";
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
  const auto number = [digits](double value) { return with_sign(value, digits); };
  if (!estimate.interval.bounded()) return number_text(estimate, number);
  return fmt::format("{} {}", number(estimate.value), signed_interval_text(estimate.interval, digits));
}

std::string with_margin(const statistics::Estimate& estimate) {
  const auto number = [](double value) { return fixed(value, 2); };
  if (!estimate.interval.bounded()) return number_text(estimate, number);
  return fmt::format("{} +/- {:.2f}", number(estimate.value), estimate.margin());
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

Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json json_or_null(const std::optional<double>& value) { return value ? json_number(*value) : Json(nullptr); }

Json json_of(const statistics::Interval& interval) {
  return Json::array({json_number(interval.low), json_number(interval.high)});
}

Json json_of(const study::MeanEstimate& estimate) {
  const bool any = estimate.pairs > 0;
  return {{"pairs", estimate.pairs},
          {"mean", any ? Json(estimate.mean) : Json(nullptr)},
          {"standard_deviation", estimate.pairs > 1 ? Json(estimate.standard_deviation) : Json(nullptr)},
          {"interval", estimate.interval ? json_of(*estimate.interval) : Json(nullptr)}};
}

std::string text_of(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace regista::report
