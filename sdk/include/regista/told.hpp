// SPDX-License-Identifier: MIT
// What robots said last: see <regista/extensions/told.h>.
//
//   void setup(const regista::Environment&, const regista::Host& host) { told_ = regista::Told(host); }
//   ... if (const std::optional<regista::ToldPacket> packet = told_.packet(3)) walk_from(packet->pose);
#pragma once

#include <cstdint>
#include <optional>

#include <regista/extensions/told.h>
#include <regista/host.hpp>

namespace regista {

using ToldPacket = regista_told_packet;

class Told {
 public:
  Told() = default;
  explicit Told(const Host& host) : table_(host.extension<regista_told>(REGISTA_TOLD_EXTENSION)) {}

  // Of a robot by its shirt number, the own last packet too. Nothing: none was heard, or the host tells none.
  std::optional<ToldPacket> packet(int number) const {
    ToldPacket out{};
    out.size = sizeof out;
    if (table_ == nullptr || table_->packet(table_->context, number, &out) == 0) return std::nullopt;
    return out;
  }
  // Nothing: the host does not tell.
  std::optional<bool> sees_ball() const {
    if (table_ == nullptr) return std::nullopt;
    return table_->sees_ball(table_->context) != 0;
  }
  // Shirt number, 0 = nobody. Nothing: the host does not tell.
  std::optional<int> receiver() const {
    if (table_ == nullptr) return std::nullopt;
    return table_->receiver(table_->context);
  }

 private:
  const regista_told* table_ = nullptr;
};

}  // namespace regista
