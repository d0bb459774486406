// SPDX-License-Identifier: MIT
// Tracking of the 2D simulation league; see formats.hpp.
#include <fmt/format.h>

#include <cmath>

#include "study/prediction/formats.hpp"

namespace regista::study {
namespace {

constexpr double cycle = 0.1;                // s
constexpr double farthest_on_pitch = 200.0;  // m: the field is 105 x 68

struct Column {
  int object;
  std::size_t x, y;
};

std::vector<Column> columns(const Table& table, config::PredictorStudy::Subject subject) {
  const auto pair = [&table](int object, const std::string& prefix) {
    return Column{object, table.column(prefix + "_x"), table.column(prefix + "_y")};
  };
  if (subject == config::PredictorStudy::Subject::ball) return {pair(ball_object, "b")};
  std::vector<Column> out;
  for (int number = 1; number <= 11; ++number) {
    out.push_back(pair(robot_object(1, number), fmt::format("l{}", number)));
    out.push_back(pair(robot_object(2, number), fmt::format("r{}", number)));
  }
  return out;
}

double coordinate(const Table& table, std::size_t column) {
  const double value = table.number(column);
  if (std::abs(value) > farthest_on_pitch)
    table.refuse(column, fmt::format("is more than {:.0f} m from the centre", farthest_on_pitch));
  return value;
}

}  // namespace

GameRecording read_simulation_2d(const std::filesystem::path& data, config::PredictorStudy::Subject subject,
                                 const Progress& progress) {
  Table table(data, progress);
  const std::size_t number = table.column("#"), mode = table.column("playmode");
  const std::vector<Column> wanted = columns(table, subject);
  Stretch stretch{1, {}, {}};
  double last = -1.0;
  while (table.next()) {
    const double time = cycle * table.integer(number);
    if (time <= last) table.refuse(number, "runs backwards or stands still");
    last = time;
    const bool runs = table.text(mode) == "play_on";
    if (stretch.play.empty() || stretch.play.back().runs != runs) stretch.play.push_back({time, runs});
    for (const Column& each : wanted) {
      const double x = coordinate(table, each.x), y = coordinate(table, each.y);
      stretch.samples.push_back({time, each.object, x, -y});
    }
  }
  GameRecording out;
  if (!stretch.samples.empty()) out.stretches.push_back(std::move(stretch));
  return out;
}

}  // namespace regista::study
