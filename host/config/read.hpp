// SPDX-License-Identifier: MIT
// A located document -> the object that a declaration is bound to.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "config/declaration.hpp"
#include "config/node.hpp"

namespace regista::config {

// Fills what the declaration is bound to. Throws Error at the first value that is not as declared. `what` is the path
// of the map, "" at the top of a document. Members whose key is missing keep their value.
void read(const Map& map, const Node& node, const std::string& what = "");

// What stands at a dotted path of a document (list elements by index); absent where there is nothing.
Node at(const Node& document, std::string_view path);

// Throws Error for a value that is sound by itself but cannot be played: at the first of the paths that the document
// has, at the whole document where none of them is.
[[noreturn]] void refuse(const Node& document, std::initializer_list<std::string_view> paths,
                         const std::string& reason);

}  // namespace regista::config
