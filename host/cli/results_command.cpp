// SPDX-License-Identifier: MIT
// `regista results`: the studies whose results lie in a folder, and what each of them says.
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "cli/commands.hpp"
#include "output/output.hpp"
#include "results/results_file.hpp"
#include "study/study.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr auto results_examples = R"(Examples:
  regista results
  regista results nights
  regista results nights --json

Each file NAME.db of the folder: how far it has come and when it was last written, who plays, what was asked, and what
it says. Other databases are left out.

Exit codes: 0 done; 1 the list could not be written; 2 bad input; 3 a defect of Regista.)";

struct ResultsOptions {
  std::string folder;
  bool json = false;
};

struct Found {
  std::string file, study, title, question, state, headline, written;
  std::vector<std::string> teams;
  std::string unreadable;  // why; then nothing else is known but the file
};

// When it was written to: results of a study that is still played lie beside the file at first.
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
  } catch (
      const std::exception& error) {  // damaged in a way that was not looked for: the others are listed all the same
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
    output::print(Json{{"results", all}}.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
  } else if (text.empty()) {
    complain(fmt::format("no results in {}", options.folder.empty() ? "this folder" : texts::one_line(options.folder)));
  } else {
    output::print(text);
  }
  return exit_done;
}

}  // namespace

void add_results(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("results", "the studies whose results lie in a folder");
  const auto options = std::make_shared<ResultsOptions>();
  command.take("folder", options->folder, "[FOLDER]", "where the results lie; default: the working folder",
               Reads::results);
  command.flag("--json", options->json, "write the list as JSON");
  command.notes(results_examples);
  command.run = [options, &invocation] { return list(*options, invocation); };
}

}  // namespace regista::cli
