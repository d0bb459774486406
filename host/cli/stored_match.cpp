// SPDX-License-Identifier: MIT
#include "cli/stored_match.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <vector>

#include "campaign/inputs.hpp"
#include "campaign/job_setup.hpp"
#include "campaign/mathematics.hpp"
#include "campaign/shell.hpp"
#include "cli/end_of_program.hpp"
#include "cli/results_file.hpp"
#include "config/typed.hpp"
#include "output/output.hpp"

namespace regista::cli {

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
    if (!played) throw BadInput(fmt::format("--row {}: this match of {} has not been played", number, results));
    out.job = std::move(played->job);
    out.decided = std::move(played->decided);
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  }
  std::error_code error;
  std::filesystem::current_path(study.folder(), error);
  if (error) {
    throw BadInput(fmt::format("--from {}: the folder it was begun in, {}, cannot be entered: {}", results,
                               study.folder(), error.message()));
  }
  return out;
}

StoredSetup::StoredSetup(const StoredMatch& stored, const plugin::Catalogue& catalogue, const std::string& program)
    : catalogue_(catalogue), job_(stored.job) {
  changed_ = set_up();
  if (changed_.empty()) return;
  take_copies(stored);
  const std::string still = copies_ ? set_up() : changed_;
  if (still.empty()) return;
  std::vector<std::string> words = campaign::match_arguments(stored.job);
  words.insert(words.begin(), program);
  throw BadInput(fmt::format("--row {}: was played with something else: {}; as things are now it would be: {}",
                             stored.row, still, campaign::shell_line(words)));
}

void StoredSetup::take_copies(const StoredMatch& stored) try {
  std::vector<campaign::Document> documents = read_results(stored.results).documents();
  if (documents.empty()) return;
  const std::filesystem::path given_in = std::filesystem::current_path();
  copies_.emplace(std::move(documents));
  job_ = copies_->job(stored.job, given_in);
  std::filesystem::current_path(copies_->folder(given_in));
} catch (const std::system_error& error) {
  throw output::WriteError(fmt::format("the files of the match cannot be laid out again: {}", error.what()));
} catch (const std::invalid_argument& error) {
  throw BadInput(fmt::format("results in {} are damaged: {}", stored.results, error.what()));
} catch (const campaign::StoreError& error) {
  throw BadInput(error.what());
}

// What is not as it was; empty when nothing.
std::string StoredSetup::set_up() {
  try {
    prepared_ = campaign::match_setup(campaign::request_of(job_), catalogue_);
  } catch (const config::Error& error) {
    return error.what();
  } catch (const BadInput& error) {
    return error.what();
  }
  return campaign::what_changed(job_, prepared_, catalogue_, campaign::program_hash(),
                                campaign::mathematics_fingerprint(), copies_ ? copies_->root().string() : "");
}

}  // namespace regista::cli
