// SPDX-License-Identifier: MIT
#include "campaign/isolated_match.hpp"

#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <span>
#include <utility>

#include "campaign/belief_wire.hpp"
#include "campaign/mind_channel.hpp"
#include "campaign/mind_host.hpp"
#include "match/outcome.hpp"
#include "mind/wire.hpp"
#include "process/child.hpp"
#include "process/watch.hpp"

namespace regista::campaign {
namespace {

constexpr double look_again_after = 0.1;  // s between two looks at a process that has not replied

// The process of a side's minds.
struct Team {
  MindChannel channel;
  process::Child process;
  double waited = 0.0;  // s that the match has waited for it
};

void close_all_but_standard_streams() {
  if (::close_range(STDERR_FILENO + 1, ~0u, 0) == 0) return;
  for (int each = STDERR_FILENO + 1; each < 1024; ++each) ::close(each);
}

class IsolatedMatch {
 public:
  IsolatedMatch(match::Setup setup, const std::array<const mind::TeamPlan*, 2>& plans, const Limits& limits,
                bool closely, const AfterDigest& after, WorkerNote& note)
      : setup_(std::move(setup)),
        plans_(plans),
        limits_(limits),
        examination_{closely, static_cast<bool>(after)},
        after_(after),
        note_(note) {
    for (const match::Side side : match::both_sides) {
      setup_.roles[match::index(side)] = match::roles(*plans[match::index(side)]);
      setup_.reasons[match::index(side)] = plans[match::index(side)]->reasons();
      setup_.plugin_metrics[match::index(side)] = plans[match::index(side)]->metrics();
    }
    // A death of either interrupts the sleep for the other.
    struct sigaction action {};
    action.sa_handler = [](int) {};
    sigemptyset(&action.sa_mask);
    sigaction(SIGCHLD, &action, &before_);
  }
  ~IsolatedMatch() {
    for (Team& team : teams_) team.process = {};
    note_.groups = {};
    sigaction(SIGCHLD, &before_, nullptr);
  }
  IsolatedMatch(const IsolatedMatch&) = delete;
  IsolatedMatch& operator=(const IsolatedMatch&) = delete;

  match::Result play() {
    for (const match::Side side : match::both_sides) start(side);
    for (const match::Side side : match::both_sides) hear(side);  // that the minds have been created
    std::array<std::vector<mind::Think>, 2> think;
    for (const match::Side side : match::both_sides) {
      for (int number = 1; number <= plans_[match::index(side)]->rules().team_size; ++number) {
        think[match::index(side)].push_back(
            [this, side, number](const mind::Percepts& percepts, std::span<const mind::HeardPacket> heard,
                                 mind::Outcome& out) { decide(side, number, percepts, heard, out); });
      }
    }
    const match::Beliefs beliefs = [this](match::Side side, int number, match::Belief& out) {
      read(side, ask(side, Question::believe, number, {}), out);
    };
    match::Observer observer;
    if (after_) {
      observer.decision = [this](const match::Decision& decision) { after_(decision, digest_); };
    }
    const match::Result result = match::play(setup_, think[0], think[1], &observer, beliefs);
    for (const match::Side side : match::both_sides) ask(side, Question::finish, 0, {});
    return result;
  }

 private:
  Team& team(match::Side side) { return teams_[match::index(side)]; }

  void start(match::Side side) {
    const process::Setting setting{.keeps_streams = true, .keeps_signals = true};
    team(side).process = process::Child::copy(setting, [&]() -> int {
      std::signal(SIGCHLD, SIG_DFL);
      close_all_but_standard_streams();
      // Nothing that the match or the other team's minds read is left in reach of plugins.
      team(match::opposite(side)).channel.forget();
      ::munmap(&note_, sizeof note_);
      serve_minds(*plans_[match::index(side)], side, setup_.seed, examination_, team(side).channel);
    });
    note_.groups[match::index(side)] = team(side).process.process();
  }

  void decide(match::Side side, int number, const mind::Percepts& percepts, std::span<const mind::HeardPacket> heard,
              mind::Outcome& out) {
    question_.clear();
    question_(percepts);
    mind::write_heard(question_, heard);
    config::BytesIn answer = ask(side, Question::decide, number, question_.bytes());
    try {
      answer(out);
      if (examination_.digest_decisions) {
        for (std::uint64_t& each : digest_) answer(each);
      }
    } catch (const std::out_of_range&) {
      damaged(side, number);
    }
    const std::string why =
        match::unsound(out, setup_.robots[match::index(side)],
                       {setup_.roles[match::index(side)].size(), setup_.reasons[match::index(side)].size(),
                        setup_.plugin_metrics[match::index(side)].size()});
    if (!why.empty()) throw Fault(noted(side, "its mind handed over an outcome that is not sound: " + why), false);
  }

  template <class T>
  void read(match::Side side, config::BytesIn answer, T& out) {
    try {
      answer(out);
    } catch (const std::out_of_range&) {
      damaged(side, 0);
    }
  }

  [[noreturn]] void damaged(match::Side side, int robot) {
    throw Fault({static_cast<int>(match::index(side)), "", "", robot, 0, "the memory of its minds is damaged"}, false);
  }

  config::BytesIn ask(match::Side side, Question question, int robot, std::span<const std::uint8_t> bytes) {
    if (bytes.size() > MindChannel::most_bytes) throw std::length_error("percepts too long for a channel");
    team(side).channel.ask(question, robot, bytes);
    return hear(side);
  }

  config::BytesIn hear(match::Side side) {
    Team& asked = team(side);
    if (!asked.channel.replied()) wait_for(side);
    if (asked.channel.reply() == Reply::done) return config::BytesIn(asked.channel.bytes());
    if (asked.channel.reply() == Reply::no_memory) {
      // Below half of what it may have, it is the machine that has no more.
      const bool of_the_machine =
          limits_.memory == 0 || process::address_space_of(asked.process.process()) < limits_.memory / 2;
      throw Fault(noted(side, "no memory is left"), of_the_machine);
    }
    const auto bytes = asked.channel.bytes();
    Failure failure;
    try {
      failure = failure_from_json(std::string(bytes.begin(), bytes.end()));
    } catch (const std::invalid_argument&) {
      damaged(side, 0);
    }
    failure.side = static_cast<int>(match::index(side));
    throw Fault(failure, false);
  }

  void wait_for(match::Side side) {
    Team& asked = team(side);
    process::CallWatch<int> watch({limits_.processor_seconds, limits_.wall_seconds});
    for (;;) {
      asked.channel.wait_for_reply(look_again_after);
      if (asked.channel.replied()) break;
      for (const match::Side each : match::both_sides) look_after(each);
      if (asked.channel.replied()) break;
      switch (watch.look(0, true, asked.process.process())) {
        case process::Exceeded::processor_time:
          throw Fault(noted(side, process::used_processor_time(limits_.processor_seconds)), false);
        case process::Exceeded::wall_time:
          throw Fault(noted(side, process::did_not_return(limits_.wall_seconds)), false);
        case process::Exceeded::nothing:
          break;
      }
      check_match_time(side, watch.wall_seconds());
    }
    asked.waited += watch.wall_seconds();
    check_match_time(side, 0.0);
  }

  // The one that has been waited for longer has used up the time of the match.
  void check_match_time(match::Side side, double waiting) {
    const auto waited = [&](match::Side each) { return team(each).waited + (each == side ? waiting : 0.0); };
    const double home = waited(match::Side::home), away = waited(match::Side::away);
    if (home + away <= limits_.match_wall_seconds) return;
    const match::Side slower = home >= away ? match::Side::home : match::Side::away;
    // Where both are slow, it may be the machine.
    constexpr double most_of_it = 0.75;
    const bool both = std::max(home, away) < most_of_it * (home + away);
    throw Fault({static_cast<int>(match::index(slower)), "", "", 0, 0,
                 fmt::format("kept the match waiting for {:.0f} s of the {:.0f} s that a match may last",
                             std::max(home, away), limits_.match_wall_seconds)},
                both);
  }

  void look_after(match::Side side) {
    Team& looked_at = team(side);
    const std::optional<process::ProcessEnd> end = looked_at.process.look();
    if (!end) return;
    if (end->out_of_processor_time())
      throw Fault(noted(side, process::used_processor_time(limits_.match_seconds()) + " in one match"), false);
    throw Fault(noted(side, end->in_words()), end->was_stopped() || end->from_outside());
  }

  // A failure of the call that was under way last.
  Failure noted(match::Side side, const std::string& what) {
    const WorkerNote note = team(side).channel.note().sound();
    return {static_cast<int>(match::index(side)),
            note.call.plugin.data(),
            note.call.call.data(),
            note.call.robot,
            note.call.tick,
            what + where(note.fatal) + (note.call.inside == 1 ? "" : ", between two calls")};
  }

  match::Setup setup_;
  std::array<const mind::TeamPlan*, 2> plans_;
  Limits limits_;
  Examination examination_;
  const AfterDigest& after_;
  WorkerNote& note_;
  std::array<Team, 2> teams_;
  struct sigaction before_ {};
  config::BytesOut question_;
  match::DecisionDigest digest_{};
};

}  // namespace

match::Result play_isolated(match::Setup setup, const std::array<const mind::TeamPlan*, 2>& plans, const Limits& limits,
                            bool closely, const AfterDigest& after, WorkerNote& note) {
  return IsolatedMatch(std::move(setup), plans, limits, closely, after, note).play();
}

}  // namespace regista::campaign
