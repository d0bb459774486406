// SPDX-License-Identifier: MIT
// Bytes written out by hand from the specification, published checksums, limits of UTF-8.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mcap/encoding.hpp"

namespace regista::mcap {
namespace {

using std::string_literals::operator""s;

TEST(Checksum, IsTheOneOfIeee8023) {
  EXPECT_EQ(checksum("123456789"), 0xcbf43926u);  // the check value of CRC-32/ISO-HDLC
  EXPECT_EQ(checksum("6789", checksum("12345")), 0xcbf43926u);
  EXPECT_EQ(checksum(""), 0u);
}

TEST(Encode, RecordsAsTheSpecificationLaysThemOut) {
  std::string bytes;
  append_record(bytes, Header{"lib"});
  EXPECT_EQ(bytes,
            "\x01\x0b\0\0\0\0\0\0\0"
            "\0\0\0\0"
            "\x03\0\0\0lib"s);
  bytes.clear();
  append_record(bytes, Schema{SchemaId{0x0201}, "n", "e", "d"});
  EXPECT_EQ(bytes,
            "\x03\x11\0\0\0\0\0\0\0"
            "\x01\x02"
            "\x01\0\0\0n\x01\0\0\0e\x01\0\0\0d"s);
  bytes.clear();
  append_record(bytes, Channel{ChannelId{3}, SchemaId{4}, "/t", "json"});
  EXPECT_EQ(bytes,
            "\x04\x16\0\0\0\0\0\0\0"
            "\x03\0\x04\0\x02\0\0\0/t\x04\0\0\0json"
            "\0\0\0\0"s);
  bytes.clear();
  append_record(bytes, Metadata{"m", {{"k", "vv"}}});
  EXPECT_EQ(bytes,
            "\x0c\x14\0\0\0\0\0\0\0"
            "\x01\0\0\0m"
            "\x0b\0\0\0\x01\0\0\0k\x02\0\0\0vv"s);
  bytes.clear();
  append_record(bytes, Message{ChannelId{3}, 0x04030201, 0x0807060504030201, 1, "{}"});
  EXPECT_EQ(bytes,
            "\x05\x18\0\0\0\0\0\0\0"
            "\x03\0\x01\x02\x03\x04\x01\x02\x03\x04\x05\x06\x07\x08\x01\0\0\0\0\0\0\0{}"s);
  bytes.clear();
  append_fields(bytes, Opcode::message_index, ChannelId{3}, std::vector<MessagePlace>{{5, 6}});
  EXPECT_EQ(bytes,
            "\x07\x16\0\0\0\0\0\0\0"
            "\x03\0\x10\0\0\0\x05\0\0\0\0\0\0\0\x06\0\0\0\0\0\0\0"s);
  bytes.clear();
  append_data_end(bytes, 0x0a0b0c0d);
  EXPECT_EQ(bytes, "\x0f\x04\0\0\0\0\0\0\0\x0d\x0c\x0b\x0a"s);
}

TEST(Decode, IgnoresFieldsThatALaterVersionAdds) {
  std::string bytes;
  append_record(bytes, Channel{ChannelId{3}, SchemaId::none, "/t", "json"});
  const Channel channel = decode<Channel>(bytes.substr(record_prefix) + "more");
  EXPECT_EQ(channel.topic, "/t");
}

TEST(Decode, RefusesEveryRecordThatEndsTooEarly) {
  const auto refuses_shorter = [](const auto& record, auto decode, const std::string& what) {
    std::string bytes;
    append_record(bytes, record);
    const std::string content = bytes.substr(record_prefix);
    EXPECT_NO_THROW(decode(content)) << what;
    for (std::size_t length = 0; length < content.size(); ++length) {
      EXPECT_THROW(decode(std::string_view(content).substr(0, length)), Malformed)
          << what << ", " << length << " bytes";
    }
  };
  refuses_shorter(Header{"library"}, decode<Header>, "header");
  refuses_shorter(Schema{SchemaId{1}, "name", "encoding", "data"}, decode<Schema>, "schema");
  refuses_shorter(Channel{ChannelId{1}, SchemaId{1}, "topic", "json"}, decode<Channel>, "channel");
  refuses_shorter(Metadata{"name", {{"key", "value"}}}, decode<Metadata>, "metadata");
  refuses_shorter(ChunkIndex{1, 2, 3, 4, {{ChannelId{1}, 5}}, 6, "zstd", 7, 8}, decode<ChunkIndex>, "chunk index");
  refuses_shorter(MetadataIndex{1, 2, "name"}, decode<MetadataIndex>, "metadata index");
  refuses_shorter(Statistics{1, 2, 3, 4, 5, 6, 7, {{ChannelId{1}, 1}}}, decode<Statistics>, "statistics");
}

TEST(Utf8, TakesWhatRfc3629TakesAndNothingElse) {
  for (const std::string& good : {""s, "a\0b"s, "\x7f"s, "\xc2\x80"s, "\xdf\xbf"s, "\xe0\xa0\x80"s, "\xed\x9f\xbf"s,
                                  "\xee\x80\x80"s, "\xef\xbf\xbf"s, "\xf0\x90\x80\x80"s, "\xf4\x8f\xbf\xbf"s}) {
    EXPECT_TRUE(is_utf8(good)) << testing::PrintToString(good);
  }
  for (const std::string& bad :
       {"\x80"s, "\xc0\x80"s, "\xc1\xbf"s, "\xc2"s, "\xc2 "s, "\xe0\x9f\xbf"s, "\xed\xa0\x80"s, "\xe2\x82"s,
        "\xe2\x82 "s, "\xf0\x8f\xbf\xbf"s, "\xf4\x90\x80\x80"s, "\xf5\x80\x80\x80"s, "\xff"s, "ok\xfe"s}) {
    EXPECT_FALSE(is_utf8(bad)) << testing::PrintToString(bad);
  }
}

}  // namespace
}  // namespace regista::mcap
