// SPDX-License-Identifier: MIT
#include "study/tuning/tuned_team.hpp"

#include <algorithm>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "config/block.hpp"
#include "config/overlay.hpp"
#include "config/parse.hpp"
#include "config/typed.hpp"

namespace regista::study {
namespace {

using config::Node;

const config::Location nowhere;

std::vector<std::string> parts_of(const std::string& path) {
  std::vector<std::string> out;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    out.push_back(path.substr(begin, end - begin));
    begin = end + 1;
  }
  return out;
}

// The map with a value at the end of a path of keys; maps on the way are made where there are none.
Node inserted(const Node& map, std::span<const std::string> path, const Node& value) {
  std::vector<Node::Entry> entries(map.entries().begin(), map.entries().end());
  auto found = std::ranges::find(entries, path.front(), &Node::Entry::key);
  if (found == entries.end()) {
    entries.push_back({path.front(), nowhere, Node()});
    found = entries.end() - 1;
  }
  found->value = path.size() == 1 ? value : inserted(found->value, path.subspan(1), value);
  return Node::map(std::move(entries), nowhere);
}

// Of a document, what stands at some paths: laid over another one it makes these the same.
class Overlay {
 public:
  // whole: the team's document as it shall be.
  explicit Overlay(Node whole) : whole_(std::move(whole)) {}

  // What has become of a setting in the end: a later one may have replaced it, and a file that it names stands there as
  // it is found from everywhere.
  void add(const std::string& setting) {
    const std::size_t equals = setting.find('=');
    const std::vector<std::string> parts = parts_of(setting.substr(0, equals));
    Node at = whole_;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (at.kind() == Node::Kind::sequence) {
        out_ = inserted(out_, std::span(parts).first(i), at);
        return;
      }
      at = at[parts[i]];
    }
    const bool removes =
        config::parse_value(std::string_view(setting).substr(equals + 1), nowhere).kind() == Node::Kind::null;
    if (at || removes) out_ = inserted(out_, parts, at ? at : Node::null(nowhere));
  }

  std::string text() const { return config::block(out_); }

 private:
  Node whole_, out_ = Node::map({}, nowhere);
};

}  // namespace

std::string tuned_team(const TuningPlan& plan, const ParameterValues& values, const std::string& name,
                       const std::string& base) {
  Overlay overlay(config::parse_text(TunedDocument(plan).with(values), plan.asked.team));
  for (const std::string& each : plan.settings) {
    if (!each.starts_with("team=")) overlay.add(each);  // it has a name of its own
  }
  for (const std::string& each : settings_of(plan, values)) overlay.add(each);
  const Node head = Node::map(
      {{"extends", nowhere, Node::scalar(base, true, nowhere)}, {"team", nowhere, Node::scalar(name, false, nowhere)}},
      nowhere);
  return config::block(head) + '\n' + overlay.text();
}

}  // namespace regista::study
