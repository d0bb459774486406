// SPDX-License-Identifier: MIT
// The SPQR team's role assignment as released in 2022 (its context-based coordination: Riccio, Borzi, Gemignani and
// Nardi, RoboCup 2015; Riccio et al., IROS 2016): greedy, but a robot takes another role only a second after the one
// that is computed has begun to differ from the one that it has.
//
// The clock starts when they first differ, and is not stopped when they agree again; when it ends, the robot takes what
// is computed then. Both as in that code. `lasting` is ours: the difference must have lasted.
//
// A robot delays its own role alone. What it shows of the others is greedy, too, without the role that it keeps.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <plugins/assigners/greedy/algorithm.hpp>
#include <plugins/assigners/matrix.hpp>

namespace delayed_greedy {

using assignment::forbidden, assignment::Matrix;

inline constexpr int no_task = -1;

struct Settings {
  double after = 1.0;    // s from the first difference to the change
  bool lasting = false;  // the difference must last for so long
};

// Since when the role of one robot is not the one that is computed.
class Delay {
 public:
  void forget() { *this = {}; }
  // has, wanted: ids of the tasks that the robot has and that is computed, no_task for none. keeps: whether it could go
  // on with what it has. Returns whether it shall have what is computed. time: s, never runs back. Call once per
  // decision.
  bool changes(const Settings& settings, double time, int has, int wanted, bool keeps) {
    constexpr double rounding = 1e-9;  // s
    // Without a role, or with one that there is no more, nothing is waited for.
    if (has == no_task || !keeps || (has == wanted && (settings.lasting || !waits_))) {
      waits_ = false;
      return true;
    }
    if (!waits_) {
      waits_ = true;
      since_ = time;
    }
    if (time - since_ < settings.after - rounding) return false;
    waits_ = false;
    return true;
  }

 private:
  bool waits_ = false;
  double since_ = 0.0;  // when the two first differed; while it waits
};

// The greedy pairing of greedy::assign in which this row has this column, an allowed pair. out comes in with a negative
// number for every row. `scratch`: as many numbers as there are pairs; written over.
inline void assign_beside(const Matrix& utilities, std::span<const std::uint32_t> order, std::size_t row,
                          std::size_t column, std::span<double> scratch, std::span<std::int32_t> out) {
  assert(scratch.size() >= utilities.rows * utilities.columns && utilities(row, column) != forbidden);
  for (std::size_t i = 0; i < utilities.rows; ++i) {
    for (std::size_t j = 0; j < utilities.columns; ++j) {
      const bool is_open = (i == row) == (j == column);
      scratch[i * utilities.columns + j] = is_open ? utilities(i, j) : forbidden;
    }
  }
  greedy::assign({scratch.data(), utilities.rows, utilities.columns, utilities.columns}, order, out);
}

}  // namespace delayed_greedy
