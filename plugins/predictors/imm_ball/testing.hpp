// SPDX-License-Identifier: MIT
// What the tests of imm_ball share.
#pragma once

#include <Eigen/Dense>

#include "../test_ball.hpp"
#include "algorithm.hpp"

namespace imm_ball {

using ball::ahead, ball::covariance, ball::everywhere, ball::mean;
using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;

inline constexpr auto in_reach = [](const Whereabouts&) { return Reach::somebody; };
inline constexpr auto out_of_reach = [](const Whereabouts&) { return Reach::nobody; };

// Squared error under the covariance that the estimate tells.
inline double normalised(const Vector2d& error, const Matrix2d& told) { return error.dot(told.inverse() * error); }
inline double normalised(const Vector4d& error, const Matrix4d& told) { return error.dot(told.inverse() * error); }

}  // namespace imm_ball
