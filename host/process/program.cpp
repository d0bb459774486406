// SPDX-License-Identifier: MIT
#include "process/program.hpp"

#include <poll.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

#include "process/descriptor.hpp"

namespace regista::process {
namespace {

using Clock = std::chrono::steady_clock;

// What it writes, until it has closed both; false where that takes too long.
bool read_both(const ProgramCall& call, FileDescriptor& output, FileDescriptor& errors, ProgramEnd& out) {
  const auto begin = Clock::now();
  const auto append_to = [&](std::string& text) {
    return [&text, &call](std::string_view piece) {
      text.append(piece.substr(0, call.longest_text - std::min(call.longest_text, text.size())));
    };
  };
  while (output.is_open() || errors.is_open()) {
    int wait = -1;
    if (call.patience) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(begin + *call.patience - Clock::now());
      if (left.count() <= 0) return false;
      wait = static_cast<int>(left.count());
    }
    std::array<pollfd, 2> ends{{{output.number, POLLIN, 0}, {errors.number, POLLIN, 0}}};
    if (::poll(ends.data(), ends.size(), wait) <= 0) continue;  // a signal, or time is up
    if (ends[0].revents != 0) read_available(output, append_to(out.output));
    if (ends[1].revents != 0) read_available(errors, append_to(out.errors));
  }
  return true;
}

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("_-./=:,+@%").find(c) != std::string_view::npos;
}

std::string quoted(const std::string& word) {
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  std::string out = "'";
  for (const char c : word) {
    if (c == '\'') {
      out += "'\\''";
    } else {
      out += c;
    }
  }
  return out + '\'';
}

}  // namespace

ProgramEnd run_program(const ProgramCall& call) {
  ProgramEnd out;
  Pipe output = make_pipe(), errors = make_pipe();
  Setting setting{.files = {{output.write.number, 1}, {errors.write.number, 2}},
                  .limits = {.core_file = true},
                  .outlives_parent = true};
  Child running;
  try {
    running = Child::program(setting, {call.words.front(), call.words, std::nullopt});
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::no_such_file_or_directory) throw;
    out.found = false;
    return out;
  }
  output.write.reset();
  errors.write.reset();
  out.in_time = read_both(call, output.read, errors.read, out);
  if (!out.in_time) running.kill();
  out.end = running.wait();
  return out;
}

std::string shell_line(std::span<const std::string> words) {
  std::string line;
  for (const std::string& word : words) {
    if (!line.empty()) line += ' ';
    line += quoted(word);
  }
  return line;
}

std::string command_line(std::span<const std::string> words) {
  std::vector<std::string> line{"regista"};
  line.insert(line.end(), words.begin(), words.end());
  return shell_line(line);
}

}  // namespace regista::process
