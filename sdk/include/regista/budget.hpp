// SPDX-License-Identifier: MIT
// The budget of packets for plugins that are no sender: see <regista/extensions/budget.h>.
//
//   void setup(const regista::Environment&, const regista::Host& host) { budget_ = regista::BudgetNow(host); }
//   ... const std::optional<regista_budget> now = budget_.read(); urgent = now && now->packets_left > now->line;
#pragma once

#include <optional>

#include <regista/extensions/budget.h>
#include <regista/host.hpp>

namespace regista {

class BudgetNow {
 public:
  BudgetNow() = default;
  explicit BudgetNow(const Host& host) : table_(host.extension<regista_budget_now>(REGISTA_BUDGET_EXTENSION)) {}

  // Nothing: the host does not tell.
  std::optional<regista_budget> read() const {
    if (table_ == nullptr) return std::nullopt;
    regista_budget out{};
    out.size = sizeof out;
    table_->read(table_->context, &out);
    return out;
  }

 private:
  const regista_budget_now* table_ = nullptr;
};

}  // namespace regista
