// SPDX-License-Identifier: MIT
// Recordings for the fuzzer to begin with, with and without checksums: fuzz_mcap_seeds FOLDER
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>

#include "fuzz/mcap/examine.hpp"
#include "unit/mcap/example.hpp"
#include "unit/mcap/plain_chunks.hpp"

int main(int count, char** arguments) {
  using namespace regista::mcap;
  if (count != 2) {
    std::fputs("usage: fuzz_mcap_seeds FOLDER\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  write_example(folder / "zstd.mcap", {.chunk_size = 400}, 6);
  std::ifstream in(folder / "zstd.mcap", std::ios::binary);
  const std::string zstd{std::istreambuf_iterator<char>(in), {}};
  const std::string plain = with_plain_chunks(zstd);
  std::ofstream(folder / "plain.mcap", std::ios::binary) << plain;
  for (const auto& [name, bytes] : {std::pair<std::string, std::string>{"zstd", zstd}, {"plain", plain}}) {
    const std::string unguarded = without_checksums(bytes);
    std::ofstream(folder / (name + "_unguarded.mcap"), std::ios::binary) << unguarded;
    std::ofstream(folder / (name + "_unfinished.mcap"), std::ios::binary) << unguarded.substr(0, unguarded.size() - 1);
  }
  return 0;
}
