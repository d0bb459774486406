// SPDX-License-Identifier: MIT
// A team of robots that pass tokens over a simulated radio, for tests. Every tick each robot hears what has arrived and
// decides; then it speaks if its packet is due.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "message.hpp"
#include "robot.hpp"

namespace token_passing {

struct Radio {
  double loss = 0.0;                           // probability of each packet and receiver
  double least_delay = 0.0, most_delay = 0.0;  // s
  double period = 0.0;                         // s between two packets of a robot; 0: one at every tick
};

// What is true of the team's tasks, equal for all robots unless a test changes it.
// importance, capability: as in Work.
struct Tasks {
  std::vector<int> ids, importance;                   // the most important first
  std::vector<std::vector<std::int32_t>> capability;  // task x robot
};

class Team {
 public:
  Team(int robots, int tokens, const Settings& chosen, std::uint32_t seed)
      : settings(chosen), size_(robots), random_(seed), minds_(static_cast<std::size_t>(robots)) {
    layout_ = {robots, tokens, settings.rounds()};
    members = (robots == 32 ? 0 : Robots{1} << robots) - 1u;
    for (Mind& mind : minds_) {
      mind.robot.reserve(robots, tokens);
      mind.next_packet = std::uniform_real_distribution<double>(0.0, 1.0)(random_);
    }
  }

  Settings settings;
  Radio radio;
  Tasks tasks;                                             // as all see them
  std::function<Tasks(int number, const Tasks&)> seen_by;  // else; unset: as they are
  Robots members = 0;                                      // those that play
  Robots radio_off = 0;                                    // are not heard
  Robots deaf = 0;                                         // neither hear nor are heard, and are given up at once
  double tick = 0.1;                                       // s
  double now = 0.0;
  int passes = 0;           // so far
  bool hosts_tell = false;  // of packets without tokens

  int size() const { return size_; }
  Robot& robot(int number) { return mind(number).robot; }
  // Id of the task that a robot does, or none.
  int does(int number) const { return minds_[static_cast<std::size_t>(number - 1)].does; }
  // The latest state of a token that anybody knows of; null: nobody does.
  const Token* newest(int id) const {
    const Token* out = nullptr;
    for (const Mind& each : minds_) {
      const Token* token = each.robot.token(id);
      if (token != nullptr && (out == nullptr || compare(*token, *out) == negotiation::Order::later)) out = token;
    }
    return out;
  }
  // Robots that play and believe to hold the token.
  std::vector<int> holders(int id) const {
    std::vector<int> out;
    for (int number = 1; number <= size_; ++number) {
      const Token* token = minds_[static_cast<std::size_t>(number - 1)].robot.token(id);
      const bool plays = (members & only(number)) != 0;
      if (plays && token != nullptr && !token->done && token->holder == number) out.push_back(number);
    }
    return out;
  }
  std::vector<int> doers(int id) const {
    std::vector<int> out;
    for (int number = 1; number <= size_; ++number) {
      if (does(number) == id) out.push_back(number);
    }
    return out;
  }

  void step() {
    for (int number = 1; number <= size_; ++number) {
      Mind& mind = this->mind(number);
      for (const Arrival& each : mind.inbox) {
        if (each.time <= now) hear(number, each);
      }
      std::erase_if(mind.inbox, [this](const Arrival& each) { return each.time <= now; });
      decide(number);
    }
    for (int number = 1; number <= size_; ++number) {
      Mind& mind = this->mind(number);
      if (radio.period > 0.0 && mind.next_packet > now) continue;
      if (radio.period > 0.0)
        mind.next_packet += radio.period * std::uniform_real_distribution<double>(0.9, 1.1)(random_);
      if ((members & only(number)) != 0) speak(number);
    }
    now += tick;
  }
  void play(double seconds) {
    for (const double end = now + seconds - 1e-9; now < end;) step();
  }

 private:
  struct Arrival {
    int sender;
    double sent, time;
    std::vector<std::uint8_t> bytes;
  };
  struct Mind {
    Robot robot;
    double next_packet = 0.0;
    int does = Robot::none;
    std::vector<Arrival> inbox;
  };
  Mind& mind(int number) { return minds_[static_cast<std::size_t>(number - 1)]; }

  void hear(int number, const Arrival& packet) {
    if (read(layout_, packet.sender, packet.bytes, read_)) {
      mind(number).robot.hear(number, packet.sender, read_, packet.sent, now, true);
    } else if (packet.bytes.empty()) {
      mind(number).robot.overhear(number, packet.sender, packet.sent);
    }
  }

  void decide(int number) {
    Tasks other;
    if (seen_by) other = seen_by(number, tasks);
    const Tasks& seen = seen_by ? other : tasks;
    std::vector<Work> work;
    for (std::size_t i = 0; i < seen.ids.size(); ++i) {
      work.push_back({seen.ids[i], seen.importance[i], seen.capability[i]});
    }
    Robots known = members;
    if ((deaf & only(number)) != 0) known &= only(number);
    known &= ~(deaf & ~only(number));
    Mind& mind = this->mind(number);
    std::vector<int> held_before;
    for (int id = 0; id < layout_.tokens; ++id) {
      const Token* token = mind.robot.token(id);
      if (token != nullptr && token->holder == number && !token->done) held_before.push_back(id);
    }
    const int w = mind.robot.decide(settings, {now, number, known, work});
    mind.does = w == Robot::none ? Robot::none : seen.ids[static_cast<std::size_t>(w)];
    for (const int id : held_before) {
      const int holder = mind.robot.token(id)->holder;
      if (holder != number && holder != 0) ++passes;
    }
  }

  void speak(int number) {
    const auto told = mind(number).robot.told();
    write(layout_, told, bytes_);
    mind(number).robot.transmitted(told.size());
    if ((told.empty() && !hosts_tell) || ((deaf | radio_off) & only(number)) != 0) return;
    for (int other = 1; other <= size_; ++other) {
      if (other == number || (deaf & only(other)) != 0) continue;
      if (std::uniform_real_distribution<double>(0.0, 1.0)(random_) < radio.loss) continue;
      const double delay = std::uniform_real_distribution<double>(radio.least_delay, radio.most_delay)(random_);
      mind(other).inbox.push_back({number, now, now + delay, bytes_});
    }
  }

  int size_;
  std::mt19937 random_;
  Layout layout_;
  std::vector<Mind> minds_;
  std::vector<Told> read_;
  std::vector<std::uint8_t> bytes_;
};

inline Tasks make_tasks(std::vector<std::vector<std::int32_t>> capability) {
  Tasks out;
  for (std::size_t i = 0; i < capability.size(); ++i) {
    out.ids.push_back(static_cast<int>(i));
    out.importance.push_back(static_cast<int>(i));
  }
  out.capability = std::move(capability);
  return out;
}

inline Tasks random_tasks(int robots, int tasks, std::mt19937& random, bool some_forbidden = false) {
  std::vector<std::vector<std::int32_t>> capability(static_cast<std::size_t>(tasks));
  for (auto& row : capability) {
    for (int number = 1; number <= robots; ++number) {
      const bool forbidden = some_forbidden && random() % 5 == 0;
      row.push_back(forbidden ? -1 : static_cast<std::int32_t>(random() % 1001));
    }
  }
  return make_tasks(std::move(capability));
}

inline int one_holder(const Team& team, int id) {
  const std::vector<int> holders = team.holders(id);
  return holders.size() == 1 ? holders.front() : -static_cast<int>(holders.size());
}

// Only some robots perceive the task with this id.
inline void only_seen_by(Team& team, Robots robots, int id) {
  team.seen_by = [robots, id](int number, const Tasks& all) {
    Tasks out;
    for (std::size_t i = 0; i < all.ids.size(); ++i) {
      if (all.ids[i] == id && (robots & only(number)) == 0) continue;
      out.ids.push_back(all.ids[i]);
      out.importance.push_back(all.importance[i]);
      out.capability.push_back(all.capability[i]);
    }
    return out;
  };
}

}  // namespace token_passing
