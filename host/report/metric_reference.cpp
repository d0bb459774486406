// SPDX-License-Identifier: MIT
#include "report/metric_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "plugin/info.hpp"
#include "report/number.hpp"
#include "study/measure.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

using match::MetricRow;

constexpr std::string_view marker = "<!-- metrics: ", end_of_marker = " -->";

const char* of_what(const MetricRow& row) {
  constexpr std::array words{"match", "team", "role", "event", "plugin", "plugin"};  // order of MetricRow::Of
  return words[static_cast<std::size_t>(row.of)];
}

std::string meaning(const MetricRow& row) { return (row.is_list() ? "list, " : "") + row.meaning; }

std::string markdown_table(std::string_view part, std::span<const MetricRow> table) {
  std::string out = "| Path | Unit | Meaning |\n|---|---|---|\n";
  for (const MetricRow& row : table) {
    if (row.part != part) continue;
    out +=
        fmt::format("| `{}` |{}| {} |\n", row.pattern(), row.unit.empty() ? " " : ' ' + row.unit + ' ', meaning(row));
  }
  return out;
}

// Removes the first line with its line end from the text. Returns this line without its line end.
std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

struct RoleWords {
  std::string_view name, of_role, of_all;  // words after the name of a role; words for all roles together
};
constexpr std::array role_words{
    RoleWords{"overlap_seconds", "held twice", "roles held twice"},
    RoleWords{"uncovered_seconds", "held by nobody", "roles held by nobody"},
    RoleWords{"unplayed_seconds", "played by nobody", "roles played by nobody"},
    RoleWords{"switches", "changes of holder", "changes of role"},
};

struct Span {
  std::string_view name, words;
};
constexpr std::array spans{Span{"_before_silence", " before the silence"},
                           Span{"_after_silence", " after the silence"}};

// Returns words for a number of one or all roles, such as "overlap_after_silence_seconds"; empty for other numbers.
std::string of_roles(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  std::string name(path.substr(dot + 1)), when;
  for (const Span& span : spans) {
    const std::size_t at = name.find(span.name);
    if (at == std::string::npos) continue;
    name.erase(at, span.name.size());
    when = span.words;
  }
  const auto found = std::ranges::find(role_words, name, &RoleWords::name);
  if (found == role_words.end()) return {};
  const std::string role = dot == std::string_view::npos ? std::string() : name_of_role(path.substr(0, dot));
  return (role.empty() ? std::string(found->of_all) : role + ' ' + std::string(found->of_role)) + when;
}

// Splits the title "Distance walked, m" into "Distance walked" and "m".
std::pair<std::string, std::string> in_parts(const std::string& title) {
  const std::size_t at = title.rfind(", ");
  return at == std::string::npos ? std::pair{title, std::string()}
                                 : std::pair{title.substr(0, at), title.substr(at + 2)};
}

std::string measure_unit(std::string_view measure) {
  if (study::is_time(measure)) return "minutes of 60";
  const MetricRow* const row = match::find_metric(match::metric_table(), measure);
  if (row == nullptr || row->total == MetricRow::Total::sum) return study::unit_of(measure);
  if (const std::string unit = in_parts(row->title).second; !unit.empty()) return unit;
  return row->unit.empty() ? study::unit_of(measure) : row->unit;
}

std::string uncapped(std::string words) {
  if (!words.empty()) words.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(words.front())));
  return words;
}

Json parameter_json(const config::PluginParameter& declared) {
  using Type = config::PluginParameter::Type;
  Json out{{"name", declared.name}, {"type", plugin::type_name(declared.type)}};
  switch (declared.type) {
    case Type::real:
      out.update({{"minimum", declared.minimum}, {"maximum", declared.maximum}, {"default", declared.initial}});
      break;
    case Type::integer:
      out.update({{"minimum", std::llround(declared.minimum)},
                  {"maximum", std::llround(declared.maximum)},
                  {"default", std::llround(declared.initial)}});
      break;
    case Type::boolean:
      out["default"] = declared.initial != 0.0;
      break;
    case Type::choice:
      out.update({{"choices", declared.choices}, {"default", plugin::default_text(declared)}});
      break;
    case Type::text:
    case Type::file:
      out["default"] = plugin::default_text(declared);
      break;
  }
  out.update({{"unit", declared.unit},
              {"tunable", declared.tunable},
              {"log_scale", declared.log_scale},
              {"doc", declared.doc}});
  return out;
}

}  // namespace

std::string metrics_text(std::span<const MetricRow> table) {
  std::size_t width = 0;
  for (const MetricRow& row : table) width = std::max(width, row.pattern().size());
  std::string out;
  for (const MetricRow& row : table) {
    out += fmt::format("{:{}}  {:7}  {}\n", row.pattern(), width, row.unit, meaning(row));
  }
  return out;
}

std::string metrics_json(std::span<const MetricRow> table) {
  Json out = Json::array();
  for (const MetricRow& row : table) {
    out.push_back({{"path", row.pattern()},
                   {"of", of_what(row)},
                   {"unit", row.unit},
                   {"total", row.total == MetricRow::Total::sum ? "sum" : "mean"},
                   {"list", row.is_list()},
                   {"part", row.part},
                   {"meaning", row.meaning}});
  }
  return text_of(out, 2);
}

std::string with_metric_tables(std::string_view page, std::span<const MetricRow> table) {
  std::string out;
  std::vector<std::string_view> missing(match::metric_parts.begin(), match::metric_parts.end());
  while (!page.empty()) {
    const std::string_view line = take_line(page);
    out.append(line) += '\n';
    if (!line.starts_with(marker) || !line.ends_with(end_of_marker)) continue;
    const std::string_view part = line.substr(marker.size(), line.size() - marker.size() - end_of_marker.size());
    if (std::erase(missing, part) == 0) {
      throw std::invalid_argument(fmt::format("\"{}\" is no part of the metrics, or is given twice", part));
    }
    out += '\n' + markdown_table(part, table);
    // Skips the old table of this part.
    while (page.starts_with('\n')) take_line(page);
    while (page.starts_with('|')) take_line(page);
    if (!page.empty() && !page.starts_with('\n')) out += '\n';
  }
  if (missing.empty()) return out;
  throw std::invalid_argument(fmt::format("there is no line \"{}{}{}\"", marker, missing.front(), end_of_marker));
}

std::string spaced(std::string_view name) {
  std::string out(name);
  std::ranges::replace(out, '_', ' ');
  return out;
}

std::string name_of_role(std::string_view role) { return spaced(role.substr(role.rfind('.') + 1)); }

std::string measure_words(std::string_view measure) {
  const MetricRow* const row = match::find_metric(match::metric_table(), measure);
  if (row != nullptr && row->of == MetricRow::Of::role) {
    if (std::string words = of_roles(measure); !words.empty()) return words;
  }
  if (row != nullptr && !row->title.empty()) return uncapped(in_parts(row->title).first);
  std::string words = spaced(measure);
  for (const std::string_view unit : {" seconds", " metres", " share"}) {
    if (words.ends_with(unit)) words.resize(words.size() - unit.size());
  }
  return words;
}

std::string measure_axis(std::string_view measure, std::size_t longest) {
  return texts::visible_at_most(measure_words(measure), longest) + ", " + measure_unit(measure);
}

Json plugin_json(const plugin::Found& plugin) {
  const regista_descriptor& d = *plugin.descriptor;
  Json parameters = Json::array();
  for (const config::PluginParameter& each : plugin::parameters(plugin)) parameters.push_back(parameter_json(each));
  return {{"id", d.id},
          {"kinds", texts::names_of(plugin.description->kinds(), plugin::kind_name)},
          {"version", d.version},
          {"summary", d.summary},
          {"licence", d.licence},
          {"build_tag", d.build_tag},
          {"interface", fmt::format("{}.{}", d.abi_major, d.abi_minor)},
          {"file", plugin.file.string()},
          {"subjects", plugin::subject_names(plugin.description->subjects())},
          {"negotiates", plugin::negotiates(plugin)},
          {"parameters", parameters}};
}

}  // namespace regista::report
