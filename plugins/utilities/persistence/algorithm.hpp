// SPDX-License-Identifier: MIT
// Keeping a role pays: h in [0, 1] grows with the time for which it has been held and is full after a while (10 s in
// the SPQR team's utility of 2022, weight 0.2). In that of 2023 it is full at once and fades: times 0.9 each second,
// weight 0.5. SPQR's code counts it for the own row only, so that each robot computes another matrix even when all
// messages arrive; counting it on every row is what makes the matrices alike.
//
// The released code of 2022 divides whole seconds by 10, so that there h is a step: 0 before, then 1.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>

namespace persistence_utility {

inline constexpr int no_role = -1;
inline constexpr double least = 1e-12;  // what has faded below is 0: it would only cost time as a denormal number

struct Holder {
  int role = no_role;  // id of the role that the robot of this row holds
  double held = 0.0;   // s; negative counts as 0
};

struct Settings {
  double ramp_seconds = 10.0;  // s, >= 0; 0: at once
  double fade = 1.0;           // factor for each whole second for which the role has been held, [0, 1]; 1: never
  bool step = false;           // nothing before ramp_seconds
};

// factor^count by repeated squaring: the same bits on every processor, which pow of the C library does not promise.
inline double power(double factor, std::uint32_t count) {
  double out = 1.0;
  for (; count != 0 && out != 0.0; count >>= 1, factor *= factor) {
    if ((count & 1u) != 0) out *= factor;
  }
  return out;
}

// In [0, 1].
inline double value(double held, const Settings& settings) {
  double grown = settings.ramp_seconds > 0.0 ? std::clamp(held / settings.ramp_seconds, 0.0, 1.0) : 1.0;
  if (settings.step && grown < 1.0) grown = 0.0;
  if (settings.fade == 1.0) return grown;
  constexpr double longest = 1e6;  // s; by then whatever fades has faded
  const double faded = power(settings.fade, static_cast<std::uint32_t>(std::clamp(held, 0.0, longest)));
  return faded < least ? 0.0 : grown * faded;
}

// out[i * stride + j] = value of the time held where robot i holds task j; other entries are not touched. A role that
// is no task now, or no_role, leaves its row as it is.
inline void score(std::span<const Holder> rows, std::span<const int> task_ids, const Settings& settings, double* out,
                  std::size_t stride) {
  assert(settings.ramp_seconds >= 0.0 && settings.fade >= 0.0 && settings.fade <= 1.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].role == no_role) continue;
    const auto column = std::find(task_ids.begin(), task_ids.end(), rows[i].role);
    if (column == task_ids.end()) continue;
    out[i * stride + static_cast<std::size_t>(column - task_ids.begin())] = value(rows[i].held, settings);
  }
}

}  // namespace persistence_utility
