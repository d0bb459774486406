// SPDX-License-Identifier: MIT
#include "campaign/run_program.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "campaign/file_descriptor.hpp"

namespace regista::campaign {
namespace {

using Clock = std::chrono::steady_clock;

struct Pipe {
  FileDescriptor read, write;
};

Pipe new_pipe(const std::string& program) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) == -1)
    throw std::system_error(errno, std::generic_category(), "cannot start " + program);
  return {FileDescriptor(ends[0]), FileDescriptor(ends[1])};
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> out;
  for (std::string& each : words) out.push_back(each.data());
  out.push_back(nullptr);
  return out;
}

// How a child is set up; freed at the end.
struct SpawnSettings {
  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
  SpawnSettings() {
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
  }
  ~SpawnSettings() {
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
};

// The error of posix_spawnp.
int spawn(const ProgramCall& call, const Pipe& output, const Pipe& errors, pid_t& child) {
  std::vector<std::string> words = call.words;
  std::vector<std::string> variables = call.environment.value_or(std::vector<std::string>());
  const std::vector<char*> arguments = pointers(words), own_environment = pointers(variables);
  SpawnSettings settings;
  posix_spawn_file_actions_addopen(&settings.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&settings.actions, output.write.number, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&settings.actions, errors.write.number, STDERR_FILENO);
  if (!call.folder.empty()) posix_spawn_file_actions_addchdir_np(&settings.actions, call.folder.c_str());
  posix_spawnattr_setflags(&settings.attributes, POSIX_SPAWN_SETPGROUP);
  return posix_spawnp(&child, words.front().c_str(), &settings.actions, &settings.attributes, arguments.data(),
                      call.environment ? own_environment.data() : environ);
}

// A process with a group of its own. Killed and waited for at the end, where nobody has done so.
class Child {
 public:
  explicit Child(pid_t process) : process_(process) {}
  ~Child() {
    if (process_ == -1) return;
    end();
    while (waitpid(process_, nullptr, 0) == -1 && errno == EINTR) {
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // With all that it has started.
  void end() const { kill(-process_, SIGKILL); }
  int wait() {
    int status = 0;
    while (waitpid(process_, &status, 0) == -1) {
      if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "cannot wait for a program");
    }
    process_ = -1;
    return status;
  }

 private:
  pid_t process_;
};

// What it writes, until it has closed both; false where that takes too long.
bool read_both(const ProgramCall& call, Pipe& output, Pipe& errors, ProgramEnd& out) {
  const auto begin = Clock::now();
  struct Text {
    FileDescriptor& from;
    std::string& to;
  };
  std::array<Text, 2> texts{{{output.read, out.output}, {errors.read, out.errors}}};
  std::array<char, 4096> piece{};
  const auto open = [](const Text& text) { return text.from.number != -1; };
  while (std::ranges::any_of(texts, open)) {
    int wait = -1;
    if (call.patience) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(begin + *call.patience - Clock::now());
      if (left.count() <= 0) return false;
      wait = static_cast<int>(left.count());
    }
    std::array<pollfd, 2> ends{{{texts[0].from.number, POLLIN, 0}, {texts[1].from.number, POLLIN, 0}}};
    if (poll(ends.data(), ends.size(), wait) <= 0) continue;  // a signal, or time is up
    for (std::size_t i = 0; i < texts.size(); ++i) {
      if (ends[i].revents == 0) continue;
      const ssize_t got = ::read(ends[i].fd, piece.data(), piece.size());
      if (got == -1 && errno == EINTR) continue;
      if (got <= 0) {
        texts[i].from.reset();
        continue;
      }
      const std::size_t room = call.longest_text - std::min(call.longest_text, texts[i].to.size());
      texts[i].to.append(piece.data(), std::min(room, static_cast<std::size_t>(got)));
    }
  }
  return true;
}

}  // namespace

bool ProgramEnd::succeeded() const { return found && in_time && WIFEXITED(status) && WEXITSTATUS(status) == 0; }

ProgramEnd run_program(const ProgramCall& call) {
  ProgramEnd out;
  Pipe output = new_pipe(call.words.front()), errors = new_pipe(call.words.front());
  pid_t child = -1;
  const int error = spawn(call, output, errors, child);
  const bool has_folder = call.folder.empty() || std::filesystem::is_directory(call.folder);
  if (error == ENOENT && has_folder) {
    out.found = false;
    return out;
  }
  if (error != 0) throw std::system_error(error, std::generic_category(), "cannot start " + call.words.front());
  output.write.reset();
  errors.write.reset();
  Child running{child};
  out.in_time = read_both(call, output, errors, out);
  if (!out.in_time) running.end();
  out.status = running.wait();
  return out;
}

}  // namespace regista::campaign
