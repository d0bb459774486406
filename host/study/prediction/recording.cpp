// SPDX-License-Identifier: MIT
#include "study/prediction/recording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "study/prediction/formats.hpp"

namespace regista::study {

bool Stretch::runs_at(double time) const {
  const auto after = std::upper_bound(play.begin(), play.end(), time,
                                      [](double t, const PlayChange& change) { return t < change.time; });
  return after != play.begin() && (after - 1)->runs;
}

std::filesystem::path referee_file(const std::filesystem::path& data) {
  const std::string name = data.filename().string();
  const std::size_t end = std::min(name.rfind("_ball"), name.rfind("_robots"));
  if (end != std::string::npos) {
    for (const char* ending : {"_referee.csv.gz", "_referee.csv"}) {
      const std::filesystem::path candidate = data.parent_path() / (name.substr(0, end) + ending);
      std::error_code ignored;
      if (std::filesystem::exists(candidate, ignored)) return candidate;
    }
  }
  throw config::Error({data.string()},
                      "the states of the referee are missing: no NAME_referee.csv.gz stands beside it; say which file "
                      "with --referee FILE");
}

GameRecording read_recording(const config::PredictorStudy& study, const std::filesystem::path& data,
                             const std::filesystem::path& referee, const Progress& progress) {
  using Format = config::PredictorStudy::Format;
  GameRecording recording;
  switch (study.format) {
    case Format::ssl_ball:
      recording = read_ssl_ball(data, referee, progress);
      break;
    case Format::ssl_robots:
      recording = read_ssl_robots(data, referee, progress);
      break;
    case Format::simulation_2d:
      recording = read_simulation_2d(data, study.subject, progress);
      break;
  }
  recording.file = data.string();
  if (recording.stretches.empty()) throw config::Error({recording.file}, "holds no detection");
  return recording;
}

}  // namespace regista::study
