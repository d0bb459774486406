// SPDX-License-Identifier: MIT
// Recordings for the fuzzer to begin with, with and without checksums: fuzz_mcap_seeds FOLDER
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "fuzz/mcap/examine.hpp"
#include "unit/mcap/example.hpp"

int main(int count, char** arguments) {
  using namespace regista::mcap;
  if (count != 2) {
    std::fputs("usage: fuzz_mcap_seeds FOLDER\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  for (const Compression compression : {Compression::none, Compression::zstd}) {
    const std::string name = compression == Compression::none ? "plain" : "zstd";
    const std::filesystem::path file = folder / (name + ".mcap");
    write_example(file, {.chunk_size = 400, .compression = compression}, 6);
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const std::string unguarded = without_checksums(bytes);
    std::ofstream(folder / (name + "_unguarded.mcap"), std::ios::binary) << unguarded;
    std::ofstream(folder / (name + "_unfinished.mcap"), std::ios::binary) << unguarded.substr(0, unguarded.size() - 1);
  }
  return 0;
}
