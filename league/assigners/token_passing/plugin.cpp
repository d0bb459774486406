// SPDX-License-Identifier: MIT
// Assigner plugin around robot.hpp: every role of the frame is a task that needs one robot, and its token has the
// role's id. A robot's capability for a role is what the chosen world says of the distance, or what the team's
// utilities say; pairs that are forbidden are capabilities that nobody has.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <plugins/assigners/task_order.hpp>
#include <regista/assigner.hpp>
#include <regista/host.hpp>
#include <regista/mailbox.hpp>
#include <regista/told.hpp>

#include "../negotiation/bids.hpp"
#include "../negotiation/reserve.hpp"
#include "../negotiation/standing_offer.hpp"
#include "message.hpp"
#include "robot.hpp"

namespace {

constexpr double thousandths = 1000.0;

struct TokenPassing {
  static constexpr auto id = "token_passing", version = "1.0.0",
                        summary = "Tokens of tasks go round until somebody is able enough (Farinelli et al. 2005)";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr bool negotiates = true;

  enum class Capability { distance, utility };
  static constexpr std::array capabilities{"distance", "utility"};
  static constexpr std::array takeovers{"never", "last", "always"};

  Capability capability = Capability::distance;
  double reach = 11.0, full_utility = 1.0;
  double threshold = 0.7, step = 0.1, give_up = 0.1;
  bool urgent = true;
  int stop_negotiating_at = negotiation::usual_reserve;
  token_passing::Settings settings;
  static constexpr std::tuple parameters{
      regista::choice(
          "capability", &TokenPassing::capability, capabilities,
          "What a robot is able to do: distance is 1 at the task's place and falls to 0 at `reach`, utility "
          "is the team's utility divided by `full_utility` (assumption)"),
      regista::real("reach", &TokenPassing::reach, {0.5, 100.0}, "m",
                    "Distance from which on the capability is 0 (assumption: about the diagonal of the field)")
          .tunable(),
      regista::real("full_utility", &TokenPassing::full_utility, {0.001, 1000.0}, "1",
                    "Utility of a capability of 1: the sum of the weights where each term is at most 1"),
      regista::real("threshold", &TokenPassing::threshold, {0.0, 1.0}, "1",
                    "A robot keeps the token of a new task if its capability is at least this (assumption)")
          .tunable(),
      regista::real("step", &TokenPassing::step, {0.02, 1.0}, "1",
                    "The threshold falls by this when all have been visited, not below 0 (assumption)")
          .tunable(),
      regista::real("give_up", &TokenPassing::give_up, {0.0, 1.0}, "1",
                    "A robot gives its task up when its capability is this far below the threshold (assumption)")
          .tunable(),
      regista::boolean("urgent", &TokenPassing::urgent,
                       "Tokens that were made, passed or taken are worth a packet at once; false: they wait for the "
                       "next one (assumption)"),
      negotiation::stop_negotiating_at(&TokenPassing::stop_negotiating_at),
      regista::within(
          &TokenPassing::settings,
          regista::choice("takeover", &token_passing::Settings::takeover, takeovers,
                          "When a robot leaves its task for a more important one whose token it gets: never as in the "
                          "publication, only at the last threshold, or always (assumption)"),
          regista::boolean("foresight", &token_passing::Settings::foresight,
                           "Teammates that would refuse by this robot's own prediction are not asked; false: all are, "
                           "as in the publication (assumption)"),
          regista::integer(
              "repeats", &token_passing::Settings::repeats, {1, 20}, "1",
              "Packets that name the new holder before the token is taken back, and packets in which a holder does not "
              "name its token before that is lost (assumption)"),
          regista::real("patience", &token_passing::Settings::patience, {0.2, 60.0}, "s",
                        "How long the new holder may take to answer the last of them (assumption)"),
          regista::real("silence", &token_passing::Settings::silence, {1.0, 600.0}, "s",
                        "A token is lost when nobody has answered for it for this long (assumption: longer than the "
                        "longest period of a sender)"),
          regista::real("stagger", &token_passing::Settings::stagger, {0.0, 60.0}, "s",
                        "Each robot waits this much longer than the next lower number before it makes a token "
                        "(assumption)"),
          regista::real("rest", &token_passing::Settings::rest, {0.5, 600.0}, "s",
                        "A teammate that refused against the prediction is asked again after this (assumption)"),
          regista::real("gone_after", &token_passing::Settings::gone_after, {0.0, 60.0}, "s",
                        "A task is done when its holder has not perceived it for this long (assumption)"))};

  token_passing::Robot robot;
  token_passing::Layout layout;
  regista::Span<regista::Role> roles;
  regista::Mailbox mailbox;
  negotiation::StandingOffer offer;
  negotiation::Reserve reserve;
  int own = 1;
  std::size_t offered = 0;    // tokens in it
  std::size_t most_told = 0;  // that a packet has room for
  regista::Told told;
  std::vector<std::uint32_t> order;
  std::vector<token_passing::Work> work;
  std::vector<std::int32_t> able;  // work x number
  std::vector<token_passing::Told> heard;
  std::vector<std::uint8_t> bytes;

  void setup(const regista::Environment& environment, const regista::Host& host) {
    settings.threshold = static_cast<int>(std::lround(thousandths * threshold));
    settings.step = static_cast<int>(std::lround(thousandths * step));
    settings.give_up = static_cast<int>(std::lround(thousandths * give_up));
    roles = environment.roles();
    own = environment->own_number;
    mailbox = host.mailbox();
    told = regista::Told(host);
    const auto tokens = static_cast<int>(roles.size());
    const auto team_size = static_cast<int>(environment->team_size);
    layout = {team_size, tokens, settings.rounds()};
    robot.reserve(team_size, tokens);
    offer.setup(mailbox, layout.bytes(roles.size()));
    reserve.setup(environment, host, stop_negotiating_at);
    bytes.reserve(layout.bytes(roles.size()));
    order.reserve(roles.size());
    work.reserve(roles.size());
    heard.reserve(roles.size());
    able.reserve(roles.size() * environment->team_size);
  }

  void reset(std::uint64_t) {
    robot.forget();
    offer.forget();
    offered = most_told = 0;
  }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    if (reserve.is_reached()) {
      robot.decide(settings, {frame.time(), own, 0, {}});  // as one that does not play: it holds nothing
      offered = 0;
      offer.withdraw();
      return reserve.assign_by_rank(frame, utilities, out);
    }
    const regista::Span<std::int32_t> active = frame.world().active();
    read_tasks(frame, utilities);
    token_passing::Robots members = 0;
    for (const std::int32_t number : active) members |= token_passing::only(number);
    overhear();
    robot.decide(settings, {frame.time(), own, members, work});
    say(frame.time());
    for (std::size_t row = 0; row < out.size(); ++row) {
      const std::int32_t number = active[row];
      if (number != own && !robot.was_heard(number)) out[row] = regista::Assignment::unknown_task;
      const int does = robot.work_of(number);
      if (does == token_passing::Robot::none) continue;
      const std::uint32_t column = order[static_cast<std::size_t>(does)];
      if (utilities(row, column) != regista::UtilityMatrix::forbidden) out[row] = static_cast<std::int32_t>(column);
    }
  }

  void receive(const regista::Message& message) {
    const int sender = message.sender();
    if (sender < 1 || sender > layout.team_size || sender == own) return;
    if (!token_passing::read(layout, sender, message.bytes(), heard)) return;
    robot.hear(own, sender, heard, message.time_sent(), message.time_heard(), heard.size() < most_told);
  }
  void transmitted(std::uint64_t handle) {
    if (offer.gone(handle)) robot.transmitted(offered);
  }
  void dropped(std::uint64_t handle) { offer.gone(handle); }

  // "1 does jolly, striker with 2, supporter with 3 at 0.50": who does a task, who is to take a token or has it in its
  // hands, and the threshold if it has fallen.
  std::string describe(std::span<const std::uint8_t> said) const {
    std::vector<token_passing::Told> all;
    if (!token_passing::read(layout, 0, said, all)) return "no tokens of this team";
    std::string line;
    for (const token_passing::Told& each : all) {
      if (!line.empty()) line += ", ";
      const token_passing::Token& token = each.token;
      const std::string name = roles[static_cast<std::size_t>(each.id)].name, holder = std::to_string(token.holder);
      if (token.done) {
        line += name + " is done";
        continue;
      }
      line += token.kept ? holder + " does " + name : name + " with " + holder;
      if (token.round == 0) continue;
      const int hundredths = settings.threshold_of(token.round) / 10;
      line += " at 0." + std::to_string(hundredths / 10) + std::to_string(hundredths % 10);
    }
    return line;
  }

 private:
  // Who answers for no token says nothing to this plugin.
  void overhear() {
    for (int number = 1; number <= layout.team_size; ++number) {
      const auto packet = number == own ? std::nullopt : told.packet(number);
      if (packet) robot.overhear(own, number, packet->time_sent);
    }
  }

  void read_tasks(const regista::Frame& frame, const regista::UtilityMatrix& utilities) {
    const regista::Span<regista::Task> tasks = frame.tasks();
    const regista::World world = frame.world();
    const regista::Span<std::int32_t> active = world.active();
    assignment::by_importance(tasks, order);
    const auto team_size = static_cast<std::size_t>(layout.team_size);
    able.assign(order.size() * team_size, -1);
    work.clear();
    for (std::size_t w = 0; w < order.size(); ++w) {
      const std::span<std::int32_t> of_robots = std::span(able).subspan(w * team_size, team_size);
      const regista::Task& task = tasks[order[w]];
      for (std::size_t row = 0; row < utilities.rows(); ++row) {
        const double utility = utilities(row, order[w]);
        if (utility == regista::UtilityMatrix::forbidden) continue;
        const regista::Robot& mate = world.robot(active[row]);
        const double part = capability == Capability::utility
                                ? utility / full_utility
                                : 1.0 - std::hypot(task.after[0] - mate.pose[0], task.after[1] - mate.pose[1]) / reach;
        of_robots[static_cast<std::size_t>(active[row] - 1)] = static_cast<std::int32_t>(negotiation::in_steps(
            std::clamp(part, 0.0, 1.0), 1.0 / thousandths, static_cast<std::uint32_t>(thousandths)));
      }
      work.push_back({task.id, task.priority, of_robots});
    }
  }

  // As many tokens as a packet can take, what matters most first.
  void say(double now) {
    constexpr std::uint32_t heading = 2;
    const std::uint32_t free = mailbox.bytes_free();
    const auto tokens = robot.told();
    most_told = layout.most(free > heading ? free - heading : 0);
    offered = std::min(tokens.size(), most_told);
    if (offered == 0) return offer.withdraw();
    token_passing::write(layout, tokens.first(offered), bytes);
    offer.say(bytes, now, urgent && robot.is_urgent() ? 1.0 : 0.0);
  }
};

}  // namespace

REGISTA_PLUGIN(TokenPassing, regista::assigner)
