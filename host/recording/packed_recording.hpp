// SPDX-License-Identifier: MIT
// The page that plays a recording. It contains viewer and recording, so it works from disk without a server.
//
// A page holds a recording in packed form: every message complete, in two fifths of the bytes. Messages of one topic
// differ mostly in their numbers. So all messages with the same texts between their numbers form a table: these texts
// are written once, and each column of numbers as differences from row to row. The page makes a message from its table
// when the reader looks at it (viewer/src/recording/packed.ts).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mcap/encoding.hpp"

namespace regista::recording {

// The packed form is an MCAP file whose messages are in records of this kind, which other readers skip. Content of a
// record: the number of bytes of the tables as an 8-byte integer, their CRC-32, and the tables as a frame of zstd. The
// tables consist of integers (LEB128), signed integers (n is written as the integer 2 n, or -2 n - 1 if negative) and
// texts (after their length). Data of one kind are together, because they then compress better:
//   topics: their number, their names. Messages: their number, the differences of their log times (signed).
//   Tables: their number; for each table the number of columns, the pieces of text before, between and after the
//   columns, the decimals of each column, the number of rows. Then for each table: the differences between the
//   indices of its rows' messages (signed), between their topics (signed), and each column: 0 for a number that is
//   written as a text, otherwise 1 + the signed difference from the last number above that is not a text. At the end:
//   the texts of numbers.
inline constexpr auto packed_messages = static_cast<mcap::Opcode>(0x80);

// Returns the bytes for a page: the packed form, or the file itself if it is damaged or cut off; the page then says so.
std::string packed_recording(const std::filesystem::path& file);

// Largest recording (bytes) that a browser can hold as one text.
inline constexpr std::size_t largest_recording_in_a_page = std::size_t{256} << 20;

// Returns the viewer's page with the recording in it, or nothing if the page has no place for a recording, because it
// belongs to another version. viewer: the page built from viewer/. name: title. mark: markup for the top of the head.
std::optional<std::string> match_page(std::string_view viewer, std::string_view recording, std::string_view name,
                                      std::string_view mark = {});

}  // namespace regista::recording
