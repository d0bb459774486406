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

#include <filesystem>
#include <memory>

#include "match/match.hpp"
#include "mind/mind.hpp"
#include "recording/recording_metadata.hpp"

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
  void close();

 private:
  struct Impl;
  std::unique_ptr<Impl> parts_;
};

}  // namespace regista::recording
