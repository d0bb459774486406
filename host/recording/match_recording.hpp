// SPDX-License-Identifier: MIT
// A match as an MCAP file, written while it is played: what happened, what every robot believed, and how it decided.
// Foxglove and the other readers of MCAP open it; messages are JSON with a schema. docs/recordings.md says what is in
// them.
//
//   /game                  ten times a second: clock, phase, score, penalties, packets left, where everything truly is
//   /event                 of the referee, when it happens
//   /play                  each shot, meant pass, clearance and duel, when it is decided what became of it
//   /packet                when it is sent and charged, by whom and why
//   /heard                 when a robot hears a packet of another
//   /segment               what becomes of the bytes that plugins offer for packets; only where they offer some
//   /log                   lines that plugins write, and
//   /draw                  what they draw in the field, when it changes, each layer at most twice a second; only where
//   they do /decision/<side>/<n>   of a robot, when its context, kept tasks, assignment or role changed,
//                          when another robot has taken the same role or play begins, and after 5 s without any of
//                          these
//   /belief/<side>/<n>     of a robot, twice a second and when its role changed
//
// All of it in the world frame: origin at the centre, home attacks towards +x in the first half. Metres, seconds,
// radians. The metadata record "match" says who plays, with which roles and contexts, on which field.
#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "match/match.hpp"
#include "mind/mind.hpp"
#include "recording/about.hpp"

namespace regista::recording {

class MatchRecording {
 public:
  struct Options {
    bool replace = false;     // a file of this name, instead of refusing it
    bool background = false;  // a thread of its own compresses and writes
    double at_stake = 2.0;    // s of the match that are lost at most when the process dies
  };
  // The plans of `setup` outlive the recording. Every function throws mcap::Error when the file cannot be written.
  MatchRecording(const std::filesystem::path& file, const RecordedSetup& setup, const Options& options);
  ~MatchRecording();  // closes what close() has not
  MatchRecording(const MatchRecording&) = delete;
  MatchRecording& operator=(const MatchRecording&) = delete;

  // To be called as match::play calls its observers.
  void decided(const mind::Mind& mind, const match::Decision& turn);
  void event(double time, const match::Event& event, const match::GameState& state);
  void play(double time, const match::PlayEvent& event);
  void stepped(const match::Snapshot& snapshot);
  void close();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace regista::recording
