// SPDX-License-Identifier: MIT
#include "recording/label_placement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

namespace regista::recording::picture {
namespace {

constexpr double gap = 3.0;  // px between a label and its object

// A place of a label: its offset from the centre of the object. across, down: multiples of the distance between this
// centre and the label's nearest edge, which `away` (px) enlarges. of_width, of_height: multiples of half the label's
// size.
struct Offset {
  double across, down, of_width, of_height, away = 0.0;
};

constexpr std::array<Offset, 8> near{{{0, 1, 0, 1},
                                      {0, -1, 0, -1},
                                      {1, 0, 1, 0},
                                      {-1, 0, -1, 0},
                                      {0.7, 0.7, 1, 1},
                                      {-0.7, 0.7, -1, 1},
                                      {0.7, -0.7, 1, -1},
                                      {-0.7, -0.7, -1, -1}}};

std::vector<Offset> far_offsets() {
  constexpr int directions = 12;
  std::vector<Offset> out;
  for (const double away : {16.0, 28.0, 42.0, 58.0}) {
    for (int i = 0; i < directions; ++i) {
      const double angle = (i + 0.5) * 2.0 * std::numbers::pi / directions;
      out.push_back({std::cos(angle), std::sin(angle), std::cos(angle), std::sin(angle), away});
    }
  }
  return out;
}

bool meet(const Area& a, const Area& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

std::optional<Area> area_at(const WantedLabel& label, const Offset& offset, const Area& within) {
  const double reach = label.radius + gap + offset.away, half_width = label.width / 2.0,
               half_height = label.height / 2.0;
  double x = label.x + offset.across * reach + offset.of_width * half_width;
  const double y = label.y + offset.down * reach + offset.of_height * half_height;
  // The edge of the picture may push a label aside that stands above or below its object.
  if (offset.across == 0.0) x = std::min(within.right - half_width, std::max(within.left + half_width, x));
  const Area out{x - half_width, y - half_height, x + half_width, y + half_height};
  const bool inside =
      out.left >= within.left && out.top >= within.top && out.right <= within.right && out.bottom <= within.bottom;
  return inside ? std::optional(out) : std::nullopt;
}

// Returns an estimate of the width of a text in px. letter: size of the letters in px.
double width_of(std::string_view words, double letter) {
  constexpr double mean = 0.56;  // width of a letter of Arial in names of roles, in sizes of letters
  const auto begins_letter = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0u) != 0x80u; };
  return mean * letter * static_cast<double>(std::ranges::count_if(words, begins_letter)) + 3.0;
}

// Draws the line from the rim of an object to the nearest point of its label at (x, y).
texts::Html line_to(const WantedLabel& of, double x, double y) {
  const double to_x = std::clamp(of.x, x - of.width / 2.0, x + of.width / 2.0),
               to_y = std::clamp(of.y, y - of.height / 2.0, y + of.height / 2.0),
               length = std::hypot(to_x - of.x, to_y - of.y);
  if (length <= of.radius) return {};
  const double share = of.radius / length;
  return texts::drawn(R"(<path class="lead" d="M{:.1f} {:.1f}L{:.1f} {:.1f}"/>)", of.x + share * (to_x - of.x),
                      of.y + share * (to_y - of.y), to_x, to_y);
}

}  // namespace

std::vector<std::optional<PlacedLabel>> place_labels(std::span<const WantedLabel> labels, std::span<const Area> taken,
                                                     const Area& within) {
  const std::vector<Offset> far = far_offsets();
  std::vector<Area> full(taken.begin(), taken.end());
  std::vector<std::optional<PlacedLabel>> out;
  for (const WantedLabel& label : labels) {
    std::optional<PlacedLabel>& placed = out.emplace_back();
    const auto place_at_first = [&](std::span<const Offset> offsets, bool is_far) {
      for (const Offset& offset : offsets) {
        const std::optional<Area> area = area_at(label, offset, within);
        if (!area || std::ranges::any_of(full, [&](const Area& other) { return meet(*area, other); })) continue;
        full.push_back(*area);
        placed = {(area->left + area->right) / 2.0, (area->top + area->bottom) / 2.0, is_far};
        return;
      }
    };
    place_at_first(near, false);
    if (!placed && label.far) place_at_first(far, true);
  }
  return out;
}

void Labels::add(double x, double y, double radius, std::string words, const Style& style) {
  if (words.empty()) return;
  const double width = width_of(words, style.letter);
  labels_.push_back({std::move(words), {x, y, radius, width, style.letter + 2.0, style.far}, style});
}

texts::Html Labels::written(const Area& within) const {
  std::vector<Label> all = labels_;
  std::ranges::stable_sort(all, {}, [](const Label& each) { return each.style.rank; });
  std::vector<WantedLabel> wanted;
  for (const Label& each : all) wanted.push_back(each.wanted);
  const std::vector<std::optional<PlacedLabel>> places = place_labels(wanted, taken_, within);
  texts::Html lines, words;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!places[i]) continue;
    const auto& [x, y, far] = *places[i];
    if (far) lines << line_to(wanted[i], x, y);
    words << texts::label(x, y + 0.36 * all[i].style.letter, all[i].style.classes, all[i].words);
  }
  return lines << words;  // lines may pass below labels
}

}  // namespace regista::recording::picture
