// SPDX-License-Identifier: MIT
// Keeps findings short: each once, and not more than a person reads.
#include <regista/testkit/findings.hpp>

#include <algorithm>
#include <utility>

namespace regista::testkit {

void Findings::where(std::string corner, std::string scene) {
  corner_ = std::move(corner);
  scene_ = std::move(scene);
  if (underway_) underway_(corner_, scene_);
}

std::string Findings::text() const {
  std::string out;
  for (const std::string& line : lines()) out += line + "\n";
  return out;
}

std::vector<std::string> Findings::List::told() const {
  std::vector<std::string> out = lines;
  if (left_out > 0) out.push_back("and " + std::to_string(left_out) + " more like these");
  return out;
}

void Findings::add(const std::string& text, List& list) {
  if (std::find(seen_.begin(), seen_.end(), text) != seen_.end()) return;
  seen_.push_back(text);
  if (list.lines.size() == most) {
    ++list.left_out;
    return;
  }
  list.lines.push_back(text + place());
}

std::string Findings::place() const {
  const std::string text = corner_ + (corner_.empty() || scene_.empty() ? "" : "; ") + scene_;
  return text.empty() ? "" : " (" + text + ")";
}

}  // namespace regista::testkit
