// SPDX-License-Identifier: MIT
// Logs of the Small Size League as tables; see formats.hpp.
#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>

#include "study/prediction/formats.hpp"

namespace regista::study {
namespace {

constexpr double millimetre = 1e-3;
constexpr double farthest = 100.0;  // m: no field is larger

// Lines of one event must be in the order of time, and an event must not be taken up again.
class Stretches {
 public:
  Stretches(const Table& table, std::size_t event, std::size_t time) : table_(table), event_(event), time_(time) {}

  // The stretch of the present line, and its time.
  std::pair<Stretch*, double> of_line() {
    const int number = table_.integer(event_);
    const double time = table_.number(time_);
    if (all.empty() || all.back().number != number) {
      if (!line_of_.emplace(number, table_.where(event_).line).second) {
        table_.refuse(event_, fmt::format("comes back; its lines began at line {}", line_of_[number]));
      }
      all.push_back({number, {}, {}});
    } else if (time < last_) {
      table_.refuse(time_, fmt::format("runs backwards: the line before says {}", last_));
    }
    last_ = time;
    return {&all.back(), time};
  }

  std::vector<Stretch> all;

 private:
  const Table& table_;
  std::size_t event_, time_;
  double last_ = 0.0;
  std::map<int, int> line_of_;
};

double metres(const Table& table, std::size_t column) {
  const double value = table.number(column) * millimetre;
  if (std::abs(value) > farthest) table.refuse(column, fmt::format("is more than {:.0f} m from the centre", farthest));
  return value;
}

std::map<int, std::vector<PlayChange>> read_referee(const std::filesystem::path& file) {
  Table table(file);
  const std::size_t state = table.column("state");
  Stretches stretches(table, table.column("event"), table.column("t"));
  std::map<int, std::vector<PlayChange>> out;
  while (table.next()) {
    const auto [stretch, time] = stretches.of_line();
    out[stretch->number].push_back({time, table.text(state) == "GameRunning"});
  }
  return out;
}

// The clocks of cameras and referee agree within this; the first state of an event may stand a moment before it.
constexpr double clock_difference = 2.0;  // s

// Events have numbers, which are in every file from 0 on: the states of another match would go unnoticed.
void refuse_another_match(const std::vector<Stretch>& stretches, const std::map<int, std::vector<PlayChange>>& play,
                          const std::filesystem::path& file) {
  std::size_t without = 0;
  for (const Stretch& stretch : stretches) {
    const auto states = play.find(stretch.number);
    if (states == play.end()) {
      ++without;
      continue;
    }
    const double first = states->second.front().time, last = states->second.back().time;
    const double begin = stretch.samples.front().time, end = stretch.samples.back().time;
    if (last < begin - clock_difference || first > end + clock_difference) {
      throw config::Error(
          {file.string()},
          fmt::format("belongs to another match: its states of event {} are from {:.1f} to {:.1f} s, the "
                      "detections from {:.1f} to {:.1f} s",
                      stretch.number, first, last, begin, end));
    }
  }
  if (2 * without > stretches.size()) {
    throw config::Error({file.string()}, fmt::format("belongs to another match: it has no states of {} of {} events",
                                                     without, stretches.size()));
  }
}

GameRecording with_referee(std::vector<Stretch> stretches, const std::filesystem::path& file) {
  std::map<int, std::vector<PlayChange>> play = read_referee(file);
  refuse_another_match(stretches, play, file);
  for (Stretch& stretch : stretches) stretch.play = std::move(play[stretch.number]);
  return {{}, std::move(stretches)};
}

}  // namespace

GameRecording read_ssl_ball(const std::filesystem::path& data, const std::filesystem::path& referee,
                            const Progress& progress) {
  Table table(data, progress);
  const std::size_t x = table.column("x_mm"), y = table.column("y_mm");
  if (table.has_column("team")) {
    throw config::Error({data.string(), 1, 1}, "is a recording of robots; expected one of the ball");
  }
  Stretches stretches(table, table.column("event"), table.column("t"));
  while (table.next()) {
    const auto [stretch, time] = stretches.of_line();
    const double px = metres(table, x), py = metres(table, y);
    stretch->samples.push_back({time, ball_object, px, py});
  }
  return with_referee(std::move(stretches.all), referee.empty() ? referee_file(data) : referee);
}

GameRecording read_ssl_robots(const std::filesystem::path& data, const std::filesystem::path& referee,
                              const Progress& progress) {
  Table table(data, progress);
  const std::size_t x = table.column("x_mm"), y = table.column("y_mm");
  const std::size_t team = table.column("team"), id = table.column("id");
  Stretches stretches(table, table.column("event"), table.column("t"));
  while (table.next()) {
    const auto [stretch, time] = stretches.of_line();
    const double px = metres(table, x), py = metres(table, y);
    const std::string_view colour = table.text(team);
    if (colour != "b" && colour != "y") table.refuse(team, "is no team; there are b and y");
    const int number = table.integer(id);
    if (number < 0 || number > 99) table.refuse(id, "is no number of a robot (0 to 99)");
    stretch->samples.push_back({time, robot_object(colour == "b" ? 1 : 2, number), px, py});
  }
  return with_referee(std::move(stretches.all), referee.empty() ? referee_file(data) : referee);
}

}  // namespace regista::study
