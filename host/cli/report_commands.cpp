// SPDX-License-Identifier: MIT
// `regista report` and `results` show what files of results hold. They play no match.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "cli/command_line.hpp"
#include "config/scalar.hpp"
#include "output/output_files.hpp"
#include "output/replaced_file.hpp"
#include "report/number.hpp"
#include "report/study_report.hpp"
#include "results/replay.hpp"
#include "results/results_file.hpp"
#include "results/study_run.hpp"
#include "study/study.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

// --- `regista report`: reports the stored results of a study, even while the study is played.

constexpr auto report_examples = R"(Examples:
  regista report tournament.db
  regista report tournament.db --json
  regista report tournament.db --csv > matches.csv
  regista report tournament.db --csv --metrics > everything.csv
  regista report tournament.db -o tournament.html
  regista report tournament.db --replays 5
  regista report tournament.db --figures figures
  regista report tournament.db --standard-error 17
  regista report tournament.db --study again
  regista report here.db there.db

-o writes one page that needs nothing else, --figures each of its figures as NAME.svg and its data as NAME.csv. A study
that has ended is reported as it was at its end; another one as far as its matches have been played without a gap. The
table of an experiment has a row for each number of each match, that of a tuning one for each point of its search.
Several files are reported as one where they are of one study, begun alike, whose matches were played in several places.
--replays plays so many matches again: in turn the clearest win of each side (of equal ones the first) and a forfeit. It writes their pages to
NAME.replays/ROW.html beside the results NAME.db, and the page of the study with links to them: NAME.html, or -o.
--study writes the study itself, as it was asked for, with its teams, profiles and scenes: `regista run study.yaml` in that
folder plays it again.
--standard-error writes what plugins wrote to standard error in a match, as far as it was kept.)";

struct ReportOptions {
  std::vector<std::string> files;                             // files of results of one study
  std::string file;                                           // the first of `files`; outputs are named after it
  std::string page, figures, study, standard_error, replays;  // standard_error: number of the match, from 1
  bool json = false, csv = false, metrics = false, force = false;
};

constexpr std::uint64_t most_replays = 1000;

// Bytes. The report prints rows in pieces of this size, so its memory does not grow with the number of rows.
constexpr std::size_t piece = std::size_t{1} << 20;

void refuse_what_does_not_go_together(const ReportOptions& options) {
  if (options.file.empty())
    throw BadInput("report: which results? Name a file that `regista tournament`, `experiment` or `tune` wrote");
  if (options.csv && options.json) throw BadInput("report: --csv and --json: one of them");
  if (options.metrics && !options.csv) throw BadInput("report: --metrics adds columns to --csv, which is not given");
  const bool files = !options.page.empty() || !options.figures.empty(), table = options.csv || options.json;
  if (files && table) {
    throw BadInput(fmt::format("report: {} and {}: one of them", options.page.empty() ? "--figures" : "-o",
                               options.csv ? "--csv" : "--json"));
  }
  if (!options.standard_error.empty() && (files || table))
    throw BadInput("report: --standard-error writes the text of a match, and nothing else");
  if (!options.study.empty() && (files || table || !options.standard_error.empty()))
    throw BadInput("report: --study writes the study, and nothing else");
  if (!options.replays.empty() && (table || !options.study.empty() || !options.standard_error.empty()))
    throw BadInput("report: --replays writes the pages of matches and of the study, and nothing else");
  if (!options.replays.empty() && options.files.size() > 1)
    throw BadInput("report: --replays: of one file of results; `regista gather` makes one of several");
  if (options.force && !files) throw BadInput("report: --force belongs to -o or --figures, which are not given");
}

// Returns the names of the metrics of all matches that the study has taken. Later rows of the file do not count.
match::MetricPaths metric_columns(const ReportOptions& options, const campaign::Store& store,
                                  const Invocation& invocation) {
  std::uint64_t rows = 0;
  const auto report = results::stored_study(options.file, store, {}, invocation.studies);
  study::read_back(report->study(), store, report->study().metrics(),
                   [&rows](const study::Round& round, std::uint64_t index, const campaign::MatchResult* /*decided*/) {
                     rows = round.first_row + index + 1;
                   });
  return store.metric_paths(static_cast<std::int64_t>(rows));
}

int print_report(const ReportOptions& options, const campaign::Store& store, const Invocation& invocation) try {
  const auto report = results::stored_study(options.file, store, results::play_again(invocation), invocation.studies);
  if (options.metrics && !report->is_table_of_matches()) {
    throw BadInput(
        fmt::format("report: --metrics: the table of a {} has no row for each match", report->study().what()));
  }
  report::TableOptions wish{.all_metrics = options.metrics};
  if (options.metrics && report->has_a_column_for_each_metric())
    wish.metrics = metric_columns(options, store, invocation);
  std::string csv = options.csv ? report->begin_table(wish) : std::string();
  study::read_back(report->study(), store, options.metrics ? campaign::Metrics::wanted : report->study().metrics(),
                   [&](const study::Round& round, std::uint64_t index, const campaign::MatchResult* decided) {
                     if (!options.csv || decided == nullptr) return;
                     csv += report->table_lines(round, index, *decided);
                     if (csv.size() <= piece) return;
                     output::print(csv);
                     csv.clear();
                   });
  if (const std::string incomplete = report->incomplete(); !incomplete.empty()) {
    complain(fmt::format("{} holds {}", options.file, incomplete));
  }
  output::print(options.csv    ? csv + report->end_table()
                : options.json ? outline_json(report->outline())
                               : outline_text(report->outline()));
  return exit_done;
} catch (const campaign::StoreError& error) {
  throw BadInput(error.what());
}

// Prints what plugins wrote in a match. Control characters except ends of lines become visible, for safety.
int tell_standard_error(const std::string& file, const campaign::Store& store, std::int64_t match) try {
  const auto row = store.row(match);
  if (!row) throw BadInput(fmt::format("{} holds no match {}", file, match));
  if (row->decided.output.empty()) {
    throw BadInput(fmt::format("{}: in match {} no plugin wrote to standard error", file, match));
  }
  const std::string text = texts::visible_lines(row->decided.output);
  output::print(text.ends_with('\n') ? text : text + '\n');
  return exit_done;
} catch (const campaign::StoreError& error) {
  throw BadInput(error.what());
}

results::PageOptions page_options(const ReportOptions& options) {
  results::PageOptions out;
  if (!options.page.empty()) out.page = options.page;
  if (!options.figures.empty()) out.figures.folder = options.figures;
  out.figures.existing = options.force ? output::Existing::replaced : output::Existing::refused;
  return out;
}

int play_again(const ReportOptions& options, std::uint64_t matches, const campaign::Store& store,
               const Invocation& invocation) {
  const results::StoredResults results{options.file, store, invocation.studies};
  const bool all_same = results::replay_telling(results, static_cast<std::size_t>(matches), invocation);
  const auto page =
      options.page.empty() ? results::write_page_beside(results, false) : std::filesystem::path(options.page);
  if (!options.page.empty() || !options.figures.empty()) results::write_page(results, page_options(options));
  if (!page) return exit_no;
  output::print(fmt::format("page: {}\n", page->string()));
  return all_same ? exit_done : exit_no;
}

int run(ReportOptions options, const output::OutputFiles& outputs, const Invocation& invocation) {
  if (!options.files.empty()) options.file = options.files.front();
  refuse_what_does_not_go_together(options);
  outputs.check(options.force);
  std::int64_t match = 0;  // 0: no match
  if (!options.standard_error.empty()) {
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
    match = static_cast<std::int64_t>(config::parse_whole("--standard-error", options.standard_error, 1, most));
  }
  std::optional<std::uint64_t> replays;
  if (!options.replays.empty()) replays = config::parse_whole("--replays", options.replays, 1, most_replays);
  const results::ResultsTogether results(options.files, invocation.studies);
  const campaign::Store& store = results.store();
  if (match != 0) return tell_standard_error(options.file, store, match);
  if (!options.study.empty()) {
    const auto report = results::stored_study(options.file, store, {}, invocation.studies);
    for (const std::string& each :
         results::write_study(report->played(), store.documents(), invocation.studies, options.study))
      complain(each);
    return exit_done;
  }
  if (replays) return play_again(options, *replays, store, invocation);
  if (options.page.empty() && options.figures.empty()) return print_report(options, store, invocation);
  results::write_page({options.file, store, invocation.studies}, page_options(options));
  return exit_done;
}

// --- `regista results`: lists the studies whose results are in a folder, with their findings.

namespace fs = std::filesystem;
using report::Json;

constexpr auto results_examples = R"(Examples:
  regista results
  regista results nights
  regista results nights --json

Each file NAME.db of the folder: how far it has come and when it was last written, who plays, what was asked, and what
it says. Other databases are left out.)";

struct ResultsOptions {
  std::string folder;
  bool json = false;
};

struct Found {
  std::string file, study, title, question, state, headline, written;
  std::vector<std::string> teams;
  std::string unreadable;  // why the file cannot be read; then only `file` is set
};

// Returns the time of the last write. While a study runs, SQLite first writes results to a second file "-wal".
std::string last_written(const fs::path& file) {
  fs::file_time_type last = fs::file_time_type::min();
  for (const char* ending : {"", "-wal"}) {
    std::error_code error;
    const auto time = fs::last_write_time(file.string() + ending, error);
    if (!error) last = std::max(last, time);
  }
  const auto seconds = std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::file_clock::to_sys(last));
  return fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::chrono::system_clock::to_time_t(seconds)));
}

Found look_at(const fs::path& path, const Invocation& invocation) {
  Found out;
  out.file = path.string();
  try {
    const campaign::Store store = results::read_results(out.file);
    const std::string plan = results::stored_plan(store);
    out.study = results::kind_of(out.file, plan, invocation.studies).name;
    const auto report = results::stored_study(out.file, store, {}, invocation.studies);
    study::read_back(report->study(), store, report->study().metrics());
    const report::Outline outline = report->outline();
    out.title = outline.title;
    out.question = outline.question;
    out.headline = plain(outline.headline);
    const std::string incomplete = report->incomplete();
    out.state = incomplete.empty() ? "finished" : incomplete;
    out.teams = report->teams();
    out.written = last_written(path);
  } catch (const BadInput& error) {
    out.unreadable = error.what();
  } catch (const std::exception& error) {  // one damaged file does not stop the list
    out.unreadable = fmt::format("{}: {}", out.file, error.what());
  }
  return out;
}

std::vector<fs::path> databases(const std::string& folder) {
  std::vector<fs::path> out;
  try {
    for (const fs::directory_entry& each : fs::directory_iterator(folder)) {
      if (each.path().extension() == ".db" && each.is_regular_file()) out.push_back(each.path().lexically_normal());
    }
  } catch (const fs::filesystem_error& error) {
    throw BadInput(fmt::format("results: {}: {}", texts::one_line(folder), error.code().message()));
  }
  std::ranges::sort(out);
  return out;
}

std::string text_of(const Found& found) {
  const auto line = [](const std::string& text) {
    return text.empty() ? std::string() : fmt::format("  {}\n", texts::one_line(text));
  };
  if (!found.unreadable.empty()) return fmt::format("{}\n", texts::one_line(found.unreadable));
  return fmt::format("{}: {}, {}, last written {}\n", texts::one_line(found.file), found.study, found.state,
                     found.written) +
         line(found.title) + line(found.teams.size() > 2 ? fmt::format("{}", fmt::join(found.teams, ", ")) : "") +
         line(found.question) + line(found.headline);
}

Json json_of(const Found& found) {
  if (!found.unreadable.empty()) return {{"file", found.file}, {"unreadable", found.unreadable}};
  return {{"file", found.file},   {"study", found.study},       {"title", found.title},
          {"teams", found.teams}, {"question", found.question}, {"finished", found.state == "finished"},
          {"state", found.state}, {"finding", found.headline},  {"written", found.written}};
}

int list(const ResultsOptions& options, const Invocation& invocation) {
  Json all = Json::array();
  std::string text;
  for (const fs::path& each : databases(options.folder.empty() ? "." : options.folder)) {
    if (!campaign::is_store(each)) continue;
    const Found found = look_at(each, invocation);
    if (options.json)
      all.push_back(json_of(found));
    else
      text += (text.empty() ? "" : "\n") + text_of(found);
  }
  if (options.json) {
    output::print(report::text_of({{"results", all}}, 2));
  } else if (text.empty()) {
    complain(fmt::format("no results in {}", options.folder.empty() ? "this folder" : texts::one_line(options.folder)));
  } else {
    output::print(text);
  }
  return exit_done;
}

}  // namespace

void add_report(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("report", "what stored results say");
  const auto options = std::make_shared<ReportOptions>();
  command.take("results", options->files, "RESULTS.db", "files that a tournament, an experiment or a tuning wrote",
               Reads::results);
  command.flag("--json", options->json, "write the report as JSON");
  command.flag("--csv", options->csv,
               "write a table with a row for each match, of an experiment for each number, of a tuning for each point");
  command.flag("--metrics", options->metrics, "with --csv: all numbers of the matches, too");
  command.take("-o,--output", options->page, "PAGE.html", "write the report as a page that needs nothing else",
               Writes::page);
  command.take("--figures", options->figures, "FOLDER", "write the figures of the page as files of this folder",
               Writes::figures);
  command.take("--replays", options->replays, "N",
               "play the N most telling matches again, and write their pages and that of the study");
  command.take("--study", options->study, "FOLDER", "write the study with all its files, to be played again",
               Writes::sources);
  command.take("--standard-error", options->standard_error, "MATCH",
               "write what plugins wrote to standard error in this match");
  command.flag("--force", options->force, "replace files that exist already");
  command.notes(report_examples,
                "0 done; 1 the report could not be written, or a match of --replays came out otherwise",
                command::interruptible);
  command.run = [options, &command, &invocation] { return run(*options, command.outputs("report"), invocation); };
}

void add_results(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("results", "the studies whose results lie in a folder");
  const auto options = std::make_shared<ResultsOptions>();
  command.take("folder", options->folder, "[FOLDER]", "where the results lie; default: the working folder",
               Reads::results);
  command.flag("--json", options->json, "write the list as JSON");
  command.notes(results_examples, "0 done; 1 the list could not be written");
  command.run = [options, &invocation] { return list(*options, invocation); };
}

}  // namespace regista::cli
