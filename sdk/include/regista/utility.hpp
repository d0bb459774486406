// SPDX-License-Identifier: MIT
// A utility is one term of the Utility Estimation Matrix: how well each robot would do each task, all at once. The host
// adds the terms with the weights of the team's YAML. The class has
//
//   void score(const regista::Frame&, regista::Utilities out);     out(row, column) = finite value >= 0
//
// Row i is robot frame.world().active()[i], column j is frame.tasks()[j].
#pragma once

#include <regista/plugin.hpp>

namespace regista {

// A matrix in the host's memory.
class Utilities {
 public:
  explicit Utilities(const regista_matrix_room& raw) : raw_(raw) {}
  std::size_t rows() const { return raw_.rows; }
  std::size_t columns() const { return raw_.columns; }
  std::size_t stride() const { return raw_.stride; }
  double* data() const { return raw_.values; }
  double& operator()(std::size_t row, std::size_t column) const {
    // Checked in every build: a write beside the matrix would break the host, far from whoever wrote it.
    if (row >= raw_.rows || column >= raw_.columns) detail::outside("utility", row, column, raw_.rows, raw_.columns);
    return raw_.values[row * raw_.stride + column];
  }

 private:
  regista_matrix_room raw_;
};

#pragma GCC visibility push(hidden)  // see plugin.hpp
struct utility {
  static constexpr std::int32_t kind = REGISTA_KIND_UTILITY;

  template <class Class>
  static const void* table() {
    static constexpr regista_utility calls{
        sizeof(regista_utility), 0,
        [](void* instance, const regista_frame* frame, const regista_matrix_room* out, regista_error* error) {
          return detail::guarded(error, [&] { static_cast<Class*>(instance)->score(Frame(*frame), Utilities(*out)); });
        }};
    return &calls;
  }
};
#pragma GCC visibility pop

}  // namespace regista
