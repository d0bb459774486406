// SPDX-License-Identifier: MIT
// What plugins draw in the field, as recordings tell it: layer by layer, only what has changed, and each layer at most
// twice a second, as beliefs are, or drawings would be most of a recording.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "match/side.hpp"
#include "mind/extensions/drawings.hpp"
#include "texts/json_text.hpp"

namespace regista::recording {

class DrawnLayers {
 public:
  struct Change {
    const char* plugin;
    std::string_view layer;
    std::string_view shapes;  // a JSON list, see docs/recordings.md; empty: nothing is drawn there any more
  };

  // To be told every decision of every robot, at the time of each. direction: in which the team attacks, +1 or -1; the
  // shapes are turned into the world frame by it. What is to be told is valid until the next call.
  std::span<const Change> follow(match::Side side, int robot, double time, std::span<const mind::DrawnShape> shapes,
                                 double direction);

 private:
  struct Layer {
    const char* plugin;
    std::string name, shapes;  // as they were told last
    double told = 0.0;         // when, s
  };
  static std::size_t layer(std::vector<Layer>& of_robot, const mind::DrawnShape& shape);

  std::array<std::vector<std::vector<Layer>>, 2> layers_;  // by side and robot (n - 1)
  std::vector<std::size_t> layer_of_;                      // of each shape of the present call
  std::vector<Change> changes_;
  texts::JsonText json_;
};

}  // namespace regista::recording
