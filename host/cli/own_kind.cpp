// SPDX-License-Identifier: MIT
#include "cli/own_kind.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string>
#include <system_error>

#include "cli/end_of_program.hpp"

namespace regista::cli {

void refuse_other_kinds(std::string_view option, const std::filesystem::path& file, std::string_view begin,
                        std::string_view what) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none) || std::filesystem::file_size(file, none) == 0) return;
  std::ifstream in(file, std::ios::binary);
  std::string found(begin.size(), '\0');
  in.read(found.data(), static_cast<std::streamsize>(found.size()));
  if (in.gcount() == static_cast<std::streamsize>(begin.size()) && found == begin) return;
  throw BadInput(
      fmt::format("{} {}: there is a file of another kind, which no {} replaces", option, file.string(), what));
}

}  // namespace regista::cli
