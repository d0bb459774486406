// SPDX-License-Identifier: MIT
// What recording a whole match costs: configs/teams/paper.yaml against fixed_rate.yaml, with and without a recording,
// in turn in one run. `wall` and `processor` are the ratio of what a recorded match takes to what a bare one takes;
// `background` tells whether chunks are compressed in a thread of their own, as `regista match --record` does (workers
// of a tournament do not). `mb` is the size of the file, `mb_truth_and_decisions` of one that held /game and /decision
// alone.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <map>
#include <string>

#include "match/teams.hpp"
#include "mcap/reader.hpp"
#include "mcap/writer.hpp"
#include "recording/match_recording.hpp"
#include "teams.hpp"

namespace regista {
namespace {

struct Seconds {
  double wall = 0.0, processor = 0.0;
  Seconds& operator+=(const Seconds& other) {
    wall += other.wall;
    processor += other.processor;
    return *this;
  }
};

Seconds seconds_of(const auto& work) {
  const auto wall = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  work();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count(),
          static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC};
}

// The size of a file with these messages of `from` alone.
double size_of_truth_and_decisions(const std::filesystem::path& from, const std::filesystem::path& to) {
  mcap::Reader reader(from);
  mcap::Writer writer(to, {.replace = true});
  std::map<mcap::ChannelId, mcap::ChannelId> copied;
  mcap::Message message;
  while (reader.next(message)) {
    const mcap::Channel& channel = reader.channels().at(message.channel);
    if (channel.topic != "/game" && !channel.topic.starts_with("/decision/")) continue;
    const auto [place, fresh] = copied.try_emplace(message.channel);
    if (fresh) place->second = writer.add_channel(channel.topic, channel.message_encoding);
    message.channel = place->second;
    writer.write(message);
  }
  writer.close();
  return static_cast<double>(std::filesystem::file_size(to));
}

void recorded_match(benchmark::State& state) {
  static const Teams teams;
  const std::array<const mind::TeamPlan*, 2> both{&teams.paper, &teams.fixed_rate};
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("regista_recording_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / "match.mcap";
  const bool background = state.range(0) != 0;

  Seconds bare, recorded;
  for (auto _ : state) {
    std::uint64_t hash = 0;
    bare += seconds_of([&] { hash = match::play(teams.setup, both).hash; });
    recorded += seconds_of([&] {
      recording::MatchRecording recording(file, {both, "benchmark", "benchmark", "", 1},
                                          {.replace = true, .background = background});
      match::Observer observer;
      observer.step = [&](const match::Snapshot& snapshot) { recording.stepped(snapshot); };
      observer.event = [&](double time, const match::Event& event, const match::GameState& now) {
        recording.event(time, event, now);
      };
      const auto after = [&](const mind::Mind& mind, const match::Decision& decision) {
        recording.decided(mind, decision);
      };
      if (match::play(teams.setup, both, &observer, after).hash != hash) state.SkipWithError("another match");
      recording.close();
    });
  }
  state.counters["wall"] = recorded.wall / bare.wall;
  state.counters["processor"] = recorded.processor / bare.processor;
  state.counters["mb"] = static_cast<double>(std::filesystem::file_size(file)) / 1e6;
  state.counters["mb_truth_and_decisions"] = size_of_truth_and_decisions(file, folder / "part.mcap") / 1e6;
  std::filesystem::remove_all(folder);
}

BENCHMARK(recorded_match)->ArgName("background")->Arg(1)->Arg(0)->Unit(benchmark::kMillisecond)->Iterations(5);

}  // namespace
}  // namespace regista
