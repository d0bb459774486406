// SPDX-License-Identifier: MIT
#include "check/perturbed_rerun.hpp"

#include <alloca.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <exception>
#include <string_view>
#include <system_error>

#include "config/errors.hpp"
#include "config/scalar.hpp"
#include "plugin/description.hpp"
#include "plugin/shared_object.hpp"

namespace regista::check {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t words_before_parameters = 5;

bool needs_a_file(const plugin::Description& plugin) {
  for (std::uint32_t i = 0; i < plugin.declared().parameter_count; ++i) {
    if (plugin::parameter(plugin.declared(), i).type == REGISTA_TYPE_FILE) return true;
  }
  return false;
}

// Lets another plugin play first: the first plugin in the folder that needs no file to play.
void let_a_visitor_play(const Elsewhere& what, Underway& note) {
  std::error_code none;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(what.visitors, none), end; !none && entry != end; entry.increment(none)) {
    std::error_code unknown;
    const bool same = fs::equivalent(entry->path(), what.file, unknown);
    if (entry->path().extension() == ".so" && !same) files.push_back(entry->path());
  }
  std::ranges::sort(files);
  constexpr std::size_t enough = 8;  // largest number of files that are tried
  files.resize(std::min(files.size(), enough));
  for (const fs::path& file : files) {
    const plugin::ScannedFile surveyed = std::move(plugin::scan_files(std::array{file}).front());
    for (const auto& visitor : surveyed.plugins) {
      const auto kind =
          std::ranges::find_if(kinds_checked, [&](std::int32_t each) { return visitor->implements(each); });
      if (kind == kinds_checked.end() || needs_a_file(*visitor)) continue;
      note.write(fmt::format("another plugin: {}", visitor->declared().id));
      try {
        testkit::scenario_digest(*kind, {file.string(), visitor->declared().id}, {});
        return;
      } catch (const std::exception&) {
        continue;  // errors of the visitor do not matter
      }
    }
  }
}

void go_to_another_folder() {
  std::error_code none;
  const fs::path root = "/";
  fs::current_path(fs::current_path(none) == root ? fs::path("/tmp") : root, none);
}

}  // namespace

std::vector<std::string> Elsewhere::words() const {
  std::vector<std::string> out{file.string(), plugin, std::to_string(kind), std::to_string(seed),
                               visitors.empty() ? "/dev/null" : visitors.string()};
  for (const auto& [name, value] : parameters) out.push_back(fmt::format("{}={}", name, value));
  return out;
}

Elsewhere Elsewhere::of(const std::vector<std::string>& words) {
  if (words.size() < words_before_parameters) throw config::BadInput("this command is for the program itself");
  Elsewhere out;
  out.file = words[0];
  out.plugin = words[1];
  out.kind = static_cast<std::int32_t>(config::parse_whole("kind", words[2], 0, REGISTA_KIND_END));
  out.seed = config::parse_whole("seed", words[3], 0, ~std::uint64_t{0});
  out.visitors = words[4];
  for (std::size_t i = words_before_parameters; i < words.size(); ++i) {
    const std::size_t sign = words[i].find('=');
    if (sign == std::string::npos) throw config::BadInput("this command is for the program itself");
    out.parameters.emplace_back(words[i].substr(0, sign), words[i].substr(sign + 1));
  }
  return out;
}

std::vector<std::string> environment_elsewhere() {
  std::vector<std::string> out{"HOME=/nowhere", "USER=another_user", "LOGNAME=another_user", "LANG=tr_TR.ISO8859-9",
                               "TZ=Pacific/Chatham"};
  for (const char* const* each = environ; *each != nullptr; ++each) {
    const std::string_view entry(*each);
    const std::string_view name = entry.substr(0, entry.find('='));
    // Keeps these variables: without them the plugin may not open, or its sanitizers may behave differently.
    if (name.starts_with("LD_") || name.ends_with("SAN_OPTIONS")) out.emplace_back(entry);
  }
  return out;
}

testkit::Options options_with(std::uint64_t seed, const GivenValues& given, const std::string& plugin, Underway& note) {
  testkit::Options out;
  out.seed = seed;
  out.base = [&](testkit::Values& values) { given.give(plugin, values); };
  out.underway = [&](const std::string& corner, const std::string& scene) {
    note.write(corner + (corner.empty() || scene.empty() ? "" : "; ") + scene);
  };
  return out;
}

Outcome play_perturbed(const Elsewhere& what, Underway& note) {
  // Reads the parameters before the working folder changes, because they may name files relative to the user's folder.
  const plugin::ScannedFile surveyed = std::move(plugin::scan_files(std::array{what.file}).front());
  if (!surveyed.refusal.empty()) return {Status::fail, {surveyed.refusal}};
  const GivenValues given(what.parameters, surveyed, {what.plugin});
  go_to_another_folder();
  for (int i = 0; i < 17; ++i) std::rand();  // as if other code had drawn random numbers
  let_a_visitor_play(what, note);
  errno = ENOENT;
  const testkit::Options options = options_with(what.seed, given, what.plugin, note);
  auto* const deeper = static_cast<volatile char*>(::alloca(70'003));
  deeper[0] = 1;
  const testkit::Loaded plugin(what.file.string(), what.plugin);
  testkit::scenario_digest(what.kind, plugin, options);  // a first play; only the hash of the second play counts
  return {Status::pass, {fmt::format("{:016x}", testkit::scenario_digest(what.kind, plugin, options))}};
}

}  // namespace regista::check
