// SPDX-License-Identifier: MIT
#include "campaign/match_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "campaign/campaign_error.hpp"

namespace regista::campaign {
namespace {

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
  if (twice_) trail_ = std::make_unique<TrailFile>();
  start(Stage::first);
}

bool MatchRun::isolated(Stage stage) const {
  return stage == Stage::isolated || (stage != Stage::recording && limits_.isolation == Isolation::always);
}

void MatchRun::start(Stage stage) {
  stage_ = stage;
  Job job = job_;
  job.limits = limits_;
  job.isolated = isolated(stage);
  // Another folder, environment and addresses, to see whether the match depends on them. Whoever failed there may do so
  // for want of a file: whether that is a fault, a play where the first one was decides.
  job.elsewhere = stage == Stage::second;
  job.closely = stage == Stage::second || stage == Stage::isolated;
  job.trail = twice_ && (stage == Stage::first || stage == Stage::second || (stage == Stage::isolated && first_));
  // A recording needs the minds in the match's own process.
  if (stage != Stage::first || job.isolated) job.record.clear();
  if (stage == Stage::recording) {
    job.expects_failure = decided_->failure.has_value();
    job.record = job_.record.empty() ? failure_record_ : job_.record;
  } else {
    ++plays_;
  }
  if (job.trail) trail_->clear();
  worker_ = std::make_unique<Worker>(job, limits_, note_, job.trail ? trail_->descriptor() : -1, server_);
}

bool MatchRun::advance() {
  if (worker_->advance()) settle();
  return complete_;
}

// What runs then is no code of anybody's.
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
  bool from_outside = end.how == End::How::killed_from_outside || end.how == End::How::stopped;
  if (end.how == End::How::answered) {
    try {
      answer = answer_from_json(end.text);
    } catch (const std::invalid_argument&) {
      what = "wrote an answer that cannot be read";
    }
  }
  if (stage_ == Stage::recording) {
    recorded(end, answer);
    return;
  }
  seconds_ += end.seconds;
  if (stage_ != Stage::second || output_.empty()) output_ = end.output;
  if (answer && (answer->kind == Answer::Kind::changed || answer->kind == Answer::Kind::refused)) {
    throw CampaignError(CampaignError::Kind::input, answer->message);
  }
  if (answer && answer->kind == Answer::Kind::played) {
    played(*answer);
    return;
  }
  blame_nobody_for_overwritten_files(answer && answer->kind == Answer::Kind::failed ? answer->decided.failure->what
                                                                                    : what);
  Attempt attempt{isolated(stage_), false, from_outside, {}, what};
  if (!answer) {
    if (!isolated(stage_)) attempt.what = in_words(what, end.note);
  } else if (answer->kind == Answer::Kind::failed) {
    const Failure& failure = *answer->decided.failure;
    attempt.from_outside = answer->from_outside;
    attempt.what = fmt::format("plugin {}, {}: {}", failure.plugin, failure.call, failure.what);
    if (isolated(stage_)) attempt.failure = failure;
  } else {
    attempt.what = answer->message;
  }
  failed(std::move(attempt));
}

void MatchRun::played(const Answer& answer) {
  if (stage_ == Stage::first) {
    not_recorded_ = answer.message;
    if (twice_) {
      first_ = answer.decided;
      first_trail_ = trail_->content();
      start(Stage::second);
      return;
    }
  }
  if (stage_ == Stage::second) {
    compare(answer.decided);
    return;
  }
  attempts_.push_back({isolated(stage_), true, false, {}, {}});
  if (first_) {
    compare(answer.decided);
    return;
  }
  switch (judge(attempts_)) {
    case Judgement::counts:
      if (attempts_.size() > 1) accident_ = attempts_.front().what;
      decide(answer.decided);
      break;
    case Judgement::set_aside: {
      Decided out;
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
    case Judgement::forfeit:
      decide(forfeit(*attempts_.back().failure, 0.0));
      break;
    case Judgement::give_up:
      throw CampaignError(
          CampaignError::Kind::machine,
          fmt::format("workers died {} times over one match, at last so: {}", attempts_.size(), attempts_.back().what));
    default:
      start(Stage::isolated);
  }
}

void MatchRun::compare(const Decided& again) {
  Decided out = *first_;
  const bool same =
      out.score == again.score && out.ended == again.ended && out.hash == again.hash && out.metrics == again.metrics;
  out.irreproducible = first_difference(first_trail_, trail_->content());
  if (!same && out.irreproducible.empty()) {
    out.irreproducible = "the results of two plays differ, though all decisions are the same";
  }
  // The second play itself failed. That says nothing about the first one, which was played to its end.
  const auto failed = std::ranges::find(attempts_, false, &Attempt::played);
  if (failed != attempts_.end()) {
    if (failed->from_outside)
      accident_ = failed->what;
    else if (out.irreproducible.empty())
      out.irreproducible = "the second play failed, in another process and folder: " + failed->what;
  }
  decide(out);
}

void MatchRun::decide(Decided decided) {
  decided.seconds = seconds_;
  decided.output = output_;
  decided_ = std::move(decided);
  complete_ = true;
  if (decided_->set_aside()) {
    remove(job_.record);
    return;
  }
  // In the file of a match that failed in its first play, or was played with its minds elsewhere, is not what counts.
  const bool first_counts = attempts_.empty() || (attempts_.size() == 1 && attempts_.front().played);
  const bool wanted = decided_->failure ? !failure_record_.empty() || !job_.record.empty() : !job_.record.empty();
  if (!wanted || (first_counts && limits_.isolation != Isolation::always)) return;
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
    // What was recorded is another match than the one that failed.
    if (decided_->failure) remove(file);
    if (decided_->failure && not_recorded_.empty()) not_recorded_ = "it did not fail where both teams share a process";
  } else if (!decided_->failure) {
    remove(file);
    not_recorded_ = end.text;
  }
  if (not_recorded_.empty() && !std::filesystem::exists(file, none)) not_recorded_ = file + " could not be written";
}

}  // namespace regista::campaign
