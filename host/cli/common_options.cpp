// SPDX-License-Identifier: MIT
#include "cli/common_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <utility>
#include <variant>

#include "texts/message.hpp"

namespace regista::cli {
namespace {

using Form = DocumentOption::Form;

constexpr std::array common{
    DocumentOption{"--seed", "seed"},
    DocumentOption{"--seeds", "seeds"},
    DocumentOption{"--limit", "limit"},
    DocumentOption{"--openings", "openings", Form::list},
    DocumentOption{"--rules", "rules"},
    DocumentOption{"--robot", "robot"},
    DocumentOption{"--disturbance", "disturbance"},
    DocumentOption{"--processor-seconds", "limits.processor_seconds"},
    DocumentOption{"--memory", "limits.memory"},
    DocumentOption{"--wall-seconds", "limits.wall_seconds"},
    DocumentOption{"--match-seconds", "limits.match_seconds"},
    DocumentOption{"--isolation", "isolation"},
};

// Calls use() with the field at `path` of the document, such as "section.key".
template <class Use>
void with_field(const config::Map& map, std::string_view path, Use use) {
  const std::string_view key = path.substr(0, path.find('.'));
  for (const config::Field& each : map.fields) {
    if (each.key != key) continue;
    if (key.size() == path.size()) return use(each);
    const auto* const section = std::get_if<config::Section>(&each.kind);
    assert(section != nullptr);
    return with_field(section->open(), path.substr(key.size() + 1), use);
  }
  assert(false && "an option of a value that no document has");
}

struct Described {
  std::string type, help;
  std::vector<std::string> choices;
  output::FileUse use;
};

std::string type_of(const std::string& unit, const char* otherwise) {
  return unit == "s" ? "SECONDS" : unit == "min" ? "MINUTES" : unit == "MiB" ? "MIB" : otherwise;
}

// Returns the texts of a field for the help, without Markdown's quotes, which a terminal does not need.
Described described(const config::Field& field) {
  Described out;
  std::ranges::remove_copy(field.doc, std::back_inserter(out.help), '`');
  if (const auto* real = std::get_if<config::Real>(&field.kind)) {
    out.type = type_of(real->unit, "NUMBER");
    if (real->member.present()) out.help += fmt::format("; default {:.10g}", real->member.get() / real->scale);
  } else if (const auto* whole = std::get_if<config::Integer>(&field.kind)) {
    out.type = type_of(whole->unit, "N");
    if (whole->present()) out.help += fmt::format("; default {}", whole->get());
  } else if (const auto* choice = std::get_if<config::Choice>(&field.kind)) {
    out.choices = choice->names;
    out.help += fmt::format("; default {}", choice->names[choice->get()]);
  } else if (std::holds_alternative<config::Numbers>(field.kind)) {
    out.type = "A,B";
  } else {
    const bool paths = std::holds_alternative<config::Paths>(field.kind);
    const bool files =
        std::holds_alternative<config::File>(field.kind) || std::holds_alternative<config::List>(field.kind);
    out.type = paths ? "PATH" : files ? "FILE" : "TEXT";
    if (paths || files) out.use = Reads::documents;
  }
  return out;
}

config::Node scalar(const std::string& text, const config::Location& where) {
  return config::Node::scalar(text, false, where);
}

config::Location place_of(const DocumentOption& option, const std::string& value) {
  return {fmt::format("{} {}", option.name, value), 0, 0};
}

config::Node pair_of(const std::string& text, const config::Location& where) {
  std::vector<config::Node> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    parts.push_back(scalar(text.substr(begin, end - begin), where));
    begin = end + 1;
  }
  return config::Node::sequence(std::move(parts), where);
}

config::Node list_of(const DocumentOption& option, const std::vector<std::string>& values) {
  std::vector<config::Node> elements;
  for (const std::string& each : values) {
    const config::Location where = place_of(option, each);
    config::Node value = scalar(each, where);
    elements.push_back(option.form == Form::teams ? config::Node::map({{"team", where, std::move(value)}}, where)
                                                  : std::move(value));
  }
  return config::Node::sequence(std::move(elements), place_of(option, values.front()));
}

}  // namespace

void add_plugin_folders(Command& command, std::vector<std::string>& folders) {
  command.take("--plugins", folders, "DIR", "search this folder for plugins first; may be repeated", Reads::plugins);
}

std::vector<std::string> folders_of(const plugin::Catalogue& catalogue) {
  return texts::names_of(catalogue.folders(), [](const auto& each) { return each.string(); });
}

const std::string& the_only(const std::vector<std::string>& words, std::string_view expected, std::string_view advice) {
  if (words.size() != 1) throw BadInput(fmt::format("{}, {} given{}", expected, words.size(), advice));
  return words.front();
}

void tell_what_is_not_used(const plugin::Catalogue& catalogue, const std::vector<std::string>& folders) {
  for (const plugin::Refused& refused : catalogue.refused()) {
    if (std::ranges::find(folders, refused.file.parent_path().string()) == folders.end()) continue;
    complain(fmt::format("not used: {}", plugin::to_string(refused)));
  }
  for (const plugin::Refused& remarked : catalogue.remarked()) complain(plugin::to_string(remarked));
}

void DocumentValues::declare(Command& command, const config::DocumentKind& kind, std::span<const DocumentOption> own) {
  kind.with_defaults([&](const config::Map& declared) {
    std::vector<DocumentOption> all(own.begin(), own.end());
    all.insert(all.end(), common.begin(), common.end());
    for (const DocumentOption& each : all) {
      Given& given = given_.emplace_back(Given{each, {}, {}});
      with_field(declared, each.path, [&](const config::Field& field) {
        const Described shown = described(field);
        if (!shown.choices.empty())
          command.choose(each.name, given.value, shown.choices, shown.help);
        else if (each.form == Form::list || each.form == Form::teams)
          command.take(each.name, given.values, shown.type, shown.help + "; may be repeated", shown.use);
        else
          command.take(each.name, given.value, shown.type, shown.help, shown.use);
      });
    }
  });
  command.flag("--play-once", play_once_,
               "do not play the first match of each pairing a second time, in which it is seen whether it is "
               "reproducible, whether robots decide alone, and whether plugins change their inputs");
}

config::Overrides DocumentValues::overrides() const {
  config::Overrides out;
  for (const Given& each : given_) {
    if (each.value.empty() && each.values.empty()) continue;
    const DocumentOption& option = each.option;
    const config::Location where = place_of(option, each.values.empty() ? each.value : each.values.front());
    if (option.instead_of != nullptr) out.emplace_back(option.instead_of, config::Node::null(where), where);
    out.emplace_back(option.path,
                     option.form == Form::value  ? scalar(each.value, where)
                     : option.form == Form::pair ? pair_of(each.value, where)
                                                 : list_of(option, each.values),
                     where);
  }
  const config::Location once{"--play-once", 0, 0};
  if (play_once_) out.emplace_back("play_twice", scalar("false", once), once);
  return out;
}

void add_document_options(Command& command, StudyOptions& options, const config::DocumentKind& kind,
                          std::span<const DocumentOption> own, std::string_view whose) {
  options.values.declare(command, kind, own);
  command.take("--set", options.set, "PATH=VALUE",
               fmt::format("a value laid over {}, or over those of its matches; may be repeated", whose));
}

void add_playing_options(Command& command, campaign::Options& options) {
  command.take("--workers", options.workers, "N", "matches at the same time; default: one for each processor core");
  command.take("--until", options.until, "TIME",
               "begin no match after this time, as 08:00 or 2026-11-28T08:00; the study ends with the pairs of matches "
               "that are whole then, whatever the results (a tuning: its search ends)");
  command.take("--minutes", options.minutes, "N", "the same after so many minutes of wall time");
  command.take("--record-every", options.record_every, "N",
               "record every N-th match, beside the results in NAME.recordings/ROW.mcap; those that fail always are");
  command.take(
      "--notify", options.notify, "COMMAND",
      "run this command in a shell at the end; REGISTA_STATUS is done, stopped or failed, REGISTA_MESSAGE is the "
      "result in one line, and REGISTA_RESULTS is the file of results");
  command.flag("--live", options.live, "write the page while the study is played, too; it loads itself again");
  command.flag("--no-page", options.no_page, "write no page NAME.html beside the results NAME.db at the end");
  command.flag("--json", options.json, "write the report as JSON");
  command.flag("--quiet", options.quiet, "no progress on standard error");
}

void add_campaign_options(Command& command, campaign::Options& options, const std::string& default_results) {
  add_plugin_folders(command, options.plugins);
  command.take("--results", options.results, "FILE",
               fmt::format("file the results are kept in; default: {}", default_results), Writes::results);
  command.flag("--resume", options.resume, "go on with what the file of results was begun with");
  add_playing_options(command, options);
}

}  // namespace regista::cli
