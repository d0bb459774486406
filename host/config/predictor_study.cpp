// SPDX-License-Identifier: MIT
#include "config/predictor_study.hpp"

#include "config/read.hpp"
#include "config/team_document.hpp"

namespace regista::config {

static Map declare(PredictorStudy::Field& field) {
  return {{
      real("length", field.length, {0.5, 200}, "m", "between the goal lines"),
      real("width", field.width, {0.5, 200}, "m", "between the touch lines"),
  }};
}

static Map declare(PredictorStudy::Camera& camera) {
  return {{
      real("noise", camera.noise, {1e-4, 10}, "m", "standard deviation of a detection, each component"),
      real("range", camera.range, {0, 1000}, "m",
           "what is nearer to the centre and not detected was not there; 0: an absence says nothing"),
  }};
}

static Map declare(PredictorStudy::Observations& observations) {
  return {{
      real("every", observations.every, {0, 3600}, "s", "least time between two of an object; 0 shows all"),
      real("drop", observations.drop, {0, 1}, "1", "probability that one is lost on top of that"),
      integer("seed", observations.seed, {0, 2147483647}, "1", "of the losses"),
  }};
}

static Map declare(PredictorStudy::Questions& questions) {
  return {{
      integer("every", questions.every, {1, 1000000}, "1", "detection of an object at which the predictor is asked"),
      numbers("horizons", questions.horizons, {0.001, 60}, "s", "how far ahead it is asked", true),
      real("tolerance", questions.tolerance, {0, 1}, "s", "the truth is the detection nearest in time, at most so far"),
      real("memory", questions.memory, {0, 600}, "s", "of observations before the question that it is shown"),
      real("step", questions.step, {0.001, 60}, "s", "longest step by which it is carried forward"),
  }};
}

static Map declare(PredictorStudy::Baselines& baselines) {
  return {.fields =
              {
                  real("window", baselines.window, {0.001, 60}, "s", "velocity: least squares over so long"),
                  integer("least", baselines.least, {2, 1000}, "1", "observations that a velocity takes"),
                  real("deceleration", baselines.deceleration, {1e-3, 100}, "m/s^2", "decayed: rolls until it stops"),
                  real("time_constant", baselines.time_constant, {1e-3, 100}, "s", "decayed: loses its velocity so"),
              },
          .exactly_one = {"deceleration", "time_constant"}};
}

Map declare(PredictorStudy& study) {
  return {{
      required(name("predictor_study", study.name, "name of this study")),
      required(choice("format", study.format, {"ssl_ball", "ssl_robots", "simulation_2d"}, "of the recording")),
      required(choice("subject", study.subject, {"ball", "opponents"}, "what the predictor models")),
      required(plugin_field("predictor", study.predictor, "predictor", "what is studied")),
      required(section("field", study.field, "of the recording")),
      real("robot_radius", study.robot_radius, {0.01, 2}, "m", "of the recording's robots"),
      section("camera", study.camera, "what the recording's detections are like"),
      section("observations", study.observations, "which part of the recording the predictor is shown, as in packets"),
      section("questions", study.questions, "when it is asked, and what"),
      required(section("baselines", study.baselines, "what it is compared with")),
  }};
}

void check(const PredictorStudy& study, const Node& document, Mistakes& mistakes) {
  using Format = PredictorStudy::Format;
  using Subject = PredictorStudy::Subject;
  const Refusals wrong(document, mistakes);
  if (study.format == Format::ssl_ball && study.subject != Subject::ball) {
    wrong({"subject"}, "a recording of format ssl_ball tells of the ball alone");
  }
  if (study.format == Format::ssl_robots && study.subject != Subject::opponents) {
    wrong({"subject"}, "a recording of format ssl_robots tells of robots alone");
  }
  if (study.questions.memory < study.baselines.window) {
    wrong({"questions.memory", "baselines.window"}, "the predictor is shown less ({} s) than the baselines ({} s)",
          study.questions.memory, study.baselines.window);
  }
}

}  // namespace regista::config
