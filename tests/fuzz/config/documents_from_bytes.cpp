// SPDX-License-Identifier: MIT
#include "fuzz/config/documents_from_bytes.hpp"

#include <string>

#include "config/documents.hpp"
#include "config/parse.hpp"

namespace regista::config {
namespace {

// The next part of the bytes, which is taken off them.
std::string_view part(std::string_view& bytes) {
  const std::string_view first = bytes.substr(0, bytes.find('\x1e'));
  bytes.remove_prefix(std::min(bytes.size(), first.size() + 1));
  return first;
}

bool in_one_line(std::string_view text) {
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) return false;
  }
  return true;
}

}  // namespace

const char* check_documents_from(std::string_view bytes) {
  std::string shown;
  try {
    Node document = parse_text(part(bytes), "bytes.yaml");
    while (!bytes.empty()) document = override_with(document, {std::string(part(bytes))});
    shown = show(document);
  } catch (const Error& error) {
    return in_one_line(error.what()) ? "" : "the message has several lines";
  }
  // A flow map in one line may outgrow what a line may be.
  if (shown.size() > 60000) return "";
  try {
    const Node again = parse_text(shown, "shown.yaml");
    if (!same(again, parse_text(show(again), "shown_again.yaml"))) return "shown twice, the values differ";
  } catch (const Error&) {
    return "what was shown cannot be read";
  }
  return "";
}

}  // namespace regista::config
