// SPDX-License-Identifier: MIT
// What a page gets of a recording, unpacked by the words of packed_recording.hpp: every message, byte for byte.
#include "recording/packed_recording.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "mcap/encoding.hpp"
#include "mcap/writer.hpp"

namespace regista::recording {
namespace {

using Packed = std::tuple<std::string, std::uint64_t, std::string>;  // topic, log time, text

class PackedTables {
 public:
  explicit PackedTables(std::string_view bytes) : rest_(bytes) {}

  std::uint64_t whole() {
    std::uint64_t value = 0;
    for (int shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned char>(rest_.at(0));
      rest_.remove_prefix(1);
      value |= std::uint64_t{byte & 0x7fu} << shift;
      if (byte < 0x80) return value;
    }
  }
  static std::int64_t sign(std::uint64_t coded) {
    const auto half = static_cast<std::int64_t>(coded / 2);
    return coded % 2 == 0 ? half : -half - 1;
  }
  std::vector<Packed> messages() {
    std::vector<std::string> topics(whole());
    for (std::string& topic : topics) topic = take_text();
    const std::vector<std::int64_t> times = sums(whole());
    std::vector<Form> forms(whole());
    for (Form& form : forms) {
      form.decimals.resize(whole());
      form.pieces.resize(form.decimals.size() + 1);
      for (std::string& piece : form.pieces) piece = take_text();
      for (std::uint64_t& each : form.decimals) each = whole();
      form.rows = whole();
    }
    std::vector<std::vector<std::string>> parts(times.size());
    std::vector<std::string*> without;  // numbers that are texts
    std::vector<Packed> out(times.size());
    for (const Form& form : forms) {
      const auto places = sums(form.rows), channels = sums(form.rows);
      for (std::size_t row = 0; row < form.rows; ++row) {
        const auto place = static_cast<std::size_t>(places[row]);
        EXPECT_TRUE(parts.at(place).empty());
        parts.at(place).assign(2 * form.decimals.size() + 1, "");
        std::get<0>(out[place]) = topics.at(static_cast<std::size_t>(channels[row]));
        std::get<1>(out[place]) = static_cast<std::uint64_t>(times[place]);
        for (std::size_t i = 0; i < form.pieces.size(); ++i) parts[place][2 * i] = form.pieces[i];
      }
      for (std::size_t column = 0; column < form.decimals.size(); ++column) {
        double units = 0.0;
        for (const std::int64_t place : places) {
          std::string& number = parts[static_cast<std::size_t>(place)][2 * column + 1];
          if (const std::uint64_t coded = whole(); coded == 0) {
            without.push_back(&number);
          } else {
            units += static_cast<double>(sign(coded - 1));
            number = fmt::format("{:.{}f}", units / std::pow(10.0, static_cast<double>(form.decimals[column])),
                                 form.decimals[column]);
            if (form.decimals[column] > 0) number.erase(number.find_last_not_of('0') + 1);
            if (number.ends_with('.')) number.pop_back();
          }
        }
      }
    }
    for (std::string* number : without) *number = take_text();
    EXPECT_TRUE(rest_.empty());
    for (std::size_t i = 0; i < out.size(); ++i) {
      for (const std::string& part : parts[i]) std::get<2>(out[i]) += part;
    }
    return out;
  }

 private:
  struct Form {
    std::vector<std::string> pieces;
    std::vector<std::uint64_t> decimals;
    std::size_t rows = 0;
  };

  std::vector<std::int64_t> sums(std::size_t count) {
    std::vector<std::int64_t> values(count);
    for (std::int64_t sum = 0; std::int64_t & value : values) value = sum += sign(whole());
    return values;
  }
  std::string take_text() {
    const std::size_t length = whole();
    std::string out(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return out;
  }

  std::string_view rest_;
};

std::vector<Packed> unpacked_messages(std::string_view bytes) {
  std::vector<Packed> out;
  EXPECT_TRUE(bytes.starts_with(mcap::magic) && bytes.ends_with(mcap::magic));
  bytes.remove_suffix(mcap::magic.size());
  for (mcap::Decoder in(bytes.substr(mcap::magic.size())); !in.rest().empty();) {
    const mcap::RawRecord record = mcap::take_record(in);
    if (record.opcode != packed_messages) continue;
    mcap::Decoder content(record.content);
    const auto size = content.next<std::uint64_t>();
    const auto checksum = content.next<std::uint32_t>();
    std::string plain;
    mcap::Decompressor().decompress(content.rest(), size, plain);
    EXPECT_EQ(mcap::checksum(plain), checksum);
    std::ranges::move(PackedTables(plain).messages(), std::back_inserter(out));
  }
  return out;
}

class PackedRecordingTest : public testing::Test {
 protected:
  PackedRecordingTest() : file_(fmt::format("{}/packed_{}.mcap", testing::TempDir(), getpid())) {}
  ~PackedRecordingTest() override { std::filesystem::remove(file_); }

  std::string written(const std::vector<Packed>& messages) const {
    mcap::Writer writer(file_, {.replace = true});
    writer.write(mcap::Metadata{"match", {{"format", "1"}}});
    std::map<std::string, mcap::ChannelId> channels;
    for (const auto& [topic, time, text] : messages) {
      const auto [channel, added] = channels.try_emplace(topic);
      if (added) channel->second = writer.add_channel(topic, "json");
      writer.write({channel->second, 0, time, time, text});
    }
    writer.close();
    std::ifstream in(file_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  const std::filesystem::path file_;
};

TEST_F(PackedRecordingTest, HoldsEveryMessage) {
  std::vector<Packed> messages;
  std::mt19937 random(1);
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const auto number = [&] { return static_cast<double>(static_cast<int>(random() % 20'001) - 10'000); };
    messages.emplace_back(
        fmt::format("/decision/{}/{}", i % 2 == 0 ? "home" : "away", i % 7), i * 20'000'000,
        fmt::format(R"({{"time":{},"at":[{},{}],"utility":[[{},null],[{}]],"more":[{}]}})",
                    static_cast<double>(i) / 50.0, number() / 100.0, number() / 1000.0, number() / 1e5, number() / 1e8,
                    i % 5 == 0 ? "" : fmt::format("{},-0.5", number())));
  }
  const std::string file = written(messages), packed = packed_recording(file_);
  EXPECT_EQ(unpacked_messages(packed), messages);
  EXPECT_LT(packed.size(), file.size() / 2);
}

TEST_F(PackedRecordingTest, HoldsNumbersOfAnyFormAndTextOfAnyKind) {
  std::vector<Packed> messages;
  for (const char* text : {"",
                           "0",
                           "-0",
                           "-",
                           "--1",
                           "1.",
                           ".5",
                           "1.50",
                           "1.5",
                           "00",
                           "007",
                           "1e5",
                           "1e",
                           "-3e-05",
                           "6.856E+2",
                           "0a1b",
                           "1-2",
                           "3.2.1",
                           "2147483647",
                           "2147483648",
                           "-2147483648",
                           "99999999999",
                           "0.00001",
                           "0.000001",
                           "12345.67891",
                           "x1",
                           "\"é 7\"",
                           "0.1",
                           "-0.1",
                           "[1,2]",
                           "[1,2.25]",
                           "{\n  \"a\": 1 }"})
    messages.emplace_back(fmt::format("/{}", messages.size() % 3), 1'000'000'000 - 7 * (messages.size() % 2), text);
  messages.emplace_back("/0", 2, std::string("\0 5", 3));
  messages.emplace_back("/0", 1'790'000'000'123'456'789, std::string("5 \0", 3));
  messages.emplace_back("/0", 0, "\xff\x80");
  written(messages);
  EXPECT_EQ(unpacked_messages(packed_recording(file_)), messages);
}

TEST_F(PackedRecordingTest, LeavesADamagedFileAndOneThatIsCutOffAsTheyAre) {
  const std::string whole = written({{"/a", 1, "[1]"}, {"/a", 2, "[2]"}});
  std::string damaged = whole;
  damaged[damaged.find("zstd") + 20] ^= 1;
  for (const std::string& bytes : {whole.substr(0, whole.size() - 1), damaged}) {
    std::ofstream(file_, std::ios::binary) << bytes;
    EXPECT_EQ(packed_recording(file_), bytes);
  }
}

}  // namespace
}  // namespace regista::recording
