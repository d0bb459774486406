// SPDX-License-Identifier: MIT
// What a user writes about roles in one text: entries "role: value", one a line or separated by commas, `#` starts a
// comment. A role is named as in the team's YAML; "list/role" means the one of that list alone, and goes before the
// same name without a list. Errors name the line, what is wrong and the nearest name.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace formations {

// A row of the team's table of roles.
struct Role {
  std::string name, list;
  int priority = 0;  // place in its list, 0 is the most important
};

// An entry for one row of the table.
struct RoleEntry {
  std::size_t row;
  std::string_view value;  // points into the text
  std::string where;       // "line 3: striker", for messages
};

// In order of the text, but entries with a list last, so that the last one about a row holds. `what` (the parameter's
// name) begins each message. Throws std::invalid_argument.
std::vector<RoleEntry> role_entries(std::string_view text, std::span<const Role> roles, std::string_view what);

// Splits at white space. Throws std::invalid_argument("<where>: ...") unless these are just `out.size()` finite
// numbers.
void read_numbers(std::string_view text, std::span<double> out, const std::string& where);

// Of what may be anything: short, on one line, printable.
std::string quoted(std::string_view text);

// The name that takes the fewest insertions, deletions and exchanges of letters; the first of equals. "" of none.
std::string nearest_name(std::string_view name, std::span<const std::string> names);

}  // namespace formations
