// SPDX-License-Identifier: MIT
// An assigner gives tasks to robots (Phi of the paper). The class has
//
//   void assign(const regista::Frame&, regista::UtilityMatrix, regista::Assignment out);    out[row] = column
//
// and, when robots may show the same task while they have not agreed yet,
//
//   static constexpr bool negotiates = true;
#pragma once

#include <limits>

#include <regista/plugin.hpp>

namespace regista {

// The Utility Estimation Matrix: entries finite and >= 0, or `forbidden`. Row i is frame.world().active()[i], column j
// is frame.tasks()[j].
class UtilityMatrix {
 public:
  static constexpr double forbidden = -std::numeric_limits<double>::infinity();
  explicit UtilityMatrix(const regista_matrix& raw) : raw_(raw) {}
  std::size_t rows() const { return raw_.rows; }
  std::size_t columns() const { return raw_.columns; }
  std::size_t stride() const { return raw_.stride; }
  const double* data() const { return raw_.values; }
  double operator()(std::size_t row, std::size_t column) const {
    assert(row < raw_.rows && column < raw_.columns);
    return raw_.values[row * raw_.stride + column];
  }

 private:
  regista_matrix raw_;
};

// One entry per row: a column, `no_task` (as it is on entry) or `unknown_task`.
class Assignment {
 public:
  static constexpr std::int32_t no_task = REGISTA_NO_TASK, unknown_task = REGISTA_UNKNOWN_TASK;
  Assignment(std::int32_t* out, std::size_t rows) : out_(out), rows_(rows) {}
  std::size_t size() const { return rows_; }
  std::int32_t& operator[](std::size_t row) const {
    if (row >= rows_) detail::outside("assignment", row, 0, rows_, 1);  // in every build, as in Utilities
    return out_[row];
  }

 private:
  std::int32_t* out_;
  std::size_t rows_;
};

#pragma GCC visibility push(hidden)  // see plugin.hpp
struct assigner {
  static constexpr std::int32_t kind = REGISTA_KIND_ASSIGNER;

  template <class Class>
  static constexpr std::uint32_t flags() {
    if constexpr (requires { Class::negotiates; }) {
      return Class::negotiates ? REGISTA_ASSIGNER_NEGOTIATES : 0;
    } else {
      return 0;
    }
  }

  template <class Class>
  static const void* table() {
    static constexpr regista_assigner calls{
        sizeof(regista_assigner), flags<Class>(),
        [](void* instance, const regista_frame* frame, const regista_matrix* utilities, std::int32_t* out,
           regista_error* error) {
          return detail::guarded(error, [&] {
            static_cast<Class*>(instance)->assign(Frame(*frame), UtilityMatrix(*utilities),
                                                  Assignment(out, utilities->rows));
          });
        }};
    return &calls;
  }
};
#pragma GCC visibility pop

}  // namespace regista
