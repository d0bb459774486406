// SPDX-License-Identifier: MIT
#include "plugin/mailbox.hpp"

#include <gtest/gtest.h>

#include <array>

#include "plugin/utility.hpp"
#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

using MailboxTest = PuppetTest;

TEST_F(MailboxTest, IsThereOnlyForPluginsThatTakeMessages) {
  EXPECT_TRUE(Mailbox::of(instance_of(open("sound"))).has_value());
  EXPECT_FALSE(Mailbox::of(instance_of(open("sound", 1))).has_value());
}

TEST_F(MailboxTest, SharesTheInstanceWithTheOtherKinds) {
  const auto instance = instance_of(open("sound"));
  const std::array<std::uint8_t, 6> bytes{};
  const regista_message message{2, REGISTA_MEDIUM_RADIO, 1.0, 1.5, bytes.data(), 6, 0};
  Mailbox::of(instance)->receive(message);
  Scene scene(8);
  Matrix out(1, 8);
  Utility(instance).score(scene.frame, out.room);
  EXPECT_EQ(out(0, 7), 6.0);
}

TEST_F(MailboxTest, TellsWhatBecameOfAnOffer) {
  static std::vector<std::uint64_t> told;
  told.clear();
  Puppet::mailbox.transmitted = [](void*, std::uint64_t handle, regista_error*) {
    told.push_back(handle);
    return Puppet::ok;
  };
  Puppet::mailbox.dropped = [](void*, std::uint64_t handle, regista_error*) {
    told.push_back(1000 + handle);
    return Puppet::ok;
  };
  std::optional<Mailbox> mailbox = Mailbox::of(Puppet::instance());
  mailbox->transmitted(4);
  mailbox->dropped(5);
  EXPECT_EQ(told, (std::vector<std::uint64_t>{4, 1005}));
}

TEST_F(MailboxTest, ReportsFailures) {
  std::optional<Mailbox> mailbox = Mailbox::of(instance_of(open("throws")));
  EXPECT_EQ(message_of([&] { mailbox->transmitted(1); }), failure("throws", "transmitted: fell in transmitted"));
  EXPECT_EQ(message_of([&] { mailbox->dropped(1); }),
            failure("throws", "dropped: threw something that is no std::exception"));
  EXPECT_EQ(message_of([&] { mailbox->receive({}); }), failure("throws", "receive: fell in receive"));
}

}  // namespace
}  // namespace regista::plugin::test
