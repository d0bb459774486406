// SPDX-License-Identifier: MIT
// A curve over any number of places in bounded memory: every place is kept until there are too many, then every second,
// every fourth, and so on. Which ones are kept follows from how many there were, so the same results give the same
// curve.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace regista::report {

template <class Point>
class Thinned {
 public:
  // most: points that are kept, an even number.
  explicit Thinned(std::size_t most) : most_(most) {}

  // The next place. `make` gives its point, and is asked only where it is kept.
  template <class Make>
  void offer(Make make) {
    ++places_;
    last_is_kept_ = places_ % stride_ == 0;
    if (!last_is_kept_) return;
    points_.push_back(make());
    if (points_.size() < most_) return;
    // Of places stride, 2 stride, 3 stride, ... the even ones stay; the last is among them.
    for (std::size_t i = 0; 2 * i + 1 < points_.size(); ++i) points_[i] = points_[2 * i + 1];
    points_.resize(points_.size() / 2);
    stride_ *= 2;
  }

  std::uint64_t places() const { return places_; }
  std::uint64_t stride() const { return stride_; }

  // What was kept, and the last place in any case.
  template <class Make>
  std::vector<Point> with_last(Make make) const {
    std::vector<Point> out = points_;
    if (places_ > 0 && !last_is_kept_) out.push_back(make());
    return out;
  }

 private:
  std::size_t most_;
  std::uint64_t places_ = 0, stride_ = 1;
  bool last_is_kept_ = false;
  std::vector<Point> points_;
};

}  // namespace regista::report
