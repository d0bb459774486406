// SPDX-License-Identifier: MIT
#include "results/replay.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "campaign/match_setup.hpp"
#include "command/terminal.hpp"
#include "config/document_files.hpp"
#include "match/side.hpp"
#include "mcap/file_io.hpp"
#include "process/file_descriptor.hpp"
#include "recording/packed_recording.hpp"
#include "recording/recorded_match.hpp"
#include "recording/recording_metadata.hpp"
#include "report/outline.hpp"
#include "results/played_match.hpp"
#include "results/results_file.hpp"
#include "study/study.hpp"
#include "texts/message.hpp"

namespace regista::results {
namespace {

namespace fs = std::filesystem;
using command::BadInput;

constexpr double before_goal = 4.0, before_end = 8.0;  // s by which a replay opens before the goal or the end

// Restores the current folder when it is destroyed.
struct SameFolder {
  SameFolder() : folder(fs::current_path()) {}
  ~SameFolder() {
    std::error_code none;
    fs::current_path(folder, none);
  }
  SameFolder(const SameFolder&) = delete;
  SameFolder& operator=(const SameFolder&) = delete;
  fs::path folder;
};

// A recording in progress. The destructor removes its file unless keep() has moved it to its place. If the folder of
// the results is not writable, the recording is in a temporary folder, and keep() does nothing.
class NewRecording {
 public:
  explicit NewRecording(const fs::path& place) : place_(place), file_(place) {
    const fs::path folder = place.parent_path();
    std::error_code error;
    made_folder_ = fs::create_directories(folder, error);
    if (access(folder.c_str(), W_OK) == 0) {
      file_ += ".new";
    } else {
      elsewhere_.emplace();
      file_ = elsewhere_->path() / place.filename();
    }
  }
  ~NewRecording() {
    std::error_code none;
    fs::remove(file_, none);
    if (made_folder_) fs::remove(place_.parent_path(), none);  // removes only an empty folder
  }

  const fs::path& file() const { return file_; }
  void keep() const {
    if (elsewhere_) return;
    std::error_code error;
    fs::rename(file_, place_, error);
    if (error) throw output::WriteError(fmt::format("cannot write {}: {}", place_.string(), error.message()));
  }

 private:
  fs::path place_, file_;
  std::optional<process::TemporaryFolder> elsewhere_;
  bool made_folder_ = false;
};

// Returns the identity that a recording of the match must contain.
recording::RecordingIdentity wanted_of(const StoredMatch& stored, const campaign::MatchSetup& prepared) {
  recording::RecordingIdentity out;
  out.seed = stored.job.seed;
  for (const std::size_t side : {0u, 1u}) out.labels[side] = prepared.plans[side]->team().name;
  if (prepared.setup.opening) out.opening = prepared.setup.opening->name;
  if (stored.decided.failure || stored.decided.set_aside()) return out;
  out.score = stored.decided.score;
  const auto home = stored.decided.metrics.of_side(match::Side::home, "packets"),
             away = stored.decided.metrics.of_side(match::Side::away, "packets");
  if (home && away) out.packets = *home + *away;
  return out;
}

// Returns the time in s at which the replay opens: before the first goal, or before the end of a failed match.
double moment_to_open(const fs::path& recording, bool broke_off) {
  if (broke_off) return std::max(0.0, recording::RecordedMatch(recording).end() - before_end);
  const std::optional<double> goal = recording::first_goal(recording);
  return goal ? std::max(0.0, *goal - before_goal) : 0.0;
}

std::string score_text(const report::ListedMatch& match) {
  const auto& [home, away] = match.players.sides;
  if (match.forfeited_by)
    return fmt::format("{} – {}, forfeited by {}", home, away,
                       match.players.sides[static_cast<std::size_t>(*match.forfeited_by)]);
  if (!match.played()) return fmt::format("{} – {}, could not be played", home, away);
  return fmt::format("{} {}:{} {}", home, match.score[0], match.score[1], away);
}

// Returns a played match in the form that the study's page lists.
report::ListedMatch listed_in(const report::StudyReport& report, const study::Round& round, std::uint64_t index,
                              const campaign::MatchResult& decided) {
  report::ListedMatch out = report::listed(round.first_row + index + 1, report.players(round, index), decided);
  if (round.first_of_pairing && round.first_of_pairing(index)) out.seconds.reset();  // two plays: no time of one play
  return out;
}

// Calls `take` for each played match, in the order of rows.
void for_each_listed(const StoredResults& results, const std::function<void(report::ListedMatch)>& take) try {
  const auto report = stored_study(results.file.string(), results.store, {}, results.kinds);
  study::read_back(report->study(), results.store, report->study().metrics(),
                   [&](const study::Round& round, std::uint64_t index, const campaign::MatchResult* decided) {
                     if (decided != nullptr) take(listed_in(*report, round, index, *decided));
                   });
} catch (const campaign::StoreError& error) {
  throw BadInput(error.what());
}

std::string end_text(const campaign::MatchResult& now) {
  if (now.failure) return fmt::format("it was forfeited by {}", now.failure->side == 0 ? "home" : "away");
  if (now.set_aside()) return "it could not be played";
  return fmt::format("it ended {}:{} with the hash {}", now.score[0], now.score[1], now.hash);
}

void require_viewer(const Invocation& invocation) {
  const fs::path viewer = viewer_file(invocation);
  std::error_code none;
  if (fs::exists(viewer, none)) return;
  throw BadInput(
      fmt::format("{}: this build has no viewer page ({} is missing): it is made where Node.js is installed and "
                  "`npm ci` was run in viewer/; `regista view --at` and other readers of MCAP work without it",
                  invocation.command(), viewer.string()));
}

}  // namespace

std::filesystem::path viewer_file(const Invocation& invocation) { return invocation.own("share/regista/viewer.html"); }

void require_small_enough(const std::filesystem::path& recording) {
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(recording, none);
  if (none || size <= recording::largest_recording_in_a_page) return;  // the reader of the file reports other errors
  throw BadInput(
      fmt::format("{}: holds {} MiB; no browser opens a page with more than {} MiB; `regista view --at` and "
                  "other readers of MCAP can read it",
                  recording.string(), size >> 20, recording::largest_recording_in_a_page >> 20));
}

std::string viewer_page(const std::filesystem::path& recording, std::string_view name, std::string_view mark,
                        const Invocation& invocation) {
  require_viewer(invocation);
  const std::filesystem::path viewer = viewer_file(invocation);
  const std::optional<std::string> page = config::file_content(viewer);
  if (!page) throw BadInput(fmt::format("{}: cannot be read", viewer.string()));
  const auto out = recording::match_page(*page, recording::packed_recording(recording), name, mark);
  if (!out) throw BadInput(fmt::format("{}: belongs to another version of Regista", viewer.string()));
  return *out;
}

Replay replay(const fs::path& results, const report::ListedMatch& match, Recorded recorded, const fs::path& page,
              const Invocation& invocation) try {
  const SameFolder back;
  const fs::path file = fs::absolute(results), page_file = fs::absolute(page);
  require_viewer(invocation);
  const StoredMatch stored = read_stored_match(file.string(), std::to_string(match.row), invocation.studies);
  std::vector<std::string> folders = stored.job.plugins;
  for (std::string& each : folders) each = fs::absolute(each).string();
  const plugin::Catalogue catalogue = open_stored_plugins(file.string(), folders, invocation);
  const std::unique_ptr<campaign::StoredSetup> as_then =
      set_up(stored, catalogue, invocation.arguments.front(), Changed::played);
  campaign::Job job = as_then->job();
  Replay out;
  out.page = page;
  if (!as_then->missing().empty()) {
    out.remark = fmt::format("not as it was when {} was played: {}; hashes say whether the matches are the same",
                             results.string(), as_then->missing());
    for (auto* inputs : {&job.home_inputs, &job.away_inputs, &job.common_inputs})
      inputs->clear();  // otherwise the worker would refuse the match, whose inputs have other hashes
  } else if (!as_then->changed().empty()) {
    out.remark = fmt::format("files have changed ({}); matches are played as {} holds them", as_then->changed(),
                             results.string());
  }
  const recording::RecordingIdentity wanted = wanted_of(stored, as_then->take());
  const fs::path place = study::recording_file(file, static_cast<std::int64_t>(match.row));
  const bool failed = !match.played();

  const bool plays = recorded == Recorded::played_again || !recording::is_recording_of(place, wanted);
  std::optional<NewRecording> fresh;
  std::string came_out = "as it was recorded";
  if (plays) {
    fresh.emplace(place);
    job.plugin_files = catalogue.used_files();
    job.record = fresh->file().string();
    const command::Interruption interruption(fmt::format("regista: interrupted while row {} was played\n", match.row));
    const campaign::MatchResult now = play_by_workers(stored, std::move(job));
    if (interruption.requested())
      throw command::Interrupted(fmt::format("interrupted while row {} was played", match.row),
                                 interruption.signal_number());
    out.same = came_out_alike(stored.decided, now);
    came_out = out.same ? "the same match" : "NOT the same match: " + end_text(now);
    if (!fs::exists(fresh->file()))
      throw output::WriteError(fmt::format("row {} was played again, but could not be recorded", match.row));
  }
  const fs::path shown = fresh ? fresh->file() : place;
  require_small_enough(shown);
  const std::string mark =
      report::replay_mark({report::fingerprint_of(match), out.same, moment_to_open(shown, failed)}).str();
  const std::string name =
      fmt::format("{}, row {}{}", file.filename().string(), match.row, out.same ? "" : " (came out otherwise)");
  const std::string text = viewer_page(shown, name, mark, invocation);
  std::error_code error;
  fs::create_directories(page_file.parent_path(), error);
  output::write_whole(page_file, text, output::Existing::replaced);
  if (fresh && out.same) fresh->keep();
  out.words = texts::one_line(fmt::format("row {}: {}, {}", match.row, score_text(match), came_out));
  return out;
} catch (const mcap::Error& error) {
  throw BadInput(error.what());
} catch (const std::system_error& error) {
  throw output::WriteError(error.what());
}

report::ListedMatch listed_match(const StoredResults& results, std::uint64_t row) {
  std::optional<report::ListedMatch> out;
  for_each_listed(results, [&](report::ListedMatch match) {
    if (match.row == row) out = std::move(match);
  });
  if (!out)
    throw BadInput(
        fmt::format("--row {}: {} has no such match, or matches before it are missing", row, results.file.string()));
  return *out;
}

bool replay_telling(const StoredResults& results, std::size_t matches, const Invocation& invocation) {
  require_viewer(invocation);
  report::MatchList list(matches);
  for_each_listed(results, [&](report::ListedMatch match) { list.take(std::move(match)); });
  const std::vector<report::ListedMatch> telling = list.highlights(matches);
  if (telling.empty()) {
    command::complain(fmt::format("{}: no match was won or forfeited; `regista view {} --row N` shows any of them",
                                  results.file.string(), results.file.string()));
    return true;
  }
  const double seconds = list.usual_seconds() * static_cast<double>(telling.size());
  command::say(fmt::format(
      "{} played again{}\n", texts::plural(telling.size(), "match is", "matches are"),
      seconds > 0.0 ? fmt::format(": about {}, by the time that the study took", texts::duration(seconds)) : ""));
  bool all_same = true;
  std::string remark;
  const auto began = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < telling.size(); ++i) {
    const fs::path page = study::replay_file(results.file, static_cast<std::int64_t>(telling[i].row));
    const Replay each = replay(results.file, telling[i], Recorded::played_again, page, invocation);
    if (each.remark != std::exchange(remark, each.remark) && !each.remark.empty()) command::complain(each.remark);
    all_same = all_same && each.same;
    output::print(fmt::format("{}: {}\n", each.words, each.page.string()));
    if (i > 0 || telling.size() == 1) continue;
    const double first = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    command::say(fmt::format("by the first one, about {} more\n",
                             texts::duration(first * static_cast<double>(telling.size() - 1))));
  }
  return all_same;
}

namespace {

// Opens only regular files, because reading a pipe could wait forever.
bool is_our_page(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  std::string beginning(report::page_beginning, '\0');
  std::ifstream(file, std::ios::binary).read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return report::is_our_page(beginning);
}

// Inserts the section of matches after the first two sections, which contain the findings.
void add_matches(report::Outline& outline, const report::MatchList& matches, const report::MatchesOnPage& page) {
  constexpr std::ptrdiff_t place = 2;
  report::Section section = matches_section(matches, page);
  if (section.empty()) return;
  const auto at = outline.sections.begin() + std::min(place, std::ssize(outline.sections));
  outline.sections.insert(at, std::move(section));
  outline.beside.push_back(ways_to_matches(matches, page));
}

}  // namespace

void write_page(const StoredResults& results, const PageOptions& options) {
  try {
    // A page is read on any machine, so its commands use the plain name of the program.
    const auto report = stored_study(
        results.file.string(), results.store, [](const campaign::Job& job) { return campaign::match_command(job); },
        results.kinds);
    report->begin_page(results.file);
    report::MatchList matches;
    study::read_back(report->study(), results.store, report->page_metrics(),
                     [&](const study::Round& round, std::uint64_t index, const campaign::MatchResult* decided) {
                       report->take(round, index, decided);
                       if (decided != nullptr) matches.take(listed_in(*report, round, index, *decided));
                     });
    report->end_page();
    const std::string incomplete = report->incomplete();
    if (!incomplete.empty() && !options.incomplete_is_known)
      command::complain(fmt::format("{} holds {}", results.file.string(), incomplete));
    const std::vector<report::Figure> figures = report->figures();
    output::write_figures(figures, options.figures);
    if (!options.page) return;
    report::Outline outline = report->page_outline({results.file, *options.page, stored_documents(results.store)});
    outline.reload_seconds = options.reload_seconds;
    if (options.reload_seconds > 0)
      outline.beside.insert(
          outline.beside.begin(),
          fmt::format("It is still being played; this page loads itself again every {} s.{}", options.reload_seconds,
                      incomplete.empty() ? "" : " So far: " + incomplete + "."));
    add_matches(outline, matches,
                {results.file.filename().string(), report->is_table_of_matches(),
                 report::replay_pages(results.file, *options.page)});
    output::write_whole(*options.page, outline_page(outline, results.file.filename().string(), figures),
                        options.figures.existing);
  } catch (const campaign::StoreError& error) {
    throw command::BadInput(error.what());
  } catch (const std::system_error& error) {
    throw output::WriteError(error.what());
  }
}

std::optional<fs::path> write_page_beside(const StoredResults& results, bool figures, PageOptions options) {
  const fs::path page = study::page_file(results.file);
  try {
    std::error_code error;
    const bool exists = fs::exists(page, error);
    if (exists && !is_our_page(page)) {
      command::complain(fmt::format("no page was written: Regista did not write {}, so the file stays", page.string()));
      return std::nullopt;
    }
    options.page = page;
    options.figures.existing = exists || figures ? output::Existing::replaced : output::Existing::refused;
    if (figures) options.figures.folder = study::figure_folder(results.file);
    options.figures.only_these = figures;
    write_page(results, options);
    return page;
  } catch (const std::exception& error) {
    command::complain(fmt::format("no page is written, the results are safe: {}", error.what()));
    return std::nullopt;
  }
}

}  // namespace regista::results
