// SPDX-License-Identifier: MIT
#include "plugin/shared_object.hpp"

#include <gtest/gtest.h>

namespace regista::plugin {
namespace {

// XXH3_128bits of nothing with seed 0, as the specification of xxHash gives it (tests of the reference implementation).
TEST(ContentHash, IsThePublishedOne) { EXPECT_EQ(content_hash(""), "99aa06d3014798d86001c324468d497f"); }

TEST(ContentHash, TellsContentsApart) {
  EXPECT_NE(content_hash("formation"), content_hash("formatioN"));
  EXPECT_NE(content_hash(std::string_view("\0", 1)), content_hash(""));
  EXPECT_EQ(content_hash("formation"), content_hash("formation"));
}

}  // namespace
}  // namespace regista::plugin
