// SPDX-License-Identifier: MIT
// Lines for people: see <regista/extensions/log.h>.
//
//   void setup(const regista::Environment&, const regista::Host& host) { log_ = regista::Log(host); }
//   ...
//   log_.info("no free robot for the libero");
#pragma once

#include <cstdint>
#include <string_view>

#include <regista/extensions/log.h>
#include <regista/host.hpp>

namespace regista {

// Without a host that takes lines nothing happens.
class Log {
 public:
  Log() = default;
  explicit Log(const Host& host) : table_(host.extension<regista_log>(REGISTA_LOG_EXTENSION)) {}

  void debug(std::string_view line) const { write(REGISTA_LOG_DEBUG, line); }
  void info(std::string_view line) const { write(REGISTA_LOG_INFO, line); }
  void warning(std::string_view line) const { write(REGISTA_LOG_WARNING, line); }
  void error(std::string_view line) const { write(REGISTA_LOG_ERROR, line); }

 private:
  void write(std::int32_t level, std::string_view line) const {
    if (table_ != nullptr) table_->write(table_->context, level, line.data(), static_cast<std::uint32_t>(line.size()));
  }
  const regista_log* table_ = nullptr;
};

}  // namespace regista
