// SPDX-License-Identifier: MIT
// Tasks in their order, each to the free robot that is best for it: an assigner on the C++ headers.
#include <regista/assigner.hpp>

namespace {

struct BestFirst {
  static constexpr auto id = "best_first", version = "1.0.0", summary = "Each task in order to its best free robot";
  double least = 0.0;
  static constexpr std::tuple parameters{
      regista::real("least", &BestFirst::least, {0.0, 10.0}, "1", "pairs with less utility stay unassigned")};

  void assign(const regista::Frame&, regista::UtilityMatrix utilities, regista::Assignment out) {
    for (std::size_t column = 0; column < utilities.columns(); ++column) {
      std::size_t best = utilities.rows();
      for (std::size_t row = 0; row < utilities.rows(); ++row) {
        if (out[row] != regista::Assignment::no_task || utilities(row, column) < least) continue;
        if (best == utilities.rows() || utilities(row, column) > utilities(best, column)) best = row;
      }
      if (best < utilities.rows()) out[best] = static_cast<std::int32_t>(column);
    }
  }
};

}  // namespace

REGISTA_PLUGIN(BestFirst, regista::assigner)
