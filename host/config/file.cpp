// SPDX-License-Identifier: MIT
#include "config/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <span>
#include <sstream>
#include <utility>
#include <vector>

#include "config/parse.hpp"
#include "config/scalar.hpp"
#include "texts/message.hpp"
#include "texts/nearest.hpp"

namespace regista::config {
namespace {

namespace fs = std::filesystem;

// Whether one file may be meant by the name of another: an ending that both have makes no two names alike.
bool alike(const fs::path& asked, const fs::path& there) {
  const std::string stem = asked.stem().string();
  const std::array names{there.stem().string()};
  return stem == names.front() || !texts::nearest(stem, std::span<const std::string>(names)).empty();
}

// `; nearest: "b.yaml"` when the folder holds a file of nearly that name.
std::string neighbour(const fs::path& file) {
  constexpr std::size_t most = 1000;
  std::vector<std::string> names;
  std::error_code failed;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::size_t seen = 0;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end && seen < most;
       entry.increment(failed), ++seen) {
    if (alike(file, entry->path())) names.push_back(entry->path().filename().string());
  }
  if (failed && file.has_parent_path()) return fmt::format("; there is no folder {}", folder.string());
  std::sort(names.begin(), names.end());
  const std::string asked = file.filename().string();
  const std::string_view near = texts::nearest(asked, names);
  return near.empty() || near == asked ? "" : fmt::format("; nearest: {}", texts::in_quotes(near));
}

}  // namespace

std::string read_file(const fs::path& file, const Location& asked_by, std::string_view expected) {
  const bool asked = !asked_by.file.empty();
  const Location here = asked ? asked_by : Location{file.string(), 0, 0};
  const std::string name = asked ? file.string() + ": " : "";
  std::error_code failed;
  const fs::file_status status = fs::status(file, failed);
  if (status.type() == fs::file_type::not_found) throw Error(here, name + "no such file" + neighbour(file));
  if (status.type() == fs::file_type::directory) {
    throw Error(here, fmt::format("{}is a folder; expected {}", name, expected));
  }
  if (status.type() == fs::file_type::regular) {
    const auto size = fs::file_size(file, failed);
    if (!failed && size > largest_file) {
      throw Error(here, fmt::format("{}is {} bytes large; at most {} are read", name, size, largest_file));
    }
    std::ifstream stream(file, std::ios::binary);
    std::string content;
    std::array<char, 16384> part;
    while (stream && content.size() <= largest_file) {
      stream.read(part.data(), part.size());
      content.append(part.data(), static_cast<std::size_t>(stream.gcount()));
    }
    if (stream.is_open() && !stream.bad()) return content;
    throw Error(here, name + "cannot be read");
  }
  throw Error(here, name + (failed ? "cannot be read: " + failed.message() : "is not a regular file"));
}

std::optional<std::string> file_content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  // An empty file gives nothing to the stream, which takes that for a failure.
  if (!in || (in.peek() != std::ifstream::traits_type::eof() && !(bytes << in.rdbuf())) || in.bad())
    return std::nullopt;
  return std::move(bytes).str();
}

fs::path named_file(const Node& value, std::string_view what) {
  const std::string name = to_text(value, what);
  if (name.empty()) throw Error(value.where(), fmt::format("{}: empty; expected a path", what));
  const fs::path path = name;
  if (path.is_absolute() || value.where().is_laid()) return path.lexically_normal();
  return (fs::path(value.where().file).parent_path() / path).lexically_normal();
}

fs::path existing_file(const Node& value, std::string_view what) {
  const fs::path path = named_file(value, what);
  std::error_code failed;
  if (!fs::is_regular_file(path, failed)) {
    const bool there = fs::exists(path, failed);
    throw Error(value.where(), fmt::format("{}: {}", what, path.string()) +
                                   (there ? ": is not a regular file" : ": no such file" + neighbour(path)));
  }
  return fs::absolute(path).lexically_normal();
}

}  // namespace regista::config
