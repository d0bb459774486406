// SPDX-License-Identifier: MIT
#include "recording/typed_moment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <system_error>

#include "config/bad_input.hpp"
#include "texts/message.hpp"
#include "texts/visible.hpp"

namespace regista::recording {
namespace {

template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number out{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return out;
}

}  // namespace

Moment parse_moment(const std::string& typed) {
  const auto refuse = [&] {
    throw config::BadInput(
        fmt::format("--at: {}; wanted is the time since the match began, 7:42 or 462.3, or the clock of a half, 2/7:42",
                    texts::in_quotes(typed)));
  };
  Moment out;
  out.typed = typed;
  std::string_view rest = typed;
  if (const std::size_t slash = rest.find('/'); slash != std::string_view::npos) {
    const auto half = number_in<int>(rest.substr(0, slash));
    if (!half || *half < 1 || *half > 99) refuse();
    out.half = *half;
    rest.remove_prefix(slash + 1);
  }
  double minutes = 0.0;
  if (const std::size_t colon = rest.find(':'); colon != std::string_view::npos) {
    const auto whole = number_in<int>(rest.substr(0, colon));
    if (!whole || *whole < 0) refuse();
    minutes = *whole;
    rest.remove_prefix(colon + 1);
  }
  const auto seconds = number_in<double>(rest);
  if (!seconds || !(*seconds >= 0.0) || *seconds > 1e6) refuse();
  // 7:4 may mean 7:40 as well as 7:04.
  const bool two_digits = rest.size() == 2 || (rest.size() > 2 && rest[2] == '.');
  if (typed.find(':') != std::string::npos && (*seconds >= 60.0 || !two_digits)) refuse();
  out.seconds = 60.0 * minutes + *seconds;
  return out;
}

RobotName parse_robot(const std::string& typed, int team_size) {
  std::string_view rest = typed;
  RobotName out;
  if (rest.starts_with("home/")) {
    rest.remove_prefix(5);
  } else if (rest.starts_with("away/")) {
    out.side = 1;
    rest.remove_prefix(5);
  }
  const auto number = number_in<int>(rest);
  if (!number || *number < 1 || *number > team_size) {
    throw config::BadInput(fmt::format("--robot: {}; wanted is 1 to {}, home/1 to home/{} or away/1 to away/{}",
                                       texts::in_quotes(typed), team_size, team_size, team_size));
  }
  out.number = *number;
  return out;
}

void keep_layers(std::vector<RecordedDrawing>& drawings, const std::vector<std::string>& typed) {
  if (typed.empty()) return;
  const auto is_meant = [](const RecordedDrawing& drawing, const std::string& name) {
    return name == drawing.layer || name == drawing.name();
  };
  for (const std::string& name : typed) {
    if (std::ranges::any_of(drawings, [&](const auto& drawing) { return is_meant(drawing, name); })) continue;
    if (drawings.empty()) {
      throw config::BadInput(
          fmt::format("--layer {}: no plugin of this robot has drawn anything by then", texts::in_quotes(name)));
    }
    // Under the same kind of name as was typed, for "cells" and "voronoi: cells" are far from each other.
    constexpr std::size_t longest = 60;
    const bool with_plugin = name.find(": ") != std::string::npos;
    std::vector<std::string> known;
    for (const RecordedDrawing& drawing : drawings) {
      const std::string each = texts::visible_at_most(with_plugin ? drawing.name() : drawing.layer, longest);
      if (std::ranges::find(known, each) == known.end()) known.push_back(each);
    }
    throw config::BadInput("--layer: " + texts::unknown("layer", name, "the drawings of this robot", known));
  }
  for (RecordedDrawing& drawing : drawings) {
    const bool kept = std::ranges::any_of(typed, [&](const std::string& name) { return is_meant(drawing, name); });
    if (!kept) drawing.shapes.clear();
  }
}

double time_of(const RecordedMatch& match, const Moment& moment) {
  if (moment.half == 0) {
    if (moment.seconds <= match.end() + 1e-9) return std::max(moment.seconds, match.begin());
    throw config::BadInput(fmt::format("--at {}: the recording ends at {:.1f} s", moment.typed, match.end()));
  }
  if (const auto time = match.time_of(moment.half, moment.seconds)) return *time;
  throw config::BadInput(
      fmt::format("--at {}: the clock of half {} does not show that in this recording, which ends {:.1f} s "
                  "after the match began",
                  moment.typed, moment.half, match.end()));
}

}  // namespace regista::recording
