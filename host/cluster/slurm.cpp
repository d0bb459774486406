// SPDX-License-Identifier: MIT
#include "cluster/slurm.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <set>
#include <sstream>
#include <thread>

#include "campaign/file_descriptor.hpp"
#include "config/text.hpp"

namespace regista::cluster {
namespace {

constexpr std::chrono::minutes patience{2};  // with a controller that does not answer

constexpr int not_found = 127;  // exit code of a child that found no program

struct Ended {
  int status = 0;
  std::string output, errors;
};

std::string everything_of(int descriptor) {
  std::string out;
  std::array<char, 4096> piece{};
  for (;;) {
    const ssize_t got = ::read(descriptor, piece.data(), piece.size());
    if (got == -1 && errno == EINTR) continue;
    if (got <= 0) return out;
    out.append(piece.data(), static_cast<std::size_t>(got));
  }
}

// What it says is short, so that the one pipe is not full while the other is read.
Ended run_once(std::vector<std::string> words) {
  std::array<int, 2> output{}, errors{};
  if (pipe2(output.data(), O_CLOEXEC) == -1 || pipe2(errors.data(), O_CLOEXEC) == -1)
    throw SlurmError(fmt::format("cannot start {}: {}", words.front(), std::strerror(errno)));
  const campaign::FileDescriptor said(output[0]), complained(errors[0]);
  std::vector<char*> arguments;
  for (std::string& each : words) arguments.push_back(each.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, output[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors[1], STDERR_FILENO);
  // Ctrl-C is for this program, which then decides.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t child = -1;
  const int error = posix_spawnp(&child, words.front().c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  ::close(output[1]);
  ::close(errors[1]);
  const auto absent = [&] {
    return SlurmError(
        fmt::format("there is no {} here: this machine does not belong to a cluster with Slurm, or its "
                    "commands are not in PATH",
                    words.front()));
  };
  if (error == ENOENT) throw absent();
  if (error != 0) throw SlurmError(fmt::format("cannot start {}: {}", words.front(), std::strerror(error)));
  Ended out;
  out.output = everything_of(said.number);
  out.errors = everything_of(complained.number);
  while (waitpid(child, &out.status, 0) == -1 && errno == EINTR) {
  }
  if (WIFEXITED(out.status) && WEXITSTATUS(out.status) == not_found && out.output.empty()) throw absent();
  return out;
}

// The controller is restarted, or has too much to do.
bool is_passing(const Ended& ended) {
  constexpr std::array signs{"Unable to contact slurm controller", "Socket timed out", "Connection refused",
                             "Resource temporarily unavailable", "Slurm controller is not responding"};
  return std::ranges::any_of(signs, [&](const char* each) { return ended.errors.find(each) != std::string::npos; });
}

Ended run(const std::vector<std::string>& words) {
  const auto until = std::chrono::steady_clock::now() + patience;
  for (;;) {
    Ended out = run_once(words);
    if ((WIFEXITED(out.status) && WEXITSTATUS(out.status) == 0) || !is_passing(out)) return out;
    if (std::chrono::steady_clock::now() > until) return out;
    std::this_thread::sleep_for(std::chrono::seconds(2));
  }
}

// Its last line says what was wrong: "sbatch: error: Batch job submission failed: Invalid partition name specified".
[[noreturn]] void fail(const std::string& command, const Ended& ended) {
  std::istringstream lines(ended.errors);
  std::string line, last;
  while (std::getline(lines, line)) {
    if (!line.empty()) last = line;
  }
  throw SlurmError(last.empty() ? command + " failed and does not say why" : config::one_line(last));
}

bool succeeded(const Ended& ended) { return WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == 0; }

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
                                 "--chdir=" + request.script.parent_path().string(),
                                 "--ntasks=1",
                                 fmt::format("--cpus-per-task={}", request.processors)};
  if (request.tasks > 0) words.push_back(fmt::format("--array=0-{}", request.tasks - 1));
  if (!request.after.empty()) words.push_back("--dependency=afterany:" + request.after);
  words.insert(words.end(), request.options.begin(), request.options.end());
  words.push_back(request.script.string());
  words.insert(words.end(), request.arguments.begin(), request.arguments.end());
  const Ended ended = run(words);
  if (!succeeded(ended)) fail("sbatch", ended);
  // "123" or "123;cluster"
  const std::string number = ended.output.substr(0, ended.output.find_first_not_of("0123456789"));
  if (number.empty()) throw SlurmError("sbatch names no job: " + config::one_line(ended.output));
  return number;
}

std::vector<std::string> alive(const std::vector<std::string>& jobs) {
  if (jobs.empty()) return {};
  // Without --jobs: of a job that has been forgotten squeue would say that its number is invalid.
  const Ended ended = run({"squeue", "--noheader", "--me", "--format=%A %F"});
  if (!succeeded(ended)) fail("squeue", ended);
  std::istringstream in(ended.output);
  std::set<std::string> there;
  for (std::string number; in >> number;) there.insert(number);
  std::vector<std::string> out;
  std::ranges::copy_if(jobs, std::back_inserter(out), [&](const std::string& each) { return there.contains(each); });
  return out;
}

void cancel(const std::vector<std::string>& jobs) {
  if (jobs.empty()) return;
  std::vector<std::string> words{"scancel", "--quiet"};
  words.insert(words.end(), jobs.begin(), jobs.end());
  const Ended ended = run(words);
  if (!succeeded(ended)) fail("scancel", ended);
}

bool is_within(const std::vector<std::string>& jobs) {
  const char* const job = std::getenv("SLURM_JOB_ID");
  return job != nullptr && std::ranges::find(jobs, job) != jobs.end();
}

}  // namespace regista::cluster
