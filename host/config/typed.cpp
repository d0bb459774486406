// SPDX-License-Identifier: MIT
#include "config/typed.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <system_error>

#include "config/bad_input.hpp"
#include "texts/message.hpp"

namespace regista::config {

std::optional<double> typed_number(std::string_view text) {
  double value = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

double parse_rate(const std::string& option, const std::string& text) {
  const auto rate = typed_number(text);
  if (!rate || !(*rate > 0.0 && *rate < 1.0)) {
    throw BadInput(fmt::format("{}: {}; expected a number above 0 and below 1", option, texts::in_quotes(text)));
  }
  return *rate;
}

std::uint64_t parse_whole(const std::string& option, const std::string& text, std::uint64_t least, std::uint64_t most) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || value < least || value > most) {
    throw BadInput(
        fmt::format("{}: {}; expected a whole number from {} to {}", option, texts::in_quotes(text), least, most));
  }
  return value;
}

}  // namespace regista::config
