// SPDX-License-Identifier: MIT
#include "recording/field_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "mind/coordination/coordination.hpp"
#include "texts/message.hpp"

namespace regista::recording::picture {
namespace {

constexpr double farthest = 1e9;  // coordinates are clamped to +-1e9, so that no difference overflows

Point bounded(const Point& p) { return {std::clamp(p[0], -farthest, farthest), std::clamp(p[1], -farthest, farthest)}; }

// One edge of the rectangle. It bounds x (axis 0) or y (axis 1): inside, sign * coordinate <= sign * limit.
struct Edge {
  std::size_t axis;
  double sign, limit;

  double beyond(const Point& p) const { return sign * (p[axis] - limit); }
  Point crossing(const Point& a, const Point& b) const {
    const double share = beyond(a) / (beyond(a) - beyond(b));
    Point out{a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])};
    out[axis] = limit;
    return out;
  }
};

std::array<Edge, 4> edges(const Rectangle& r) {
  return {{{0, -1.0, r.left}, {0, 1.0, r.right}, {1, -1.0, r.low}, {1, 1.0, r.high}}};
}

constexpr double gap = 3.0;  // px between a label and its object

// A label's place: its offset from the object's centre. across, down: multiples of the distance between this centre and
// the label's nearest edge, which `away` (px) enlarges. of_width, of_height: multiples of half the label's size.
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
Html line_to(const WantedLabel& of, double x, double y) {
  const double to_x = std::clamp(of.x, x - of.width / 2.0, x + of.width / 2.0),
               to_y = std::clamp(of.y, y - of.height / 2.0, y + of.height / 2.0),
               length = std::hypot(to_x - of.x, to_y - of.y);
  if (length <= of.radius) return {};
  const double share = of.radius / length;
  return drawn(R"(<path class="lead" d="M{:.1f} {:.1f}L{:.1f} {:.1f}"/>)", of.x + share * (to_x - of.x),
               of.y + share * (to_y - of.y), to_x, to_y);
}

}  // namespace

std::vector<std::vector<Point>> clipped_line(std::span<const Point> line, const Rectangle& to) {
  std::vector<std::vector<Point>> out;
  bool goes_on = false;  // true: the last piece ends where the next segment begins
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    Point a = bounded(line[i]), b = bounded(line[i + 1]);
    bool inside = true, cut_at_end = false;
    for (const Edge& edge : edges(to)) {
      const double from_a = edge.beyond(a), from_b = edge.beyond(b);
      inside = inside && (from_a <= 0.0 || from_b <= 0.0);
      if (!inside) break;
      if (from_a > 0.0) {
        a = edge.crossing(a, b);
        goes_on = false;
      } else if (from_b > 0.0) {
        b = edge.crossing(a, b);
        cut_at_end = true;
      }
    }
    if (!inside) {
      goes_on = false;
      continue;
    }
    if (!goes_on) out.push_back({a});
    out.back().push_back(b);
    goes_on = !cut_at_end;
  }
  return out;
}

std::vector<Point> clipped_polygon(std::span<const Point> corners, const Rectangle& to) {
  std::vector<Point> out;
  for (const Point& corner : corners) out.push_back(bounded(corner));
  for (const Edge& edge : edges(to)) {
    std::vector<Point> before;
    before.swap(out);
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Point &a = before[i == 0 ? before.size() - 1 : i - 1], &b = before[i];
      const double from_a = edge.beyond(a), from_b = edge.beyond(b);
      if ((from_a > 0.0) != (from_b > 0.0)) out.push_back(edge.crossing(a, b));
      if (from_b <= 0.0) out.push_back(b);
    }
  }
  return out;
}

Html field_lines(const config::FieldSize& field, const Scale& to) {
  Html out;
  const auto box = [&](double x0, double y0, double x1, double y1) {
    out << drawn(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)", to.x(std::min(x0, x1)),
                 to.y(std::max(y0, y1)), std::abs(x1 - x0) * to.per_metre, std::abs(y1 - y0) * to.per_metre);
  };
  const double x = field.length / 2.0, y = field.width / 2.0;
  out << drawn(R"(<rect class="grass" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)", to.left, to.top,
               2.0 * to.half_length * to.per_metre, 2.0 * to.half_width * to.per_metre);
  out << R"(<g class="line">)"_html;
  box(-x, -y, x, y);
  for (const double side : {-1.0, 1.0}) {
    box(side * x, -field.goal_area_width / 2.0, side * (x - field.goal_area_length), field.goal_area_width / 2.0);
    box(side * x, -field.penalty_area_width / 2.0, side * (x - field.penalty_area_length),
        field.penalty_area_width / 2.0);
    box(side * x, -field.goal_width / 2.0, side * (x + field.goal_depth), field.goal_width / 2.0);
    out << drawn(R"(<circle cx="{:.1f}" cy="{:.1f}" r="1.5"/>)", to.x(side * (x - field.penalty_mark_distance)),
                 to.y(0.0));
  }
  out << drawn(R"(<path d="M{:.1f} {:.1f}V{:.1f}"/><circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)", to.x(0.0), to.y(y),
               to.y(-y), to.x(0.0), to.y(0.0), field.centre_circle_diameter / 2.0 * to.per_metre);
  return out << "</g>"_html;
}

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

Html Labels::written(const Area& within) const {
  std::vector<Label> all = labels_;
  std::ranges::stable_sort(all, {}, [](const Label& each) { return each.style.rank; });
  std::vector<WantedLabel> wanted;
  for (const Label& each : all) wanted.push_back(each.wanted);
  const std::vector<std::optional<PlacedLabel>> places = place_labels(wanted, taken_, within);
  Html lines, words;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!places[i]) continue;
    const auto& [x, y, far] = *places[i];
    if (far) lines << line_to(wanted[i], x, y);
    words << label(x, y + 0.36 * all[i].style.letter, all[i].style.classes, all[i].words);
  }
  return lines << words;  // lines may pass below labels
}

}  // namespace regista::recording::picture

namespace regista::recording {
namespace {

using namespace picture;
using mind::Vector2d;

constexpr double page_width = 720.0, page_margin = 8.0, page_head = 20.0, marker = 7.0, letter = 12.0;  // px

Html arrow(const Vector2d& at, const Vector2d& towards, const Scale& to) {
  const Vector2d way = towards - at;
  if (way.norm() < 1e-6) return {};
  const Vector2d end = way.normalized() * (marker + 7.0);
  return drawn(R"(<path class="facing" d="M{:.1f} {:.1f}l{:.1f} {:.1f}"/>)", to.x(at.x()), to.y(at.y()), end.x(),
               -end.y());
}

Html line(const Vector2d& from, const Vector2d& end, const Scale& to) {
  return drawn(R"(<path class="guide" d="M{:.1f} {:.1f}L{:.1f} {:.1f}"/>)", to.x(from.x()), to.y(from.y()),
               to.x(end.x()), to.y(end.y()));
}

// Draws the lines, circles and points from which the rule of a single role computes its target.
Html guides(const config::TargetRule& rule, const mind::NamedPoints& anchors, const Vector2d& target, const Scale& to) {
  Html out;
  if (!anchors.ball_known() && rule.without_ball) return out;
  if (rule.on_line) out << line(anchors.at(rule.on_line->from), anchors.at(rule.on_line->to), to);
  if (rule.on_circle) {
    const Vector2d centre = anchors.at(rule.on_circle->centre);
    out << line(anchors.at(rule.on_circle->from), anchors.at(rule.on_circle->towards), to)
        << drawn(R"(<circle class="guide" cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)", to.x(centre.x()), to.y(centre.y()),
                 (target - centre).norm() * to.per_metre);
  }
  if (rule.at) out << line(anchors.at(*rule.at), target, to);
  return out;
}

Html region(const std::array<double, 4>& within, const Scale& to) {
  return drawn(R"(<rect class="within" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}"/>)", to.x(within[0]),
               to.y(within[3]), (within[1] - within[0]) * to.per_metre, (within[3] - within[2]) * to.per_metre);
}

constexpr Markup roles_style = R"(<style>
text{font-family:"Helvetica Neue",Arial,"DejaVu Sans",sans-serif;font-size:12px;fill:#1b1f24;text-anchor:middle}
.head{text-anchor:start;font-weight:600}
.grass{fill:#eef4ee}.line *{fill:none;stroke:#7d8a80;stroke-width:1.5}
.lead{stroke:#4a545e;stroke-opacity:.7;fill:none}.role{paint-order:stroke;stroke:#fff;stroke-width:2.5px;stroke-linejoin:round}
.marker{fill:#0072b2;stroke:#fff;stroke-width:1}.facing{stroke:#0072b2;stroke-width:2.5}
.number{fill:#fff;font-size:10px;font-weight:600}
.ball{fill:#1b1f24;stroke:#fff;stroke-width:1.5}
.guide{fill:none;stroke:#a04a86;stroke-width:1.2;stroke-dasharray:5 4}
.within{fill:#cc79a7;fill-opacity:.12;stroke:#a04a86;stroke-width:1.2;stroke-dasharray:2 3}
</style>)"_html;

}  // namespace

std::string roles_svg(const RolesToDraw& what, const config::FieldSize& field) {
  Scale to{page_margin, page_margin + page_head, 0.0, field.length / 2.0 + field.border_strip,
           field.width / 2.0 + field.border_strip};
  to.per_metre = (page_width - 2.0 * page_margin) / (2.0 * to.half_length);
  const double height = 2.0 * page_margin + page_head + 2.0 * to.half_width * to.per_metre;

  std::vector<std::array<double, 2>> balls(what.balls.begin(), what.balls.end());
  const bool known = !balls.empty(), several = balls.size() > 1, alone = what.roles.size() == 1;
  if (!known) balls.emplace_back();

  Labels labels;
  const auto name = [&](double x, double y, double radius, std::string words) {
    labels.add(x, y, radius, std::move(words), {"role", 0, letter, true});
  };
  Html shapes, markers;
  if (alone && what.roles.front()->target.within) shapes << region(*what.roles.front()->target.within, to);
  struct Named {
    Vector2d at;
    const config::Role* role;
  };
  std::vector<Named> named;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    mind::DistributedWorldModel world(1);
    if (known) world.ball_state.flags = REGISTA_BALL_KNOWN;
    std::ranges::copy(balls[i], world.ball_state.position);
    // The ball is at rest, so its deceleration has no influence.
    const mind::NamedPoints anchors(field, 1.0, world);
    for (const config::Role* role : what.roles) {
      const Vector2d at = mind::target_of(role->target, anchors);
      const double x = to.x(at.x()), y = to.y(at.y());
      if (alone) shapes << guides(role->target, anchors, at, to);
      markers << arrow(at, anchors.at(role->target.facing), to)
              << drawn(R"(<circle class="marker" cx="{:.1f}" cy="{:.1f}" r="{:.1f}"/>)", x, y, marker);
      if (several) markers << label(x, y + 3.5, "number", fmt::format("{}", i + 1));
      labels.take(x, y, marker);
      if (i == 0 || !several) named.push_back({at, role});
    }
    if (!known) continue;
    const double x = to.x(balls[i][0]), y = to.y(balls[i][1]);
    markers << drawn(R"(<circle class="ball" cx="{:.1f}" cy="{:.1f}" r="5"/>)", x, y);
    labels.take(x, y, 5.0);
    if (several) name(x, y, 5.0, fmt::format("ball {}", i + 1));
  }
  for (const Named& each : named)
    name(to.x(each.at.x()), to.y(each.at.y()), marker, texts::visible_at_most(each.role->name, 32));
  Html out = sheet(page_width, height);
  const std::string title =
      fmt::format("{}: roles of {}", texts::visible_at_most(what.team, 40), texts::visible_at_most(what.of, 60));
  out << roles_style << label(page_margin, 19.0, "head", title) << field_lines(field, to) << shapes << markers
      << labels.written({0.0, page_head, page_width, height});
  return std::string(roles_svg_begin) + '\n' + (out << "</svg>\n"_html).str();
}

}  // namespace regista::recording
