// SPDX-License-Identifier: MIT
// How soon each robot can be at each task: a time, rather than a distance, tells a robot that lies on the ground from
// one that stands. B-Human chooses the player of the ball so: the least time to reach it, the present player counting 1
// s less, one that is getting up 5 s more.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>

namespace time_to_reach {

enum class Form { linear, inverse };  // max(0, 1 - t / scale), 1 / (1 + t / scale)

inline constexpr int no_task = -1;

struct Row {
  double extra = 0.0;  // s that this robot needs besides, >= 0
  int held = no_task;  // column of the task that it holds
};

struct Settings {
  Form form = Form::linear;
  double scale = 60.0;     // s, > 0
  double incumbent = 0.0;  // s that a robot's own task counts less, >= 0
};

// Row-major, element (i, j) at i * stride + j; stride >= columns.
template <class Value>
struct Matrix {
  Value* values;
  std::size_t stride;
};

// out(i, j) in [0, 1] from times(i, j) >= 0, s.
inline void score(std::span<const Row> rows, std::size_t columns, const Matrix<const double>& times,
                  const Settings& settings, const Matrix<double>& out) {
  assert(settings.scale > 0.0);
  const double per_second = 1.0 / settings.scale;
  const auto value = [&](double time) {
    const double scaled = time * per_second;
    return settings.form == Form::linear ? std::max(0.0, 1.0 - scaled) : 1.0 / (1.0 + scaled);
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double* time = times.values + i * times.stride;
    double* to = out.values + i * out.stride;
    const double extra = rows[i].extra;
    if (settings.form == Form::linear) {
      for (std::size_t j = 0; j < columns; ++j) to[j] = std::max(0.0, 1.0 - (time[j] + extra) * per_second);
    } else {
      for (std::size_t j = 0; j < columns; ++j) to[j] = 1.0 / (1.0 + (time[j] + extra) * per_second);
    }
    if (rows[i].held == no_task) continue;
    const auto held = static_cast<std::size_t>(rows[i].held);
    to[held] = value(std::max(0.0, time[held] + extra - settings.incumbent));
  }
}

}  // namespace time_to_reach
