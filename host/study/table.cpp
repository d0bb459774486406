// SPDX-License-Identifier: MIT
#include "study/table.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <utility>

#include "texts/message.hpp"

namespace regista::study {
namespace {

// A field of a file that may be anything, for a terminal: bytes that are not plain ASCII as escapes.
std::string in_ascii_quotes(std::string_view field) {
  std::string plain;
  for (const char c : field) {
    const bool is_plain = c >= 0x20 && c < 0x7f;
    plain += is_plain ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return texts::in_quotes(plain);
}

}  // namespace

// Bytes of the file, decompressed; zlib hands files that are not compressed through as they are.
struct Table::Stream {
  gzFile file = nullptr;
  std::array<char, 65'536> buffer;
  std::size_t begin = 0, end = 0;
  bool finished = false;

  ~Stream() {
    if (file != nullptr) gzclose_r(file);
  }
};

Table::Table(const std::filesystem::path& file, Progress progress)
    : name_(file.string()), progress_(std::move(progress)), stream_(std::make_unique<Stream>()) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw config::Error({name_}, "is a folder, not a table");
  // A pipe would wait for ever, a device never end.
  if (std::filesystem::is_other(file, ignored)) throw config::Error({name_}, "is not a regular file");
  errno = 0;
  stream_->file = gzopen(name_.c_str(), "rb");
  if (stream_->file == nullptr) {
    throw config::Error({name_}, fmt::format("cannot be opened: {}", std::strerror(errno)));
  }
  gzbuffer(stream_->file, 1u << 17);
  if (!read_line()) throw config::Error({name_}, "is empty; expected a first line with the names of columns");
  if (line_.starts_with("\xEF\xBB\xBF")) line_.erase(0, 3);
  split();
  for (const std::string_view each : fields_) columns_.emplace_back(each);
}

Table::~Table() = default;

bool Table::has_column(std::string_view name) const {
  return std::find(columns_.begin(), columns_.end(), name) != columns_.end();
}

std::size_t Table::column(std::string_view name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  if (found != columns_.end()) return static_cast<std::size_t>(found - columns_.begin());
  constexpr std::size_t most_shown = 8;
  std::vector<std::string> known(columns_.begin(),
                                 columns_.begin() + static_cast<std::ptrdiff_t>(std::min(columns_.size(), most_shown)));
  for (std::string& each : known) each = in_ascii_quotes(each);
  if (columns_.size() > most_shown) known.emplace_back("...");
  throw config::Error({name_, 1, 1},
                      fmt::format("no column {}; this file has: {}", texts::in_quotes(name), texts::join(known)));
}

bool Table::next() {
  do {
    if (!read_line()) return false;
  } while (line_.empty());
  split();
  if (fields_.size() != columns_.size()) {
    refuse_line(fmt::format("{} values, but the first line names {} columns", fields_.size(), columns_.size()));
  }
  if (progress_ && lines_ % 16'384 == 0) progress_(lines_);
  return true;
}

bool Table::read_line() {
  line_.clear();
  Stream& in = *stream_;
  for (;;) {
    if (in.begin == in.end) {
      if (in.finished) break;
      const int count = gzread(in.file, in.buffer.data(), static_cast<unsigned>(in.buffer.size()));
      int code = Z_OK;
      const char* message = gzerror(in.file, &code);
      if (count < 0 || (count == 0 && code != Z_OK && code != Z_STREAM_END)) {
        const std::string reason = code == Z_ERRNO ? std::strerror(errno) : message;
        throw config::Error({name_, static_cast<int>(lines_ + 1), 1},
                            fmt::format("cannot be read on: {}", texts::one_line(reason)));
      }
      in.begin = 0;
      in.end = static_cast<std::size_t>(count);
      in.finished = count == 0;
      continue;
    }
    const char* first = in.buffer.data() + in.begin;
    const auto* stop = static_cast<const char*>(std::memchr(first, '\n', in.end - in.begin));
    const std::size_t length = stop != nullptr ? static_cast<std::size_t>(stop - first) : in.end - in.begin;
    if (line_.size() + length > longest_line) {
      ++lines_;
      refuse_line(fmt::format("is longer than {} bytes; this is no table of comma-separated values", longest_line));
    }
    line_.append(first, length);
    in.begin += length + (stop != nullptr ? 1 : 0);
    if (stop != nullptr) {
      if (++lines_ > most_lines) refuse_line(fmt::format("a table may have at most {} lines", most_lines));
      if (!line_.empty() && line_.back() == '\r') line_.pop_back();
      return true;
    }
  }
  if (line_.empty()) return false;
  ++lines_;  // the last line, without its end
  return true;
}

void Table::split() {
  fields_.clear();
  const std::string_view line = line_;
  for (std::size_t from = 0;;) {
    const std::size_t comma = std::min(line.find(',', from), line.size());
    std::string_view field = line.substr(from, comma - from);
    while (!field.empty() && field.front() == ' ') field.remove_prefix(1);
    while (!field.empty() && field.back() == ' ') field.remove_suffix(1);
    fields_.push_back(field);
    if (comma == line.size()) return;
    from = comma + 1;
  }
}

double Table::number(std::size_t column) const {
  const std::string_view field = fields_[column];
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error == std::errc::result_out_of_range) refuse(column, "is beyond all numbers");
  if (error != std::errc() || end != field.data() + field.size()) refuse(column, "is no number");
  if (!std::isfinite(value)) refuse(column, "is not finite");
  return value;
}

int Table::integer(std::size_t column) const {
  const std::string_view field = fields_[column];
  int value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size()) refuse(column, "is no whole number");
  return value;
}

std::int64_t Table::count(std::size_t column, std::int64_t most) const {
  const std::string_view field = fields_[column];
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size() || value < 0 || value > most) {
    refuse(column, fmt::format("is no whole number from 0 to {}", most));
  }
  return value;
}

config::Location Table::where(std::size_t column) const {
  return {name_, static_cast<int>(lines_), static_cast<int>(fields_[column].data() - line_.data()) + 1};
}

void Table::refuse(std::size_t column, const std::string& message) const {
  throw config::Error(where(column),
                      fmt::format("{}: {} {}", columns_[column], in_ascii_quotes(fields_[column]), message));
}

void Table::refuse_line(const std::string& message) const {
  throw config::Error({name_, static_cast<int>(lines_), 1}, message);
}

}  // namespace regista::study
