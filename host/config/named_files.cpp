// SPDX-License-Identifier: MIT
#include "config/named_files.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <system_error>
#include <utility>

#include "config/parse.hpp"

namespace regista::config {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 20'000;   // a folder may hold anything
constexpr std::size_t longest_name = 4'096;  // of a file, bytes
constexpr int most_names = 8;                // of one file; a link may lead to its own folder

class Search {
 public:
  // A name as it is seen from a folder; the empty folder is the current one.
  void name(const std::string& text, const fs::path& folder) {
    if (text.empty() || text.size() > longest_name || text.find('\0') != std::string::npos) return;
    const fs::path path = folder / text;
    std::error_code none;
    const fs::file_type type = fs::status(path, none).type();
    if (type == fs::file_type::regular) file(path);
    if (type == fs::file_type::directory) files_in(path);
  }

  // In a document the names are seen from where it stands, those of a study's `set` from the current folder.
  void values(const Node& node, const fs::path& folder) {
    if (node.kind() == Node::Kind::scalar) {
      name(node.text(), folder);
      if (!folder.empty()) name(node.text(), {});
    }
    for (const Node& each : node.elements()) values(each, folder);
    for (const Node::Entry& each : node.entries()) values(each.value, folder);
  }

  // Follows what was named until nothing new is: a list and no recursion, for chains may be long.
  std::vector<fs::path> all() {
    for (std::size_t i = 0; i < out_.size(); ++i) {
      const fs::path path = out_[i];
      std::error_code none;
      if (fs::file_size(path, none) > largest_file) continue;  // no document
      try {
        values(parse(path), path.parent_path());
      } catch (const Error&) {
        // No document: data of a plugin, or a plugin.
      }
    }
    return std::move(out_);
  }

 private:
  void file(const fs::path& path) {
    std::error_code none;
    if (out_.size() >= most_files || !names_.insert(path.lexically_normal()).second) return;
    // By whatever links it is named: what it names by relative paths may be another file for each.
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
  std::map<fs::path, int> names_of_;  // by what they lead to
};

}  // namespace

std::vector<fs::path> named_files(std::span<const fs::path> documents, const Overrides& overrides) {
  Search search;
  for (const fs::path& each : documents) search.name(each.string(), {});
  for (const Override& each : overrides) search.values(each.value, {});
  return search.all();
}

}  // namespace regista::config
