// SPDX-License-Identifier: MIT
// A picture of gnuplot as a tree of the few elements and attributes that such pictures are made of. Everything else is
// left out (titles, filters, other attributes) or refused (other elements, links that lead out of the picture).
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace regista::report {

// It is no picture as gnuplot writes it. what() says where it is not.
class StrangePicture : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct SvgAttribute {
  std::string_view name;
  std::string value;
};

struct SvgElement {
  std::string_view name;
  std::vector<SvgAttribute> attributes;
  std::vector<SvgElement> children;
  std::string_view text;  // as it stood, its entities too; holds no <

  const std::string* value(std::string_view of) const {
    const auto found = std::ranges::find(attributes, of, &SvgAttribute::name);
    return found == attributes.end() ? nullptr : &found->value;
  }
};

// The views in the tree are into `svg`. Throws StrangePicture.
SvgElement svg_tree(std::string_view svg);

}  // namespace regista::report
