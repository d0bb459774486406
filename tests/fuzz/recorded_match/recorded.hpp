// SPDX-License-Identifier: MIT
// A recording with messages of any content, and what every one of them must do: be shown, or refused in one line.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "mcap/file_io.hpp"
#include "mcap/writer.hpp"
#include "recording/moment_svg.hpp"
#include "recording/recorded_match.hpp"

namespace regista::recording {

struct RecordedTexts {
  std::string field =
      R"({"length":9,"width":6,"border_strip":0.7,"goal_width":1.5,"goal_depth":0.5,"goal_area":[0.6,2.2],)"
      R"("penalty_area":[1.65,4],"penalty_mark_distance":1.3,"centre_circle_radius":0.75})";
  std::string team =
      R"({"team":"a","file":"a.yaml","robot_radius":0.15,"roles":[{"name":"goalkeeper","list":"playing","priority":0,)"
      R"("robot":1},{"name":"striker","list":"playing","priority":1,"robot":0}],"contexts":[{"name":"playing","priority":0,)"
      R"("plugin":"always","parameters":"","list":"playing","utility_knowledge":"mine","tasks_knowledge":"mine",)"
      R"("terms":[{"name":"distance","weight":0.7}],"positioner":"","assigner":"greedy","sender":"fixed_rate"}]})";
  std::string game =
      R"({"time":1,"half":1,"clock":1,"phase":"playing","set_play":"none","kicking":"home","score":[1,0],)"
      R"("packets_left":[10,20],"penalised":[[],[2]],"fallen":[[1],[]],"kicks":[[],[]],"ball":[1,0,0,0],)"
      R"("home":[[0,0,0],[1,1,1]],"away":[[2,0,3],[1,-1,1]],"roles":[[0,1],[0,-1]]})";
  std::string decision =
      R"({"time":1,"context":0,"knowledge":"mine","waypoints":[[1,2,0],[2,2,1]],"edges":[[0,1]],"tasks":[{"role":0,)"
      R"("before":[-4,0,0],"after":[-4,0,0]},{"role":1,"before":[1,0,0],"after":null}],"columns":[0,1],"rows":[1,2],)"
      R"("utility":[[0.5,null],[0.2,0.9]],"terms":[[[0.7,null],[0.3,1.2]]],"assigned":[0,1],"role":0,"since":0.5})";
  std::string belief =
      R"({"time":1,"pose":[0,0,0],"sees_ball":true,"mine":{"ball":{"at":[1,0],"velocity":[0,0],"covariance":[0.1,0,0.1],)"
      R"("age":0},"teammates":{"number":[1,2],"pose":[[0,0,0],[1,1,1]],"covariance":[[0,0,0],[0.1,0.02,0.1]],"age":[0,3],)"
      R"("role":[0,1],"active":[1,2]},"opponents":{"at":[[2,0]],"covariance":[[0.2,0,0.2]],"age":[1],"weight":[0.9]}}})";
};

inline void write_recording(const std::filesystem::path& file, const RecordedTexts& texts) {
  mcap::Writer writer(file, {.replace = true});
  writer.write(mcap::Metadata{"match",
                              {{"format", "1"},
                               {"program", "regista"},
                               {"field", texts.field},
                               {"ball_radius", "0.05"},
                               {"home", texts.team},
                               {"away", texts.team}}});
  const std::array<std::pair<const char*, const std::string*>, 3> messages{
      {{"/game", &texts.game}, {"/decision/home/1", &texts.decision}, {"/belief/home/1", &texts.belief}}};
  for (const auto& [topic, text] : messages) {
    writer.write({writer.add_channel(topic, "json"), 0, 1'000'000'000, 1'000'000'000, *text});
  }
  writer.close();
}

// The picture of its only moment, or the line that refuses it. Whatever else is thrown is a defect.
struct Shown {
  std::string picture, refusal;
};

inline Shown show(const std::filesystem::path& file) {
  try {
    const RecordedMatch match(file);
    const RobotName robot{0, 1};
    return {moment_svg(match, match.at(match.end(), robot), robot), ""};
  } catch (const mcap::Error& error) {
    return {"", error.what()};
  }
}

}  // namespace regista::recording
