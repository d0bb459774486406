// SPDX-License-Identifier: MIT
// A plugin that says more than a packet can take is found, and one that fits exactly is not.
#include "mind/coordination/unused_parts.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mind/world/mailboxes.hpp"
#include "team.hpp"

namespace regista::mind {
namespace {

std::vector<std::string> warned(int length, int packet_size = 128) {
  config::Team page = team();
  page.contexts[0].terms[1].weight = 0.1;
  page.contexts[0].terms[1].use = use("gossip", {{"length", std::to_string(length)}});
  page.contexts[0].terms[1].use.where = {"team.yaml", 7, 3};
  config::Rules rules;
  rules.messages.size = packet_size;
  const auto plan = plan_of(page, rules);
  std::vector<std::string> out;
  for (const config::Warning& each : unsendable_segment_warnings(*plan, unsendable_segments(*plan))) {
    out.push_back(to_string(each));
  }
  return out;
}

// Of a packet, for segments with their headings.
int room(int packet_size) { return static_cast<int>(Mailboxes(static_cast<std::size_t>(packet_size)).bytes_free()); }
constexpr int heading = static_cast<int>(segment_heading);

TEST(UnsendableSegments, WhatFitsExactlyIsNotWarnedOf) {
  EXPECT_EQ(warned(1), std::vector<std::string>{});
  EXPECT_EQ(warned(room(128) - heading), std::vector<std::string>{});
  EXPECT_EQ(warned(200, 1024), std::vector<std::string>{});
}

TEST(UnsendableSegments, WhatNoPacketCanTakeIsWarnedOfAtItsPluginsPlace) {
  ASSERT_EQ(room(128), 73);
  EXPECT_EQ(warned(72),
            std::vector<std::string>{"team.yaml:7:3: warning: gossip offers segments of 72 bytes, and a packet "
                                     "of these rules takes at most 71: its teammates never hear them"});
  EXPECT_EQ(warned(room(100) - heading + 1, 100).size(), 1u);
}

TEST(UnsendableSegments, OfTwoOfOnePluginTheOneThatOffersThemIsNamed) {
  config::Team page = team();
  page.contexts[0].terms[1].use = use("gossip", {{"length", "1"}});
  page.contexts[0].terms[1].use.where = {"team.yaml", 7, 3};
  page.contexts[0].terms.push_back({"louder", use("gossip", {{"length", "200"}}), 0.1, {}});
  page.contexts[0].terms[2].use.where = {"team.yaml", 8, 3};
  const auto plan = plan_of(page);
  const auto found = unsendable_segment_warnings(*plan, unsendable_segments(*plan));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].where.line, 8);
}

}  // namespace
}  // namespace regista::mind
