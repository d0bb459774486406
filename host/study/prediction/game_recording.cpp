// SPDX-License-Identifier: MIT
#include "study/prediction/game_recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace regista::study {
namespace {

constexpr std::int64_t most_numbered = 1'000'000'000;  // events, cycles

double coordinate(const Table& table, std::size_t column, double unit, double farthest) {
  const double value = table.number(column) * unit;
  if (std::abs(value) > farthest) table.refuse(column, fmt::format("is more than {:.0f} m from the centre", farthest));
  return value;
}

// The file of the referee's states, see read_recording(). Throws config::Error at `data` if there is no such file.
std::filesystem::path referee_file(const std::filesystem::path& data) {
  const std::string name = data.filename().string();
  const std::size_t end = std::min(name.rfind("_ball"), name.rfind("_robots"));
  if (end != std::string::npos) {
    for (const char* ending : {"_referee.csv.gz", "_referee.csv"}) {
      const std::filesystem::path candidate = data.parent_path() / (name.substr(0, end) + ending);
      std::error_code ignored;
      if (std::filesystem::exists(candidate, ignored)) return candidate;
    }
  }
  throw config::Error({data.string()},
                      "the states of the referee are missing: no NAME_referee.csv.gz stands beside it; say which file "
                      "with --referee FILE");
}

// Divides the lines of a table into stretches: parts of a match without cuts, one for each number in the column
// `event`. The lines of a stretch must follow each other, ordered by time.
class Stretches {
 public:
  Stretches(const Table& table, std::size_t event, std::size_t time) : table_(table), event_(event), time_(time) {}

  // Returns the stretch (the part of the match without cuts that has the event number of the current line) and the
  // line's time. Begins a new stretch if the number differs from the last line's. Refuses a number that comes back, and
  // a time before the last line's.
  std::pair<Stretch*, double> of_line() {
    const int number = static_cast<int>(table_.count(event_, most_numbered));
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

std::map<int, std::vector<PlayChange>> read_referee(const std::filesystem::path& file) {
  Table table(file);
  constexpr std::string_view layout = "states of the referee have the columns event, t, state";
  const std::size_t state = table.column("state", layout);
  Stretches stretches(table, table.column("event", layout), table.column("t", layout));
  std::map<int, std::vector<PlayChange>> out;
  while (table.next()) {
    const auto [stretch, time] = stretches.of_line();
    out[stretch->number].push_back({time, table.text(state) == "GameRunning"});
  }
  return out;
}

// The allowed difference between the clocks of cameras and referee, and between an event's states and detections.
constexpr double clock_difference = 2.0;  // s

// Refuses a file of another match. Only the times show this, because every file numbers its events from 0.
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

// The object number of the robot in the current line.
int robot_of(const Table& table, std::size_t team, std::size_t id) {
  const std::string_view colour = table.text(team);
  if (colour != "b" && colour != "y") table.refuse(team, "is no team; there are b and y");
  return robot_object(colour == "b" ? 1 : 2, static_cast<int>(table.count(id, 99)));
}

// Reads raw detections of the cameras of the Small Size League, in millimetres. Columns for the ball:
// `event,t,x_mm,y_mm`; for robots: `event,t,team,id,x_mm,y_mm,theta` (teams b and y); for states of the referee:
// `event,t,state`. Events become stretches, which may overlap in time.
std::vector<Stretch> read_ssl(const std::filesystem::path& data, const std::filesystem::path& referee, bool robots,
                              const Progress& progress) {
  constexpr double millimetre = 1e-3, farthest = 100.0;  // m; no field is larger
  Table table(data, progress);
  const std::string_view layout = robots ? "a recording of robots has the columns event, t, team, id, x_mm, y_mm"
                                         : "a recording of the ball has the columns event, t, x_mm, y_mm";
  const std::size_t x = table.column("x_mm", layout), y = table.column("y_mm", layout);
  if (!robots && table.has_column("team"))
    throw config::Error({data.string(), 1, 1}, "is a recording of robots; expected one of the ball");
  const std::size_t team = robots ? table.column("team", layout) : 0, id = robots ? table.column("id", layout) : 0;
  Stretches stretches(table, table.column("event", layout), table.column("t", layout));
  while (table.next()) {
    const auto [stretch, time] = stretches.of_line();
    const double px = coordinate(table, x, millimetre, farthest), py = coordinate(table, y, millimetre, farthest);
    stretch->samples.push_back({time, robots ? robot_of(table, team, id) : ball_object, px, py});
  }
  const std::filesystem::path states = referee.empty() ? referee_file(data) : referee;
  std::map<int, std::vector<PlayChange>> play = read_referee(states);
  refuse_another_match(stretches.all, play, states);
  for (Stretch& stretch : stretches.all) stretch.play = std::move(play[stretch.number]);
  return std::move(stretches.all);
}

// Reads tracking of the 2D simulation league, one line per cycle of 0.1 s:
// `#,playmode,b_x,b_y,l1_x,l1_y,...,r11_x,r11_y`. The y of the file points to the right, so the reader changes its
// sign. The game runs while the mode is play_on.
std::vector<Stretch> read_simulation_2d(const std::filesystem::path& data, config::PredictorStudy::Subject subject,
                                        const Progress& progress) {
  constexpr double cycle = 0.1;       // s
  constexpr double farthest = 200.0;  // m; the field is 105 x 68
  struct Column {
    int object;
    std::size_t x, y;
  };
  Table table(data, progress);
  const std::size_t number = table.column("#"), mode = table.column("playmode");
  std::vector<Column> columns;
  const auto take = [&](int object, const std::string& prefix) {
    columns.push_back({object, table.column(prefix + "_x"), table.column(prefix + "_y")});
  };
  if (subject == config::PredictorStudy::Subject::ball) {
    take(ball_object, "b");
  } else {
    for (int robot = 1; robot <= 11; ++robot) {
      take(robot_object(1, robot), fmt::format("l{}", robot));
      take(robot_object(2, robot), fmt::format("r{}", robot));
    }
  }
  Stretch stretch{1, {}, {}};
  double last = -1.0;
  while (table.next()) {
    const double time = cycle * static_cast<double>(table.count(number, most_numbered));
    if (time <= last) table.refuse(number, "runs backwards or stands still");
    last = time;
    const bool runs = table.text(mode) == "play_on";
    if (stretch.play.empty() || stretch.play.back().runs != runs) stretch.play.push_back({time, runs});
    for (const Column& each : columns) {
      const double x = coordinate(table, each.x, 1.0, farthest), y = coordinate(table, each.y, 1.0, farthest);
      stretch.samples.push_back({time, each.object, x, -y});
    }
  }
  std::vector<Stretch> out;
  if (!stretch.samples.empty()) out.push_back(std::move(stretch));
  return out;
}

}  // namespace

bool Stretch::runs_at(double time) const {
  const auto after = std::ranges::upper_bound(play, time, {}, &PlayChange::time);
  return after != play.begin() && (after - 1)->runs;
}

GameRecording read_recording(const config::PredictorStudy& study, const std::filesystem::path& data,
                             const std::filesystem::path& referee, const Progress& progress) {
  using Format = config::PredictorStudy::Format;
  GameRecording out{data.string(), study.format == Format::simulation_2d
                                       ? read_simulation_2d(data, study.subject, progress)
                                       : read_ssl(data, referee, study.format == Format::ssl_robots, progress)};
  if (out.stretches.empty()) throw config::Error({out.file}, "holds no detection");
  return out;
}

}  // namespace regista::study
