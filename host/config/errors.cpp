// SPDX-License-Identifier: MIT
#include "config/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "texts/message.hpp"

namespace regista::config {

std::string to_string(const Location& where) {
  if (where.line == 0) return where.file;
  return fmt::format("{}:{}:{}", where.file, where.line, where.column);
}

Error::Error(Location where, const std::string& message)
    : std::runtime_error(texts::one_line(to_string(where) + ": " + message)),
      where_(std::move(where)),
      before_message_(texts::one_line(to_string(where_) + ": ").size()) {}

void Mistakes::add(const Error& mistake, std::string_view path) {
  if (after_ == After::stop) throw mistake;
  if (!path.empty()) doubt(path);
  if (total_ >= most_kept) {
    ++total_;
    return;
  }
  if (!said_.insert(mistake.what()).second) return;
  found_.push_back(mistake);
  ++total_;
}

bool Mistakes::mistaken(std::string_view path) const {
  for (std::size_t end = path.find('.'); end != std::string_view::npos; end = path.find('.', end + 1)) {
    if (doubted_.contains(path.substr(0, end))) return true;
  }
  return doubted_.contains(path);
}

bool Mistakes::doubtful(std::string_view path) const {
  if (mistaken(path)) return true;
  const std::string inside = std::string(path) + '.';
  const auto next = doubted_.lower_bound(inside);
  return next != doubted_.end() && next->starts_with(inside);
}

void Mistakes::take_over(const Mistakes& others) {
  for (const Error& each : others.found_) add(each, "");
  for (const Location& each : others.doubted_places_) {
    if (!doubtful_place(each)) doubt_place(each);
  }
}

bool Mistakes::doubtful_place(const Location& place) const {
  return std::ranges::find(doubted_places_, place) != doubted_places_.end();
}

std::vector<Error> Mistakes::in_order(std::string_view file) const {
  std::vector<Error> out = found_;
  const auto place = [file](const Error& mistake) {
    const Location& where = mistake.where();
    return std::tuple(where.file != file, std::string_view(where.file), where.line, where.column);
  };
  std::ranges::stable_sort(out, [&](const Error& a, const Error& b) { return place(a) < place(b); });
  return out;
}

}  // namespace regista::config
