// SPDX-License-Identifier: MIT
// A ball that keeps its velocity: a Kalman filter for which x and y are alike. Knows nothing of Regista, so that it can
// be tested and used alone.
#pragma once

struct MovingBall {
  double x = 0.0, y = 0.0, vx = 0.0, vy = 0.0;
  double place = 0.0, cross = 0.0, velocity = 0.0;  // covariance of each axis: m^2, m^2/s, m^2/s^2
  double age = 0.0;                                 // s since it was seen
};

// dt s later. noise: how fast the velocity becomes uncertain, m/s^1.5.
inline void predict(MovingBall& ball, double dt, double noise) {
  const double q = noise * noise;
  ball.x += dt * ball.vx;
  ball.y += dt * ball.vy;
  ball.place += dt * (2.0 * ball.cross + dt * (ball.velocity + q * dt / 3.0));
  ball.cross += dt * (ball.velocity + q * dt / 2.0);
  ball.velocity += q * dt;
  ball.age += dt;
}

// It is seen at (x, y). variance: of each of the two, m^2, > 0.
inline void correct(MovingBall& ball, double x, double y, double variance) {
  const double for_place = ball.place / (ball.place + variance), for_velocity = ball.cross / (ball.place + variance);
  const double dx = x - ball.x, dy = y - ball.y;
  ball.x += for_place * dx;
  ball.y += for_place * dy;
  ball.vx += for_velocity * dx;
  ball.vy += for_velocity * dy;
  ball.velocity -= for_velocity * ball.cross;
  ball.cross *= 1.0 - for_place;
  ball.place *= 1.0 - for_place;
  ball.age = 0.0;
}
