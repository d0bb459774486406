// SPDX-License-Identifier: MIT
// A recording as a page holds it: every message whole, in two fifths of the bytes. Messages of a topic differ in little
// but their numbers, so each form of message becomes a table: what stands between the numbers is written once, and each
// column of numbers as differences from row to row. The page puts a message together when it is looked at
// (viewer/src/recording/packed.ts).
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "mcap/records.hpp"

namespace regista::recording {

// The packed form is an MCAP file whose messages stand in records of this kind, which other readers skip. Content:
// bytes of the tables as 8-byte integer, their CRC-32, and the tables as a frame of zstd. The tables consist of
// integers (LEB128), signed integers (2 n, or -2 n - 1 if negative) and texts (after their length). Like stands with
// like:
//   topics: how many, texts. Messages: how many, differences of their log times (signed).
//   Tables: how many; for each how many columns, the pieces of text before, between and after them, the decimals of
//   each column, how many rows. For each table: differences of the rows' places among the messages (signed), of their
//   topics (signed), and each column: 0 for a number that is written as a text, otherwise 1 more than the signed
//   difference from the number above. The texts of these numbers.
inline constexpr auto packed_messages = static_cast<mcap::Opcode>(0x80);

// Returns the bytes for a page. A damaged or cut-off file stays as it is, so that the page says what is missing.
std::string packed_recording(const std::filesystem::path& file);

}  // namespace regista::recording
