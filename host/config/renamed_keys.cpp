// SPDX-License-Identifier: MIT
#include "config/renamed_keys.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "config/overlay.hpp"

namespace regista::config {
namespace {

struct Renamed {
  std::string_view plugin, former, present;
};

// Names that changed in version 0.3.
constexpr Renamed renamed[] = {
    {"", "across", "lateral"},
    {"consensus_bundle", "static_at", "stop_negotiating_at"},
    {"distributed_auction", "static_at", "stop_negotiating_at"},
    {"keep_goal", "comes_out", "narrow_angle"},
    {"keep_goal", "comes_out_share", "narrow_angle_share"},
    {"keep_goal", "late", "leave_lost_ball"},
    {"nao_devils", "static_at", "stop_negotiating_at"},
    {"persistence", "full_after", "ramp_seconds"},
    {"persistence", "rows", "for_robots"},
    {"precedence_auction", "static_at", "stop_negotiating_at"},
    {"role_exchange", "static_at", "stop_negotiating_at"},
    {"scram_vote", "static_at", "stop_negotiating_at"},
    {"search", "turns_first", "search_turn_seconds"},
    {"set_play", "still_for", "hold_seconds"},
    {"support", "leaves_for_lane", "open_passing_lane"},
    {"token_passing", "static_at", "stop_negotiating_at"},
};

class Renaming {
 public:
  Renaming(const Node& team, const Declares& declares) : team_(team), declares_(declares) {}

  // Returns `node` with new names. path: path of the node in the team's document. The path is empty for `use` of a
  // context, because the keys of `use` are paths from the root of the document. around: the map that contains the node.
  Node of(const Node& node, const std::string& path, const Node& around) const {
    if (node.kind() == Node::Kind::sequence) {
      std::vector<Node> out;
      for (const Node& each : node.elements()) out.push_back(of(each, path, around));
      return Node::sequence(std::move(out), node.where());
    }
    if (node.kind() != Node::Kind::map) return node;
    std::vector<Node::Entry> out(node.entries().begin(), node.entries().end());
    for (Node::Entry& each : out) {
      const std::string whole = path.empty() ? each.key : path + '.' + each.key;
      each.value = of(each.value, each.key == "use" ? "" : whole, node);
      const std::size_t begin = each.key.rfind('.') + 1;  // begin of the last part of the key
      const bool is_path = begin != 0;
      const std::string present = present_key(whole, each.key.substr(begin), is_path ? Node() : around);
      if (!node[each.key.substr(0, begin) + present]) each.key.replace(begin, std::string::npos, present);
    }
    return Node::map(std::move(out), node.where());
  }

 private:
  // Returns the new name of the last key of a path. with_plugin: the map that names the plugin, if the caller knows it.
  std::string present_key(const std::string& path, const std::string& key, const Node& with_plugin) const {
    const std::size_t end = path.size() - std::min(path.size(), key.size() + 1);
    const std::string_view place(path.data(), end);
    if (place == "target" || place.ends_with(".target") || place.starts_with("targets.")) {
      const std::string_view present = present_name("", key);
      return std::string(present.empty() ? key : present);
    }
    constexpr std::string_view params = ".params";
    if (!place.ends_with(params)) return key;
    const std::string use(place.substr(0, place.size() - params.size()));
    Node plugin = with_plugin["plugin"];
    if (!plugin) plugin = value_at(team_, use)["plugin"];
    const std::string id = plugin ? plugin.text() : use.substr(use.rfind('.') + 1);
    const std::string_view present = present_name(id, key);
    return std::string(declares_(id, present) && !declares_(id, key) ? present : key);
  }

  const Node& team_;
  const Declares& declares_;
};

}  // namespace

std::string_view present_name(std::string_view plugin, std::string_view former) {
  const auto found = std::ranges::find_if(
      renamed, [&](const Renamed& each) { return each.plugin == plugin && each.former == former; });
  return found == std::end(renamed) ? std::string_view() : found->present;
}

Node with_present_names(const Node& team, const Declares& declares) {
  return Renaming(team, declares).of(team, "", Node());
}

}  // namespace regista::config
