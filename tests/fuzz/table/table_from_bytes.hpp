// SPDX-License-Identifier: MIT
// What must hold for any bytes at all as a table: they are refused with one line at a place of the file, or read; and
// what was read, written with every field in quotes and read again is the same. Shared by the fuzzer and the unit test.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "study/table.hpp"

namespace regista::study {

inline std::vector<std::vector<std::string>> rows_of(const std::filesystem::path& file) {
  Table table(file);
  std::vector<std::vector<std::string>> out{{table.columns().begin(), table.columns().end()}};
  while (table.next()) {
    std::vector<std::string>& row = out.emplace_back();
    for (std::size_t i = 0; i < table.columns().size(); ++i) {
      const config::Location place = table.where(i);
      if (place.line < 1 || place.column < 1) throw std::logic_error("a field without a place");
      row.emplace_back(table.text(i));
    }
  }
  return out;
}

inline void write_bytes(const std::filesystem::path& file, std::string_view bytes) {
  std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

// Returns what is wrong, "" for nothing. Writes `file`.
inline const char* check_table_from(const std::filesystem::path& file, std::string_view bytes) {
  const auto in_one_line = [](std::string_view text) {
    return std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) >= 0x20 && c != 0x7f; });
  };
  write_bytes(file, bytes);
  try {
    read_results_of_teams(file);
  } catch (const config::Error& error) {
    if (!in_one_line(error.what())) return "the message has several lines";
  }
  std::vector<std::vector<std::string>> rows;
  try {
    rows = rows_of(file);
  } catch (const config::Error&) {
    return "";
  }
  std::string again;
  for (const std::vector<std::string>& row : rows) {
    for (const std::string& field : row) {
      again += again.empty() || again.back() == '\n' ? "\"" : ",\"";
      for (const char c : field) again += c == '"' ? std::string("\"\"") : std::string(1, c);
      again += '"';
    }
    again += '\n';
  }
  if (again.size() > Table::longest_line) return "";  // a line may have outgrown what a line may be
  write_bytes(file, again);
  try {
    return rows_of(file) == rows ? "" : "written and read again, the fields differ";
  } catch (const config::Error&) {
    return "what was read and written cannot be read";
  }
}

}  // namespace regista::study
