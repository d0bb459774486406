// SPDX-License-Identifier: MIT
// What a mind believes as bytes: see texts/bytes.hpp.
#pragma once

#include "match/belief.hpp"
#include "texts/bytes.hpp"

namespace regista::match {

template <class Archive>
void visit(Archive& archive, Vector& vector) {
  archive(vector.x, vector.y);
}

template <class Archive>
void visit(Archive& archive, Estimate& estimate) {
  archive(estimate.known, estimate.at, estimate.xx, estimate.xy, estimate.yy);
}

template <class Archive>
void visit(Archive& archive, Belief& belief) {
  archive(belief.self, belief.ball, belief.teammates, belief.opponents);
}

}  // namespace regista::match
