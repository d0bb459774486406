// SPDX-License-Identifier: MIT
#include "plugin/kinds.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

#include "plugin/description.hpp"
#include "puppet.hpp"
#include "regista/utility.hpp"

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
  EXPECT_EQ(Utility(instance).score(scene.frame, 1, 8)[7], 6.0);
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
  EXPECT_EQ(message_of([&] { mailbox->describe({}); }), failure("throws", "describe: fell in describe"));
}

// --- What bytes say --------------------------------------------------------------------------------------------------

// What the puppet writes to its room, byte by byte; nothing is written behind it.
std::string said;

class DescribeTest : public PuppetTest {
 protected:
  void SetUp() override {
    PuppetTest::SetUp();
    said.clear();
    Puppet::mailbox.describe = [](void*, const std::uint8_t*, std::uint32_t, char* text, std::uint32_t capacity,
                                  regista_error*) {
      said.copy(text, capacity);
      return Puppet::ok;
    };
  }
  static std::string described(const std::string& text) {
    said = text;
    return Mailbox::of(Puppet::instance())->describe({});
  }
  static std::string refused(const std::string& text) {
    return message_of([&] { described(text); });
  }
};

TEST_F(DescribeTest, GivesTheBytesAndTakesTheText) {
  Puppet::mailbox.describe = [](void*, const std::uint8_t* bytes, std::uint32_t count, char* text,
                                std::uint32_t capacity, regista_error*) {
    if (bytes == nullptr || text[0] != '\0') return static_cast<std::int32_t>(REGISTA_FAILED);
    std::snprintf(text, capacity, "%u bytes, the first is %u", count, bytes[0]);
    return Puppet::ok;
  };
  const std::array<std::uint8_t, 3> bytes{7, 8, 9};
  std::optional<Mailbox> mailbox = Mailbox::of(Puppet::instance());
  EXPECT_EQ(mailbox->describe(bytes), "3 bytes, the first is 7");
  EXPECT_EQ(mailbox->describe({}).substr(0, 7), "0 bytes") << "no null, and no text of the call before";
}

TEST_F(DescribeTest, PluginsWithoutWordsHaveNone) {
  Puppet::mailbox.describe = nullptr;
  EXPECT_EQ(described("words"), "");
  EXPECT_EQ(what_is_wrong(Puppet::descriptor(), 0), "");
  Puppet::mailbox.size -= 8;
  EXPECT_EQ(what_is_wrong(Puppet::descriptor(), 0),
            "plugin \"puppet\": table of the mailbox is 32 bytes; the interface needs 40");
}

TEST_F(DescribeTest, ChecksTheText) {
  EXPECT_EQ(described(std::string("für Robot 3\0", 13)), "für Robot 3");
  EXPECT_EQ(described(std::string(255, 'x') + '\0'), std::string(255, 'x'));
  EXPECT_EQ(refused(std::string(256, 'x')), Puppet::failure("describe: the text does not end within 256 bytes"));
  EXPECT_EQ(refused(std::string("two\nlines\0", 10)), Puppet::failure("describe: the text is not one line"));
  EXPECT_EQ(refused(std::string("\xff\0", 2)),
            Puppet::failure("describe: the text is no plain UTF-8: \"\xef\xbf\xbd\""));
  EXPECT_EQ(refused(std::string("\x1b[2J\0", 5)).substr(0, 110),
            Puppet::failure("describe: the text is no plain UTF-8: \"\\x1b[2J\"").substr(0, 110));
}

TEST_F(DescribeTest, FindsWhatIsWrittenElsewhere) {
  Puppet::mailbox.describe = [](void*, const std::uint8_t*, std::uint32_t, char* text, std::uint32_t capacity,
                                regista_error*) {
    text[capacity] = '!';
    return Puppet::ok;
  };
  EXPECT_EQ(message_of([] { described(""); }), Puppet::failure("describe: wrote past the end of its answer: text"));
}

// --- The SDK's way there ---------------------------------------------------------------------------------------------

struct Speaker {
  static constexpr auto id = "speaker", version = "1.0.0", summary = "Says what the test wants";
  static inline std::string words;
  void score(const Frame&, Utilities) {}
  void receive(const Message&) {}
  std::string describe(std::span<const std::uint8_t> bytes) const { return words + std::to_string(bytes.size()); }
};

TEST(SdkDescribe, CutsBetweenTwoCharacters) {
  static const regista_descriptor* const descriptor = regista::Plugin<Speaker, regista::utility>::descriptor();
  const auto described = [] { return Mailbox::of(instance_of({"speaker.so", descriptor}))->describe({}); };
  Speaker::words = "bytes: ";
  EXPECT_EQ(described(), "bytes: 0");
  Speaker::words = std::string(254, 'x') + "\u00fc";  // its second byte would be the 256th
  EXPECT_EQ(described(), std::string(254, 'x'));
  Speaker::words = std::string(253, 'x') + "\u00fc";
  EXPECT_EQ(described(), std::string(253, 'x') + "\u00fc");
}

}  // namespace
}  // namespace regista::plugin::test
