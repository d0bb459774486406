// SPDX-License-Identifier: MIT
#include "output/new_plugin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>

#include "config/document_files.hpp"
#include "config/errors.hpp"
#include "plugin/description.hpp"
#include "texts/message.hpp"

namespace regista::output {
namespace {

namespace fs = std::filesystem;
using config::BadInput;

// Names of targets of CMake, make and ninja. Only lower-case names are listed, because plugins have lower-case names.
constexpr std::array<std::string_view, 14> cmake_targets{
    "all",           "clean",   "default_target",          "define",     "depend",  "edit_cache",
    "help",          "install", "list_install_components", "preinstall", "package", "package_source",
    "rebuild_cache", "test"};
// Libraries that a plugin or its test links. CMake would confuse a target with such a name with the library.
constexpr std::array<std::string_view, 4> libraries{"c", "dl", "m", "pthread"};
// Targets that find_package(regista) defines.
constexpr std::array<std::string_view, 2> regista_targets{"regista_sdk", "regista_testkit"};

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ_";

// Returns the name of the placeholder at the beginning of the text; empty if the text begins with no placeholder.
std::string_view placeholder(std::string_view text) {
  if (!text.starts_with('@')) return {};
  const std::size_t end = text.find_first_not_of(letters, 1);
  return end != std::string_view::npos && text[end] == '@' ? text.substr(1, end - 1) : std::string_view{};
}

void add_files(std::vector<NewFile>& files, const fs::path& folder, const PlaceholderValues& values) {
  std::error_code error;
  for (fs::directory_iterator each(folder, error), end; !error && each != end; each.increment(error)) {
    if (!each->is_regular_file(error)) continue;
    const std::optional<std::string> text = config::file_content(each->path());
    if (!text) throw BadInput(fmt::format("{}: cannot be read", each->path().string()));
    files.push_back({each->path().filename().string(), filled_in(*text, values)});
  }
  if (error) throw BadInput(fmt::format("template {}: {}", folder.string(), error.message()));
}

}  // namespace

std::string wrong_with_new_name(std::string_view name) {
  const auto is_one_of = [name](const auto& names) { return std::ranges::find(names, name) != names.end(); };
  if (name.empty()) return "the plugin needs a name, such as my_plugin";
  if (const std::string wrong = plugin::wrong_with_name(name); !wrong.empty()) {
    return fmt::format("the name {} {}; a name begins with a letter and has lower-case letters, digits and underscores",
                       texts::in_quotes(name), wrong);
  }
  if (is_one_of(cmake_targets)) return fmt::format("CMake has a target {} of its own; choose another name", name);
  if (is_one_of(libraries)) return fmt::format("{} is the name of a system library; choose another name", name);
  if (is_one_of(regista_targets))
    return fmt::format("Regista's CMake package has a target {}; choose another name", name);
  return {};
}

std::string filled_in(std::string_view text, const PlaceholderValues& values) {
  std::string out;
  while (!text.empty()) {
    const std::string_view name = placeholder(text);
    if (name.empty()) {
      const std::size_t next = std::min(text.find('@', 1), text.size());
      out += text.substr(0, next);
      text.remove_prefix(next);
      continue;
    }
    const auto found = values.find(name);
    if (found == values.end()) {
      const auto known = texts::names_of(values, &PlaceholderValues::value_type::first);
      throw BadInput("template: " + texts::unknown("placeholder", name, "", known));
    }
    out += found->second;
    text.remove_prefix(name.size() + 2);
  }
  return out;
}

std::vector<NewFile> files_from_template(const fs::path& templates, const std::string& kind,
                                         const std::string& language, const PlaceholderValues& values) {
  std::vector<NewFile> files;
  for (const fs::path& folder :
       {fs::path("shared"), "shared" / fs::path(language), fs::path(kind), kind / fs::path(language)}) {
    add_files(files, templates / folder, values);
  }
  std::ranges::sort(files, {}, &NewFile::name);
  return files;
}

}  // namespace regista::output
