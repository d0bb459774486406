// SPDX-License-Identifier: MIT
// The property that the fuzzer hunts for, held on a small corpus and on damaged copies of it.
#include <algorithm>
#include <random>
#include <vector>

#include "fuzz/config/documents_from_bytes.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

std::vector<std::filesystem::path> corpus() {
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"configs/rules", "configs/robots", "configs/disturbances", "configs/teams",
                             "configs/openings", "tests/fixtures/config", "tests/fixtures/config/corpus"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(project / folder)) {
      if (entry.is_regular_file()) files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Corpus, IsReadOrRefused) {
  ASSERT_GE(corpus().size(), 10u);
  for (const auto& file : corpus()) EXPECT_STREQ(check_documents_from(content_of(file)), "") << file;
}

TEST(Corpus, DamagedIsReadOrRefused) {
  std::mt19937 random(3);
  for (const auto& file : corpus()) {
    const std::string whole = content_of(file);
    if (whole.empty()) continue;
    for (int i = 0; i < 40; ++i) {
      std::string text = whole;
      const std::size_t at = random() % text.size();
      switch (random() % 4) {
        case 0:
          text.resize(at);
          break;
        case 1:
          text.erase(at, random() % 8);
          break;
        case 2:
          text[at] = "\"'{}[]:,#&*!|>-?%@`~\n \t0"[random() % 25];
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), random() % 40));
          break;
      }
      EXPECT_STREQ(check_documents_from(text), "") << file << '\n' << text;
    }
  }
}

}  // namespace
}  // namespace regista::config
