// SPDX-License-Identifier: MIT
#include "report/configuration_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "config/node.hpp"
#include "config/parse.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

using config::Node;

constexpr std::size_t most_compared = 8;    // documents that are compared
constexpr std::size_t most_documents = 40;  // that are shown in full
constexpr std::size_t most_rows = 1000;
constexpr std::size_t most_open = 25;  // rows that are shown without being asked for

struct Value {
  std::string path, text;
};

bool is_plain(const Node& node) {
  return node.kind() == Node::Kind::scalar || node.kind() == Node::Kind::null || node.kind() == Node::Kind::absent;
}

std::string plain_text(const Node& node) { return node.kind() == Node::Kind::scalar ? node.text() : "null"; }

// A value in one line.
std::string flow(const Node& node) {
  if (is_plain(node)) return plain_text(node);
  const bool map = node.kind() == Node::Kind::map;
  std::string out(1, map ? '{' : '[');
  const auto comma = [&out] {
    if (out.size() > 1) out += ", ";
  };
  for (const Node::Entry& entry : node.entries()) {
    comma();
    out += entry.key + ": " + flow(entry.value);
  }
  for (const Node& element : node.elements()) {
    comma();
    out += flow(element);
  }
  return out + (map ? '}' : ']');
}

// Every element is a map with a name of its own.
bool is_named(const Node& sequence) {
  std::set<std::string> names;
  return std::ranges::all_of(sequence.elements(), [&](const Node& element) {
    const Node name = element["name"];
    return name.kind() == Node::Kind::scalar && names.insert(name.text()).second;
  });
}

void collect(const Node& node, const std::string& path, std::vector<Value>& out) {
  if (node.kind() == Node::Kind::map && !node.entries().empty()) {
    for (const Node::Entry& entry : node.entries()) {
      collect(entry.value, path.empty() ? entry.key : path + '.' + entry.key, out);
    }
  } else if (node.kind() == Node::Kind::sequence && !node.elements().empty() && is_named(node)) {
    std::string order;
    for (const Node& element : node.elements()) {
      const std::string& name = element["name"].text();
      order += (order.empty() ? "" : ", ") + name;
      for (const Node::Entry& entry : element.entries()) {
        if (entry.key != "name") collect(entry.value, path + '[' + name + "]." + entry.key, out);
      }
    }
    out.push_back({path, order});
  } else {
    out.push_back({path, flow(node)});
  }
}

// What is called the same and is another: disturbances, shared objects and files of parameters.
void add_what_they_bring(std::span<const PlayedTeam> teams, std::vector<DifferingValue>& rows) {
  std::map<std::string, std::vector<std::optional<std::string>>> found;
  const auto value_of = [&](const std::string& what, std::size_t team) -> std::optional<std::string>& {
    return found.try_emplace(what, teams.size()).first->second[team];
  };
  for (std::size_t team = 0; team < teams.size(); ++team) {
    const PlayedProfile& disturbance = teams[team].disturbance;
    value_of("disturbance", team) =
        disturbance.name + (disturbance.file.empty() ? "" : fmt::format(" ({})", disturbance.file));
    for (const campaign::Input& each : teams[team].inputs) {
      // The team's own document is compared value by value.
      if (!each.name.starts_with("team ")) value_of(each.name.substr(0, each.name.find(" (")), team) = each.hash;
    }
  }
  for (auto& [what, values] : found) {
    std::set<std::string> different;
    for (const auto& each : values) {
      if (each) different.insert(*each);
    }
    if (different.size() > 1) rows.push_back({what, std::move(values)});
  }
}

void add_differences(std::span<const PlayedTeam> teams, const std::vector<DifferingValue>& rows, Section& out) {
  if (rows.empty()) {
    out.line("The resolved documents are the same, and so are disturbances, plugins and files.", Readers::page);
    return;
  }
  Table table{{{"Value", Column::words}}};
  for (std::size_t i = 0; i < rows.front().values.size(); ++i)
    table.headings.push_back({named(teams[i].name), Column::words});
  for (std::size_t i = 0; i < std::min(rows.size(), most_rows); ++i) {
    std::vector<Cell> cells{path(rows[i].path)};
    for (const auto& value : rows[i].values) cells.push_back(value ? code(*value) : Sentence("–"));
    table.row(std::move(cells));
  }
  table.look = Table::Look::values;
  table.summary = texts::counted(rows.size(), "value differs", "values differ");
  table.open = rows.size() <= most_open;
  out.table(std::move(table), Readers::page);
  if (rows.size() > most_rows)
    out.line(fmt::format("{} more values are not listed.", rows.size() - most_rows), Readers::page);
}

}  // namespace

std::vector<DifferingValue> differing_values(std::span<const std::string> documents) {
  std::vector<DifferingValue> rows;
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    std::vector<Value> values;
    collect(config::parse_text(documents[i], "resolved document"), "", values);
    for (Value& each : values) {
      const auto [at, fresh] = known.try_emplace(each.path, rows.size());
      if (fresh) {
        rows.push_back({each.path, std::vector<std::optional<std::string>>(documents.size())});
      }
      rows[at->second].values[i] = std::move(each.text);
    }
  }
  std::erase_if(rows, [](const DifferingValue& row) {
    return std::ranges::all_of(row.values, [&](const auto& value) { return value == row.values.front(); });
  });
  return rows;
}

Section configuration_section(std::span<const std::string> documents, std::span<const PlayedTeam> teams) {
  Section out("configuration", "Where the teams differ");
  if (documents.empty()) {
    out.line("These results do not hold the teams' documents: they were begun by an older Regista.", Readers::page);
    return out;
  }
  const std::size_t compared = std::min(documents.size(), most_compared);
  try {
    std::vector<DifferingValue> rows = differing_values(documents.first(compared));
    add_what_they_bring(teams.first(std::min(compared, teams.size())), rows);
    add_differences(teams, rows, out);
  } catch (const config::Error& error) {
    out.line(fmt::format("The documents cannot be compared: {}", error.what()), Readers::page);
  }
  if (compared < documents.size()) out.note(fmt::format("Of the first {} teams.", compared), Readers::page);
  for (std::size_t i = 0; i < std::min(documents.size(), most_documents); ++i)
    out.listing(Sentence("All of ") << named(teams[i].name), documents[i]);
  return out;
}

}  // namespace regista::report
