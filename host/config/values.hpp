// SPDX-License-Identifier: MIT
// Writes the values of a declared object as YAML or JSON, compares values and documents, and replaces file names.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/node.hpp"

namespace regista::config {

enum class Remarks { with, without };  // without: no comments, so that documents with equal values give equal texts

// Returns the object as YAML text, from which read() makes an equal object. Each value has a comment with unit, meaning
// and origin. `document` is the document from which the object was read. A value that `document` lacks is a default.
std::string show(const Map& map, const Node& document, std::span<const PluginDeclaration> plugins,
                 Remarks remarks = Remarks::with);

// Returns all values of the object as a document, including defaults.
Node values_of(const Map& declared);

// Returns the text of values_of() as a document. Bytes that are not UTF-8 (in file names) become U+FFFD.
std::string document_text(const Map& declared);
template <class Document>
std::string document_text(Document document) {
  return document_text(declare(document));
}

// Converts maps, lists, texts, numbers, true, false and null.
nlohmann::ordered_json to_json(const Node& node);

// Compares `before` with `now`. Returns one line for each difference that may change results (Field::decides): "pairs:
// was 3, now 4". Does not compare file names, because the caller compares the contents of the files.
std::vector<std::string> differences(const Node& before, const Map& now);

// The values of two documents at a path, each as YAML in one line; empty for a document without a value there.
struct Difference {
  std::string path;  // in the form that `--set` takes
  std::string first, second;
};

// Compares two documents. In each map the keys of `first` come first, then keys that only `second` has. Lists of named
// maps are compared name by name, other lists as a whole. An element or map that one document lacks is one difference.
std::vector<Difference> differences(const Node& first, const Node& second);

// Replaces every file name in the object by renamed(file name). File names are the values of the types File and Paths.
void rename_files(const Map& declared, const std::function<std::string(const std::string&)>& renamed);

}  // namespace regista::config
