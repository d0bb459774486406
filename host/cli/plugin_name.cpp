// SPDX-License-Identifier: MIT
#include "cli/plugin_name.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "plugin/descriptor.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

// What CMake, or what it writes for make and ninja, calls its own targets. Of these only names in lower case: others
// are no names of plugins.
constexpr std::array<std::string_view, 14> cmake_targets{
    "all",           "clean",   "default_target",          "define",     "depend",  "edit_cache",
    "help",          "install", "list_install_components", "preinstall", "package", "package_source",
    "rebuild_cache", "test"};
// Libraries that a plugin or its test is linked with: a target of this name would be taken for them.
constexpr std::array<std::string_view, 4> libraries{"c", "dl", "m", "pthread"};
// Targets that find_package(regista) makes.
constexpr std::array<std::string_view, 2> regista_targets{"regista_sdk", "regista_testkit"};

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

}  // namespace regista::cli
