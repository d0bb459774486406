// SPDX-License-Identifier: MIT
#include "campaign/document_copies.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include "config/file.hpp"

namespace regista::campaign {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest = std::uintmax_t{16} << 20;  // bytes

fs::path plain(const fs::path& path) { return fs::absolute(path).lexically_normal(); }

}  // namespace

std::vector<Document> documents_in(std::span<const fs::path> files) {
  std::vector<Document> out;
  std::set<std::string> seen;
  for (const fs::path& file : files) {
    Document document{plain(file).string(), std::nullopt};
    if (!seen.insert(document.path).second) continue;
    std::error_code none;
    const std::uintmax_t size = fs::file_size(file, none);
    if (none) continue;  // gone since it was read
    if (size <= largest) {
      document.content = config::content_of(file);
      if (document.content && document.content->starts_with("\x7f"
                                                            "ELF"))
        document.content.reset();
    }
    out.push_back(std::move(document));
  }
  std::ranges::sort(out, {}, &Document::path);
  return out;
}

DocumentCopies::DocumentCopies(std::vector<Document> documents) {
  for (Document& each : documents) {
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
    paths_.push_back(std::move(each.path));
  }
}

fs::path DocumentCopies::at(const fs::path& path) const { return root_.path() / path.relative_path(); }

fs::path DocumentCopies::folder(const fs::path& given_in) const {
  fs::path out = at(given_in);
  fs::create_directories(out);
  return out;
}

Job DocumentCopies::job(Job job, const fs::path& given_in) const {
  for (std::string* name : {&job.teams[0], &job.teams[1], &job.rules, &job.robot, &job.disturbance,
                            &job.home_disturbance, &job.away_disturbance, &job.opening}) {
    const fs::path path = (given_in / *name).lexically_normal();
    // What is not here is the name of a built-in profile.
    if (!name->empty() && std::ranges::find(paths_, path.string()) != paths_.end()) *name = at(path).string();
  }
  for (std::string& each : job.plugins) each = (given_in / each).lexically_normal().string();
  return job;
}

}  // namespace regista::campaign
