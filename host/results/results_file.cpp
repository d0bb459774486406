// SPDX-License-Identifier: MIT
#include "results/results_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "campaign/match_setup.hpp"
#include "command/terminal.hpp"
#include "config/documents.hpp"
#include "config/parse.hpp"
#include "config/values.hpp"
#include "output/replaced_file.hpp"
#include "process/child.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::results {
namespace {

// Keys of the metadata in the file.
constexpr auto schedule = "schedule";
constexpr auto resolved_teams = "documents";

// Thrown to end the run of a study that has told what its caller asks.
struct Known {};

std::vector<std::string> differences(const std::string& file, const std::string& before, const study::Study& now,
                                     std::span<const StudyKind> kinds) {
  const StudyKind &then = kind_of(file, before, kinds), &kind = kind_of(file, now.plan(), kinds);
  if (&then != &kind) return {fmt::format("it was {}, now {}", then.article, kind.article)};
  try {
    return now.differences(before);
  } catch (const std::invalid_argument& error) {
    throw command::BadInput(fmt::format("{}: {}", file, error.what()));
  }
}

// Returns "; Regista 0.1.0 began it" if another version began the study; otherwise "".
std::string other_program(const campaign::Store& store) {
  const std::string began = store.meta("program");
  return began.empty() || began == REGISTA_VERSION ? std::string() : fmt::format("; Regista {} began it", began);
}

// Several machines share a file in a study's folder (cluster/study_folder.hpp), so it needs a rollback journal.
campaign::Journal journal_of(const std::string& file) {
  std::error_code none;
  const std::filesystem::path folder = std::filesystem::absolute(file, none).parent_path();
  return std::filesystem::exists(folder / "cluster.json", none) ? campaign::Journal::rollback : campaign::Journal::log;
}

// Prints a message if options differ from the stored study but change no match. Then the stored options stay in force.
void remark_on_other_values(const std::string& file, const std::string& stored, const std::string& asked) {
  const auto document = [](const std::string& plan) {
    const auto json = nlohmann::json::parse(plan, nullptr, false);
    return json.is_object() ? json.value("document", std::string()) : std::string();
  };
  if (document(stored) == document(asked) || document(stored).empty()) return;
  command::complain(fmt::format(
      "{} goes on as it was begun: what is asked for otherwise now, though it decides no match, is left out", file));
}

void remark_on(const campaign::Store& store) {
  if (const std::string remark = store.remark(); !remark.empty()) command::complain(remark);
}

template <class Open>
auto opening(Open open) {
  try {
    return open();
  } catch (const campaign::StoreRefusal& error) {
    throw command::BadInput(error.what());
  } catch (const campaign::StoreDiskError& error) {
    throw output::WriteError(error.what());
  } catch (const campaign::StoreError& error) {
    throw command::BadInput(error.what());
  }
}

// Replaces the stored plan. changed: makes the new plan from kind and plan, and throws std::invalid_argument if the
// change is not allowed. who: the beginning of messages.
template <class Changed>
void change_plan(const std::string& who, campaign::Store& store, std::span<const StudyKind> kinds, Changed changed) {
  opening([&] {
    const std::string before = store.meta(schedule);
    const StudyKind& kind = kind_of(who, before, kinds);
    try {
      const std::string now = changed(kind, before);
      if (now == before) return;
      // The file may hold matches of later pairs. The new plan must contain all stored matches.
      const auto report = kind.report(now, &store, [](const campaign::Job&) { return std::string(); });
      try {
        study::require_no_row_beyond(store, report->study().most_matches());
      } catch (const campaign::StoreDamaged&) {
        throw std::invalid_argument("matches of later pairs are stored already; name more pairs");
      }
      store.set_meta(schedule, now);
    } catch (const std::invalid_argument& error) {
      throw command::BadInput(fmt::format("{}: {}", who, error.what()));
    }
  });
}

}  // namespace

const StudyKind& kind_of(const std::string& file, const std::string& plan, std::span<const StudyKind> kinds) {
  const std::string study = study::study_of(plan);
  const auto found = std::ranges::find(kinds, study, &StudyKind::name);
  if (found == kinds.end()) {
    throw command::BadInput(
        fmt::format("{}: {}", file, study.empty() ? "its plan is damaged" : "these are results of another study"));
  }
  return *found;
}

std::string stored_plan(const campaign::Store& store) { return store.meta(schedule); }

void store_plan(campaign::Store& store, const std::string& plan) { store.set_meta(schedule, plan); }

void lift_end(const std::string& file, campaign::Store& store, std::span<const StudyKind> kinds) {
  change_plan(file, store, kinds, [](const StudyKind& kind, const std::string& plan) {
    return kind.without_end ? kind.without_end(plan) : plan;
  });
}

void enter_folder(const std::string& who, const std::string& folder) {
  std::error_code error;
  std::filesystem::current_path(folder, error);
  if (!error) return;
  throw command::BadInput(
      fmt::format("{}: the folder it was begun in, {}, cannot be entered: {}", who, folder, error.message()));
}

void give_pairs(const std::string& file, std::uint64_t pairs, std::span<const StudyKind> kinds) {
  auto store =
      opening([&] { return campaign::Store(file, campaign::Store::Mode::open, REGISTA_VERSION, journal_of(file)); });
  change_plan(fmt::format("--pairs {}: {}", pairs, file), store, kinds,
              [pairs, &store](const StudyKind& kind, const std::string& plan) {
                if (!kind.with_pairs)
                  throw std::invalid_argument(fmt::format("{} has no number of pairs", kind.article));
                return kind.with_pairs(plan, pairs, static_cast<std::uint64_t>(store.rows()));
              });
}

campaign::Store open_results(const std::string& file, bool resume, const study::Study& study,
                             const BegunWith& begun_with, std::span<const StudyKind> kinds) {
  std::error_code error;
  if (resume && std::filesystem::status(file, error).type() == std::filesystem::file_type::not_found) {
    throw command::BadInput(
        fmt::format("--resume: {}: no such file; without --resume it is begun", texts::one_line(file)));
  }
  return opening([&] {
    campaign::Store store(file, resume ? campaign::Store::Mode::open : campaign::Store::Mode::create, REGISTA_VERSION,
                          journal_of(file));
    remark_on(store);
    const std::string stored = store.meta(schedule);
    if (stored.empty()) {  // the file is new, or the process that made it was killed early
      using Json = nlohmann::json;
      store.keep(campaign::documents_in(begun_with.files));
      store.set_meta(resolved_teams, Json(begun_with.teams).dump(-1, ' ', false, Json::error_handler_t::replace));
      store.set_meta(schedule, study.plan());
      return store;
    }
    const std::vector<std::string> changed = differences(file, stored, study, kinds);
    if (changed.empty()) {
      remark_on_other_values(file, stored, study.plan());
      return store;
    }
    throw command::BadInput(
        fmt::format("--resume: {} was begun with something else: {}; its matches would be mixed with others; "
                    "--results names a new file{}",
                    file, texts::join(changed), other_program(store)));
  });
}

std::vector<std::string> stored_documents(const campaign::Store& store) {
  const std::string stored = store.meta(resolved_teams);
  if (stored.empty()) return {};
  try {
    return nlohmann::json::parse(stored).get<std::vector<std::string>>();
  } catch (const nlohmann::json::exception&) {
    throw campaign::StoreError("the teams' documents in the results are damaged");
  }
}

campaign::Store read_results(const std::string& file) {
  return opening([&] {
    campaign::Store store(file, campaign::Store::Mode::read, REGISTA_VERSION);
    if (store.meta(schedule).empty()) throw command::BadInput(fmt::format("{}: holds no study yet", file));
    return store;
  });
}

ResultsTogether::ResultsTogether(const std::vector<std::string>& files, std::span<const StudyKind> kinds) {
  using campaign::Store;
  if (files.size() == 1) {
    store_ = std::make_unique<Store>(read_results(files.front()));
    remark_on(*store_);
    return;
  }
  const std::string first = texts::one_line(files.front());
  try {
    folder_ = std::make_unique<process::TemporaryFolder>();
  } catch (const std::system_error& error) {
    throw output::WriteError(fmt::format("the results cannot be put together: {}", error.what()));
  }
  opening([&] {
    store_ = std::make_unique<Store>(folder_->path() / "together.db", Store::Mode::create, REGISTA_VERSION);
    for (const std::string& each : files) {
      const Store part = read_results(each);
      remark_on(part);
      const std::string name = texts::one_line(each), plan = part.meta(schedule);
      if (store_->meta(schedule).empty()) {
        store_->set_meta(resolved_teams, part.meta(resolved_teams));
        store_->set_meta(schedule, plan);
        store_->keep(part.documents());
      } else if (plan != store_->meta(schedule)) {
        const auto study = stored_study(first, *store_, {}, kinds);
        // The plans differ, but maybe only because the studies were begun in different folders.
        const std::vector<std::string> changed = differences(name, plan, study->study(), kinds);
        if (!changed.empty())
          throw command::BadInput(fmt::format("{} and {} are not of one study: {}", first, name, texts::join(changed)));
      }
      const campaign::Taken taken = store_->take(part, Store::Unknown::planned);
      if (taken.refused > 0) throw command::BadInput(fmt::format("{}: {}", name, taken.why.front()));
    }
  });
}

std::unique_ptr<report::StudyReport> stored_study(const std::string& file, const campaign::Store& store,
                                                  report::CommandOf again, std::span<const StudyKind> kinds) {
  if (!again) again = [](const campaign::Job&) { return std::string(); };
  return opening([&] {
    const std::string plan = store.meta(schedule);
    try {
      return kind_of(file, plan, kinds).report(plan, &store, std::move(again));
    } catch (const std::invalid_argument& error) {
      throw command::BadInput(fmt::format("{}: {}", file, error.what()));
    }
  });
}

std::vector<campaign::Job> first_jobs(study::Study& study) {
  std::vector<campaign::Job> out;
  try {
    study.run([&out](const study::Round& round) {
      std::set<std::pair<std::string, std::vector<std::string>>> seen;
      for (const campaign::Store::Fixture& fixture : round.fixtures) {
        bool is_new = false;
        for (const std::string& file : {fixture.job.teams[0], fixture.job.teams[1], fixture.job.opening})
          is_new |= seen.emplace(file, fixture.job.overrides).second;
        if (is_new) out.push_back(fixture.job);
      }
      throw Known();
    });
  } catch (const Known&) {
  }
  return out;
}

std::optional<campaign::Store::Row> stored_match(const campaign::Store& store, study::Study& study, std::uint64_t row) {
  const auto place = static_cast<std::int64_t>(row);
  if (auto found = store.row(place)) return found;
  // Equal matches share one row, so the match of this row may be stored in another row. Only the study knows which
  // match belongs to a row, and it plans a round from the results of earlier rounds. So the study runs until this row.
  std::optional<campaign::Job> job;
  try {
    study.run([&](const study::Round& round) {
      const bool here = row > round.first_row && row - round.first_row <= round.matches;
      if (here) job = round.job(row - round.first_row - 1);
      if (here || !study::answer_from(store, round, study.metrics())) throw Known();
    });
  } catch (const Known&) {
  }
  if (!job) return std::nullopt;
  const std::string key = campaign::fixture_key(job->home_inputs, job->away_inputs, job->common_inputs);
  const std::int64_t number = store.numbers(std::span(&key, 1)).front();
  const auto decided = store.find(place, {number, job->seed}, campaign::Metrics::left_out);
  return decided ? std::optional(campaign::Store::Row{*job, *decided}) : std::nullopt;
}

namespace {

namespace fs = std::filesystem;

constexpr auto study_file = "study.yaml";

bool is_study(const std::string& content, std::span<const StudyKind> kinds) {
  try {
    return study_asked(config::parse_text(content, "a document"), kinds) != nullptr;
  } catch (const config::Error&) {
    return false;  // the file is data of a plugin
  }
}

// Returns the deepest folder that contains all files.
fs::path folder_of(const std::vector<fs::path>& files) {
  fs::path out = files.empty() ? fs::path() : files.front().parent_path();
  for (const fs::path& each : files) {
    const auto [end, rest] = std::mismatch(out.begin(), out.end(), each.begin(), each.end());
    fs::path common;
    for (auto part = out.begin(); part != end; ++part) common /= *part;
    out = std::move(common);
  }
  return out;
}

class StudyWriter {
 public:
  StudyWriter(const report::WhatWasPlayed& played, const std::vector<campaign::Document>& documents,
              std::span<const StudyKind> kinds)
      : played_(played), kinds_(kinds) {
    std::vector<fs::path> files;
    for (const campaign::Document& each : documents) {
      // A file of results may come from anybody, so its paths must not lead outside of the new folder.
      const fs::path path = each.path;
      const bool plain = path.is_absolute() && path.has_filename() && path == path.lexically_normal();
      if (!plain || !each.content || is_study(*each.content, kinds)) continue;
      contents_.emplace(each.path, &*each.content);
      files.emplace_back(each.path);
    }
    root_ = folder_of(files);
    if (root_.has_relative_path() && contents_.contains((root_ / study_file).string())) root_ = root_.parent_path();
    for (const auto& [path, content] : contents_) {
      for (const auto& [other, unused] : contents_) {
        if (content->find(other) == std::string::npos) continue;
        left_out.push_back(fmt::format("{} names {} from the root of the file system, and goes on to read it there",
                                       texts::one_line(path), texts::one_line(other)));
      }
    }
    for (const std::string& each : played.plugins) {
      const std::string folder = absolute(each).string();
      left_out.push_back(fmt::format("plugins do not come along: `regista run study.yaml` needs {}",
                                     process::shell_line({"--plugins", folder})));
    }
  }

  std::vector<output::NewFile> files() {
    std::vector<output::NewFile> out{{study_file, study()}};
    for (const auto& [path, content] : contents_) out.push_back({fs::path(path).lexically_relative(root_), *content});
    return out;
  }

  std::vector<std::string> left_out;

 private:
  std::string study() {
    const config::Node document = with_own_names(config::parse_text(played_.document, study_file));
    config::Mistakes first(config::Mistakes::After::stop, config::Mistakes::Files::as_they_stand);
    std::string out;
    study_asked(document, kinds_)->document.with_values(document, first, [&](const config::Map& declared) {
      config::rename_files(declared, [this](const std::string& name) { return renamed(name); });
      out = config::document_text(declared);
    });
    return out;
  }

  // Returns the document with the new names of its files, including names in values of match documents and of a sweep.
  // The entry `played_with` gets the current inputs. A repetition is compared with these inputs.
  config::Node with_own_names(const config::Node& document) const {
    std::vector<config::Node::Entry> out;
    for (const config::Node::Entry& each : document.entries()) {
      if (each.key == "played_with") continue;
      out.push_back({each.key, each.key_where, with_names(each.value, may_name(each.key))});
    }
    std::vector<config::Node> lines;
    for (const std::string& each : report::played_with(played_)) lines.push_back(config::Node::scalar(each, true, {}));
    out.push_back({"played_with", {}, config::Node::sequence(std::move(lines), {})});
    return config::Node::map(std::move(out), document.where());
  }

  fs::path absolute(const std::string& name) const { return (fs::path(played_.folder) / name).lexically_normal(); }

  // Returns whether a file belongs to the new folder. A folder of scenes belongs to it if one of its files does.
  bool is_taken(const fs::path& path) const {
    const auto found = contents_.lower_bound(path.string());
    return found != contents_.end() && (found->first == path.string() || found->first.starts_with(path.string() + '/'));
  }

  std::string renamed(const std::string& name) {
    const fs::path path = absolute(name);
    if (is_taken(path)) return path.lexically_relative(root_).generic_string();
    left_out.push_back(
        fmt::format("{} is not in the results: it is named where it is", texts::one_line(path.string())));
    return path.string();
  }

  static bool may_name(const std::string& key) { return key == "set" || key == "values"; }

  // Returns the node with the new names of the study's files. may: true if the values may be names of files.
  config::Node with_names(const config::Node& node, bool may) const {
    const config::Location where = may ? config::Location() : node.where();
    switch (node.kind()) {
      case config::Node::Kind::scalar: {
        const fs::path path = absolute(node.text());
        if (!may || node.text().empty() || !contents_.contains(path.string())) return node;
        return config::Node::scalar(path.lexically_relative(root_).generic_string(), true, {});
      }
      case config::Node::Kind::sequence: {
        std::vector<config::Node> out;
        for (const config::Node& each : node.elements()) out.push_back(with_names(each, may));
        return config::Node::sequence(std::move(out), where);
      }
      case config::Node::Kind::map: {
        std::vector<config::Node::Entry> out;
        for (const config::Node::Entry& each : node.entries())
          out.push_back(
              {each.key, may ? config::Location() : each.key_where, with_names(each.value, may || may_name(each.key))});
        return config::Node::map(std::move(out), where);
      }
      default:
        return node;
    }
  }

  const report::WhatWasPlayed& played_;
  std::span<const StudyKind> kinds_;
  std::map<std::string, const std::string*> contents_;  // contents by path
  fs::path root_;
};

}  // namespace

std::vector<std::string> write_study(const report::WhatWasPlayed& played,
                                     const std::vector<campaign::Document>& documents, std::span<const StudyKind> kinds,
                                     const fs::path& folder) {
  StudyWriter writer(played, documents, kinds);
  output::write_new_folder(folder.has_filename() ? folder : folder.parent_path(), writer.files());
  return writer.left_out;
}

}  // namespace regista::results
