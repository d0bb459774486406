// SPDX-License-Identifier: MIT
#include "recording/match_page.hpp"

#include "texts/base64.hpp"
#include "texts/html.hpp"

namespace regista::recording {
namespace {

// viewer/README.md: once each, the name first.
constexpr std::string_view name_place = "@REGISTA_RECORDING_NAME@", recording_place = "@REGISTA_RECORDING@";

}  // namespace

std::optional<std::string> match_page(std::string_view viewer, std::string_view recording, std::string_view name) {
  const std::size_t at_name = viewer.find(name_place), at_recording = viewer.find(recording_place);
  if (at_name == std::string_view::npos || at_recording == std::string_view::npos || at_recording < at_name) return {};
  std::string out;
  out.reserve(viewer.size() + recording.size() / 3 * 4 + 1000);
  out += viewer.substr(0, at_name);
  out += texts::text(name).str();
  out += viewer.substr(at_name + name_place.size(), at_recording - at_name - name_place.size());
  texts::append_base64(out, recording);
  out += viewer.substr(at_recording + recording_place.size());
  return out;
}

}  // namespace regista::recording
