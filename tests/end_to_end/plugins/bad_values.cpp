// SPDX-License-Identifier: MIT
// An assigner and a utility that hand back wrong values as soon as two robots are known. Until then there is no row 1,
// and a whole match begins with frames of a single robot.
#include <limits>

#include <regista/assigner.hpp>
#include <regista/utility.hpp>

struct AssignsBeyond {
  static constexpr auto id = "assigns_beyond", version = "1.0.0", summary = "Gives a task that does not exist";
  void assign(const regista::Frame&, regista::UtilityMatrix utilities, regista::Assignment out) {
    if (out.size() > 1) out[1] = static_cast<std::int32_t>(utilities.columns()) + 2;
  }
};

struct ScoresNan {
  static constexpr auto id = "scores_nan", version = "1.0.0", summary = "Scores with what is no number";
  void score(const regista::Frame&, regista::Utilities out) {
    if (out.rows() > 1) out(1, 0) = std::numeric_limits<double>::quiet_NaN();
  }
};

REGISTA_PLUGINS(regista::Plugin<AssignsBeyond, regista::assigner>, regista::Plugin<ScoresNan, regista::utility>)
