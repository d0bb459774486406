// SPDX-License-Identifier: MIT
#include "recording/match_to_find.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "mcap/error.hpp"
#include "mcap/reader.hpp"
#include "recording/about.hpp"
#include "texts/json.hpp"

namespace regista::recording {
namespace {

constexpr std::uint64_t last_stretch = 1'000'000'000;  // ns: the state of the game is written every 0.1 s

bool says(const mcap::Pairs& about, const char* key, std::string_view value) {
  const auto found = about.find(key);
  return found != about.end() && found->second == value;
}

// Teams of the same name have their files or letters behind it in a tournament: "small (a/small.yaml)".
bool says_team(const mcap::Pairs& about, const char* side, const std::string& label) {
  const auto found = about.find(side);
  if (found == about.end()) return false;
  const std::string name = nlohmann::json::parse(found->second).at("team").get<std::string>();
  return label == name || label.starts_with(name + " (");
}

bool fits(const mcap::Pairs& about, const MatchToFind& match) {
  return says(about, "seed", std::to_string(match.seed)) && says(about, "opening", match.opening) &&
         says_team(about, "home", match.labels[0]) && says_team(about, "away", match.labels[1]);
}

// The score at the end of a recording that was finished. Goals of the last tenth of a second are found in events alone.
std::optional<std::array<int, 2>> last_score(mcap::Reader& reader) {
  const mcap::Statistics* const statistics = reader.statistics();
  if (statistics == nullptr) return std::nullopt;
  const std::uint64_t end = statistics->last_time;
  reader.select({.first_time = end - std::min(end, last_stretch), .topics = {"/game", "/event"}});
  std::string last;
  for (mcap::Message message; reader.next(message);) last = message.data;
  if (last.empty()) return std::nullopt;
  return nlohmann::json::parse(last).at("score").get<std::array<int, 2>>();
}

// How many packets were recorded; of a file with a summary, which counts them.
double packets(const mcap::Reader& reader) {
  std::uint64_t out = 0;
  for (const auto& [channel, count] : reader.statistics()->messages_of) {
    const auto found = reader.channels().find(channel);
    if (found != reader.channels().end() && found->second.topic == "/packet") out += count;
  }
  return static_cast<double>(out);
}

}  // namespace

bool holds(const std::filesystem::path& recording, const MatchToFind& match) {
  try {
    mcap::Reader reader(recording);
    if (!reader.indexed()) {
      if (match.score) return false;
      // Who plays stands before the first message.
      mcap::Message message;
      reader.next(message);
    }
    const mcap::Pairs* const about = about_in(reader);
    if (about == nullptr || !fits(*about, match)) return false;
    if (!match.score) return true;
    return last_score(reader) == match.score && (!match.packets || packets(reader) == *match.packets);
  } catch (const mcap::Error&) {
  } catch (const nlohmann::json::exception&) {
  }
  return false;
}

}  // namespace regista::recording
