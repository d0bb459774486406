// SPDX-License-Identifier: MIT
// Assigner plugin around SCRAM's solver and last_map.hpp: the role assignment of Nao Devils (released code, 2024). The
// packets are those of the sender nao_devils_sender.
//
//   - Every robot computes the map with the least longest walk (MMDR) from what it knows. Played is the map that was
//     broadcast last.
//   - While robots and tasks are those of that map and its longest walk is no more than a metre longer than the best
//     one, it is kept. Else a new one is broadcast: by the ball chaser alone, so that one robot decides for all; by
//     anyone if there is no map. All adopt the newest.
//   - The ball chaser is who has the role that plays the ball by the map in force, and whose last packet says so while
//     no other robot has claimed the role since. The platform has no message for chasers: the role stands in every
//     packet.
//
// Ours:
//   - The author repeats its map with every packet, until it hears a newer one. Published: who missed it disagrees
//     until the next map.
//   - The author plays its map from the moment at which it is sent. Until then, it plays the old one, as all do.
//   - There is no map, and anyone may make one, also when robots have left or returned or another list of roles is in
//     force; and for a robot whose own task by the map is no longer kept: see LastMap::look(). Until a new one is
//     heard, such a robot plays its own best one.
//   - Robots whose task by the map is not known here, or that it does not know: ../negotiation/follow_map.hpp.
//   - When 5 packets are left roles are static, as published; but by rank among the robots in the game, not by number:
//     ../negotiation/reserve.hpp.
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <plugins/assigners/scram/from_frame.hpp>
#include <regista/assigner.hpp>
#include <regista/host.hpp>
#include <regista/mailbox.hpp>

#include "../negotiation/follow_map.hpp"
#include "../negotiation/reserve.hpp"
#include "../negotiation/say_map.hpp"
#include "../negotiation/standing_offer.hpp"
#include "keep_map.hpp"
#include "last_map.hpp"

namespace {

constexpr unsigned serial_bits = 8;

struct NaoDevils {
  static constexpr auto id = "nao_devils", version = "1.0.0",
                        summary = "The ball chaser broadcasts who does what, and all play the newest map";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr bool negotiates = true;

  std::string chaser = "striker";
  double margin = 1.0;
  int stop_negotiating_at = 5;
  static constexpr std::tuple parameters{
      regista::text(
          "chaser", &NaoDevils::chaser,
          "Name of the role that plays the ball, in any list of roles; the robot with this role decides for all"),
      regista::real("margin", &NaoDevils::margin, {0.0, 20.0}, "m",
                    "The last map is kept while its longest walk is at most so much longer than it could be; Nao "
                    "Devils: 1")
          .tunable(),
      regista::integer("stop_negotiating_at", &NaoDevils::stop_negotiating_at, {-1, 10000}, "1",
                       "Packets of the team at which robots stop making maps and take roles by rank; Nao Devils: 5; "
                       "-1: they never do")};

  scram::FrameSolver solver;
  scram::MapOfFrame here;
  scram::Follower follower;
  nao_devils::LastMap last;
  negotiation::StandingOffer offer;
  negotiation::Reserve reserve;
  int own = 1;
  std::vector<bool> chases;  // by id of the role
  std::vector<std::int32_t> assigned, best, heard;
  std::vector<std::uint8_t> bytes;
  nao_devils::Stamp draft_stamp;
  std::vector<std::int32_t> draft;  // as offered; empty: what is offered is the last map, or nothing

  void setup(const regista::Environment& environment, const regista::Host& host) {
    const std::size_t robots = environment->team_size, roles = environment.roles().size();
    own = environment->own_number;
    for (const regista::Role& role : environment.roles()) chases.push_back(chaser == role.name);
    solver.reserve(robots, roles);
    here.setup(environment);
    follower.reserve(roles);
    last.reserve(robots);
    reserve.setup(environment, host, stop_negotiating_at);
    offer.setup(host.mailbox(), here.code().bytes(serial_bits));
    bytes.reserve(here.code().bytes(serial_bits));
    for (auto* each : {&assigned, &best, &heard, &draft}) each->reserve(robots);
  }

  void reset(std::uint64_t) {
    last.forget();
    offer.forget();
    draft.clear();
  }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    if (reserve.is_reached()) {
      draft.clear();
      offer.withdraw();
      return reserve.assign_by_rank(frame, utilities, out);
    }
    assigned.resize(out.size());
    solver.assign({}, frame, utilities, assigned);
    here.look(frame, solver.order());
    here.write(assigned, best);
    const bool about = last.exists() && scram::is_about(last.tasks(), here.now());
    last.look(here.now().numbers, about && knows_own_task() && scram::has_members(last.tasks(), here.now().numbers));
    if (!last.is_wanting() && about) {
      follower.follow(
          last.tasks(), here.now(),
          [&](std::size_t row, std::size_t column) {
            return utilities(row, column) != regista::UtilityMatrix::forbidden;
          },
          assigned);
    }
    for (std::size_t row = 0; row < out.size(); ++row) out[row] = assigned[row];
    speak(frame);
  }

  void receive(const regista::Message& message) {
    if (message.sender() < 1 || message.sender() > static_cast<int>(here.code().robots())) return;
    negotiation::BitReader in(message.bytes());
    const auto serial = static_cast<std::uint8_t>(in.get(serial_bits));
    heard.resize(here.code().robots());
    if (here.code().read(in, heard)) last.adopt({serial, message.sender()}, heard);
  }
  void transmitted(std::uint64_t handle) {
    if (offer.gone(handle) && !draft.empty()) last.adopt(draft_stamp, draft);
  }
  void dropped(std::uint64_t handle) { offer.gone(handle); }

  // "map 12: 1 goalkeeper, 2 striker, 3 idle".
  std::string describe(std::span<const std::uint8_t> said) const {
    negotiation::BitReader in(said);
    const std::string serial = std::to_string(in.get(serial_bits)), text = here.describe(in);
    return text.empty() ? "no map of this team" : "map " + serial + ": " + text;
  }

 private:
  void speak(const regista::Frame& frame) {
    draft.clear();
    const bool makes_one = here.plays(own) && !here.now().ids.empty() &&
                           (last.is_wanting() || (is_chaser(frame) && !is_worth_keeping(frame)));
    if (makes_one) {
      draft.assign(best.begin(), best.end());
      draft_stamp = last.next_of(own);
      say(frame, draft_stamp.serial, draft, 1.0);
    } else if (last.exists() && last.stamp().author == own) {
      say(frame, last.stamp().serial, last.tasks(), 0.0);
    } else {
      offer.withdraw();
    }
  }

  void say(const regista::Frame& frame, std::uint8_t serial, std::span<const std::int32_t> map, double urgency) {
    negotiation::BitWriter writer(bytes);
    writer.put(serial, serial_bits);
    here.code().write(map, writer);
    offer.say(bytes, frame.time(), urgency);
  }

  bool knows_own_task() const {
    const std::int32_t task = last.tasks()[static_cast<std::size_t>(own - 1)];
    return task < 0 || scram::column_of(here.now(), task) != scram::no_column;
  }

  // By the map in force, and by the newest claim of the role that all can know of.
  bool is_chaser(const regista::Frame& frame) const {
    bool has_role = false;
    for (std::size_t row = 0; row < assigned.size(); ++row) {
      if (here.now().numbers[row] == own && assigned[row] >= 0) {
        has_role = is_role_of_chaser(here.now().ids[static_cast<std::size_t>(assigned[row])]);
      }
    }
    if (!has_role) return false;
    int newest = 0;
    double since = -std::numeric_limits<double>::infinity();
    const regista::World common = frame.common();
    for (const int number : here.now().numbers) {
      const regista::Robot& robot = common.robot(number);
      if (!is_role_of_chaser(robot.role) || robot.role_since <= since) continue;
      newest = number;
      since = robot.role_since;
    }
    return newest == own;
  }
  bool is_role_of_chaser(int role) const {
    return role >= 0 && static_cast<std::size_t>(role) < chases.size() && chases[static_cast<std::size_t>(role)];
  }

  bool is_worth_keeping(const regista::Frame& frame) const {
    const regista::World world = frame.world();
    return nao_devils::is_worth_keeping(last.tasks(), best, margin, [&](int number, std::int32_t task) {
      const double* const place = frame.tasks()[static_cast<std::size_t>(scram::column_of(here.now(), task))].after;
      const double* const pose = world.robot(number).pose;
      const double dx = place[0] - pose[0], dy = place[1] - pose[1];
      return std::sqrt(dx * dx + dy * dy);
    });
  }
};

}  // namespace

REGISTA_PLUGIN(NaoDevils, regista::assigner)
