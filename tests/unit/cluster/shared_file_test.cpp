// SPDX-License-Identifier: MIT
#include "cluster/study_folder.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <thread>

namespace regista::cluster {
namespace {

namespace fs = std::filesystem;

class SharedFile : public testing::Test {
 protected:
  SharedFile() { fs::create_directory(folder); }
  ~SharedFile() override { fs::remove_all(folder); }

  void replace(const std::string& text) const {
    std::ofstream(folder / "fresh", std::ios::binary) << text;
    fs::rename(folder / "fresh", file);
  }

  fs::path folder = fs::path(testing::TempDir()) / ("shared-" + std::to_string(getpid()));
  fs::path file = folder / "file";
};

TEST_F(SharedFile, IsReadWhole) {
  std::string large(300'000, 'x');
  large[70'000] = '\0';
  for (const std::string& text : {std::string(), std::string("text\n"), large}) {
    replace(text);
    EXPECT_EQ(shared_content(file), text);
  }
}

TEST_F(SharedFile, MissingIsNotUnreadable) {
  EXPECT_EQ(shared_content(file), std::nullopt);
  EXPECT_EQ(shared_content(folder / "none" / "file"), std::nullopt);
  replace("text");
  EXPECT_EQ(shared_content(file / "below"), std::nullopt);
  EXPECT_THROW(shared_content(folder), std::system_error);
}

TEST_F(SharedFile, IsReadAgainWhileItIsStale) {
  using std::chrono::milliseconds;
  int left = 3;
  const ReadOnce stale = [&](const fs::path&, std::string& out) {
    out = "half";
    if (left-- > 0) return ESTALE;
    out = "text";
    return 0;
  };
  EXPECT_EQ(shared_content(file, stale, milliseconds(0)), "text");
  EXPECT_EQ(left, -1);
  left = 1'000'000;
  try {
    shared_content(file, stale, milliseconds(0));
    FAIL() << "it was stale for ever";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code().value(), ESTALE);
  }
  int asked = 0;
  const auto denied = [&](const fs::path&, std::string&) { return ++asked, EACCES; };
  EXPECT_THROW(shared_content(file, denied, milliseconds(0)), std::system_error);
  EXPECT_EQ(asked, 1);
}

TEST_F(SharedFile, IsNeverSeenHalfReplaced) {
  const std::string one(100'000, 'a'), other(200'000, 'b');
  replace(one);
  std::atomic<bool> done = false;
  std::thread writer([&] {
    for (int i = 0; i < 300; ++i) replace(i % 2 == 0 ? other : one);
    done = true;
  });
  while (!done) {
    const auto text = shared_content(file);
    EXPECT_TRUE(text == one || text == other);
  }
  writer.join();
}

}  // namespace
}  // namespace regista::cluster
