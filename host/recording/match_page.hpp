// SPDX-License-Identifier: MIT
// The page that plays a recording back: the viewer's page with the file inside, so that it works alone, from disk.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace regista::recording {

// What a browser can still hold as one text, in bytes of the recording.
inline constexpr std::size_t largest_recording_in_a_page = std::size_t{256} << 20;

// `viewer`: the page that viewer/ was built into. `name`: of the recording, for its title. Nothing where the viewer has
// no place for a recording: it belongs to another version.
std::optional<std::string> match_page(std::string_view viewer, std::string_view recording, std::string_view name);

}  // namespace regista::recording
