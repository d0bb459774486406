// SPDX-License-Identifier: MIT
// What a check found, one line each, in the words of the person who has to repair it. No findings: sound.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace regista::testkit {

class Findings {
 public:
  // Texts before every finding that follows: which parameters, which scene.
  void where(std::string corner, std::string scene) {
    corner_ = std::move(corner);
    scene_ = std::move(scene);
  }
  // The same text is kept once, with the first place where it was seen.
  template <class... Parts>
  void say(const Parts&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    if (std::find(seen_.begin(), seen_.end(), text.str()) != seen_.end()) return;
    seen_.push_back(text.str());
    if (lines_.size() == most) {
      ++left_out_;
      return;
    }
    std::string place = corner_ + (corner_.empty() || scene_.empty() ? "" : "; ") + scene_;
    lines_.push_back(text.str() + (place.empty() ? "" : " (" + place + ")"));
  }
  bool empty() const { return lines_.empty(); }
  const std::vector<std::string>& lines() const { return lines_; }
  std::string text() const {
    std::string out;
    for (const std::string& line : lines_) out += line + "\n";
    if (left_out_ > 0) out += "and " + std::to_string(left_out_) + " more like these\n";
    return out;
  }

 private:
  static constexpr std::size_t most = 20;
  std::vector<std::string> lines_, seen_;
  std::string corner_, scene_;
  std::size_t left_out_ = 0;
};

}  // namespace regista::testkit
