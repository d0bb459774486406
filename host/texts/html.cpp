// SPDX-License-Identifier: MIT
#include "texts/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "texts/visible.hpp"

namespace regista::texts {

namespace {

struct Entity {
  char meant;
  std::string_view written;
};
constexpr std::array<Entity, 5> entities{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}}};

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text) {
    const auto entity = std::ranges::find(entities, c, &Entity::meant);
    if (entity == entities.end())
      out += c;
    else
      out += entity->written;
  }
  return out;
}

// RFC 3986: what is not unreserved, and not among `also`, stands as its bytes in hexadecimal digits.
std::string in_address(std::string_view bytes, std::string_view also) {
  std::string out;
  out.reserve(bytes.size());
  for (const char c : bytes) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~").find(c) != std::string_view::npos;
    if (plain || also.find(c) != std::string_view::npos)
      out += c;
    else
      out += fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return out;
}

}  // namespace

Html Html::made_by_us(std::string markup) {
  Html out;
  out.text_ = std::move(markup);
  return out;
}

Html& Html::operator<<(Markup markup) {
  text_ += markup.view();
  return *this;
}

Html& Html::operator<<(const Html& other) {
  text_ += other.text_;
  return *this;
}

// Escaped a line above, so it is no markup any more.
Html text(std::string_view text) { return Html::made_by_us(escaped(visible(text))); }
Html lines(std::string_view text) { return Html::made_by_us(escaped(visible_lines(text))); }

Html data_address(std::string_view media_type, std::string_view bytes) {
  return text(fmt::format("data:{};charset=utf-8,{}", media_type, in_address(bytes, ",;:/=+@!()")));
}

// A colon in the first part would be taken for the end of a scheme: "./" stands before it.
Html path_address(std::string_view path) {
  const std::string address = in_address(path, "/");
  return text(path.starts_with('/') || path.starts_with('.') ? address : "./" + address);
}

}  // namespace regista::texts
