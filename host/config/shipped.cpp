// SPDX-License-Identifier: MIT
#include "config/shipped.hpp"

#include <algorithm>
#include <array>
#include <system_error>

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

}  // namespace

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

std::vector<std::string> shipped_names() {
  std::vector<std::string> out;
  std::error_code failed;
  for (const char* const folder : folders) {
    for (fs::directory_iterator each(root() / folder, failed), end; !failed && each != end; each.increment(failed))
      if (each->path().extension() == ".yaml") out.push_back(each->path().stem().string());
  }
  std::ranges::sort(out);
  return out;
}

fs::path own_or_shipped(const fs::path& path, const fs::path& written) {
  std::error_code none;
  if (!is_name(written) || fs::exists(path, none)) return path;
  const fs::path found = shipped(written.string());
  return found.empty() ? path : found;
}

}  // namespace regista::config
