// SPDX-License-Identifier: MIT
// Records a match as an MCAP file while it is played: events, beliefs and decisions. Foxglove and other MCAP readers
// open the file. Messages are JSON with a schema; docs/recordings.md describes them. Topics and their times:
//
//   /game                  ten times a second: clock, phase, score, penalties, packets left, true positions
//   /event                 each event of the referee
//   /play                  each shot, meant pass, clearance and duel, when its outcome is known
//   /packet                each packet that is sent and charged, with sender and reason
//   /heard                 each packet that a robot hears
//   /segment               what happened to bytes that a plugin offered for a packet
//   /log                   each line that a plugin writes
//   /draw                  each changed layer of plugin drawings in the field, at most twice a second
//   /decision/<side>/<n>   when the robot's context, kept tasks, assignment or role changed, when another robot took
//                          the same role, when play begins, and after 5 s without any of these
//   /belief/<side>/<n>     twice a second and when the robot's role changed
//
// World frame: origin at the centre, home attacks towards +x in the first half. Metres, seconds, radians. The metadata
// record "match" contains teams, roles, contexts and field.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "match/match.hpp"
#include "mcap/writer.hpp"
#include "mind/mind.hpp"
#include "recording/plugin_records.hpp"
#include "recording/recording_metadata.hpp"
#include "texts/json_text.hpp"

namespace regista::recording {

class MatchRecording {
 public:
  struct Options {
    bool replace = false;     // true: replaces an existing file; false: an existing file is an error
    bool background = false;  // true: a separate thread compresses and writes
    double at_stake = 2.0;    // s of the match that are lost at most if the process dies
  };
  // The plans of `setup` must outlive the recording. Every function throws mcap::Error if the file cannot be written.
  MatchRecording(const std::filesystem::path& file, const RecordedSetup& setup, const Options& options);
  ~MatchRecording();  // closes the file and hides errors; close() throws them
  MatchRecording(const MatchRecording&) = delete;
  MatchRecording& operator=(const MatchRecording&) = delete;

  // The caller must call these functions at the same moments as match::play calls its observers.
  void decided(const mind::Mind& mind, const match::Decision& turn);
  void event(double time, const match::Event& event, const match::GameState& state);
  void play(double time, const match::PlayEvent& event);
  void stepped(const match::Snapshot& snapshot);
  void close() { writer_.close(); }

 private:
  struct Channel {
    std::optional<mcap::ChannelId> id;  // missing: no message was written yet
    std::uint32_t count = 0;            // number of messages
  };
  struct Last {
    LastDecision written;                  // the last written decision; role -1 after a crash of the robot
    double decision = 0.0, belief = -1.0;  // s; times of the last written messages
    bool shares = false;  // the next decision is written: another robot took the same role, or play has begun
    Channel decisions, beliefs;
  };
  void add(Channel& channel, const std::string& name, std::string (*schema)());
  void write(Channel& channel, double time);
  // Adds the channel with its first message, because most matches do not need this channel.
  void write(Channel& channel, double time, const char* name, std::string (*schema)());
  void begin(double time);
  void begin_of_robot(double time, match::Side side, int robot);
  void write_segments(const mind::Mind& mind, const match::Decision& turn);
  void write_log(const mind::Mind& mind, const match::Decision& turn);
  void write_drawings(const mind::Mind& mind, const match::Decision& turn);
  void write_decision(Last& robot, match::Side side, const mind::Mind& mind, double time);
  void write_belief(Last& robot, match::Side side, const mind::Mind& mind, double time);

  std::array<const mind::TeamPlan*, 2> plans_;
  double at_stake_;
  mcap::Writer writer_;
  texts::JsonText json_;
  Channel game_, events_, plays_, packets_, heard_, segments_, log_, drawings_;
  std::array<mind::PacketLimits, 2> limits_;
  std::array<bool, 2> with_common_{};  // true: a context of the team uses the common world
  std::vector<mind::Segment> heard_segments_;
  SentSegments sent_;
  DrawnLayers layers_;
  std::array<std::vector<Last>, 2> last_;  // by side and number - 1
  std::uint64_t steps_ = 0;
  double chunk_began_ = 0.0;
  int half_ = 1;
  mind::Phase phase_ = mind::Phase::initial;
};

}  // namespace regista::recording
