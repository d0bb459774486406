// SPDX-License-Identifier: MIT
// Places labels in a picture so that no label lies over another label or over a body. Each label in turn takes the
// first free place: below, above, right, left and at the corners of its object, then farther away, where a line leads
// to it. A label without a free place is left out. The viewer's page places labels by the same rule (viewer/src/field).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "texts/html.hpp"

namespace regista::recording::picture {

// px; y grows downwards.
struct Area {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

struct WantedLabel {
  double x = 0.0, y = 0.0, radius = 0.0;  // px: centre and radius of the object
  double width = 0.0, height = 0.0;       // px: size of the label
  bool far = false;                       // the label may stand farther away
};

struct PlacedLabel {
  double x = 0.0, y = 0.0;  // px: centre of the label
  bool far = false;         // a line must lead to it
};

// Returns a place in `within` for each label; earlier labels choose first. taken: areas that no label may cover.
std::vector<std::optional<PlacedLabel>> place_labels(std::span<const WantedLabel> labels, std::span<const Area> taken,
                                                     const Area& within);

// The labels of one picture. They are gathered while the picture is drawn, and written last, over everything else.
class Labels {
 public:
  // No label covers the square with this centre and half side, px.
  void take(double x, double y, double half) { taken_.push_back({x - half, y - half, x + half, y + half}); }

  // classes: of the style sheet. rank: the lowest choose first. letter: size, px. far: it may stand farther away.
  struct Style {
    const char* classes;
    int rank;
    double letter;
    bool far;
  };
  void add(double x, double y, double radius, std::string words, const Style& style);

  // Returns the labels that have a place. Lines to them have the style class lead.
  texts::Html written(const Area& within) const;

 private:
  struct Label {
    std::string words;
    WantedLabel wanted;
    Style style;
  };
  std::vector<Label> labels_;
  std::vector<Area> taken_;
};

}  // namespace regista::recording::picture
