// SPDX-License-Identifier: MIT
// What a robot tells its teammates: the role that it plays, the one that it wishes for, and how well it would play each
// role that it considers, in steps of 1/255 of the largest utility that can be told. Roles are named by their row in
// the team's table. For 19 roles, seven of which are considered, these are 11 bytes.
//
//   role, wish: as few bits as the number of roles needs, that number itself meaning none
//   one bit for each row of the table: whether a utility follows
//   the utilities, eight bits each, by row
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../negotiation/bits.hpp"

namespace role_exchange {

inline constexpr std::int32_t no_role = -1;
inline constexpr std::int16_t cannot = -1;  // a utility that is not told: the robot does not do this role
inline constexpr std::uint32_t most_steps = 255;

// The utilities have an element for each row of the table of roles: 0 to 255, or `cannot`.
struct Statement {
  std::int32_t role = no_role, wish = no_role;
  std::vector<std::int16_t> utilities;

  void forget(std::size_t roles) {
    role = wish = no_role;
    utilities.assign(roles, cannot);
  }
};

inline unsigned bits_of_a_role(std::size_t roles) { return static_cast<unsigned>(std::bit_width(roles)); }

// Of a statement that tells `told` utilities.
inline std::size_t message_bytes(std::size_t roles, std::size_t told) {
  return (2 * bits_of_a_role(roles) + roles + 8 * told + 7) / 8;
}

// role and wish: rows of the table, or no_role. Fills `bytes` from its beginning.
inline void write_statement(const Statement& statement, std::vector<std::uint8_t>& bytes) {
  const std::size_t roles = statement.utilities.size();
  const unsigned bits = bits_of_a_role(roles);
  negotiation::BitWriter out(bytes);
  for (const std::int32_t each : {statement.role, statement.wish}) {
    out.put(each == no_role ? static_cast<std::uint32_t>(roles) : static_cast<std::uint32_t>(each), bits);
  }
  for (const std::int16_t each : statement.utilities) out.put(each == cannot ? 0u : 1u, 1);
  for (const std::int16_t each : statement.utilities) {
    if (each != cannot) out.put(static_cast<std::uint32_t>(each), 8);
  }
}

// Reads whatever was sent. False: no statement about a table of so many roles; then `statement` is anything.
inline bool read_statement(std::span<const std::uint8_t> bytes, std::size_t roles, Statement& statement) {
  const unsigned bits = bits_of_a_role(roles);
  negotiation::BitReader in(bytes);
  statement.forget(roles);
  for (std::int32_t* each : {&statement.role, &statement.wish}) {
    const std::uint32_t row = in.get(bits);
    if (row > roles) return false;
    *each = row == roles ? no_role : static_cast<std::int32_t>(row);
  }
  for (std::int16_t& each : statement.utilities) each = in.get(1) != 0 ? std::int16_t{0} : cannot;
  for (std::int16_t& each : statement.utilities) {
    if (each != cannot) each = static_cast<std::int16_t>(in.get(8));
  }
  return in.complete();
}

}  // namespace role_exchange
