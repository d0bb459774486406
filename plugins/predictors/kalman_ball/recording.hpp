// SPDX-License-Identifier: MIT
// Reads the recording of ball detections of a Small Size League match (RoboCIn's logs; cameras see the whole field at
// about 70 Hz) for tests: detections and the times at which the game was running.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace kalman_ball {

struct Detection {
  double time;
  Eigen::Vector2d position;  // m
};

// One stretch of the match, by time.
struct Stretch {
  std::vector<Detection> detections;
  std::vector<std::pair<double, bool>> running;  // from this time on

  bool runs_at(double time) const {
    bool runs = false;
    for (const auto& [since, state] : running) {
      if (since <= time) runs = state;
    }
    return runs;
  }
  // The detection nearest `time`, null when none is within `tolerance`.
  const Detection* at(double time, double tolerance) const {
    const auto after = std::lower_bound(detections.begin(), detections.end(), time,
                                        [](const Detection& d, double t) { return d.time < t; });
    const Detection* best = nullptr;
    for (auto each = after == detections.begin() ? after : after - 1; each != detections.end() && each <= after;
         ++each) {
      const double gap = std::abs(each->time - time);
      if (gap <= tolerance && (best == nullptr || gap < std::abs(best->time - time))) best = &*each;
    }
    return best;
  }
};

// Calls `line(text)` for every line but the first of a gzipped text file; false when it cannot be read.
template <class Line>
bool for_each_line(const std::string& file, const Line& line) {
  if (std::FILE* probe = std::fopen(file.c_str(), "rb")) {
    std::fclose(probe);
  } else {
    return false;
  }
  std::FILE* pipe = popen(("gzip -dc '" + file + "'").c_str(), "r");
  if (pipe == nullptr) return false;
  char text[256];
  bool first = true;
  while (std::fgets(text, sizeof text, pipe) != nullptr) {
    if (!first) line(text);
    first = false;
  }
  return pclose(pipe) == 0;
}

// Empty when the recording is not there.
inline std::map<int, Stretch> read_recording(const std::string& folder) {
  std::map<int, Stretch> out;
  const bool balls = for_each_line(folder + "/zjunlict_ball_raw.csv.gz", [&out](const char* text) {
    int stretch;
    double time, x, y;
    if (std::sscanf(text, "%d,%lf,%lf,%lf", &stretch, &time, &x, &y) == 4) {
      out[stretch].detections.push_back({time, {x / 1000.0, y / 1000.0}});
    }
  });
  const bool states = for_each_line(folder + "/zjunlict_referee.csv.gz", [&out](const char* text) {
    int stretch;
    double time;
    char state[64];
    if (std::sscanf(text, "%d,%lf,%63s", &stretch, &time, state) == 3) {
      out[stretch].running.emplace_back(time, std::strcmp(state, "GameRunning") == 0);
    }
  });
  return balls && states ? out : std::map<int, Stretch>{};
}

}  // namespace kalman_ball
