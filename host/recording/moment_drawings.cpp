// SPDX-License-Identifier: MIT
// The plugin drawings of a robot in the picture of a moment: layers in the field, and their legend.
#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "recording/field_svg.hpp"
#include "recording/moment_svg.hpp"
#include "texts/message.hpp"

namespace regista::recording::moment {
namespace {

constexpr double usual_line = 0.02, usual_dot = 0.08;  // m
constexpr double thinnest = 0.5;                       // px
constexpr std::size_t most_letters = 60;               // letters of a text in the field

// Colours of Okabe and Ito 2008 without yellow, which is too light. Colours that are unused elsewhere come first.
constexpr std::array<RecordedColour, 7> usual_colours{{{0xe6, 0x9f, 0x00},
                                                       {0x56, 0xb4, 0xe9},
                                                       {0x00, 0x9e, 0x73},
                                                       {0xcc, 0x79, 0xa7},
                                                       {0x00, 0x72, 0xb2},
                                                       {0xd5, 0x5e, 0x00},
                                                       {0x1b, 0x1f, 0x24}}};

// The style of a layer's shapes that have no style of their own.
struct LayerStyle {
  RecordedColour colour;
  bool dashed;  // true: another layer has the same colour
};

LayerStyle style_of(std::size_t place) {
  return {usual_colours[place % usual_colours.size()], place >= usual_colours.size()};
}

RecordedColour of_opacity(RecordedColour colour, std::uint8_t opacity) {
  colour.opacity = opacity;
  return colour;
}

// Returns a darker shade of the colour, because letters are thin.
RecordedColour for_letters(const RecordedColour& colour) {
  const auto darker = [](std::uint8_t part) { return static_cast<std::uint8_t>(part * 0.55); };
  return {darker(colour.red), darker(colour.green), darker(colour.blue), colour.opacity};
}

// Returns the attributes of a colour. which: "fill" or "stroke".
Html paint(const char* which, const RecordedColour& colour) {
  return drawn(R"( {0}="#{1:02x}{2:02x}{3:02x}" {0}-opacity="{4:.2f}")", which, colour.red, colour.green, colour.blue,
               colour.opacity / 255.0);
}

class Pencil {
 public:
  explicit Pencil(const Scale& to)
      : to_(to), picture_{-to.half_length, -to.half_width, to.half_length, to.half_width} {}

  // Draws points, a line or a polygon. Returns nothing for a shape that is a text.
  Html shape(const RecordedShape& shape, const LayerStyle& style) const {
    using Kind = RecordedShape::Kind;
    if (shape.kind == Kind::points) return points(shape, style);
    if (shape.kind == Kind::line) return line(shape, style);
    return shape.kind == Kind::polygon ? polygon(shape, style) : Html();
  }

  // Draws a text, centred at its place, or beside this place near the edge of the picture, with a rim as a contrast.
  Html letters(const RecordedShape& shape, const LayerStyle& style) const {
    const Point& at = shape.at.front();
    if (!picture_.holds(at)) return {};
    const RecordedColour colour = shape.colour.value_or(for_letters(style.colour));
    const bool light = 0.299 * colour.red + 0.587 * colour.green + 0.114 * colour.blue > 160.0;
    const std::string words = visible_at_most(shape.text, most_letters);
    constexpr double letter = 6.6, edge = 3.0;  // px; letter: typical width
    const double half = 0.5 * letter * static_cast<double>(words.size());
    const double x = to_.x(at[0]), left = to_.left + edge, right = to_.x(to_.half_length) - edge;
    const char* const anchor = x - half < left ? "start" : x + half > right ? "end" : "middle";
    Html out = drawn(R"(<text class="{}" x="{:.1f}" y="{:.1f}" text-anchor="{}")", light ? "said light-said" : "said",
                     std::clamp(x, left, right), to_.y(at[1]) + 4.0, anchor);
    return out << drawn(R"( style="fill:#{:02x}{:02x}{:02x}" opacity="{:.2f}">)", colour.red, colour.green, colour.blue,
                        colour.opacity / 255.0)
               << text(words) << "</text>"_html;
  }

 private:
  // Returns the line width in m, at most the width of the picture; `usual` for a shape without a width or with width 0.
  double width_of(const RecordedShape& shape, double usual) const {
    const double width = shape.width.value_or(0.0);
    return width > 0.0 ? std::min(width, 2.0 * to_.half_length) : usual;
  }
  // Returns the picture with a margin. The margin hides the cut ends of lines of this width.
  Rectangle around(double width) const {
    const double more = width + 0.1;
    return {picture_.left - more, picture_.low - more, picture_.right + more, picture_.high + more};
  }

  Html path(const std::vector<Point>& way) const {
    Html out;
    for (std::size_t i = 0; i < way.size(); ++i) {
      out << drawn("{}{:.1f} {:.1f}", i == 0 ? 'M' : 'L', to_.x(way[i][0]), to_.y(way[i][1]));
    }
    return out;
  }
  Html stroke(const RecordedShape& shape, const LayerStyle& style, double width) const {
    Html out = paint("stroke", shape.colour.value_or(style.colour));
    out << drawn(R"( stroke-width="{:.2f}")", std::max(thinnest, width * to_.per_metre));
    if (!shape.colour && style.dashed) out << R"( stroke-dasharray="7 4")"_html;
    return out;
  }

  Html points(const RecordedShape& shape, const LayerStyle& style) const {
    const double width = width_of(shape, usual_dot), radius = std::max(thinnest, width / 2.0 * to_.per_metre);
    const Rectangle seen = around(width);
    Html out;
    for (const Point& at : shape.at) {
      if (!seen.holds(at)) continue;
      out << drawn(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.2f}")", to_.x(at[0]), to_.y(at[1]), radius)
          << paint("fill", shape.colour.value_or(style.colour)) << "/>"_html;
    }
    return out;
  }

  Html line(const RecordedShape& shape, const LayerStyle& style) const {
    const double width = width_of(shape, usual_line);
    Html ways;
    for (const std::vector<Point>& piece : clipped_line(shape.at, around(width))) ways << path(piece);
    if (ways.empty()) return {};
    Html out = R"(<path d=")"_html;
    return out << ways << R"(" fill="none")"_html << stroke(shape, style, width) << "/>"_html;
  }

  Html polygon(const RecordedShape& shape, const LayerStyle& style) const {
    const double width = width_of(shape, usual_line);
    const Html way = path(clipped_polygon(shape.at, around(width)));
    if (way.empty()) return {};
    Html out = R"(<path d=")"_html;
    out << way << R"(Z")"_html;
    if (shape.filled)
      out << paint("fill", shape.colour.value_or(of_opacity(style.colour, 64)));
    else
      out << R"( fill="none")"_html;
    return out << stroke(shape, style, width) << "/>"_html;
  }

  Scale to_;
  Rectangle picture_;
};

// Returns at most four colours of a layer, taken evenly from its first to its last colour.
std::vector<RecordedColour> colours_of(const RecordedDrawing& drawing, const LayerStyle& style) {
  constexpr std::size_t most = 4, most_told_apart = 256;
  std::vector<RecordedColour> all;
  for (const RecordedShape& shape : drawing.shapes) {
    texts::add_once(all, shape.colour.value_or(style.colour));
    if (all.size() == most_told_apart) break;
  }
  if (all.size() <= most) return all;
  std::vector<RecordedColour> out;
  for (std::size_t i = 0; i < most; ++i) out.push_back(all[i * (all.size() - 1) / (most - 1)]);
  return out;
}

}  // namespace

Html layers(const std::vector<RecordedDrawing>& drawings, const Scale& to) {
  const Pencil pencil(to);
  Html out, texts;  // texts are drawn after, and so above, all layers
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    if (drawings[i].shapes.empty()) continue;
    out << R"x(<g class="layer" clip-path="url(#field)">)x"_html;
    for (const RecordedShape& shape : drawings[i].shapes) {
      out << pencil.shape(shape, style_of(i));
      if (shape.kind == RecordedShape::Kind::text) texts << pencil.letters(shape, style_of(i));
    }
    out << "</g>"_html;
  }
  if (texts.empty()) return out;
  return out << R"x(<g clip-path="url(#field)">)x"_html << texts << "</g>"_html;
}

Panel names_of_layers(const std::vector<RecordedDrawing>& drawings, double left, double top) {
  constexpr double square = 10.0, step = 14.0, row = 17.0;
  constexpr std::size_t most = 24;
  Panel out{{}, top};
  std::size_t count = 0;
  for (std::size_t i = 0; i < drawings.size(); ++i) {
    if (drawings[i].shapes.empty() || ++count > most) continue;
    const LayerStyle style = style_of(i);
    double x = left;
    for (const RecordedColour& colour : colours_of(drawings[i], style)) {
      out.drawing << drawn(R"(<rect class="swatch" x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}")", x,
                           out.bottom - square + 1.0, square, square)
                  << paint("fill", colour);
      if (style.dashed && colour == style.colour) out.drawing << R"( stroke-dasharray="3 2")"_html;
      out.drawing << "/>"_html;
      x += step;
    }
    out.drawing << label(x + 4.0, out.bottom, "small",
                         visible_at_most(drawings[i].plugin, 48) + ": " + visible_at_most(drawings[i].layer, 48));
    out.bottom += row;
  }
  if (count > most) {
    out.drawing << label(left, out.bottom, "small", fmt::format("and {} more layers", count - most));
    out.bottom += row;
  }
  return out;
}

}  // namespace regista::recording::moment
