// SPDX-License-Identifier: MIT
#include "config/document_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <system_error>

#include "config/parse.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

namespace fs = std::filesystem;

// The folders of shipped documents. If two folders have a document of the same name, shipped() takes the first folder.
constexpr std::array folders{"teams", "teams/league", "rules", "robots", "disturbances", "openings", "studies"};

fs::path root() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  return program.empty() ? program : (program.parent_path() / "../share/regista/configs").lexically_normal();
}

bool is_name(const fs::path& path) {
  const std::string text = path.string();
  return !text.empty() && text.find_first_of("./") == std::string::npos;
}

// Returns the path of the shipped document NAME.yaml, or of the shipped folder of documents NAME ("openings"). The path
// is empty if no shipped document or folder has this name.
fs::path shipped(const std::string& name) {
  const fs::path configs = root();
  if (configs.empty() || !is_name(name)) return {};
  std::error_code none;
  for (const char* const folder : folders) {
    const fs::path file = configs / folder / (name + ".yaml");
    if (fs::is_regular_file(file, none)) return file;
  }
  const fs::path folder = configs / name;
  return fs::is_directory(folder, none) ? folder : fs::path();
}

// Returns the entries of a folder, at most a thousand of them, in the order of their names.
std::vector<fs::path> entries_of(const fs::path& folder, std::error_code& failed) {
  std::vector<fs::path> out;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end && out.size() < 1000;
       entry.increment(failed)) {
    out.push_back(entry->path());
  }
  std::ranges::sort(out);
  return out;
}

// Returns `; nearest: "b.yaml"` if the folder has a file with a similar name, or a shipped document has a similar name.
// Else the names that begin like it; else, for a document, the shipped teams, because most names are of teams.
std::string neighbour(const fs::path& file, bool is_document) {
  const std::string asked = file.filename().string(), name = file.stem().string();
  std::vector<std::string> names, teams;
  std::error_code failed, none;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  for (const fs::path& each : entries_of(folder, failed)) {
    const std::string other = each.stem().string();
    if (other == name || !texts::nearest(name, {&other, 1}).empty()) names.push_back(each.filename().string());
  }
  if (failed && file.has_parent_path()) {
    const std::string known =
        shipped(name).empty() ? "" : fmt::format("; shipped documents go by their names: {}", name);
    return fmt::format("; there is no folder {}{}", folder.string(), known);
  }
  for (const std::string_view each : folders) {
    if (asked != name) break;  // a name with an ending is no name of a shipped document
    for (const fs::path& path : entries_of(root() / each, none)) {
      if (path.extension() == ".yaml") (each.starts_with("teams") ? teams : names).push_back(path.stem().string());
    }
  }
  names.insert(names.end(), teams.begin(), teams.end());
  if (asked == name) names.emplace_back("openings");  // the shipped folder
  std::ranges::sort(names);
  const std::string_view near = texts::nearest(asked, names);
  if (!near.empty() && near != asked) return fmt::format("; nearest: {}", texts::in_quotes(near));
  std::vector<std::string> begun;  // names that begin with all but the last letter of what was asked
  for (const std::string& each : names) {
    const bool begins = is_name(file) && asked.size() > 2 && each.starts_with(asked.substr(0, asked.size() - 1));
    if (begins && begun.size() < 4) begun.push_back(each);
  }
  if (!begun.empty()) return "; nearest: " + texts::join(begun);
  const bool may_be_team = is_document && is_name(file) && !teams.empty();
  return may_be_team ? fmt::format("; shipped teams: {}", texts::join(teams)) : "";
}

constexpr std::size_t most_files = 20'000;  // largest number of files to find; a folder may contain any number of files
constexpr std::size_t longest_name = 4'096;  // bytes of a file name
constexpr int most_names = 8;                // names kept per file: a folder that links to itself gives endless names

class Search {
 public:
  // Adds the file `text` in `folder` if the file exists. An empty `folder` means the current folder.
  void name(const std::string& text, const fs::path& folder) {
    if (text.empty() || text.size() > longest_name || text.find('\0') != std::string::npos) return;
    const fs::path path = own_or_shipped(folder / text, text);
    std::error_code none;
    const fs::file_type type = fs::status(path, none).type();
    if (type == fs::file_type::regular) file(path);
    if (type == fs::file_type::directory) files_in(path);
  }

  // Tests every value as a file name. Names in a document are relative to its folder, but names in a study's `set` are
  // relative to the current folder. So the search tests both folders.
  void values(const Node& node, const fs::path& folder) {
    if (node.kind() == Node::Kind::scalar) {
      name(node.text(), folder);
      if (!folder.empty()) name(node.text(), {});
    }
    for (const Node& each : node.elements()) values(each, folder);
    for (const Node::Entry& each : node.entries()) values(each.value, folder);
  }

  // Reads each file of the list and adds the files that it names. Uses no recursion, because the chain may be long.
  std::vector<fs::path> all() {
    for (std::size_t i = 0; i < out_.size(); ++i) {
      const fs::path path = out_[i];
      std::error_code none;
      if (fs::file_size(path, none) > largest_file) continue;  // too large for a document
      try {
        values(parse(path), path.parent_path());
      } catch (const Error&) {
        // A file that is not a document, such as a plugin or data of a plugin, names no other files.
      }
    }
    return std::move(out_);
  }

 private:
  void file(const fs::path& path) {
    std::error_code none;
    if (out_.size() >= most_files || !names_.insert(path.lexically_normal()).second) return;
    // Keeps each name of a file with links, because a relative path in the file depends on the file's folder.
    if (++names_of_[fs::weakly_canonical(path, none)] <= most_names) out_.push_back(path);
  }

  void files_in(const fs::path& folder) {
    std::error_code failed;
    std::vector<fs::path> found;
    for (fs::directory_iterator each(folder, failed), end; !failed && each != end; each.increment(failed)) {
      std::error_code none;
      if (each->path().extension() == ".yaml" && each->is_regular_file(none)) found.push_back(each->path());
    }
    std::ranges::sort(found);
    for (const fs::path& each : found) file(each);
  }

  std::vector<fs::path> out_;
  std::set<fs::path> names_;
  std::map<fs::path, int> names_of_;  // number of names of each real file
};

}  // namespace

fs::path own_or_shipped(const fs::path& path, const fs::path& written) {
  std::error_code none;
  if (!is_name(written) || fs::exists(path, none)) return path;
  const fs::path found = shipped(written.string());
  return found.empty() ? path : found;
}

std::string read_file(const fs::path& file, const Location& asked_by, std::string_view expected) {
  const bool asked = !asked_by.file.empty();
  const Location here = asked ? asked_by : Location{file.string(), 0, 0};
  const std::string name = asked ? file.string() + ": " : "";
  std::error_code failed;
  const fs::file_status status = fs::status(file, failed);
  if (status.type() == fs::file_type::not_found)
    throw Error(here, name + "no such file" + neighbour(file, expected == yaml_file));
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
  // An empty file writes nothing to the stream, so the stream reports a failure.
  if (!in || (in.peek() != std::ifstream::traits_type::eof() && !(bytes << in.rdbuf())) || in.bad())
    return std::nullopt;
  return std::move(bytes).str();
}

fs::path named_file(const Node& value, std::string_view what) {
  const std::string name = to_text(value, what);
  if (name.empty()) throw Error(value.where(), fmt::format("{}: empty; expected a path", what));
  const fs::path path = name;
  if (path.is_absolute() || value.where().is_laid()) return own_or_shipped(path.lexically_normal());
  return own_or_shipped((fs::path(value.where().file).parent_path() / path).lexically_normal(), path);
}

fs::path existing_file(const Node& value, std::string_view what) {
  const fs::path path = named_file(value, what);
  std::error_code failed;
  if (!fs::is_regular_file(path, failed)) {
    const bool there = fs::exists(path, failed);
    throw Error(value.where(), fmt::format("{}: {}", what, path.string()) +
                                   (there ? ": is not a regular file" : ": no such file" + neighbour(path, false)));
  }
  return fs::absolute(path).lexically_normal();
}

std::vector<fs::path> named_files(std::span<const fs::path> documents, const Overrides& overrides) {
  Search search;
  for (const fs::path& each : documents) search.name(each.string(), {});
  for (const Override& each : overrides) search.values(each.value, {});
  return search.all();
}

}  // namespace regista::config
