// SPDX-License-Identifier: MIT
// A radio that loses, delays and reorders: broadcast only, nothing acknowledged. Each receiver of a packet has its own
// luck. The same seed gives the same losses.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <regista/testkit/dice.hpp>

namespace regista::testkit {

struct RadioConditions {
  double loss = 0.0;          // probability that one receiver does not get a packet
  double usual_delay = 0.15;  // s, at most; a tenth of what arrives takes up to `long_delay` and may be overtaken
  double long_delay = 1.5;
};

struct Packet {
  int sender = 0;  // shirt number
  double time_sent = 0.0;
  std::vector<std::vector<std::uint8_t>> segments;
  std::int32_t role = -1;  // that the sender claims, and since when
  double role_since = 0.0;
  std::array<double, 3> pose{};  // of the sender, as it believes
};

class Radio {
 public:
  Radio(int robots, const RadioConditions& conditions, std::uint64_t seed);

  // Neither sends nor receives until it is in range again.
  void out_of_range(int number) { at(in_range_, number) = 0; }
  void into_range(int number) { at(in_range_, number) = 1; }

  void send(const Packet& packet);
  // What `receiver` has got by `now`, in the order of arrival; each packet once.
  std::vector<Packet> arrived(int receiver, double now);

 private:
  struct OnItsWay {
    double arrives;
    Packet packet;
  };
  template <class T>
  static T& at(std::vector<T>& of, int number) {
    return of.at(static_cast<std::size_t>(number) - 1);
  }

  RadioConditions conditions_;
  Dice dice_;
  std::vector<char> in_range_;
  std::vector<std::vector<OnItsWay>> on_their_way_;  // by receiver
};

}  // namespace regista::testkit
