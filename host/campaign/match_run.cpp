// SPDX-License-Identifier: MIT
#include "campaign/match_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace regista::campaign {
namespace {

bool same_match(const MatchResult& one, const MatchResult& other) {
  return one.score == other.score && one.ended == other.ended && one.hash == other.hash && one.metrics == other.metrics;
}

// Returns a place in a match as "home, robot 3, tick 41: ".
std::string place(int side, int robot, std::uint64_t tick) {
  return fmt::format("{}, robot {}, tick {}: ", side == 0 ? "home" : "away", robot, tick);
}

std::string place(const Failure& failure) { return place(failure.side, failure.robot, failure.tick); }

// Describes the failure of a play from the worker's answer; without an answer, returns the text `end`.
std::string what_failed(const std::string& end, const std::optional<Answer>& answer) {
  if (!answer) return end;
  if (answer->kind != Answer::Kind::failed) return answer->message;
  const Failure& failure = *answer->decided.failure;
  if (failure.plugin.empty())
    return fmt::format("a plugin of the {} team: {}", failure.side == 0 ? "home" : "away", failure.what);
  return fmt::format("plugin {}, {}: {}", failure.plugin, failure.call, failure.what);
}

void remove(const std::string& file) {
  std::error_code none;
  if (!file.empty()) std::filesystem::remove(file, none);
}

}  // namespace

MatchRun::MatchRun(Job job, const Limits& limits, bool twice, std::string failure_record, ForkServer* server)
    : job_(std::move(job)),
      limits_(limits),
      twice_(twice),
      failure_record_(std::move(failure_record)),
      server_(server) {
  for (const std::string& file : job_.plugin_files) plugin_files_.emplace_back(file, plugin::stamp_of(file));
  start(Stage::first);
}

// Returns whether each team has its own process in this play, so that a failure of a process blames its team.
bool MatchRun::isolated(Stage stage) const {
  return stage == Stage::isolated ||
         (stage == Stage::first && (limits_.isolation == Isolation::always || limits_.allow_shared_memory));
}

Separation MatchRun::separation(Stage stage) const {
  const bool apart = limits_.isolation == Isolation::always || limits_.allow_shared_memory;
  switch (stage) {
    case Stage::second:
    case Stage::alone:
    case Stage::traced_alone:
      return limits_.allow_shared_memory ? Separation::teams : Separation::robots;
    case Stage::isolated:
      return Separation::teams;
    case Stage::recording:  // a recording needs the minds in the process of the match
      return Separation::none;
    default:
      return apart ? Separation::teams : Separation::none;
  }
}

void MatchRun::start(Stage stage) {
  stage_ = stage;
  Job job = job_;
  job.limits = limits_;
  job.separation = separation(stage);
  // Perturbed plays have another folder, environment, date and addresses, because the match must not depend on these. A
  // plugin may fail in a perturbed play because a file is missing. A normal play decides whether this is a fault.
  job.perturbed =
      stage == Stage::second || stage == Stage::traced || stage == Stage::traced_alone || stage == Stage::traced_hiding;
  job.trail = is_traced(stage);
  // accounts: true if this isolated play must find out why the second play failed. Every other isolated play must find
  // out which team's process makes the worker die.
  const bool accounts = stage == Stage::isolated && first_;
  job.hides = stage == Stage::second || stage == Stage::traced_hiding || accounts;
  if (stage == Stage::second) job.look = plugin::Inspection::often;
  const bool judges = stage == Stage::isolated || (stage == Stage::first && limits_.isolation == Isolation::always);
  if (judges) job.look = plugin::Inspection::answers;
  if (accounts || job.trail) job.look = plugin::Inspection::always;
  if (stage != Stage::first || job.is_apart()) job.record.clear();
  if (stage == Stage::recording) {
    job.expects_failure = decided_->failure.has_value();
    job.record = job_.record.empty() ? failure_record_ : job_.record;
  } else {
    ++plays_;
  }
  if (job.trail && !trail_.is_open()) trail_ = trail_file();
  worker_ = std::make_unique<Worker>(job, note_, job.trail ? trail_.number : -1, server_);
}

bool MatchRun::advance() {
  if (worker_->advance()) settle();
  return complete_;
}

// Throws CampaignError if the file of a plugin was overwritten during the match. The plugin may then have run a mixture
// of old and new code, so no team is to blame.
void MatchRun::blame_nobody_for_overwritten_files(const std::string& what) const {
  for (const auto& [file, before] : plugin_files_) {
    if (plugin::stamp_of(file) == before) continue;
    throw CampaignError(CampaignError::Kind::input,
                        fmt::format("{}: was overwritten while a match was played ({})", file, what));
  }
}

void MatchRun::settle() {
  const End end = worker_->end();
  std::optional<Answer> answer;
  std::string what = end.text;
  if (end.answered) {
    try {
      answer = answer_from_json(end.text);
    } catch (const std::invalid_argument&) {
      what = "wrote an answer that cannot be read";
    }
  }
  if (stage_ == Stage::recording) return recorded(end, answer);
  seconds_ += end.seconds;
  const bool again = stage_ != Stage::first && stage_ != Stage::isolated;
  if (!again || output_.empty()) output_ = end.output;
  if (again) note_outside(end.outside);
  if (answer && (answer->kind == Answer::Kind::changed || answer->kind == Answer::Kind::refused)) {
    throw CampaignError(CampaignError::Kind::input, answer->message);
  }
  if (answer && answer->kind == Answer::Kind::played) return played(*answer);
  const std::optional<Failure> failure =
      answer && answer->kind == Answer::Kind::failed ? answer->decided.failure : std::nullopt;
  blame_nobody_for_overwritten_files(failure ? failure->what : what);
  Attempt attempt{isolated(stage_), false, end.from_outside, {}, what_failed(what, answer)};
  if (!answer && separation(stage_) == Separation::none) attempt.what = in_words(what, end.note);
  if (failure) {
    if (stage_ == Stage::second) second_failure_ = failure;
    attempt.from_outside = answer->from_outside;
    if (isolated(stage_)) attempt.failure = failure;
  }
  // A kill from outside must not change the report: a play that tests or explains the first play is repeated.
  if (again && attempt.from_outside && killed_++ < isolated_plays) {
    accident_ = attempt.what;
    return start(stage_);
  }
  if (is_traced(stage_) || stage_ == Stage::alone)
    explanation_failed(attempt, answer);
  else
    failed(std::move(attempt));
}

void MatchRun::played(const Answer& answer) {
  const auto difference = [this] { return first_difference(first_trail_, process::everything_in(trail_.number)); };
  switch (stage_) {
    case Stage::first:
      not_recorded_ = answer.message;
      if (!twice_) break;
      first_ = answer.decided;
      return start(Stage::second);
    case Stage::second:
      return compare(answer.decided);
    case Stage::alone:
      alone_ = true;
      if (!same_match(*first_, answer.decided)) {
        if (first_->broken.empty()) return start(Stage::traced);
        first_->unproven =
            "the match comes out otherwise where each robot is alone in a process; why, the plays that find "
            "it out cannot say, for they end at the broken promise";
      }
      return decide_first();
    case Stage::traced:
      first_trail_ = process::everything_in(trail_.number);
      return start(same_match(*first_, answer.decided) ? Stage::traced_alone : Stage::traced_here);
    case Stage::traced_here:
      first_->irreproducible = difference();
      return decide_different();
    case Stage::traced_alone:
      if (same_match(*first_, answer.decided)) return start(Stage::traced_hiding);
      first_->shared = difference();
      return decide_different();
    case Stage::traced_hiding:
      first_->irreproducible = difference();
      if (!first_->irreproducible.empty())
        first_->irreproducible += ", where what it does not declare to read is left out";
      return decide_different();
    default:
      break;
  }
  attempts_.push_back({isolated(stage_), true, false, {}, {}});
  if (first_) return compare(answer.decided);
  switch (judge(attempts_)) {
    case Judgement::counts: {
      MatchResult out = answer.decided;
      if (attempts_.size() > 1) accident_ = attempts_.front().what;
      if (twice_ && !limits_.allow_shared_memory && !attempts_.front().from_outside)
        out.unproven = "the first play died: " + attempts_.front().what;
      decide(out);
      break;
    }
    case Judgement::set_aside: {
      MatchResult out;
      out.ended = "set_aside";
      out.why_set_aside = why_set_aside(attempts_);
      decide(out);
      break;
    }
    default:
      start(Stage::isolated);
  }
}

void MatchRun::failed(Attempt attempt) {
  attempts_.push_back(std::move(attempt));
  switch (judge(attempts_)) {
    case Judgement::forfeit: {
      const Failure& failure = *attempts_.back().failure;
      if (!first_) return decide(forfeit(failure, 0.0));
      // A broken promise is only a remark here, because the pairing's other matches are inspected less closely.
      first_->broken = (failure.robot == 0 ? "" : place(failure)) + attempts_.back().what;
      if (limits_.allow_shared_memory)
        decide_first();
      else
        start(Stage::alone);
      break;
    }
    case Judgement::give_up:
      throw CampaignError(
          CampaignError::Kind::machine,
          fmt::format("workers died {} times over one match, at last so: {}", attempts_.size(), attempts_.back().what));
    default:
      start(Stage::isolated);
  }
}

// Called when a play that tests the first play came to its end: the second play or, if that failed, an isolated play.
void MatchRun::compare(const MatchResult& again) {
  first_->kept = again.kept;
  alone_ = alone_ || stage_ == Stage::second;
  if (!same_match(*first_, again) && first_->shared.empty()) return start(Stage::traced);
  // The second play may have failed because a file was missing in its folder, or because each robot had a process of
  // its own. A play of Stage::alone has the usual folder, so only the second cause can make this play fail.
  const bool second_failed = stage_ == Stage::isolated && !attempts_.front().from_outside;
  if (second_failed && first_->shared.empty() && !limits_.allow_shared_memory)
    start(Stage::alone);
  else
    decide_first();
}

void MatchRun::decide_different() {
  if (first_->shared.empty() && first_->irreproducible.empty())
    first_->irreproducible = "the results of two plays differ, and it did not come back when they were played again";
  decide_first();
}

// Called when a play failed that should explain why two plays differ, or why the second play failed.
void MatchRun::explanation_failed(const Attempt& attempt, const std::optional<Answer>& answer) {
  if (attempt.from_outside) {
    accident_ = attempt.what;
  } else if (stage_ != Stage::alone) {
    first_->irreproducible = "the results of two plays differ; a third one failed: " + attempt.what;
  } else if (answer && answer->kind == Answer::Kind::failed && first_->shared.empty()) {
    const Failure& failure = *answer->decided.failure;
    // Ignores a failure that differs from the failure of the second play, because such a failure is random.
    if (failure == second_failure_)
      first_->shared = place(failure) + attempt.what + ", where its robot is alone in a process";
  }
  decide_first();
}

// Decides the match by the result of the first play. The findings of later plays do not change this result.
void MatchRun::decide_first() {
  if (!alone_ && first_->shared.empty() && !limits_.allow_shared_memory)
    first_->unproven = "no play with each robot in a process of its own came to its end";
  // The first play came to its end, so a failure of the second play becomes only a remark.
  const auto failed = std::ranges::find(attempts_, false, &Attempt::played);
  if (failed != attempts_.end()) {
    if (failed->from_outside)
      accident_ = failed->what;
    else if (first_->irreproducible.empty() && first_->shared.empty() && first_->broken.empty())
      first_->irreproducible = "the second play failed, in another process and folder: " + failed->what;
  }
  decide(MatchResult(*first_));
}

void MatchRun::note_outside(const OutsideNote& outside) {
  if (!first_) return;
  if (outside.unconfined != 0) first_->unproven = "this system does not confine processes (seccomp)";
  if (outside.what.front() == '\0' || !first_->shared.empty()) return;
  const plugin::CallNote& call = outside.call;
  first_->shared =
      place(call.side, call.robot, call.tick) +
      fmt::format("plugin {} tried to {} in {}", call.plugin.data(), outside.what.data(), call.call.data());
}

void MatchRun::decide(MatchResult decided) {
  decided.seconds = seconds_;
  decided.output = output_;
  decided_ = std::move(decided);
  complete_ = true;
  if (decided_->set_aside()) return remove(job_.record);
  // The recording of the first play counts, unless a play failed or each team had its own process in the first play.
  const bool first_counts = attempts_.empty() || (attempts_.size() == 1 && attempts_.front().played);
  const bool wanted = decided_->failure ? !failure_record_.empty() || !job_.record.empty() : !job_.record.empty();
  if (!wanted || (first_counts && separation(Stage::first) == Separation::none)) return;
  remove(job_.record);
  complete_ = false;
  start(Stage::recording);
}

void MatchRun::recorded(const End& end, const std::optional<Answer>& answer) {
  complete_ = true;
  const std::string file = job_.record.empty() ? failure_record_ : job_.record;
  std::error_code none;
  not_recorded_.clear();
  if (answer && answer->kind == Answer::Kind::played) {
    not_recorded_ = answer->message;
    // The match did not fail in this play, so the recording does not show the failure and is removed.
    if (decided_->failure) remove(file);
    if (decided_->failure && not_recorded_.empty()) not_recorded_ = "it did not fail where both teams share a process";
  } else if (!decided_->failure) {
    remove(file);
    not_recorded_ = end.text;
  }
  if (not_recorded_.empty() && !std::filesystem::exists(file, none)) not_recorded_ = file + " could not be written";
}

}  // namespace regista::campaign
