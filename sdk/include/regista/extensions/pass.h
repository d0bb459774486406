/* SPDX-License-Identifier: MIT
 *
 * Extension "regista.pass/0", a draft: a behaviour says for which teammate a kick is meant. It changes nothing in the
 * match; it is how the host can count which passes were meant, and which of them arrived (metrics `meant_passes` and
 * others). The host's side only: what regista_host.extension gives. A host that has none gives null, and a plugin does
 * without. C++: <regista/pass.hpp>.
 */
/* clang-format off */
#ifndef REGISTA_EXTENSIONS_PASS_H
#define REGISTA_EXTENSIONS_PASS_H

#include <stdint.h>

#define REGISTA_PASS_EXTENSION "regista.pass/0"

/* Lives as long as the instance that asked for it. */
typedef struct regista_pass {
  uint32_t size;
  uint32_t reserved;
  void* context;                     /* first argument of the call below */
  /* From within `act`: the kick that this call asks for is meant for the teammate with this shirt number, not the own
   * one; else the match ends with an error, as for any other answer that breaks a promise. Without a kick it says
   * nothing. The last call counts. */
  void (*meant_for)(void* context, int32_t receiver);
} regista_pass;

#endif /* REGISTA_EXTENSIONS_PASS_H */
