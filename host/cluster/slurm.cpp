// SPDX-License-Identifier: MIT
#include "cluster/slurm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <iterator>
#include <set>
#include <sstream>
#include <system_error>
#include <thread>

#include "process/program.hpp"
#include "texts/message.hpp"

namespace regista::cluster {
namespace {

constexpr std::chrono::minutes patience{2};  // with a controller that does not answer, and with one command

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

// The controller is restarted, or has too much to do.
bool is_passing(const ProgramEnd& ended) {
  constexpr std::array signs{"Unable to contact slurm controller", "Socket timed out", "Connection refused",
                             "Resource temporarily unavailable", "Slurm controller is not responding"};
  return std::ranges::any_of(signs, [&](const char* each) { return ended.errors.find(each) != std::string::npos; });
}

ProgramEnd run(const std::vector<std::string>& words) {
  const auto until = std::chrono::steady_clock::now() + patience;
  for (;;) {
    ProgramEnd out = run_once(words);
    if (out.succeeded() || !is_passing(out)) return out;
    if (std::chrono::steady_clock::now() > until) return out;
    std::this_thread::sleep_for(std::chrono::seconds(2));
  }
}

// Its last line says what was wrong: "sbatch: error: Batch job submission failed: Invalid partition name specified".
[[noreturn]] void fail(const std::string& command, const ProgramEnd& ended) {
  std::istringstream lines(ended.errors);
  std::string line, last;
  while (std::getline(lines, line)) {
    if (!line.empty()) last = line;
  }
  throw SlurmError(last.empty() ? command + " failed and does not say why" : texts::one_line(last));
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
  const auto until = std::chrono::steady_clock::now() + patience;
  ProgramEnd ended = run_once(words);
  while (!ended.succeeded()) {
    if (!is_passing(ended)) fail("sbatch", ended);
    // Who has not answered in time may have taken the job all the same.
    if (std::string job = job_of(request); !job.empty()) return job;
    if (std::chrono::steady_clock::now() > until) fail("sbatch", ended);
    std::this_thread::sleep_for(std::chrono::seconds(2));
    ended = run_once(words);
  }
  // "123" or "123;cluster"
  const std::string number = ended.output.substr(0, ended.output.find_first_not_of("0123456789"));
  if (number.empty()) throw SlurmError("sbatch names no job: " + texts::one_line(ended.output));
  return number;
}

std::vector<std::string> alive(const std::vector<std::string>& jobs) {
  if (jobs.empty()) return {};
  // Without --jobs: of a job that has been forgotten squeue would say that its number is invalid.
  const ProgramEnd ended = run({"squeue", "--noheader", "--me", "--format=%A %F"});
  if (!ended.succeeded()) fail("squeue", ended);
  std::istringstream in(ended.output);
  std::set<std::string> there;
  for (std::string number; in >> number;) there.insert(number);
  std::vector<std::string> out;
  std::ranges::copy_if(jobs, std::back_inserter(out), [&](const std::string& each) { return there.contains(each); });
  return out;
}

std::string job_of(const JobRequest& request) {
  const ProgramEnd ended = run({"squeue", "--noheader", "--me", "--format=%F %Z %j"});
  if (!ended.succeeded()) fail("squeue", ended);
  const std::string wanted = fmt::format("{} {}", folder_of(request), request.name);
  std::istringstream in(ended.output);
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
  const ProgramEnd ended = run(words);
  if (!ended.succeeded()) fail("scancel", ended);
}

bool is_within(const std::vector<std::string>& jobs) {
  return std::ranges::any_of(std::array{"SLURM_JOB_ID", "SLURM_ARRAY_JOB_ID"}, [&](const char* name) {
    const char* const job = std::getenv(name);
    return job != nullptr && std::ranges::find(jobs, job) != jobs.end();
  });
}

}  // namespace regista::cluster
