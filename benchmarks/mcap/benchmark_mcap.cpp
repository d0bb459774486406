// SPDX-License-Identifier: MIT
// What it costs to write and to read the recording of a 20-minute match as JSON: 7 against 7, truth ten times a second,
// each robot's belief and decision twice a second. Positions walk at random, so digits compress as those of a match do.
// The messages are made beforehand; the time is the room's alone, with the system's calls.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "mcap/reader.hpp"
#include "mcap/writer.hpp"

namespace regista::mcap {
namespace {

struct Recording {
  struct Entry {
    std::size_t channel = 0;
    std::uint64_t time = 0;
    std::string data;
  };
  std::vector<Entry> entries;
  std::size_t bytes = 0;
};

class Walk {
 public:
  Walk(std::mt19937& random, double spread) : random_(random), spread_(spread), value_(spread * unit()) {}
  double step(double length) {
    value_ += length * unit();
    return value_ = value_ > spread_ ? spread_ : value_ < -spread_ ? -spread_ : value_;
  }

 private:
  double unit() { return 2.0 * static_cast<double>(random_()) / 4294967295.0 - 1.0; }
  std::mt19937& random_;
  double spread_, value_;
};

void append_numbers(std::string& text, const char* name, std::vector<Walk>& walks, std::size_t count, double step) {
  text += '"';
  text += name;
  text += "\": [";
  for (std::size_t i = 0; i < count; ++i) {
    char number[32];
    std::snprintf(number, sizeof number, i == 0 ? "%.3f" : ", %.3f", walks[i % walks.size()].step(step));
    text += number;
  }
  text += ']';
}

const Recording& recording() {
  static const Recording made = [] {
    Recording result;
    std::mt19937 random(1);
    std::vector<Walk> truth, belief, scores;
    for (int i = 0; i < 45; ++i) truth.emplace_back(random, 4.5);
    for (int i = 0; i < 60; ++i) belief.emplace_back(random, 4.5);
    for (int i = 0; i < 147; ++i) scores.emplace_back(random, 1.0);
    const auto add = [&](std::size_t channel, std::uint64_t time, std::string text) {
      result.bytes += text.size();
      result.entries.push_back({channel, time, std::move(text)});
    };
    for (std::uint64_t tick = 0; tick < 12'000; ++tick) {
      const std::uint64_t time = tick * 100'000'000;
      std::string text = "{";
      append_numbers(text, "ball", truth, 3, 0.1);
      text += ", ";
      append_numbers(text, "robots", truth, 42, 0.03);
      add(0, time, text + "}");
      for (std::size_t robot = 0; robot < 14; ++robot) {
        if ((tick + robot) % 5 != 0) continue;
        text = "{\"robot\": " + std::to_string(robot) + ", ";
        append_numbers(text, "belief", belief, 60, 0.02);
        text += ", ";
        append_numbers(text, "covariances", scores, 48, 0.01);
        add(1 + robot, time, text + "}");
        text = "{\"context\": \"playing\", \"role\": \"supporter\", ";
        append_numbers(text, "waypoints", belief, 60, 0.02);
        text += ", ";
        append_numbers(text, "utilities", scores, 147, 0.02);
        add(15 + robot, time, text + "}");
      }
    }
    return result;
  }();
  return made;
}

std::filesystem::path file() { return std::filesystem::temp_directory_path() / "regista_benchmark.mcap"; }

std::uint64_t write(const WriterOptions& options) {
  std::filesystem::remove(file());
  Writer writer(file(), options);
  const SchemaId schema = writer.add_schema("object", "jsonschema", R"({"type": "object"})");
  std::vector<ChannelId> channels;
  for (int i = 0; i < 29; ++i) channels.push_back(writer.add_channel(std::to_string(i), "json", schema));
  std::uint32_t sequence = 0;
  for (const Recording::Entry& entry : recording().entries) {
    writer.write({channels[entry.channel], sequence++, entry.time, entry.time, entry.data});
  }
  writer.close();
  return std::filesystem::file_size(file());
}

void report(benchmark::State& state, std::uint64_t size) {
  const auto bytes = static_cast<double>(recording().bytes);
  state.counters["MB_per_s"] =
      benchmark::Counter(bytes / 1e6, benchmark::Counter::kIsIterationInvariantRate, benchmark::Counter::kIs1000);
  state.counters["plain_MB"] = bytes / 1e6;
  state.counters["file_MB"] = static_cast<double>(size) / 1e6;
  std::filesystem::remove(file());
}

// Size of a chunk in KiB.
WriterOptions options_of(const benchmark::State& state) {
  return {.chunk_size = static_cast<std::size_t>(state.range(0)) << 10};
}

void write_match(benchmark::State& state) {
  recording();
  std::uint64_t size = 0;
  for (auto _ : state) size = write(options_of(state));
  report(state, size);
}

void read_match(benchmark::State& state) {
  const std::uint64_t size = write(options_of(state));
  for (auto _ : state) {
    Reader reader(file());
    std::size_t bytes = 0;
    for (Message message; reader.next(message);) bytes += message.data.size();
    if (bytes != recording().bytes) state.SkipWithError("not all came back");
  }
  report(state, size);
}

BENCHMARK(write_match)->ArgName("chunk_KiB")->Arg(256)->Arg(1024)->Arg(4096)->Unit(benchmark::kMillisecond);
BENCHMARK(read_match)->ArgName("chunk_KiB")->Arg(256)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace regista::mcap
