// SPDX-License-Identifier: MIT
// A study of a predictor over a recording: which predictor, how the recording is read, what the predictor is shown of
// it, what it is asked, and what it is compared with.
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

  // What the recording's detections are like.
  struct Camera {
    double noise = 0.01;  // m, standard deviation per axis of a detection
    // m: all within it would have been seen, so that an absence is news; 0: the recording does not tell.
    double range = 0.0;
  };

  // What the predictor is shown of it, as if it came in packets.
  struct Observations {
    double every = 0.0;  // s between two of an object; 0: all
    double drop = 0.0;   // probability that one is lost on top
    int seed = 1;
  };

  // When it is asked, and how far ahead.
  struct Questions {
    int every = 3;                                        // detections of an object
    std::array<double, 4> horizons{0.1, 0.25, 0.5, 1.0};  // s
    double tolerance = 0.012;                             // s: the truth is the detection nearest in time, this near
    double memory = 3.0;                                  // s of observations before the question that are shown
    double step = 0.1;                                    // s: it is carried forward in steps of at most this
  };

  // Velocity by least squares; then onwards at that velocity, or losing it.
  struct Baselines {
    double window = 0.15;  // s
    int least = 4;         // observations in the window
    // Exactly one of the two: a ball that rolls, or a robot that will stop.
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

// Throws Error at values of the document that are sound one by one, but not together.
void check(const PredictorStudy& study, const Node& document, Mistakes& mistakes);

}  // namespace regista::config
