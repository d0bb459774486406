// SPDX-License-Identifier: MIT
// Laying one document over another: what `extends`, `--set path=value` and a context's `use:` have in common.
#pragma once

#include <string_view>

#include "config/node.hpp"

namespace regista::config {

// `over` laid over `base`: maps merge key by key, everything else replaces, null removes the key. A map that names
// another `plugin` than the one below it drops that plugin's `params` and `file`: they mean nothing to the new one.
// A map over a list whose elements have names lays each of its values over the element of that name; null removes it. A
// name that is not there adds an element, whose key `before` or `after` names the one that it stands beside; in one
// that is there, they move it. Locations stay those of the values. Throws Error at a null whose key is not there to be
// removed, at a name of no element that says no place, and at a place that is none.
Node merge(const Node& base, const Node& over);

// `value` laid over what stands at a dotted path of `document`. Elements of a list of maps are addressed by their
// `name`, of any list by their index from 0; null removes what is there. A path may end in keys that do not exist yet:
// whether they are known is for the reader to say, so everything created stands at `where`. Throws Error at `where`
// for a path that leads through a value without parts, or to an element that is not there.
Node with(const Node& document, std::string_view path, const Node& value, const Location& where);

// What stands at a path as with() understands it; absent where there is nothing.
Node value_at(const Node& document, std::string_view path);

}  // namespace regista::config
