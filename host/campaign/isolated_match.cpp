// SPDX-License-Identifier: MIT
#include "campaign/isolated_match.hpp"

#include <fmt/format.h>
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>
#include <cstdint>

#include <algorithm>
#include <csignal>
#include <span>
#include <utility>
#include <vector>

#include "campaign/mind_host.hpp"
#include "match/teams.hpp"
#include "mind/serialization.hpp"
#include "process/child.hpp"

namespace regista::campaign {
namespace {

constexpr double look_again_after = 0.1;  // s between two looks at a process that has not replied

struct Thinkers {
  explicit Thinkers(const MindPlace& in) : place(in) {}
  MindPlace place;
  MindChannel channel;
  process::Child process;
  double waited = 0.0;  // time that the match has waited for these minds, s
};

void close_all_but_standard_streams() {
  if (::close_range(STDERR_FILENO + 1, ~0u, 0) == 0) return;
  for (int each = STDERR_FILENO + 1; each < 1024; ++each) ::close(each);
}

// Binds this process and its future copies to the current processor. Match and minds take turns for every decision. On
// two processors, each turn wakes a sleeping process, which takes longer than the decision itself. Only plays with a
// process for each robot use this function, because otherwise all matches of a study would share a few processors.
void stay_on_this_processor() {
  const int here = ::sched_getcpu();
  if (here < 0 || here >= CPU_SETSIZE) return;
  cpu_set_t only;
  CPU_ZERO(&only);
  CPU_SET(static_cast<unsigned>(here), &only);
  ::sched_setaffinity(0, sizeof only, &only);
}

class IsolatedMatch {
 public:
  IsolatedMatch(match::Setup setup, const std::array<const mind::TeamPlan*, 2>& plans, const Job& job,
                std::optional<TrailWriter>& trail, WorkerNote& note)
      : setup_(std::move(setup)), plans_(plans), job_(job), limits_(job.limits), trail_(trail), note_(note) {
    for (const match::Side side : match::both_sides) {
      setup_.roles[match::index(side)] = match::roles(*plans[match::index(side)]);
      setup_.reasons[match::index(side)] = plans[match::index(side)]->reasons();
      setup_.plugin_metrics[match::index(side)] = plans[match::index(side)]->metrics();
      const int size = plans[match::index(side)]->rules().team_size;
      std::vector<std::size_t>& of_robot = of_robot_[match::index(side)];
      for (int number = 1; number <= size; ++number) {
        if (number == 1 || job.separation == Separation::robots)
          thinkers_.emplace_back(MindPlace{side, job.separation == Separation::robots ? number : 0});
        of_robot.push_back(thinkers_.size() - 1);
      }
    }
    // SIGCHLD gets a handler, so that the death of any process of minds interrupts the wait for another process.
    struct sigaction action {};
    action.sa_handler = [](int) {};
    sigemptyset(&action.sa_mask);
    sigaction(SIGCHLD, &action, &before_);
  }
  ~IsolatedMatch() {
    for (Thinkers& each : thinkers_) each.process = {};
    for (const Thinkers& each : thinkers_) note_first(each.channel.note().outside);
    note_.groups = {};
    sigaction(SIGCHLD, &before_, nullptr);
  }
  IsolatedMatch(const IsolatedMatch&) = delete;
  IsolatedMatch& operator=(const IsolatedMatch&) = delete;

  // See play_isolated().
  match::Result play(std::string& kept) {
    if (thinkers_.size() > 2) stay_on_this_processor();
    for (Thinkers& each : thinkers_) start(each);
    for (Thinkers& each : thinkers_) hear(each);  // waits until the minds have been created
    std::array<std::vector<mind::Think>, 2> think;
    for (const match::Side side : match::both_sides) {
      for (int number = 1; number <= plans_[match::index(side)]->rules().team_size; ++number) {
        think[match::index(side)].push_back(
            [this, side, number](const mind::Percepts& percepts, std::span<const mind::HeardPacket> heard,
                                 mind::Outcome& out) { decide(side, number, percepts, heard, out); });
      }
    }
    const match::Beliefs beliefs = [this](match::Side side, int number, match::Belief& out) {
      Thinkers& asked = thinkers(side, number);
      read(asked, ask(asked, Question::believe, number, {}), out);
    };
    match::Observer observer;
    if (trail_) {
      observer.decision = [this](const match::Decision& decision) { trail_->add(decision, answers_); };
    }
    const match::Result result = match::play(setup_, think[0], think[1], &observer, beliefs);
    for (Thinkers& each : thinkers_) {
      std::string own;
      read(each, ask(each, Question::finish, 0, {}), own);
      if (own.empty() || kept.find(own) != std::string::npos) continue;
      kept += fmt::format("{}{}: plugins keep in memory that all their instances share: {}", kept.empty() ? "" : "; ",
                          match::name(each.place.side), own);
    }
    return result;
  }

 private:
  Thinkers& thinkers(match::Side side, int number) {
    return thinkers_[of_robot_[match::index(side)][static_cast<std::size_t>(number - 1)]];
  }

  void start(Thinkers& started) {
    const process::Setting setting{.keeps_streams = true, .keeps_signals = true};
    const match::Side side = started.place.side;
    started.process = process::Child::copy(setting, [&]() -> int {
      std::signal(SIGCHLD, SIG_DFL);
      close_all_but_standard_streams();
      // Removes the memory that the match or other minds read, so that plugins cannot reach it.
      for (Thinkers& each : thinkers_) {
        if (&each != &started) each.channel.forget();
      }
      ::munmap(&note_, sizeof note_);
      serve_minds(*plans_[match::index(side)], started.place, job_, started.channel);
    });
    note_.groups[static_cast<std::size_t>(&started - thinkers_.data())] = started.process.process();
  }

  void decide(match::Side side, int number, const mind::Percepts& percepts, std::span<const mind::HeardPacket> heard,
              mind::Outcome& out) {
    question_.clear();
    question_(percepts);
    mind::write_heard(question_, heard);
    Thinkers& asked = thinkers(side, number);
    texts::BytesIn answer = ask(asked, Question::decide, number, question_.bytes());
    try {
      answer(out);
      if (job_.trail) answer(answers_);
    } catch (const std::out_of_range&) {
      damaged(asked, number);
    }
    const std::string why =
        match::unsound(out, setup_.robots[match::index(side)],
                       {setup_.roles[match::index(side)].size(), setup_.reasons[match::index(side)].size(),
                        setup_.plugin_metrics[match::index(side)].size()});
    if (!why.empty()) {
      const Failure failure{number_of(asked), "", "",
                            number,           0,  "its mind handed over an outcome that is not sound: " + why};
      throw Fault(failure, false);
    }
  }

  template <class T>
  void read(const Thinkers& asked, texts::BytesIn answer, T& out) {
    try {
      answer(out);
    } catch (const std::out_of_range&) {
      damaged(asked, asked.place.robot);
    }
  }

  [[noreturn]] void damaged(const Thinkers& asked, int robot) {
    throw Fault({number_of(asked), "", "", robot, 0, "the memory of its minds is damaged"}, false);
  }

  static int number_of(const Thinkers& one) { return static_cast<int>(match::index(one.place.side)); }

  texts::BytesIn ask(Thinkers& asked, Question question, int robot, std::span<const std::uint8_t> bytes) {
    if (bytes.size() > MindChannel::most_bytes) throw std::length_error("percepts too long for a channel");
    asked.channel.ask(question, robot, bytes);
    return hear(asked);
  }

  texts::BytesIn hear(Thinkers& asked) {
    if (!asked.channel.replied()) wait_for(asked);
    if (asked.channel.reply() == Reply::done) return texts::BytesIn(asked.channel.bytes());
    if (asked.channel.reply() == Reply::no_memory) {
      // If the process uses less than half of its limit, the machine has no memory left.
      const bool of_the_machine =
          limits_.memory == 0 || process::address_space_of(asked.process.process()) < limits_.memory / 2;
      throw Fault(of_the_team(noted(asked, "no memory is left")), of_the_machine);
    }
    const auto bytes = asked.channel.bytes();
    Failure failure;
    try {
      failure = failure_from_json(std::string(bytes.begin(), bytes.end()));
    } catch (const std::invalid_argument&) {
      damaged(asked, asked.place.robot);
    }
    failure.side = number_of(asked);
    throw Fault(failure, false);
  }

  void wait_for(Thinkers& asked) {
    process::CallWatch<int> watch({limits_.processor_seconds, limits_.wall_seconds});
    for (;;) {
      asked.channel.wait_for_reply(look_again_after);
      if (asked.channel.replied()) break;
      for (Thinkers& each : thinkers_) look_after(each);
      if (asked.channel.replied()) break;
      const process::Exceeded exceeded = watch.look(0, true, asked.process.process());
      if (exceeded != process::Exceeded::nothing) throw Fault(noted(asked, watch.in_words(exceeded)), false);
      check_match_time(asked, watch.wall_seconds());
    }
    asked.waited += watch.wall_seconds();
    check_match_time(asked, 0.0);
  }

  // Throws a Fault if the match has waited for minds longer than a match may last. The slower side is to blame.
  void check_match_time(const Thinkers& asked, double waiting) {
    std::array<double, 2> waited{};
    waited[match::index(asked.place.side)] = waiting;
    for (const Thinkers& each : thinkers_) waited[match::index(each.place.side)] += each.waited;
    const auto [home, away] = waited;
    if (home + away <= limits_.match_wall_seconds) return;
    const match::Side slower = home >= away ? match::Side::home : match::Side::away;
    // If each side took more than a quarter of the waiting, it may be the machine: one such failure blames nobody.
    constexpr double most_of_it = 0.75;
    const bool both = std::max(home, away) < most_of_it * (home + away);
    throw Fault({static_cast<int>(match::index(slower)), "", "", 0, 0,
                 fmt::format("kept the match waiting for {:.0f} s of the {:.0f} s that a match may last",
                             std::max(home, away), limits_.match_wall_seconds)},
                both);
  }

  void look_after(Thinkers& looked_at) {
    const std::optional<process::ProcessEnd> end = looked_at.process.look();
    if (!end) return;
    if (end->out_of_processor_time())
      throw Fault(died(looked_at, process::used_processor_time(limits_.match_seconds()) + " in one match"), false);
    throw Fault(died(looked_at, end->in_words()), end->was_stopped() || end->from_outside());
  }

  // Returns the failure of a dead process. The failure names a plugin only if the process ended during a call, in the
  // called plugin's own code. Otherwise a thread, a timer or another plugin may be the cause.
  Failure died(const Thinkers& dead, const std::string& what) {
    Failure out = noted(dead, what);
    const WorkerNote note = dead.channel.note().sound();
    const auto parts = plans_[match::index(dead.place.side)]->parts();
    const auto called =
        std::ranges::find_if(parts, [&](const mind::Part* each) { return each->found->descriptor->id == out.plugin; });
    const bool own = note.call.inside == 1 && called != parts.end() &&
                     plugin::ended_in(note.fatal, (*called)->found->file.filename().string());
    return own ? out : of_the_team(out);
  }

  // Returns the failure without plugin and call: only the team is to blame.
  static Failure of_the_team(Failure failure) {
    failure.plugin.clear();
    failure.call.clear();
    return failure;
  }

  // Returns a failure in the current or last call of this process.
  Failure noted(const Thinkers& failed, const std::string& what) {
    const WorkerNote note = failed.channel.note().sound();
    return {number_of(failed),     note.call.plugin.data(),
            note.call.call.data(), note.call.robot,
            note.call.tick,        what + where(note.fatal) + (note.call.inside == 1 ? "" : ", between two calls")};
  }

  // Keeps the earliest try of a mind in this match to reach outside of its process.
  void note_first(const OutsideNote& outside) {
    note_.outside.unconfined |= outside.unconfined;
    if (outside.what.front() == '\0') return;
    if (note_.outside.what.front() != '\0' && note_.outside.call.tick <= outside.call.tick) return;
    note_.outside.what = outside.what;
    note_.outside.call = outside.call;
  }

  match::Setup setup_;
  std::array<const mind::TeamPlan*, 2> plans_;
  const Job& job_;
  const Limits& limits_;
  std::optional<TrailWriter>& trail_;
  WorkerNote& note_;
  std::vector<Thinkers> thinkers_;
  std::array<std::vector<std::size_t>, 2> of_robot_;  // index in thinkers_, by side and robot
  struct sigaction before_ {};
  texts::BytesOut question_;
  plugin::CallTrail answers_;
};

}  // namespace

match::Result play_isolated(match::Setup setup, const std::array<const mind::TeamPlan*, 2>& plans, const Job& job,
                            std::optional<TrailWriter>& trail, WorkerNote& note, std::string& kept) {
  return IsolatedMatch(std::move(setup), plans, job, trail, note).play(kept);
}

}  // namespace regista::campaign
