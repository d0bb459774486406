// SPDX-License-Identifier: MIT
// A recording of real or simulated matches: who was detected where and when, and when the game ran. Lengths in metres,
// time in seconds; the frame is that of the recording's field: centre, x along the field, y to the left.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/predictor_study.hpp"
#include "study/table.hpp"

namespace regista::study {

struct Sample {
  double time;
  int object;  // 0 is the ball; a robot is 100 * team + number, team 1 or 2
  double x, y;
};

inline constexpr int ball_object = 0;
constexpr int robot_object(int team, int number) { return 100 * team + number; }

// From `time` on the game runs, or does not.
struct PlayChange {
  double time;
  bool runs;
};

// A piece of a match without gaps that anybody cut.
struct Stretch {
  int number;
  std::vector<Sample> samples;   // by time
  std::vector<PlayChange> play;  // by time; before the first it does not run

  bool runs_at(double time) const;
};

struct GameRecording {
  std::string file;
  std::vector<Stretch> stretches;
};

// Reads a recording of the study's format. `referee`: file of the referee's states (Small Size League only); empty: the
// one beside the data, see referee_file(). Throws config::Error at the place that is wrong.
GameRecording read_recording(const config::PredictorStudy& study, const std::filesystem::path& data,
                             const std::filesystem::path& referee, const Progress& progress = {});

// Where the states of the referee are expected: NAME_referee.csv.gz or NAME_referee.csv beside NAME_ball_*.csv.gz or
// NAME_robots_*.csv.gz. Throws config::Error at `data` when there is none.
std::filesystem::path referee_file(const std::filesystem::path& data);

}  // namespace regista::study
