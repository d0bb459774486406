// SPDX-License-Identifier: MIT
// How the program was started, and which kinds of studies it has. A kind of study knows its document, how to plan a
// study, which report reads the plan, and how a study continues.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/engine.hpp"
#include "campaign/store.hpp"
#include "config/documents.hpp"
#include "output/output_files.hpp"
#include "plugin/catalogue.hpp"
#include "report/study_report.hpp"

namespace regista::results {

struct StudyKind;

// How the program was started. The object outlives all commands.
struct Invocation {
  std::vector<std::string> arguments;  // the first argument is the name of the program
  std::filesystem::path executable{};  // path of the program's file; empty if the system does not know it
  std::span<const StudyKind> studies{};

  std::string command() const { return arguments.size() > 1 ? arguments[1] : std::string(); }  // "report"
  // Returns the path of a file or folder of the program, such as "share/regista/viewer.html", even if this path does
  // not exist. The path is empty if the system does not know the path of the program.
  std::filesystem::path own(const std::filesystem::path& name) const {
    return executable.empty() ? executable : (executable.parent_path() / ".." / name).lexically_normal();
  }
};

// Opens the plugins in the folders of `--plugins`, then those of the environment variable REGISTA_PLUGIN_PATH, then
// ../lib/regista/plugins relative to the program's folder. Throws config::Error if an option is no folder.
plugin::Catalogue open_plugins(const std::vector<std::string>& folders, const Invocation& invocation);

// Opens the plugins of a file of results from its stored folders. Throws BadInput if a folder no longer exists; the
// message says what to type instead.
plugin::Catalogue open_stored_plugins(const std::string& file, const std::vector<std::string>& folders,
                                      const Invocation& invocation);

// The plan that a document gives.
struct PlannedStudy {
  std::string plan;                      // JSON: {"study": NAME, ...}
  std::string name;                      // name of the study in its document
  std::vector<std::string> documents{};  // resolved documents of the teams, if the plan does not contain them
};

struct StudyKind {
  std::string_view name;     // name of the kind in plans
  std::string_view article;  // the name with its article: "a tournament"
  const config::DocumentKind& document;
  // Plans the study of a document. plugins: folders of the catalogue. mistakes: gets the mistakes that prevent planning
  // a valid document; with any, the result is empty. Throws config::BadInput, and config::Error at the place of a
  // mistake that leaves nothing else to check.
  std::function<PlannedStudy(const config::Node& document, const std::vector<std::string>& plugins,
                             const plugin::Catalogue& catalogue, config::Mistakes& mistakes)>
      plan;
  // Returns the report of a plan. Its study has not run yet. store: the results of the study; null: no results yet.
  // Throws std::invalid_argument if the text is not a plan of this kind, and campaign::StoreError.
  std::function<std::unique_ptr<report::StudyReport>(const std::string& plan, const campaign::Store* store,
                                                     report::CommandOf again)>
      report;
  bool figures = true;  // true: the study writes figures beside its page
  // Returns the plan with another number of pairs of matches. No function: this kind has no number of pairs. Throws
  // std::invalid_argument with one line that says why the plan cannot have this number.
  std::function<std::string(const std::string& plan, std::uint64_t pairs, std::uint64_t stored_matches)> with_pairs{};
  // Returns the plan of a study that a time limit (--until, --minutes) stopped, without this end, so that it can go on.
  // No function: no time limit stops studies of this kind between two pairs. Throws std::invalid_argument.
  std::function<std::string(const std::string& plan)> without_end{};
  // Changes a document that has no end of its own, so that a time limit ends the study. Returns other documents
  // unchanged. No function: every document must have an end.
  std::function<config::Node(const config::Node& document)> until_the_clock{};
  // Begins or continues the study and writes its report. Returns the exit code. No function: play_study() is used.
  std::function<int(const std::string& plan, const campaign::Options& options, const output::OutputFiles& outputs,
                    const Invocation& invocation)>
      play{};
};

// --- Kinds of documents for commands: the kinds of config and the documents of all kinds of studies.

// Returns the kind of study that a document describes; null if the document is not a study.
const StudyKind* study_asked(const config::Node& document, std::span<const StudyKind> kinds);

std::vector<config::DocumentKind> document_kinds(const Invocation& invocation);
std::vector<std::string> kind_names(const Invocation& invocation);

// Throws config::BadInput for an unknown kind. command: the command's name for the message.
config::DocumentKind kind_named(const std::string& name, std::string_view command, const Invocation& invocation);

// Returns the kind of a document. Throws config::Error at the document if it names no kind.
config::DocumentKind kind_of(const config::Node& document, const Invocation& invocation);

}  // namespace regista::results
