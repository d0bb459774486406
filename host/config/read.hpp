// SPDX-License-Identifier: MIT
// A located document -> the object that a declaration is bound to.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "config/declaration.hpp"
#include "config/mistakes.hpp"
#include "config/node.hpp"

namespace regista::config {

// Fills what the declaration is bound to. Tells of every value that is not as declared. `what` is the path of the map,
// "" at the top of a document. Members whose key is missing or whose value is mistaken keep their value; a list has an
// element for each of the document's, a mistaken one too.
void read(const Map& map, const Node& node, const std::string& what, Mistakes& mistakes);

// Throws Error at the first of them.
void read(const Map& map, const Node& node, const std::string& what = "");

// What stands at a dotted path of a document (list elements by index); absent where there is nothing.
Node at(const Node& document, std::string_view path);

// Throws Error for a value that is sound by itself but cannot be played: at the first of the paths that the document
// has, at the whole document where none of them is.
[[noreturn]] void refuse(const Node& document, std::initializer_list<std::string_view> paths,
                         const std::string& reason);

// The same as a mistake; nothing where one of the paths, by which it was found out, is doubtful itself.
void refuse(const Node& document, std::initializer_list<std::string_view> paths, const std::string& reason,
            Mistakes& mistakes);

}  // namespace regista::config
