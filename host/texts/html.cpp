// SPDX-License-Identifier: MIT
#include "texts/html.hpp"

#include <utility>

#include "texts/message.hpp"

namespace regista::texts {

namespace {

std::string escaped(std::string_view text) {
  constexpr std::string_view meant = "&<>\"'";
  constexpr std::string_view written[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string out;
  out.reserve(text.size());
  for (const char& c : text) {
    const std::size_t entity = meant.find(c);
    out += entity == meant.npos ? std::string_view(&c, 1) : written[entity];
  }
  return out;
}

// Encodes bytes for an address (RFC 3986): all bytes except unreserved characters and `also` become "%" and two digits.
std::string in_address(std::string_view bytes, std::string_view also) {
  std::string out;
  out.reserve(bytes.size());
  for (const char c : bytes) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~").find(c) != std::string_view::npos;
    const bool as_it_is = plain || also.find(c) != std::string_view::npos;
    out += as_it_is ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

}  // namespace

Html Html::made_by_us(std::string markup) {
  Html out;
  out.text_ = std::move(markup);
  return out;
}

// escaped() removes all markup, so made_by_us() is safe here.
Html text(std::string_view text) { return Html::made_by_us(escaped(visible(text))); }
Html lines(std::string_view text) { return Html::made_by_us(escaped(visible_lines(text))); }

Html data_address(std::string_view media_type, std::string_view bytes) {
  return text(fmt::format("data:{};charset=utf-8,{}", media_type, in_address(bytes, ",;:/=+@!()")));
}

// "./" comes before the path, because a browser would take a path that begins with "a:b" for an address of scheme "a".
Html path_address(std::string_view path) {
  const std::string address = in_address(path, "/");
  return text(path.starts_with('/') || path.starts_with('.') ? address : "./" + address);
}

}  // namespace regista::texts
