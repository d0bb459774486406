// SPDX-License-Identifier: MIT
// What becomes of a packet is drawn when it is sent, for each receiver.
#include <regista/testkit/radio.hpp>

#include <algorithm>
#include <utility>

namespace regista::testkit {

Radio::Radio(int robots, const RadioConditions& conditions, std::uint64_t seed)
    : conditions_(conditions),
      dice_(seed),
      in_range_(static_cast<std::size_t>(robots), 1),
      on_their_way_(static_cast<std::size_t>(robots)) {}

void Radio::send(const Packet& packet) {
  constexpr double stragglers = 0.1;
  for (int receiver = 1; receiver <= static_cast<int>(in_range_.size()); ++receiver) {
    // Drawn for each alike, so that who is in range does not change the luck of the others.
    const bool lost = dice_.chance(conditions_.loss);
    const bool straggles = dice_.chance(stragglers);
    const double delay = dice_.real(0.0, straggles ? conditions_.long_delay : conditions_.usual_delay);
    if (receiver == packet.sender || lost || !at(in_range_, packet.sender) || !at(in_range_, receiver)) continue;
    at(on_their_way_, receiver).push_back({packet.time_sent + delay, packet});
  }
}

std::vector<Packet> Radio::arrived(int receiver, double now) {
  std::vector<OnItsWay>& waiting = at(on_their_way_, receiver);
  std::ranges::stable_sort(waiting, {}, &OnItsWay::arrives);
  const auto last = std::ranges::find_if(waiting, [now](const OnItsWay& each) { return each.arrives > now; });
  std::vector<Packet> out;
  for (auto each = waiting.begin(); each != last; ++each) out.push_back(std::move(each->packet));
  waiting.erase(waiting.begin(), last);
  return out;
}

}  // namespace regista::testkit
