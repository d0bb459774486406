// SPDX-License-Identifier: MIT
// What the team's page says of its roles: see <regista/extensions/roles.h>.
//
//   void setup(const regista::Environment& environment, const regista::Host& host) {
//     const regista::Roles roles(host);
//     for (int id = 0; id < static_cast<int>(environment.roles().size()); ++id)
//     groups.push_back(roles.role(id)->group);
//   }
#pragma once

#include <optional>

#include <regista/extensions/roles.h>
#include <regista/host.hpp>

namespace regista {

using RoleFacts = regista_role_facts;

class Roles {
 public:
  Roles() = default;
  explicit Roles(const Host& host) : table_(host.extension<regista_roles>(REGISTA_ROLES_EXTENSION)) {}

  // Nothing: there is no such row, or the host does not tell.
  std::optional<RoleFacts> role(int id) const {
    RoleFacts out{};
    out.size = sizeof out;
    if (table_ == nullptr || table_->role(table_->context, id, &out) == 0) return std::nullopt;
    return out;
  }

 private:
  const regista_roles* table_ = nullptr;
};

}  // namespace regista
