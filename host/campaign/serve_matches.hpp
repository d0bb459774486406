// SPDX-License-Identifier: MIT
// What a fork server does (fork_server.hpp): reads teams, and copies itself for each match. Returns at the end of its
// connection, or when another must take its place. Throws config::BadInput where no coordinator has started it.
#pragma once

#include <string>

namespace regista::campaign {

// program: "regista 0.1.0", for recordings.
void serve_matches(const std::string& program);

}  // namespace regista::campaign
