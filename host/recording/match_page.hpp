// SPDX-License-Identifier: MIT
// The page that plays a recording. The page contains viewer and recording, so it works from disk without a server.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace regista::recording {

// Largest recording (bytes) that a browser can hold as one text.
inline constexpr std::size_t largest_recording_in_a_page = std::size_t{256} << 20;

// Returns the viewer's page with the recording in it, or nothing if the page has no place for a recording, because it
// belongs to another version. viewer: the page built from viewer/. name: title. mark: markup for the top of the head.
std::optional<std::string> match_page(std::string_view viewer, std::string_view recording, std::string_view name,
                                      std::string_view mark = {});

}  // namespace regista::recording
