// SPDX-License-Identifier: MIT
// Any bytes as a recording: everything that the reader offers is asked for, every Error is an answer.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "mcap/file_io.hpp"
#include "mcap/reader.hpp"

namespace regista::mcap {

// How many messages came out. Chunks of up to 1 MiB are opened.
inline std::size_t examine(const std::filesystem::path& file) {
  std::size_t messages = 0;
  try {
    Reader reader(file, std::size_t{1} << 20);
    const auto read_on = [&] {
      Message message;
      // Every Error ends one chunk or the file, so this ends.
      while (true) {
        try {
          if (!reader.next(message)) return;
          if (!reader.channels().contains(message.channel)) std::abort();
          messages += 1;
        } catch (const Error&) {
        }
      }
    };
    read_on();
    reader.select({.first_time = 1, .last_time = 1'000'000'000, .topics = {"/truth"}});
    read_on();
    reader.select({.by_time = true});
    read_on();
  } catch (const Error&) {
  }
  return messages;
}

// Sets the checksums of a whole file to 0, "not available", so that changes elsewhere reach the code behind them.
inline std::string without_checksums(std::string bytes) {
  const auto u64 = [&](std::size_t at) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < 8; ++i) value |= std::size_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    return value;
  };
  const auto clear = [&](std::size_t at) { bytes.replace(at, 4, 4, '\0'); };
  for (std::size_t at = 8; at + 8 < bytes.size(); at += 9 + u64(at + 1)) {
    const std::size_t end = at + 9 + u64(at + 1);
    switch (static_cast<Opcode>(bytes[at])) {
      case Opcode::chunk:
        clear(at + 9 + 24);
        break;
      case Opcode::data_end:
      case Opcode::footer:
        clear(end - 4);
        break;
      default:
        break;
    }
  }
  return bytes;
}

}  // namespace regista::mcap
