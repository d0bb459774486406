// SPDX-License-Identifier: MIT
#include "cli/plugin_template.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <system_error>

#include "config/bad_input.hpp"
#include "config/file.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

namespace fs = std::filesystem;
using config::BadInput;

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ_";

// The name of the placeholder with which the text begins; empty: it begins with none.
std::string_view placeholder(std::string_view text) {
  if (!text.starts_with('@')) return {};
  const std::size_t end = text.find_first_not_of(letters, 1);
  return end != std::string_view::npos && text[end] == '@' ? text.substr(1, end - 1) : std::string_view{};
}

void add_files(std::vector<output::NewFile>& files, const fs::path& folder, const PlaceholderValues& values) {
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

std::string filled_in(std::string_view text, const PlaceholderValues& values) {
  std::string out;
  while (!text.empty()) {
    const std::size_t plain = std::min(text.find('@'), text.size());
    out += text.substr(0, plain);
    text.remove_prefix(plain);
    if (text.empty()) break;
    const std::string_view name = placeholder(text);
    if (name.empty()) {
      out += '@';
      text.remove_prefix(1);
      continue;
    }
    const auto found = values.find(name);
    if (found == values.end()) {
      std::vector<std::string> known;
      for (const auto& [each, value] : values) known.push_back(each);
      throw BadInput("template: " + texts::unknown("placeholder", name, "", known));
    }
    out += found->second;
    text.remove_prefix(name.size() + 2);
  }
  return out;
}

std::vector<output::NewFile> files_from_template(const fs::path& templates, const std::string& kind,
                                                 const std::string& language, const PlaceholderValues& values) {
  std::vector<output::NewFile> files;
  for (const fs::path& folder :
       {fs::path("shared"), "shared" / fs::path(language), fs::path(kind), kind / fs::path(language)}) {
    add_files(files, templates / folder, values);
  }
  std::ranges::sort(files, {}, &output::NewFile::name);
  return files;
}

}  // namespace regista::cli
