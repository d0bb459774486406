// SPDX-License-Identifier: MIT
// Writes pages beside a file of results: the page of the study, and pages with replays of single matches. If a replay
// differs from the stored match, its page shows the replay and says that it is another match.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "campaign/store.hpp"
#include "output/replaced_file.hpp"
#include "report/matches_section.hpp"
#include "report/study_report.hpp"
#include "results/study_kind.hpp"

namespace regista::results {

// --- The page of a study from its file of results, and the figures of the study as files.

struct PageOptions {
  std::optional<std::filesystem::path> page{};  // path of the page
  output::FigureOptions figures{};              // `figures.existing` also applies to an existing page
  int reload_seconds = 0;                       // s until an unfinished study's page reloads; 0: never
  bool incomplete_is_known = false;             // true: no message about missing results
};

// The results from which a page is written.
struct StoredResults {
  std::filesystem::path file;
  const campaign::Store& store;
  std::span<const StudyKind> kinds;
};

// Writes the page, and a message about missing results if these are not known. Throws BadInput and output::WriteError.
void write_page(const StoredResults& results, const PageOptions& options);

// Writes the page of a running or finished study beside its results (study/study.hpp). Replaces only an older page. An
// error causes only a message, because the results are safe. figures: true also writes the figures to the folder
// NAME.figures. `options` must contain no paths. Returns the path of the page; nothing if there is none.
std::optional<std::filesystem::path> write_page_beside(const StoredResults& results, bool figures,
                                                       PageOptions options = {});

// Decides when to repeat a slow task, such as writing a live page. The task takes at most a fiftieth of the time.
class RefreshSchedule {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds least{5};  // shortest time between two repetitions
  static constexpr int share = 50;                 // the task takes at most the share-th part of the time

  bool due(Clock::time_point now) const { return now >= next_; }
  void done(Clock::time_point begin, Clock::time_point end) {
    next_ = end + std::max<Clock::duration>(least, (share - 1) * (end - begin));
  }
  // Returns the whole seconds from `now` until the next repetition is due, at least 1.
  int seconds_from(Clock::time_point now) const {
    return std::max(1, static_cast<int>(std::chrono::ceil<std::chrono::seconds>(next_ - now).count()));
  }

 private:
  Clock::time_point next_{};
};

// --- The page that shows a recording. The viewer of the program makes this page.

// Returns the path of the viewer, even if the file does not exist.
std::filesystem::path viewer_file(const Invocation& invocation);

// Throws BadInput if the recording is too large for a page in a browser.
void require_small_enough(const std::filesystem::path& recording);

// Returns the viewer's page with this recording in it. name: title of the recording; mark: HTML for the head of the
// page. Throws BadInput for an unreadable file.
std::string viewer_page(const std::filesystem::path& recording, std::string_view name, std::string_view mark,
                        const Invocation& invocation);

struct Replay {
  std::filesystem::path page;
  bool same = true;    // true: the replay equals the stored match
  std::string words;   // for the user: "row 17: a 3:1 b, the same match"
  std::string remark;  // names changes of program or plugins since the study; usually empty
};

enum class Recorded { used, played_again };  // used: an existing recording is shown; played_again: a new recording

// Writes a page with a replay; an existing page is replaced. Throws BadInput, Interrupted and output::WriteError.
Replay replay(const std::filesystem::path& results, const report::ListedMatch& match, Recorded recorded,
              const std::filesystem::path& page, const Invocation& invocation);

// Returns the match of a row in the form that the study's page lists. Throws BadInput for a row that was not played.
report::ListedMatch listed_match(const StoredResults& results, std::uint64_t row);

// Replays the `matches` most informative matches (report::MatchList::highlights()) and writes a page of each. Prints
// the expected time, then a line for each match. Returns false if any replay differs. Throws like replay().
bool replay_telling(const StoredResults& results, std::size_t matches, const Invocation& invocation);

}  // namespace regista::results
