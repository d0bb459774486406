// SPDX-License-Identifier: MIT
// What the pages of all studies are made of: one file of HTML each that needs nothing else, no network, no script.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/input.hpp"
#include "report/figure.hpp"
#include "report/html.hpp"
#include "report/what_was_played.hpp"

namespace regista::report {

// From the doctype to the beginning of the content, with this title; and the end of the file.
Html page_begin(std::string_view title);
Html page_end();

// Whether a file that begins so was written with page_begin().
bool is_our_page(std::string_view beginning);
inline constexpr std::size_t page_beginning = 512;  // bytes that are enough to tell

Html section(std::string_view id, Markup title, const Html& content);  // empty for no content
Html table_link(std::string_view file_name, std::string_view csv);     // to take a table away
// Empty where there is no such figure.
Html figure(std::span<const Figure> figures, std::string_view name);
Html tile(const Html& number, const Html& what);

// Where only the team is known: "a plugin of" it.
Html plugin_cell(const Html& team);

Html code(std::string_view words);
Html path_code(std::string_view path);  // goes on in a new line only after a point or an underscore
Html block(std::string_view content);   // lines as they are

// Where teams differ, a column for each: in their documents (config::show without remarks), disturbances, plugins and
// files; then each document in full. names: of the documents. teams: the same, in the same order.
Html differing_documents(std::span<const std::string> names, std::span<const std::string> documents,
                         std::span<const PlayedTeam> teams);

// Each input once, in this order.
Html hashes_table(std::span<const campaign::Input> inputs);

}  // namespace regista::report
