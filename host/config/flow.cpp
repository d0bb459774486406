// SPDX-License-Identifier: MIT
#include "config/flow.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace regista::config {
namespace {

bool plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' ||
         c == '+' || c == '-';
}

}  // namespace

std::string flow_text(std::string_view text, bool quoted) {
  const bool readable = !text.empty() && std::all_of(text.begin(), text.end(), plain);
  const bool marker = text.starts_with("-") && (text.size() == 1 || text == "---");
  const bool null = text == "null" || text == "Null" || text == "NULL" || text == "...";
  if (!quoted && readable && !marker && !null) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      out += fmt::format("\\x{:02x}", byte);
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string flow(const Node& node) {
  std::string out;
  switch (node.kind()) {
    case Node::Kind::scalar:
      return flow_text(node.text(), node.quoted());
    case Node::Kind::sequence:
      for (const Node& element : node.elements()) out += (out.empty() ? "" : ", ") + flow(element);
      return '[' + out + ']';
    case Node::Kind::map:
      for (const Node::Entry& entry : node.entries()) {
        out += fmt::format("{}{}: {}", out.empty() ? "" : ", ", flow_text(entry.key, false), flow(entry.value));
      }
      return '{' + out + '}';
    default:
      return "~";
  }
}

}  // namespace regista::config
