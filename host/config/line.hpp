// SPDX-License-Identifier: MIT
// A text of one line that its writer chose freely, for people: what a scene shows, what an arm of an experiment is
// called.
#pragma once

#include <string>
#include <vector>

#include "config/declaration.hpp"

namespace regista::config {

// The text of a node, in one line. Throws Error at the node, "what: reason".
std::string to_line(const Node& node, const std::string& what);

// Empty is the same as not there.
Field line(std::string key, std::string& text, std::string doc);

// A list of them, each where it stands.
Field lines(std::string key, std::vector<Node>& texts, std::string doc);

}  // namespace regista::config
