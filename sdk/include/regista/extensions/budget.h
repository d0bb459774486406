/* SPDX-License-Identifier: MIT
 *
 * Extension "regista.budget/0", a draft: the budget of packets for plugins that are no sender. Who negotiates can hold
 * urgent offers back when packets run short, or stop negotiating altogether. The host's side only: what
 * regista_host.extension gives. A host that has none gives null, and a plugin does without. C++: <regista/budget.hpp>.
 */
/* clang-format off */
#ifndef REGISTA_EXTENSIONS_BUDGET_H
#define REGISTA_EXTENSIONS_BUDGET_H

#include <stdint.h>

#include <regista/abi.h>

#define REGISTA_BUDGET_EXTENSION "regista.budget/0"

/* Lives as long as the instance that asked for it. */
typedef struct regista_budget_now {
  uint32_t size;
  uint32_t reserved;
  void* context;                     /* first argument of the call below */
  /* The same numbers as the sender of this decision gets. Its `size` is set by the caller: what it has room for. */
  void (*read)(void* context, regista_budget* out);
} regista_budget_now;

#endif /* REGISTA_EXTENSIONS_BUDGET_H */
