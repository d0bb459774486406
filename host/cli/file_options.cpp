// SPDX-License-Identifier: MIT
#include "cli/file_options.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <string>

namespace regista::cli {
namespace {

constexpr std::array all_reads{Reads::documents, Reads::results, Reads::data, Reads::plugins};
constexpr std::array all_writes{Writes::results,     Writes::recording,     Writes::decisions,    Writes::metrics,
                                Writes::match_table, Writes::summary_table, Writes::search_table, Writes::tuned_team,
                                Writes::page,        Writes::figures};

std::string name(Reads what) { return "reads " + std::to_string(static_cast<int>(what)); }
std::string name(Writes what) { return "writes " + std::to_string(static_cast<int>(what)); }

// CLI11 keeps nothing of ours with an option but validators: one that accepts everything, under a name of ours.
CLI::Option* marked(CLI::Option* option, const std::string& mark) {
  return option->check(CLI::Validator([](const std::string&) { return std::string(); }, "", mark));
}

bool is_marked(const CLI::Option& option, const std::string& mark) {
  try {
    const_cast<CLI::Option&>(option).get_validator(mark);  // looks, and hands out what could be changed
    return true;
  } catch (const CLI::OptionNotFound&) {
    return false;
  }
}

template <class What, std::size_t count>
std::optional<What> mark_of(const CLI::Option& option, const std::array<What, count>& all) {
  for (const What each : all) {
    if (is_marked(option, name(each))) return each;
  }
  return std::nullopt;
}

}  // namespace

CLI::Option* reads(CLI::Option* option, Reads what) { return marked(option, name(what)); }
CLI::Option* writes(CLI::Option* option, Writes what) { return marked(option, name(what)); }

std::optional<Reads> read_by(const CLI::Option& option) { return mark_of(option, all_reads); }
std::optional<Writes> written_by(const CLI::Option& option) { return mark_of(option, all_writes); }

}  // namespace regista::cli
