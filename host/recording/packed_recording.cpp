// SPDX-License-Identifier: MIT
#include "recording/packed_recording.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mcap/reader.hpp"
#include "texts/html.hpp"

namespace regista::recording {
namespace {

constexpr int level = 9;                                    // of zstd; higher levels take much time and save 1 %
constexpr std::size_t tables_size = std::size_t{16} << 20;  // bytes of messages in one record
constexpr std::size_t most_decimals = 5, most_digits = 10;  // of a number that is written as a difference
constexpr std::array<std::int64_t, most_decimals + 1> powers{1, 10, 100, 1000, 10'000, 100'000};

void append_whole(std::string& to, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) to += static_cast<char>((value & 0x7f) | 0x80);
  to += static_cast<char>(value);
}

void append_text(std::string& to, std::string_view text) {
  append_whole(to, text.size());
  to += text;
}

std::uint64_t zigzag(std::int64_t value) {
  return (static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_of_word(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.';
}

// Returns the length of the number at the beginning of the text; 0 if there is none, or if a word continues it.
std::size_t number_length(std::string_view text) {
  std::size_t at = text.starts_with('-') ? 1 : 0;
  const auto digits = [&] {
    const std::size_t begin = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    return at > begin;
  };
  if (!digits()) return 0;
  if (at < text.size() && text[at] == '.' && (++at, !digits())) return 0;
  if (at < text.size() && text[at] == 'e') {
    ++at;
    if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
    if (!digits()) return 0;
  }
  return at < text.size() && is_of_word(text[at]) ? 0 : at;
}

struct Number {
  std::int64_t units = 0;  // of 10^-decimals
  std::size_t decimals = 0;
};

// Returns the number in the text; nothing for a text with an exponent, too many digits or decimals, or that is not the
// shortest text of its number (1.50, -0), the only one that the page can write.
std::optional<Number> number_of(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const std::size_t point = text.find('.');
  const bool whole = point == std::string_view::npos;
  Number out{0, whole ? 0 : text.size() - point - 1};
  if (text.size() > most_digits || out.decimals > most_decimals) return {};
  if ((text[0] == '0' && text.size() > 1 && text[1] != '.') || (!whole && text.back() == '0')) return {};
  for (const char c : text) {
    if (c == 'e') return {};
    if (c != '.') out.units = 10 * out.units + (c - '0');
  }
  if (!negative) return out;
  if (out.units == 0) return {};
  out.units = -out.units;
  return out;
}

struct Row {
  std::size_t place = 0, topic = 0;
  std::vector<std::string_view> numbers;
};

struct Table {
  std::vector<std::string_view> pieces;  // of text: before, between and after the numbers
  std::vector<std::size_t> decimals;     // by column: most of any number
  std::vector<Row> rows;
};

// Returns the key by which the rows of a table are sorted, so that similar rows are neighbours. Robots of a team make
// similar decisions, so their topics have one key. Other messages of a robot resemble its own earlier messages.
std::string_view kindred(std::string_view topic) {
  return topic.starts_with("/decision/") ? topic.substr(0, topic.rfind('/')) : topic;
}

// Appends a column. texts: receives the numbers that are written as texts.
void append_column(std::string& to, const Table& table, std::size_t column, std::string& texts) {
  std::int64_t before = 0;
  for (const Row& row : table.rows) {
    const std::string_view text = row.numbers[column];
    const std::optional<Number> number = number_of(text);
    const std::int64_t value = number ? number->units * powers[table.decimals[column] - number->decimals] : 0;
    if (!number || !std::in_range<std::int32_t>(value)) {
      append_whole(to, 0);
      append_text(texts, text);
    } else {
      append_whole(to, zigzag(value - std::exchange(before, value)) + 1);
    }
  }
}

void append_differences(std::string& to, const auto& elements, auto value_of) {
  std::int64_t before = 0;
  for (const auto& each : elements) {
    const auto value = static_cast<std::int64_t>(value_of(each));
    append_whole(to, zigzag(value - std::exchange(before, value)));
  }
}

class Tables {
 public:
  void add(std::size_t topic, const mcap::Message& message) {
    texts_.emplace_back(message.data);
    size_ += message.data.size();
    const std::string_view text = texts_.back();
    Row row{times_.size(), topic, {}};
    times_.push_back(message.log_time);
    std::vector<std::string_view> pieces;
    std::string form;
    const auto end_piece = [&](std::size_t begin, std::size_t end) {
      pieces.push_back(text.substr(begin, end - begin));
      append_text(form, pieces.back());
    };
    std::size_t begin = 0;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t length = at > 0 && is_of_word(text[at - 1]) ? 0 : number_length(text.substr(at));
      if (length == 0) {
        ++at;
        continue;
      }
      end_piece(begin, at);
      row.numbers.push_back(text.substr(at, length));
      begin = at += length;
    }
    end_piece(begin, text.size());
    const auto [found, added] = by_form_.try_emplace(std::move(form), tables_.size());
    if (added) tables_.push_back({std::move(pieces), std::vector<std::size_t>(row.numbers.size()), {}});
    Table& table = tables_[found->second];
    for (std::size_t i = 0; i < row.numbers.size(); ++i) {
      if (const auto number = number_of(row.numbers[i]))
        table.decimals[i] = std::max(table.decimals[i], number->decimals);
    }
    table.rows.push_back(std::move(row));
  }

  std::size_t size() const { return size_; }

  std::string bytes(const std::vector<std::string>& topics) {
    std::string out, numbers, texts;
    append_whole(out, topics.size());
    for (const std::string& topic : topics) append_text(out, topic);
    append_whole(out, times_.size());
    append_differences(out, times_, std::identity());
    append_whole(out, tables_.size());
    for (Table& table : tables_) {
      std::ranges::stable_sort(table.rows, {}, [&](const Row& row) { return kindred(topics[row.topic]); });
      append_whole(out, table.decimals.size());
      for (const std::string_view piece : table.pieces) append_text(out, piece);
      for (const std::size_t decimals : table.decimals) append_whole(out, decimals);
      append_whole(out, table.rows.size());
      append_differences(numbers, table.rows, [](const Row& row) { return row.place; });
      append_differences(numbers, table.rows, [](const Row& row) { return row.topic; });
      for (std::size_t i = 0; i < table.decimals.size(); ++i) append_column(numbers, table, i, texts);
    }
    return out + numbers + texts;
  }

 private:
  std::deque<std::string> texts_;  // pieces and numbers point into these
  std::size_t size_ = 0;
  std::vector<std::uint64_t> times_;  // of all messages
  std::vector<Table> tables_;
  std::unordered_map<std::string, std::size_t> by_form_;
};

// Returns the packed form; nothing for a cut-off file, which has no index. Throws mcap::Error for a damaged file.
std::optional<std::string> packed(const std::filesystem::path& file) {
  mcap::Reader reader(file);
  if (!reader.indexed()) return {};  // only an index knows all topics and metadata beforehand
  std::string out(mcap::magic);
  mcap::append_record(out, mcap::Header{"regista"});
  for (const mcap::Metadata& each : reader.metadata()) mcap::append_record(out, each);
  std::vector<std::string> topics;
  std::unordered_map<std::uint16_t, std::size_t> topic_of;  // by channel
  for (const auto& [id, channel] : reader.channels()) {
    topic_of.emplace(static_cast<std::uint16_t>(id), topics.size());
    topics.push_back(channel.topic);
  }
  mcap::Compressor compressor(level);
  Tables tables;
  const auto finish = [&] {
    const std::string bytes = std::exchange(tables, {}).bytes(topics);
    const mcap::OpenRecord record(out, packed_messages);
    mcap::append_integer(out, std::uint64_t{bytes.size()});
    mcap::append_integer(out, mcap::checksum(bytes));
    compressor.append(out, bytes);
  };
  for (mcap::Message message; reader.next(message);) {
    tables.add(topic_of.at(static_cast<std::uint16_t>(message.channel)), message);
    if (tables.size() >= tables_size) finish();
  }
  if (tables.size() > 0) finish();
  mcap::append_data_end(out, 0);
  mcap::append_footer_fields(out, 0, 0);
  mcap::append_integer(out, std::uint32_t{0});
  out += mcap::magic;
  return out;
}

// Each placeholder occurs once in the viewer's page; name_place comes before recording_place (viewer/README.md).
constexpr std::string_view name_place = "@REGISTA_RECORDING_NAME@", recording_place = "@REGISTA_RECORDING@";
constexpr std::string_view head_begin = "<head>\n<meta charset=\"utf-8\">\n";

}  // namespace

std::string packed_recording(const std::filesystem::path& file) {
  try {
    if (auto out = packed(file)) return std::move(*out);
  } catch (const mcap::Error&) {
    // The file is damaged. The page gets it as it is and reads it as far as possible.
  }
  const mcap::InputFile whole(file);
  std::string out;
  whole.read(0, static_cast<std::size_t>(whole.size()), out);
  return out;
}

std::optional<std::string> match_page(std::string_view viewer, std::string_view recording, std::string_view name,
                                      std::string_view mark) {
  const std::size_t at_name = viewer.find(name_place), at_recording = viewer.find(recording_place);
  if (at_name == std::string_view::npos || at_recording == std::string_view::npos || at_recording < at_name) return {};
  std::string out;
  out.reserve(viewer.size() + recording.size() / 3 * 4 + 1000);
  // The mark comes after the declaration of the encoding, because browsers look for the declaration in the first bytes.
  const std::size_t head = viewer.find(head_begin), at_mark = head < at_name ? head + head_begin.size() : at_name;
  out += viewer.substr(0, at_mark);
  if (at_mark < at_name) out += mark;
  out += viewer.substr(at_mark, at_name - at_mark);
  out += texts::text(name).str();
  out += viewer.substr(at_name + name_place.size(), at_recording - at_name - name_place.size());
  texts::append_base64(out, recording);
  out += viewer.substr(at_recording + recording_place.size());
  return out;
}

}  // namespace regista::recording
