// SPDX-License-Identifier: MIT
// Recordings that another program wrote anew: messages in another order, times since 1970, chunks of LZ4, damage. The
// pictures and what the page gets are those of the recording as it was.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <lz4frame.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "fuzz/recorded_match/recorded.hpp"
#include "mcap/reader.hpp"
#include "recording/moment_svg.hpp"
#include "unit/mcap/plain_chunks.hpp"

namespace regista::recording {
namespace {

using testing::HasSubstr;

struct Logged {
  std::string topic;
  std::uint32_t sequence = 0;
  std::uint64_t time = 0;  // ns
  std::string text;
  bool operator==(const Logged&) const = default;
};

constexpr int seconds = 60;

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::invalid_argument(from);
  return text.replace(at, from.size(), to);
}

// A match of a minute in which everything that a picture shows changes: ten states a second, a decision and a belief
// of home 1 each second, drawings of two layers and log lines now and then, some of one time.
std::vector<Logged> match() {
  std::vector<Logged> out;
  std::map<std::string, std::uint32_t> counts;
  const auto put = [&](const std::string& topic, int tenth, const std::string& text) {
    out.push_back({topic, counts[topic]++, static_cast<std::uint64_t>(tenth) * 100'000'000, text});
  };
  const RecordedTexts texts;
  for (int tenth = 1; tenth <= 10 * seconds; ++tenth) {
    const std::string time = fmt::format("\"time\":{}", tenth / 10.0);
    const auto own = [&](const std::string& rest) {
      return fmt::format(R"({{{},"side":"home","robot":1,"plugin":"voronoi",{}}})", time, rest);
    };
    std::string state = with(texts.game, "\"time\":1", time);
    state = with(state, "\"clock\":1", fmt::format("\"clock\":{}", tenth / 10.0));
    put("/game", tenth, with(state, "\"ball\":[1,0,0,0]", fmt::format("\"ball\":[{},1,0,0]", tenth % 37 / 10.0)));
    if (tenth % 10 == 3) {
      const std::string decision = with(texts.decision, "\"time\":1", time);
      put("/decision/home/1", tenth, with(decision, "[1,2,0]", fmt::format("[{},2,0]", tenth % 41 / 10.0)));
      put("/belief/home/1", tenth, with(texts.belief, "\"time\":1", time));
    }
    if (tenth % 7 == 0) {
      for (const char* layer : {"cells", "edges"}) {
        put("/draw", tenth,
            own(fmt::format(R"("layer":"{}","shapes":[{{"shape":"points","at":[[{},1]]}}])", layer,
                            tenth % 29 / 10.0)));
      }
    }
    if (tenth % 11 == 0) {
      for (const char* line : {"first", "second"})
        put("/log", tenth, own(fmt::format(R"("level":"info","text":"{} at {}")", line, tenth)));
    }
  }
  return out;
}

std::string lz4_frame(const std::string& bytes) {
  std::string out(LZ4F_compressFrameBound(bytes.size(), nullptr), '\0');
  out.resize(LZ4F_compressFrame(out.data(), out.size(), bytes.data(), bytes.size(), nullptr));
  return out;
}

class RewrittenRecordingTest : public testing::Test {
 protected:
  RewrittenRecordingTest() {
    std::string pattern = testing::TempDir() + "/rewritten_XXXXXX";
    folder_ = mkdtemp(pattern.data());
  }
  ~RewrittenRecordingTest() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

  std::filesystem::path write(const std::string& name, const std::vector<Logged>& messages,
                              std::size_t chunk_size = 20'000) const {
    const RecordedTexts texts;
    mcap::Writer writer(file(name), {.chunk_size = chunk_size, .replace = true});
    writer.write(mcap::Metadata{"match",
                                {{"format", "1"},
                                 {"program", "regista"},
                                 {"field", texts.field},
                                 {"ball_radius", "0.05"},
                                 {"home", texts.team},
                                 {"away", texts.team}}});
    std::map<std::string, mcap::ChannelId> channels;
    for (const Logged& each : messages) {
      const auto [channel, added] = channels.try_emplace(each.topic);
      if (added) channel->second = writer.add_channel(each.topic, "json");
      writer.write({channel->second, each.sequence, each.time, each.time, each.text});
    }
    writer.close();
    return file(name);
  }
  static std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::filesystem::path put(const std::string& name, std::string_view bytes) const {
    std::ofstream(file(name), std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return file(name);
  }

  // By topic, in the order of the file: what a page would take from it.
  static std::map<std::string, std::vector<Logged>> by_topic(const std::filesystem::path& path) {
    std::map<std::string, std::vector<Logged>> out;
    mcap::Reader reader(path);
    for (mcap::Message each; reader.next(each);) {
      const std::string topic = reader.channels().at(each.channel).topic;
      out[topic].push_back({topic, each.sequence, each.log_time, std::string(each.data)});
    }
    return out;
  }

  // At twenty moments and three readings of the clock, of home 1.
  static std::vector<std::string> pictures(const std::filesystem::path& path) {
    const RecordedMatch recorded(path);
    const RobotName robot{0, 1};
    std::vector<std::string> out;
    for (int i = 0; i < 20; ++i) out.push_back(moment_svg(recorded, recorded.at(1.0 + 2.93 * i, robot), robot));
    for (const char* typed : {"1/0:05", "1/0:29.5", "1/1:00"})
      out.push_back(std::to_string(time_of(recorded, parse_moment(typed))));
    return out;
  }

  // Writes what the page gets, and expects the recording as it was.
  void expect_same(const std::filesystem::path& path, const std::filesystem::path& original) const {
    EXPECT_EQ(pictures(path), pictures(original));
    const RecordedMatch recorded(path), whole(original);
    EXPECT_EQ(recorded.begin(), whole.begin());
    EXPECT_EQ(recorded.end(), whole.end());
    EXPECT_TRUE(whole.fits_page());
    EXPECT_FALSE(recorded.fits_page());
    std::filesystem::remove(file("copy.mcap"));
    recorded.write_for_page(file("copy.mcap"));
    EXPECT_EQ(by_topic(file("copy.mcap")), by_topic(original));
    EXPECT_TRUE(RecordedMatch(file("copy.mcap")).fits_page());
    EXPECT_EQ(RecordedMatch(file("copy.mcap")).damage(), "");
  }
  static std::string refusal(const std::filesystem::path& path) {
    try {
      const RecordedMatch recorded(path);
      return "read; " + recorded.damage();
    } catch (const mcap::Error& error) {
      return error.what();
    }
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(RewrittenRecordingTest, TheOrderOfMessagesDoesNotMatter) {
  const std::vector<Logged> ordered = match();
  const std::filesystem::path original = write("ordered.mcap", ordered);
  EXPECT_GT(mcap::Reader(original).statistics()->chunks, 10u);
  std::mt19937 random(1);
  // By about a second, by 20 s, and wherever they like.
  for (const std::size_t reach : {std::size_t{15}, std::size_t{300}, ordered.size()}) {
    std::vector<Logged> shuffled = ordered;
    for (std::size_t begin = 0; begin < shuffled.size(); begin += reach) {
      const auto first = shuffled.begin() + static_cast<std::ptrdiff_t>(begin);
      std::shuffle(first, first + static_cast<std::ptrdiff_t>(std::min(reach, shuffled.size() - begin)), random);
    }
    const std::filesystem::path path = write("shuffled.mcap", shuffled);
    expect_same(path, original);
    // Cut off, so that no index helps.
    const std::string bytes = bytes_of(path);
    EXPECT_EQ(pictures(put("cut.mcap", std::string_view(bytes).substr(0, bytes.size() - 1))), pictures(original));
  }
  std::vector<Logged> reversed(ordered.rbegin(), ordered.rend());
  expect_same(write("reversed.mcap", reversed), original);
  // One topic behind the other, as programs do that merge files.
  std::vector<Logged> merged = ordered;
  std::ranges::stable_sort(merged, {}, &Logged::topic);
  expect_same(write("merged.mcap", merged), original);
}

TEST_F(RewrittenRecordingTest, LogTimesMayCountFrom1970OrFromAnyTime) {
  const std::vector<Logged> ordered = match();
  const std::filesystem::path original = write("ordered.mcap", ordered);
  constexpr std::uint64_t in_2026 = 1'790'000'000'123'456'789;
  std::vector<Logged> later = ordered, earlier = ordered;
  for (Logged& each : later) each.time += in_2026;
  for (Logged& each : earlier) each.time -= 90'000'000;
  expect_same(write("later.mcap", later), original);
  expect_same(write("earlier.mcap", earlier), original);
  std::shuffle(later.begin(), later.end(), std::mt19937(2));
  expect_same(write("both.mcap", later), original);
}

TEST_F(RewrittenRecordingTest, ChunksMayBeOfLz4) {
  const std::filesystem::path original = write("ordered.mcap", match());
  const std::string packed = mcap::with_packed_chunks(bytes_of(original), {"lz4", lz4_frame});
  expect_same(put("lz4.mcap", packed), original);
  const std::filesystem::path other =
      put("bz2.mcap", mcap::with_packed_chunks(bytes_of(original), {"bz2", [](const std::string& s) { return s; }}));
  EXPECT_THAT(refusal(other), HasSubstr(" that is compressed by \"bz2\"; this program reads zstd, lz4 and uncompressed "
                                        "chunks; holds no state of the game"));
}

TEST_F(RewrittenRecordingTest, OfAFileThatIsCutOffThePageSaysSo) {
  const std::filesystem::path original = write("ordered.mcap", match());
  const std::string packed = mcap::with_packed_chunks(bytes_of(original), {"lz4", lz4_frame});
  const std::filesystem::path path = put("cut.mcap", std::string_view(packed).substr(0, packed.size() / 2));
  const RecordedMatch recorded(path);
  EXPECT_THAT(recorded.damage(), HasSubstr(": is cut off at byte "));
  EXPECT_FALSE(recorded.fits_page());
  recorded.write_for_page(file("copy.mcap"));
  const RecordedMatch copy(file("copy.mcap"));
  EXPECT_THAT(copy.damage(), HasSubstr(": is cut off at byte "));
  EXPECT_TRUE(copy.fits_page());
  EXPECT_EQ(copy.end(), recorded.end());
  EXPECT_EQ(by_topic(file("copy.mcap")), by_topic(path));
}

// In the only chunk, so that nothing else is left of the match.
TEST_F(RewrittenRecordingTest, OfDamageTheFirstCauseIsNamed) {
  const std::string bytes = mcap::with_plain_chunks(bytes_of(write("whole.mcap", match(), std::size_t{1} << 24)));
  const std::string whole = refusal(put("plain.mcap", bytes));
  EXPECT_EQ(whole, "read; ");
  const std::size_t chunk = bytes.find("\"set_play\"") - 1;  // inside of its first message
  for (const std::size_t further : {0u, 5000u, 60'000u}) {
    std::string changed = bytes;
    changed[chunk + further] = static_cast<char>(changed[chunk + further] ^ 1);
    const std::string why = refusal(put("damaged.mcap", changed));
    EXPECT_THAT(why, testing::MatchesRegex(
                         ".*/damaged.mcap: is damaged at byte [0-9]+: the checksum of a chunk is wrong; holds no "
                         "state of the game"));
    const std::size_t byte = std::stoul(why.substr(why.find("at byte ") + 8));
    EXPECT_EQ(bytes[byte], '\x06');  // there the chunk begins
    // Without the summary the chunk is the whole content, too.
    EXPECT_THAT(refusal(put("damaged.mcap", changed.substr(0, changed.size() - 1))),
                HasSubstr(fmt::format(": is damaged at byte {}: the checksum of a chunk is wrong; ", byte)));
  }
  // Where some of it is left, it is shown, and the damage is reported; no page is made of what does not fit.
  std::vector<Logged> reversed = match();
  std::ranges::reverse(reversed);
  std::string several = mcap::with_plain_chunks(bytes_of(write("several.mcap", reversed)));
  const std::size_t inside = several.find("\"set_play\"", several.size() / 2);
  several[inside] = static_cast<char>(several[inside] ^ 1);
  const RecordedMatch recorded(put("several.mcap", several));
  EXPECT_THAT(recorded.damage(), HasSubstr(": is damaged at byte "));
  EXPECT_FALSE(recorded.fits_page());
  EXPECT_THROW(recorded.write_for_page(file("copy.mcap")), mcap::Error);
}

}  // namespace
}  // namespace regista::recording
