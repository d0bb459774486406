// SPDX-License-Identifier: MIT
#include "results/stored_match.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "command/end_of_program.hpp"
#include "config/typed.hpp"
#include "output/output.hpp"
#include "process/program.hpp"
#include "results/results_file.hpp"

namespace regista::results {

StoredMatch read_stored_match(const std::string& results, const std::string& row, std::span<const StudyKind> kinds) {
  const campaign::Store store = read_results(results);
  const auto report = stored_study(results, store, {}, kinds);
  study::Study& study = report->study();
  const std::uint64_t number = config::parse_whole("--row", row, 1, study.most_matches());
  StoredMatch out;
  out.results = std::filesystem::absolute(results).string();
  out.row = row;
  out.limits = study.limits();
  try {
    auto played = stored_match(store, study, number);
    if (!played)
      throw command::BadInput(fmt::format("--row {}: this match of {} has not been played", number, results));
    out.job = std::move(played->job);
    out.decided = std::move(played->decided);
  } catch (const campaign::StoreError& error) {
    throw command::BadInput(error.what());
  }
  std::error_code error;
  std::filesystem::current_path(study.folder(), error);
  if (error) {
    throw command::BadInput(fmt::format("--from {}: the folder it was begun in, {}, cannot be entered: {}", results,
                                        study.folder(), error.message()));
  }
  return out;
}

std::unique_ptr<campaign::StoredSetup> set_up(const StoredMatch& stored, const plugin::Catalogue& catalogue,
                                              const std::string& program) try {
  auto out = std::make_unique<campaign::StoredSetup>(stored.job, catalogue,
                                                     [&] { return read_results(stored.results).documents(); });
  if (out->missing().empty()) return out;
  std::vector<std::string> words = campaign::match_arguments(stored.job);
  words.insert(words.begin(), program);
  throw command::BadInput(fmt::format("--row {}: was played with something else: {}; as things are now it would be: {}",
                                      stored.row, out->missing(), process::shell_line(words)));
} catch (const std::system_error& error) {
  throw output::WriteError(fmt::format("the files of the match cannot be laid out again: {}", error.what()));
} catch (const std::invalid_argument& error) {
  throw command::BadInput(fmt::format("results in {} are damaged: {}", stored.results, error.what()));
} catch (const campaign::StoreError& error) {
  throw command::BadInput(error.what());
}

}  // namespace regista::results
