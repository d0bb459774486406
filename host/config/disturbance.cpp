// SPDX-License-Identifier: MIT
#include "config/disturbance.hpp"

#include "config/profiles.hpp"

namespace regista::config {

Map declare(Disturbance& disturbance) {
  return {{
      required(name("disturbance", disturbance.name, "name of this disturbance")),
      real("extra_packet_loss", disturbance.extra_packet_loss, {0, 1}, "1", "probability per packet and receiver"),
      real("extra_delay", disturbance.extra_delay, {0, 60}, "s", "of every packet"),
      real("ball_blindness", disturbance.ball_blindness, {0, 1}, "1",
           "probability that a sighting of the ball is lost"),
  }};
}

}  // namespace regista::config
