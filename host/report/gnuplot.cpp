// SPDX-License-Identifier: MIT
#include "report/gnuplot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "campaign/temporary_folder.hpp"
#include "config/file.hpp"
#include "report/visible_text.hpp"

namespace regista::report {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds patience{60};
constexpr std::size_t longest_complaint = 4096;
constexpr auto cannot_start = 127;  // exit code of a child that found no program

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

bool write(const fs::path& file, const std::string& bytes) {
  std::ofstream out(file, std::ios::binary);
  out << bytes;
  out.close();
  return out.good();
}

struct Ended {
  bool started = false, in_time = true;
  int status = 0;
  std::string complaint;
};

// What it writes, until it closes its end; false when that takes too long. The rest is read and forgotten.
bool drain(int pipe, std::string& out) {
  const auto end = std::chrono::steady_clock::now() + patience;
  std::array<char, 1024> piece{};
  while (true) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
    pollfd wait{pipe, POLLIN, 0};
    const int ready = left > 0 ? poll(&wait, 1, static_cast<int>(left)) : 0;
    if (ready == -1 && errno == EINTR) continue;
    if (ready <= 0) return false;
    const ssize_t got = ::read(pipe, piece.data(), piece.size());
    if (got == -1 && errno == EINTR) continue;
    if (got <= 0) return true;
    if (out.size() < longest_complaint) out.append(piece.data(), static_cast<std::size_t>(got));
  }
}

Ended run_gnuplot(const fs::path& folder, const std::string& script) {
  std::array<int, 2> pipe{};
  if (pipe2(pipe.data(), O_CLOEXEC) == -1) fail("cannot start gnuplot");
  std::string program = "gnuplot", settings = "-d", file = script;  // -d: no files of settings
  char* const arguments[] = {program.data(), settings.data(), file.data(), nullptr};
  // No locale, font or terminal of the user's: the same picture everywhere.
  std::string locale = "LC_ALL=C.UTF-8", home = "HOME=" + folder.string();
  const char* const path = std::getenv("PATH");
  std::string search = fmt::format("PATH={}", path == nullptr ? "" : path);
  char* const environment[] = {locale.data(), home.data(), search.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  // Ctrl-C is for the program, which then decides; a figure must not be lost to it.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t child = -1;
  Ended out;
  out.started = posix_spawnp(&child, program.c_str(), &actions, &attributes, arguments, environment) == 0;
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  close(pipe[1]);
  if (out.started) {
    out.in_time = drain(pipe[0], out.complaint);
    if (!out.in_time) kill(child, SIGKILL);
    while (waitpid(child, &out.status, 0) == -1 && errno == EINTR) {
    }
  }
  close(pipe[0]);
  return out;
}

// What went wrong stands last, after warnings.
std::string last_line(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \t\r\n^");
  if (end == std::string::npos) return "it does not say why";
  const std::size_t before = text.rfind('\n', end), begin = before == std::string::npos ? 0 : before + 1;
  return visible_at_most(text.substr(begin, end + 1 - begin), 200);
}

// Into the named file of the folder. Empty: done.
std::string picture(const fs::path& folder, Drawing& drawing, Picture kind) {
  const std::string script = drawing.figure.name + (kind == Picture::svg ? ".gnuplot" : ".png.gnuplot");
  if (!write(folder / script, gnuplot_script(drawing.figure, kind))) return "temporary files cannot be written";
  const Ended ended = run_gnuplot(folder, script);
  const bool absent = !ended.started || (WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == cannot_start);
  if (absent) {
    drawing.no_gnuplot = true;
    return "gnuplot is not installed";
  }
  if (!ended.in_time) return fmt::format("gnuplot took more than {} s", patience.count());
  if (!WIFEXITED(ended.status)) return fmt::format("gnuplot was stopped by signal {}", WTERMSIG(ended.status));
  if (WEXITSTATUS(ended.status) != 0) return "gnuplot: " + last_line(ended.complaint);
  std::string& bytes = kind == Picture::svg ? drawing.svg : drawing.png;
  bytes = config::file_content(folder / (drawing.figure.name + (kind == Picture::svg ? ".svg" : ".png"))).value_or("");
  return bytes.empty() ? "gnuplot wrote no picture" : "";
}

void draw_into(Drawing& out, Png png) {
  const campaign::TemporaryFolder folder;
  if (!write(folder.path() / (out.figure.name + ".csv"), out.figure.csv)) {
    out.why_not = "temporary files cannot be written";
    return;
  }
  out.why_not = picture(folder.path(), out, Picture::svg);
  if (out.why_not.empty() && png == Png::wanted) out.why_not = picture(folder.path(), out, Picture::png);
}

}  // namespace

Drawing draw(Figure figure, Png png) {
  Drawing out;
  out.figure = std::move(figure);
  try {
    draw_into(out, png);
  } catch (const std::system_error& error) {
    out.why_not = visible(error.what());
  }
  return out;
}

}  // namespace regista::report
