// SPDX-License-Identifier: MIT
// A study of a predictor over a recording. It states the predictor, the format of the recording, the observations that
// the predictor receives, the questions to the predictor, and the baselines for comparison.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "config/declaration.hpp"
#include "config/team.hpp"

namespace regista::config {

struct PredictorStudy {
  enum class Format { ssl_ball, ssl_robots, simulation_2d };
  enum class Subject { ball, opponents };

  struct Field {
    double length = 9.0, width = 6.0;  // m
  };

  // Properties of the detections in the recording.
  struct Camera {
    double noise = 0.01;  // m, standard deviation of a detection per axis
    // Within this distance of the centre (m), a missing detection means an absent object. 0: the distance is unknown.
    double range = 0.0;
  };

  // Which detections the predictor receives. It receives them in the form of observations in packets of robots.
  struct Observations {
    double every = 0.0;  // least time between two observations of an object, s; 0: all detections
    double drop = 0.0;   // additional probability that an observation is lost
    int seed = 1;
  };

  // The times of the questions to the predictor, and the prediction horizons.
  struct Questions {
    int every = 3;                                        // one question follows this many detections of an object
    std::array<double, 4> horizons{0.1, 0.25, 0.5, 1.0};  // s
    double tolerance = 0.012;  // s; the true place is the detection nearest in time, at most this much earlier or later
    double memory = 3.0;       // the predictor receives the observations of this time before the question, s
    double step = 0.1;         // largest time step of the prediction, s
  };

  // Models for comparison. They estimate the velocity by least squares, and assume constant or decreasing velocity.
  struct Baselines {
    double window = 0.15;  // s, time of the observations for the least squares
    int least = 4;         // least number of observations in the window
    // For decreasing velocity, exactly one value is set: deceleration (rolling ball) or time_constant (stopping robot).
    std::optional<double> deceleration;   // m/s^2
    std::optional<double> time_constant;  // s
  };

  std::string name;
  Format format = Format::ssl_ball;
  Subject subject = Subject::ball;
  PluginUse predictor;
  Field field;
  double robot_radius = 0.09;  // m
  Camera camera;
  Observations observations;
  Questions questions;
  Baselines baselines;
};

Map declare(PredictorStudy& study);
void check(const PredictorStudy& study, const Node& document, Mistakes& mistakes);

}  // namespace regista::config
