// SPDX-License-Identifier: MIT
// What an object holds, seen through its declaration: as a document, as JSON, compared with another of its kind, and
// with other files.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/node.hpp"
#include "config/show.hpp"

namespace regista::config {

// Every value that is in force, defaults too.
Node values_of(const Map& declared);

// Bytes that are no UTF-8, as names of files may have them, become U+FFFD.
std::string well_formed(const std::string& text);

// The same as the text of a document.
inline std::string document_text(const Map& declared) {
  return well_formed(show(declared, Node(), {}, Remarks::without));
}
template <class Document>
std::string document_text(Document document) {
  return document_text(declare(document));
}

// Maps, lists, texts, numbers, true, false and null.
nlohmann::ordered_json to_json(const Node& node);

// What differs in values that decide what comes of the document, a line each: "pairs: was 3, now 4". Which files are
// named is left out: what they hold is for those to compare who read them. now: its declaration.
std::vector<std::string> differences(const Node& before, const Map& now);

// Replaces the name of every file, as far as it is declared as one.
void rename_files(const Map& declared, const std::function<std::string(const std::string&)>& renamed);

}  // namespace regista::config
