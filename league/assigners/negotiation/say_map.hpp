// SPDX-License-Identifier: MIT
// A map is an assignment as robots send it to each other in a negotiation: which robot takes which task. These
// functions list the robots and tasks of a Frame, turn this robot's assignment into a map, and write a map as text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <regista/assigner.hpp>

#include "follow_map.hpp"
#include "told_map.hpp"

namespace scram {

class MapOfFrame {
 public:
  void setup(const regista::Environment& environment) {
    roles_ = environment.roles();
    code_ = MapCode(environment->team_size, roles_.size());
    numbers_.reserve(code_.robots());
    ids_.reserve(roles_.size());
  }
  const MapCode& code() const { return code_; }

  // order: the columns, the most important first; lives as long as now() is used.
  void look(const regista::Frame& frame, std::span<const std::uint32_t> order) {
    numbers_.clear();
    ids_.clear();
    for (const std::int32_t number : frame.world().active()) numbers_.push_back(number);
    for (const regista::Task& task : frame.tasks()) ids_.push_back(task.id);
    now_ = {numbers_, ids_, order};
  }
  const Here& now() const { return now_; }
  bool plays(int number) const { return std::find(numbers_.begin(), numbers_.end(), number) != numbers_.end(); }

  // assigned[row]: a column, or below 0.
  void write(std::span<const std::int32_t> assigned, std::vector<std::int32_t>& map) const {
    map.assign(code_.robots(), away);
    for (std::size_t row = 0; row < assigned.size(); ++row) {
      const std::int32_t column = assigned[row];
      map[static_cast<std::size_t>(numbers_[row] - 1)] = column < 0 ? idle : ids_[static_cast<std::size_t>(column)];
    }
  }

  // "1 goalkeeper, 2 striker, 3 idle": robots that do not play are left out. Empty when it is no map of this team.
  std::string describe(negotiation::BitReader& in) const {
    std::vector<std::int32_t> map(code_.robots());
    if (!code_.read(in, map)) return {};
    std::string out;
    for (std::size_t robot = 0; robot < map.size(); ++robot) {
      if (map[robot] == away) continue;
      if (!out.empty()) out += ", ";
      out += std::to_string(robot + 1) + ' ';
      out += map[robot] == idle ? "idle" : roles_[static_cast<std::size_t>(map[robot])].name;
    }
    return out.empty() ? "nobody plays" : out;
  }

 private:
  MapCode code_;
  regista::Span<regista::Role> roles_;
  std::vector<std::int32_t> numbers_, ids_;
  Here now_;
};

}  // namespace scram
