// SPDX-License-Identifier: MIT
// libFuzzer target: the messages of a recording, a line each (field, team, game, decision, belief). Build with clang
// and -DREGISTA_FUZZ=ON, run
//   mkdir CORPUS && bin/fuzz_recorded_match -max_len=8000 CORPUS
#include <unistd.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/recorded_match/recorded.hpp"
#include "mcap/encoding.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  if (!regista::mcap::is_utf8(rest)) return 0;
  regista::recording::RecordedTexts texts;
  for (std::string* text : {&texts.field, &texts.team, &texts.game, &texts.decision, &texts.belief}) {
    const std::size_t end = rest.find('\n');
    if (!rest.substr(0, end).empty()) *text = rest.substr(0, end);
    if (end == std::string_view::npos) break;
    rest.remove_prefix(end + 1);
  }
  static const std::string file = "/dev/shm/fuzz_recorded_match_" + std::to_string(getpid()) + ".mcap";
  regista::recording::write_recording(file, texts);
  regista::recording::show(file);
  return 0;
}
