// SPDX-License-Identifier: MIT
#include "campaign/document_copies.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "config/file.hpp"
#include "texts/message.hpp"

namespace regista::campaign {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest = std::uintmax_t{16} << 20, most = std::uintmax_t{64} << 20;  // bytes
constexpr std::string_view shared_object = "\x7f\x45LF";                                       // how its content begins

bool is_plain(const std::string& name) {
  const fs::path path = name;
  return path.is_absolute() && path.has_filename() && !name.starts_with("//") && path == path.lexically_normal() &&
         name.find('\0') == std::string::npos;
}

// A file of results may come from anybody: nothing may be written but below the root, and nothing through a link.
void require_sound(const std::vector<Document>& documents) {
  std::set<std::string> paths;
  for (const Document& each : documents) paths.insert(each.path);
  for (const Document& each : documents) {
    bool sound = is_plain(each.path);
    for (fs::path folder = fs::path(each.path).parent_path(); sound && folder != folder.parent_path();
         folder = folder.parent_path()) {
      sound = !paths.contains(folder.string());
    }
    if (!sound) throw std::invalid_argument("no document has the path " + texts::in_quotes(each.path));
  }
}

}  // namespace

std::vector<Document> documents_in(std::span<const fs::path> files) {
  std::vector<Document> out;
  std::set<std::string> seen;
  std::uintmax_t sum = 0;
  for (const fs::path& file : files) {
    Document document{fs::absolute(file).lexically_normal().string(), std::nullopt};
    if (!seen.insert(document.path).second) continue;
    std::error_code none;
    const std::uintmax_t size = fs::file_size(file, none);
    if (none) continue;  // gone since it was read
    if (size <= largest && sum + size <= most) {
      std::optional<std::string> content = config::file_content(file);
      if (content && !content->starts_with(shared_object)) {
        sum += content->size();
        document.content = std::move(content);
      }
    }
    out.push_back(std::move(document));
  }
  std::ranges::sort(out, {}, &Document::path);
  return out;
}

Job in_copies(Job job, const fs::path& root, const fs::path& given_in) {
  for (std::string* name : {&job.teams[0], &job.teams[1], &job.rules, &job.robot, &job.disturbance,
                            &job.home_disturbance, &job.away_disturbance, &job.opening}) {
    const fs::path path = fs::path(*name).lexically_normal();
    if (!path.is_absolute()) continue;
    const fs::path copy = root / path.relative_path();
    std::error_code none;
    if (fs::exists(copy, none)) *name = copy.string();
  }
  for (std::string& each : job.plugins) each = (given_in / each).lexically_normal().string();
  return job;
}

DocumentCopies::DocumentCopies(std::vector<Document> documents) {
  require_sound(documents);
  for (const Document& each : documents) {
    const fs::path file = at(each.path);
    fs::create_directories(file.parent_path());
    if (each.content) {
      std::ofstream out(file, std::ios::binary);
      if (!(out << *each.content).flush()) {
        throw std::system_error(errno, std::generic_category(), "no room for a copy of " + each.path);
      }
    } else {
      fs::create_symlink(each.path, file);
    }
  }
}

fs::path DocumentCopies::at(const fs::path& path) const { return root_.path() / path.relative_path(); }

fs::path DocumentCopies::folder(const fs::path& given_in) const {
  fs::path out = at(given_in);
  fs::create_directories(out);
  return out;
}

Job DocumentCopies::job(Job job, const fs::path& given_in) const {
  return in_copies(std::move(job), root_.path(), given_in);
}

}  // namespace regista::campaign
