// SPDX-License-Identifier: MIT
#include "report/page_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "config/node.hpp"
#include "report/configuration_difference.hpp"
#include "report/html_table.hpp"
#include "report/page_style.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

// What a file begins with that may be replaced by one of ours.
constexpr Markup ours = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="generator" content="Regista )"_html;

constexpr Markup head = R"(page of results">
<meta name="viewport" content="width=device-width">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:">
)"_html;

constexpr std::size_t most_compared = 8;    // documents that stand beside each other
constexpr std::size_t most_documents = 40;  // that are shown in full
constexpr std::size_t most_rows = 1000;
constexpr std::size_t most_open = 25;  // rows that are shown without being asked for

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

Html differences_table(std::span<const std::string> names, const std::vector<DifferingValue>& rows) {
  if (rows.empty()) {
    return "<p>The resolved documents are the same, and so are disturbances, plugins and files.</p>\n"_html;
  }
  std::vector<Heading> headings{{"Value"_html, Column::words}};
  for (const std::string& each : names.first(rows.front().values.size()))
    headings.push_back({name(each), Column::words});
  HtmlTable table(headings);
  for (std::size_t i = 0; i < std::min(rows.size(), most_rows); ++i) {
    std::vector<Html> cells{path_code(rows[i].path)};
    for (const auto& value : rows[i].values) cells.push_back(value ? code(*value) : Html("–"_html));
    table.row(cells);
  }
  Html out = rows.size() > most_open ? "<details><summary>"_html : "<details open><summary>"_html;
  out << text(texts::counted(rows.size(), "value differs", "values differ"))
      << "</summary>\n<div class=\"values\">"_html << table.html() << "</div>\n"_html;
  if (rows.size() > most_rows) {
    out << text(fmt::format("{} more values are not listed.", rows.size() - most_rows));
  }
  return out << "</details>\n"_html;
}

}  // namespace

Html page_begin(std::string_view title) {
  Html page = ours;
  return page << head << "<title>"_html << text(title) << "</title>\n<style>"_html << page_style
              << "</style>\n</head>\n<body>\n<main>\n"_html;
}

Html page_end() {
  return "<footer>Written by <code>regista report</code> from the stored results alone.</footer>\n"
         "</main>\n</body>\n</html>\n"_html;
}

bool is_our_page(std::string_view beginning) { return beginning.starts_with(ours.view()); }

Html section(std::string_view id, Markup title, const Html& content) {
  if (content.empty()) return {};
  Html out = "<section id=\""_html;
  return out << text(id) << "\">\n<h2>"_html << title << "</h2>\n"_html << content << "</section>\n"_html;
}

Html table_link(std::string_view file_name, std::string_view csv) {
  Html out = "<a class=\"take\" download=\""_html;
  return out << text(file_name) << "\" href=\""_html << data_address("text/csv", csv) << "\">data as CSV</a>"_html;
}

Html figure(std::span<const Figure> figures, std::string_view figure_name) {
  const auto found = std::ranges::find(figures, figure_name, &Figure::name);
  if (found == figures.end()) return {};
  Html out = "<figure>\n"_html;
  return out << svg(*found, Look::page) << "<figcaption><b>"_html << text(found->title) << ".</b> "_html
             << text(found->description) << " "_html << table_link(found->name + ".csv", found->csv)
             << "</figcaption>\n</figure>\n"_html;
}

Html tile(const Html& number, const Html& what) {
  Html out = "<div class=\"tile\"><b>"_html;
  return out << number << "</b><span>"_html << what << "</span></div>\n"_html;
}

Html plugin_cell(const Html& team) {
  Html out = "a plugin of "_html;
  return out << team;
}

Html code(std::string_view words) {
  Html out = "<code>"_html;
  return out << text(words) << "</code>"_html;
}

Html path_code(std::string_view path) {
  Html out = "<code class=\"path\">"_html;
  std::size_t begin = 0;
  while (begin < path.size()) {
    const std::size_t end = std::min(path.find_first_of("._", begin), path.size() - 1) + 1;
    out << text(path.substr(begin, end - begin)) << (end < path.size() ? "<wbr>"_html : ""_html);
    begin = end;
  }
  return out << "</code>"_html;
}

Html block(std::string_view content) {
  Html out = "<pre>"_html;
  return out << lines(content) << "</pre>\n"_html;
}

Html differing_documents(std::span<const std::string> names, std::span<const std::string> documents,
                         std::span<const PlayedTeam> teams) {
  const std::size_t compared = std::min(documents.size(), most_compared);
  Html out;
  try {
    std::vector<DifferingValue> rows = differing_values(documents.first(compared));
    add_what_they_bring(teams.first(std::min(compared, teams.size())), rows);
    out = differences_table(names, rows);
  } catch (const config::Error& error) {
    out << "<p>The documents cannot be compared: "_html << text(error.what()) << "</p>\n"_html;
  }
  if (compared < documents.size()) {
    out << "<p class=\"note\">"_html << text(fmt::format("Of the first {} teams.", compared)) << "</p>\n"_html;
  }
  for (std::size_t i = 0; i < std::min(documents.size(), most_documents); ++i) {
    out << "<details><summary>All of "_html << name(names[i]) << "</summary>\n"_html << block(documents[i])
        << "</details>\n"_html;
  }
  return out;
}

Html hashes_table(std::span<const campaign::Input> inputs) {
  HtmlTable table({{"Input"_html, Column::words}, {"Hash of its content"_html, Column::words}});
  for (auto input = inputs.begin(); input != inputs.end(); ++input) {
    if (std::find(inputs.begin(), input, *input) == input) table.row({text(input->name), code(input->hash)});
  }
  return table.html();
}

}  // namespace regista::report
