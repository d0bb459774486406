// SPDX-License-Identifier: MIT
#include "recording/match_page.hpp"

#include "texts/html.hpp"

namespace regista::recording {
namespace {

// Each placeholder occurs once in the viewer's page; name_place comes before recording_place (viewer/README.md).
constexpr std::string_view name_place = "@REGISTA_RECORDING_NAME@", recording_place = "@REGISTA_RECORDING@";
constexpr std::string_view head_begin = "<head>\n<meta charset=\"utf-8\">\n";

}  // namespace

std::optional<std::string> match_page(std::string_view viewer, std::string_view recording, std::string_view name,
                                      std::string_view mark) {
  const std::size_t at_name = viewer.find(name_place), at_recording = viewer.find(recording_place);
  if (at_name == std::string_view::npos || at_recording == std::string_view::npos || at_recording < at_name) return {};
  std::string out;
  out.reserve(viewer.size() + recording.size() / 3 * 4 + 1000);
  // The mark comes after the declaration of the encoding, because browsers look for the declaration in the first bytes.
  const std::size_t head = viewer.find(head_begin), at_mark = head < at_name ? head + head_begin.size() : at_name;
  out += viewer.substr(0, at_mark);
  if (at_mark < at_name) out += mark;
  out += viewer.substr(at_mark, at_name - at_mark);
  out += texts::text(name).str();
  out += viewer.substr(at_name + name_place.size(), at_recording - at_name - name_place.size());
  texts::append_base64(out, recording);
  out += viewer.substr(at_recording + recording_place.size());
  return out;
}

}  // namespace regista::recording
