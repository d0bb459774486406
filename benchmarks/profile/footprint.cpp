// SPDX-License-Identifier: MIT
// How much code and data a decision touches: reads every memory reference of a match from standard input, as valgrind's
// lackey writes it (--trace-mem=yes), and prints medians over the decisions between which no physics was computed.
// profile.py --footprint runs both.
//
//   footprint ENTRY MARK STEP    offsets in the program, hexadecimal: of its first instruction, of the function that
//                                 begins a decision, of that which computes a step of physics
//
// The program is loaded below the dynamic linker, which jumps to ENTRY: so that is the first instruction below
// 0x4000000 that comes from above and has ENTRY's place in a page.
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace {

constexpr std::uint64_t linker = 0x4000000, line = 64, page = 4096;

struct Decision {
  std::unordered_set<std::uint64_t> code, data, written, pages;  // lines of the cache, pages
  std::uint64_t instructions = 0, references = 0;
  bool physics = false;
  void clear() { *this = {}; }
};

std::uint64_t hexadecimal(std::string_view text) {
  std::uint64_t out = 0;
  std::from_chars(text.data(), text.data() + text.size(), out, 16);
  return out;
}

std::uint64_t median(std::vector<std::uint64_t> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: footprint ENTRY MARK STEP\n", stderr);
    return 2;
  }
  const std::uint64_t entry = hexadecimal(argv[1]);
  std::uint64_t mark = hexadecimal(argv[2]), step = hexadecimal(argv[3]);
  bool loaded = false, deciding = false;
  std::uint64_t before = 0;
  Decision now;
  std::vector<std::uint64_t> code, data, written, pages, instructions, references;
  char text[256];
  while (std::fgets(text, sizeof text, stdin) != nullptr) {
    // "I  04001000,3", " L 1ffeffe7e,8", " S ...", " M ..."
    const char kind = text[0] == 'I' ? 'I' : text[0] == ' ' ? text[1] : '\0';
    if (kind == '\0' || std::strchr("ILSM", kind) == nullptr || text[2] != ' ') continue;
    const std::uint64_t address = hexadecimal(std::string_view(text + 3));
    if (kind == 'I') {
      const bool jumped = address < linker && before >= linker;
      before = address;
      if (!loaded && jumped && address % page == entry % page) {
        loaded = true;
        mark += address - entry;
        step += address - entry;
      }
      if (loaded && address == mark) {
        if (deciding && !now.physics) {
          code.push_back(now.code.size() * line);
          data.push_back(now.data.size() * line);
          written.push_back(now.written.size() * line);
          pages.push_back(now.pages.size());
          instructions.push_back(now.instructions);
          references.push_back(now.references);
        }
        now.clear();
        deciding = true;
      }
    }
    if (!deciding) continue;
    if (kind == 'I') {
      if (address == step) now.physics = true;
      ++now.instructions;
      now.code.insert(address / line);
    } else {
      ++now.references;
      now.data.insert(address / line);
      if (kind != 'L') now.written.insert(address / line);
    }
    now.pages.insert(address / page);
  }
  if (code.empty()) {
    std::fputs("footprint: no decision was seen\n", stderr);
    return 1;
  }
  std::printf(
      "{\"decisions\": %zu, \"code_bytes\": %llu, \"data_bytes\": %llu, \"written_bytes\": %llu, "
      "\"pages\": %llu, \"instructions\": %llu, \"references\": %llu}\n",
      code.size(), static_cast<unsigned long long>(median(code)), static_cast<unsigned long long>(median(data)),
      static_cast<unsigned long long>(median(written)), static_cast<unsigned long long>(median(pages)),
      static_cast<unsigned long long>(median(instructions)), static_cast<unsigned long long>(median(references)));
  return 0;
}
