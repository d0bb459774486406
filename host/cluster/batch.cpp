// SPDX-License-Identifier: MIT
#include "cluster/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <set>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

#include "campaign/job.hpp"
#include "process/child.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::cluster {

static void to_json(nlohmann::json& json, const Slice& slice) {
  json = nlohmann::json::array({slice.begin, slice.end});
}
static void from_json(const nlohmann::json& json, Slice& out) {
  json.at(0).get_to(out.begin);
  json.at(1).get_to(out.end);
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Batch, first_row, may_end_early, tasks)

namespace {

void add(std::uint64_t place, Slices& to) {
  if (!to.empty() && to.back().end == place)
    ++to.back().end;
  else
    to.push_back({place, place + 1});
}

// Collects at most `most` places without a result, from the index `first` on. Passes no results to the study.
void find_places(const study::Round& round, const campaign::Store& store, const std::vector<std::int64_t>& numbers,
                 std::uint64_t first, std::uint64_t most, Missing& out) {
  std::set<std::pair<std::int64_t, std::uint64_t>> seen;
  for (std::uint64_t index = first; index < round.matches && seen.size() < most; ++index) {
    const auto place = round.at(index);
    if (!place) continue;
    const campaign::MatchKey key{numbers[place->fixture], place->seed};
    if (store.find(static_cast<std::int64_t>(round.first_row + index) + 1, key, campaign::Metrics::left_out)) continue;
    if (!seen.emplace(key.fixture, key.seed).second) continue;
    add(index, out.places);
    if (round.first_of_pairing && round.first_of_pairing(index)) out.twice.push_back(index);
  }
}

}  // namespace

std::uint64_t matches_of(const Slices& slices) {
  std::uint64_t out = 0;
  for (const Slice& each : slices) out += each.end - each.begin;
  return out;
}

std::uint64_t Batch::matches() const {
  std::uint64_t out = 0;
  for (const Slices& each : tasks) out += matches_of(each);
  return out;
}

std::vector<Slices> shared_out(const Slices& places, const std::vector<std::uint64_t>& twice, std::uint64_t most,
                               std::uint64_t tasks) {
  const std::uint64_t all = matches_of(places) + (weight_of_twice - 1) * twice.size();
  const std::uint64_t load = std::min(all, most * tasks);
  std::vector<Slices> out;
  std::uint64_t before = 0;  // weight of all earlier places
  std::uint64_t last = 0;    // task of the previous place
  auto heavy = twice.begin();
  for (const Slice& places_in_a_row : places) {
    for (std::uint64_t place = places_in_a_row.begin; place < places_in_a_row.end; ++place) {
      if (before >= load) return out;
      const std::uint64_t task = before * tasks / load;
      if (out.empty() || task != last) out.emplace_back();
      last = task;
      add(place, out.back());
      const bool is_heavy = heavy != twice.end() && *heavy == place;
      if (is_heavy) ++heavy;
      before += is_heavy ? weight_of_twice : 1;
    }
  }
  return out;
}

std::string to_json(const Batch& batch) { return nlohmann::json(batch).dump() + '\n'; }

Batch batch_from_json(const std::string& text) {
  try {
    const Batch out = nlohmann::json::parse(text).get<Batch>();
    for (const Slices& slices : out.tasks) {
      if (slices.empty()) throw std::invalid_argument("a task without a match");
      std::uint64_t end = 0;
      for (const Slice& each : slices) {
        if (each.begin >= each.end || each.begin < end)
          throw std::invalid_argument("the slices of a task do not ascend");
        end = each.end;
      }
    }
    return out;
  } catch (const nlohmann::json::exception&) {
    throw std::invalid_argument("no batch of a study");
  }
}

Missing missing_of(study::Study& study, campaign::Store& store, std::uint64_t most) {
  struct NotPlayed {};
  Missing out;
  bool first_round = true;
  const study::PlayRound take = [&](const study::Round& round) {
    out.is_first = std::exchange(first_round, false);
    const std::vector<std::int64_t> numbers = store.add(round.fixtures);
    std::uint64_t next = 0;  // index of the first match that the study has not taken
    study::Round counted = round;
    counted.take = [&](std::uint64_t index, const campaign::MatchResult* decided) {
      next = index + 1;
      out.seen += decided != nullptr ? 1 : 0;
      return round.take(index, decided);
    };
    if (study::answer_from(store, counted, study.metrics())) return;
    out.first_row = round.first_row;
    out.round = round.matches;
    out.may_end_early = round.may_end_early;
    find_places(round, store, numbers, next, most, out);
    if (!study.limits().play_twice) out.twice.clear();
    throw NotPlayed();
  };
  try {
    study.run(take);
  } catch (const NotPlayed&) {
    // The study was stopped at its first missing match; `out` is complete.
  }
  return out;
}

namespace {

constexpr std::chrono::minutes patience{2};  // longest wait for a controller that does not answer, and for one command

using process::ProgramEnd;

ProgramEnd run_once(const std::vector<std::string>& words) {
  try {
    ProgramEnd out = process::run_program({.words = words, .patience = patience});
    if (!out.in_time)
      throw SlurmError(
          fmt::format("{} has not answered for {} s", words.front(), std::chrono::seconds(patience).count()));
    if (out.found) return out;
  } catch (const std::system_error& error) {
    throw SlurmError(error.what());
  }
  throw SlurmError(fmt::format(
      "there is no {} here: this machine does not belong to a cluster with Slurm, or its commands are not in "
      "PATH",
      words.front()));
}

// Returns whether the error is temporary, because the controller restarts or is overloaded.
bool is_passing(const ProgramEnd& ended) {
  constexpr std::array signs{"Unable to contact slurm controller", "Socket timed out", "Connection refused",
                             "Resource temporarily unavailable", "Slurm controller is not responding"};
  return std::ranges::any_of(signs, [&](const char* each) { return ended.errors.find(each) != std::string::npos; });
}

// Throws SlurmError with the last line of the error text, which has the reason: "sbatch: error: Batch job submission
// failed: Invalid partition name specified".
[[noreturn]] void fail(const std::string& command, const ProgramEnd& ended) {
  std::istringstream lines(ended.errors);
  std::string line, last;
  while (std::getline(lines, line)) {
    if (!line.empty()) last = line;
  }
  throw SlurmError(last.empty() ? command + " failed and does not say why" : texts::one_line(last));
}

// Returns the output of a command. Repeats the command while the controller does not answer and done() is false.
std::string output_of(const std::vector<std::string>& words, const std::function<bool()>& done = {}) {
  const auto until = std::chrono::steady_clock::now() + patience;
  for (;;) {
    const ProgramEnd ended = run_once(words);
    if (ended.succeeded()) return ended.output;
    const bool passing = is_passing(ended);
    if (passing && done && done()) return {};
    if (!passing || std::chrono::steady_clock::now() > until) fail(words.front(), ended);
    std::this_thread::sleep_for(std::chrono::seconds(2));
  }
}

std::string folder_of(const JobRequest& request) { return request.script.parent_path().string(); }

}  // namespace

std::string in_pattern(const std::filesystem::path& path) {
  std::string out;
  for (const char c : path.string()) {
    out += c;
    if (c == '%') out += c;
  }
  return out;
}

std::string submit(const JobRequest& request) {
  std::vector<std::string> words{"sbatch",
                                 "--parsable",
                                 "--requeue",
                                 "--open-mode=append",
                                 "--job-name=" + request.name,
                                 "--output=" + request.output,
                                 "--chdir=" + folder_of(request),
                                 "--ntasks=1",
                                 fmt::format("--cpus-per-task={}", request.processors)};
  if (request.tasks > 0) words.push_back(fmt::format("--array=0-{}", request.tasks - 1));
  if (!request.after.empty()) words.push_back("--dependency=afterany:" + request.after);
  words.insert(words.end(), request.options.begin(), request.options.end());
  words.push_back(request.script.string());
  words.insert(words.end(), request.arguments.begin(), request.arguments.end());
  std::string taken;  // number of a job whose submission timed out, but succeeded
  const std::string output = output_of(words, [&] {
    taken = job_of(request);
    return !taken.empty();
  });
  if (!taken.empty()) return taken;
  // sbatch prints "123" or "123;cluster".
  const std::string number = output.substr(0, output.find_first_not_of("0123456789"));
  if (number.empty()) throw SlurmError("sbatch names no job: " + texts::one_line(output));
  return number;
}

std::vector<std::string> alive(const std::vector<std::string>& jobs) {
  if (jobs.empty()) return {};
  // squeue runs without --jobs, because it reports an error for the number of a job that Slurm has forgotten.
  std::istringstream in(output_of({"squeue", "--noheader", "--me", "--format=%A %F"}));
  std::set<std::string> there;
  for (std::string number; in >> number;) there.insert(number);
  std::vector<std::string> out;
  std::ranges::copy_if(jobs, std::back_inserter(out), [&](const std::string& each) { return there.contains(each); });
  return out;
}

std::string job_of(const JobRequest& request) {
  const std::string wanted = fmt::format("{} {}", folder_of(request), request.name);
  std::istringstream in(output_of({"squeue", "--noheader", "--me", "--format=%F %Z %j"}));
  for (std::string line; std::getline(in, line);) {
    const std::size_t space = std::min(line.find(' '), line.size());
    if (line.substr(std::min(space + 1, line.size())) == wanted) return line.substr(0, space);
  }
  return {};
}

void cancel(const std::vector<std::string>& jobs) {
  if (jobs.empty()) return;
  std::vector<std::string> words{"scancel", "--quiet"};
  words.insert(words.end(), jobs.begin(), jobs.end());
  output_of(words);
}

bool is_within(const std::vector<std::string>& jobs) {
  return std::ranges::any_of(std::array{"SLURM_JOB_ID", "SLURM_ARRAY_JOB_ID"}, [&](const char* name) {
    const char* const job = std::getenv(name);
    return job != nullptr && std::ranges::find(jobs, job) != jobs.end();
  });
}

}  // namespace regista::cluster
