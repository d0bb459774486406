// SPDX-License-Identifier: MIT
// A recording of real or simulated matches: places of ball and robots over time, and the times at which the game ran.
// Units: m and s. The frame is the recording's field: origin at the centre, x along the field, y to the left.
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

// A change of play: from `time` on, the game runs or does not run.
struct PlayChange {
  double time;
  bool runs;
};

// A part of a match without cuts.
struct Stretch {
  int number;
  std::vector<Sample> samples;   // by time
  std::vector<PlayChange> play;  // by time; the game does not run before the first change

  bool runs_at(double time) const;
};

struct GameRecording {
  std::string file;
  std::vector<Stretch> stretches;
};

// Reads a recording of the study's format. `referee`: file of the referee's states (only Small Size League); if empty,
// NAME_referee.csv.gz or NAME_referee.csv beside NAME_ball_*.csv.gz or NAME_robots_*.csv.gz. Throws config::Error at
// the place of the mistake.
GameRecording read_recording(const config::PredictorStudy& study, const std::filesystem::path& data,
                             const std::filesystem::path& referee, const Progress& progress = {});

}  // namespace regista::study
