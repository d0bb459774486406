/* SPDX-License-Identifier: MIT
 *
 * Extension "regista.roles/0", a draft: what the team's page says of its roles beside the table of the environment,
 * from the moment an instance is created. The host's side only: what regista_host.extension gives. A host that has none
 * gives null, and a plugin does without. C++: <regista/roles.hpp>.
 */
/* clang-format off */
#ifndef REGISTA_EXTENSIONS_ROLES_H
#define REGISTA_EXTENSIONS_ROLES_H

#include <stdint.h>

#define REGISTA_ROLES_EXTENSION "regista.roles/0"

typedef struct regista_role_facts {
  uint32_t size;                     /* set by the caller: what it has room for */
  int32_t group;                     /* as of its task; -1 = none */
  int32_t moves;                     /* 1: the offset step may move its place to a waypoint; 0: it stays */
  int32_t purposes;                  /* REGISTA_BEHAVIOUR_*: what its behaviour is for */
  const char* behaviour;             /* name, as in the team's page; lives as long as the instance */
} regista_role_facts;

/* Lives as long as the instance that asked for it. */
typedef struct regista_roles {
  uint32_t size;
  uint32_t reserved;
  void* context;                     /* first argument of the call below */
  /* Of the role in this row of the environment's table. 1, or 0 and nothing is written: there is no such row. */
  int32_t (*role)(void* context, int32_t id, regista_role_facts* out);
} regista_roles;

#endif /* REGISTA_EXTENSIONS_ROLES_H */
