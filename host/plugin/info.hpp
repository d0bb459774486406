// SPDX-License-Identifier: MIT
// Describes the declarations of plugins, for `regista plugin list`, `regista plugin info`, docs/plugin-reference.md,
// and the schema and `show` of the configuration.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/declaration.hpp"
#include "plugin/catalogue.hpp"
#include "plugin/description.hpp"

namespace regista::plugin {

bool negotiates(const Found& plugin);  // whether the plugin is an assigner whose robots negotiate

// Returns the parameters of a plugin in the form of the configuration.
std::vector<config::PluginParameter> parameters(const Found& plugin);

std::string_view type_name(config::PluginParameter::Type type);  // "real"

// Returns the default value; a text is in quotes. Empty for a file, which has no default.
std::string default_text(const config::PluginParameter& parameter);

// Returns a text of several lines about one plugin. Each line ends with a newline.
std::string info_text(const Found& plugin);

// Lists the plugins by kind and then in the catalogue's order, then the refused files, then the searched folders.
std::string list_text(const Catalogue& catalogue);

// Escapes a plugin's text for a line or table cell of Markdown. The result has no link, picture, tag, emphasis or end
// of a cell (CommonMark 0.31, section 2.4; GitHub Flavored Markdown, section 4.10). Text between backticks stays code.
std::string as_text(std::string_view text);

// Escapes like as_text(), and also escapes characters that would begin a heading or a list.
std::string as_paragraph(std::string_view text);

// Returns a text as Markdown code. More backticks enclose the code than any sequence of backticks in the text has.
std::string as_code(std::string_view text);

// Returns a Markdown page about all plugins, by kind and then by id, with a table of parameters for each plugin. The
// page is equal on all machines, because it names no files and no builds.
std::string reference_text(const Catalogue& catalogue);

// Returns one declaration for each plugin and kind, in the given order. The JSON Schema of a team and `config show` use
// them. Leaves out mailboxes, because a team names no mailboxes. Keeps the first of plugins with equal id and kind.
std::vector<config::PluginDeclaration> declarations(std::span<const Found> plugins);

}  // namespace regista::plugin
