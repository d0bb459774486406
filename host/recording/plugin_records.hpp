// SPDX-License-Identifier: MIT
// What recordings and decision logs remember of each robot: its last decision, offered segments, recorded drawings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "match/side.hpp"
#include "mind/coordination/coordination.hpp"
#include "mind/extensions/plugin_log.hpp"
#include "mind/world/packet.hpp"
#include "texts/json_text.hpp"

namespace regista::recording {

// The last decision of a robot that was written to the file.
struct LastDecision {
  int context = -3, role = -3;  // no decision has these values
  std::vector<std::int32_t> kept, assignment;

  bool is(const mind::Decision& decision) const;
  void take(const mind::Decision& decision);
};

// --- Events of segments: a plugin offers bytes, the bytes leave in a packet or are dropped, teammates hear the packet.

// Finds the offer of a segment that a teammate heard. The packet has only the plugin's place and the bytes, not the
// handle of the offer, so each sent segment is found by sender, time of sending, and index in the packet.
class SentSegments {
 public:
  // Returns the handle that the offering robot gave to the offer of this event; 0 if there is no offer or the offer is
  // not known. The caller must pass every event of every mind in the order of time.
  std::uint64_t follow(match::Side side, int robot, const mind::SegmentEvent& event);

 private:
  struct Sent {
    std::int64_t milliseconds;  // ms; time of sending, as precise as in packets
    int at;                     // index of the segment in its packet
    std::uint64_t handle;
  };
  std::map<std::pair<match::Side, int>, std::vector<Sent>> sent_;  // by side and number
};

struct SegmentRecord {
  match::Side side;
  int robot;
  const mind::SegmentEvent& event;
  std::uint64_t handle;  // handle of the offer; 0: not known
  bool left;             // for a sent segment: its packet left the robot
};

// Writes "side":"home","robot":3,"segment":"offered", ... into an open JSON object (docs/recordings.md).
void write(texts::JsonText& json, const SegmentRecord& record);

// --- Drawings of plugins in the field. All drawings would be the largest part of a recording. Therefore a layer (the
// shapes that a plugin draws under one name) is recorded only when it has changed, and at most twice a second.

class DrawnLayers {
 public:
  struct Change {
    const char* plugin;
    std::string_view layer;
    std::string_view shapes;  // JSON list (docs/recordings.md); empty list: the layer is empty now
  };

  // Returns the changes to be recorded, which are valid until the next call. The caller must pass every decision of
  // every robot. direction: attack direction of the team, +1 or -1; it turns shapes into the world frame.
  std::span<const Change> follow(match::Side side, int robot, double time, std::span<const mind::DrawnShape> shapes,
                                 double direction);

 private:
  struct Layer {
    const char* plugin;
    std::string name, shapes;  // the shapes as last recorded
    double told = 0.0;         // s; time of the last record
  };
  std::map<std::pair<match::Side, int>, std::vector<Layer>> layers_;  // by side and number
  std::vector<std::size_t> layer_of_;  // index of the layer of each shape in the current call
  std::vector<Change> changes_;
  texts::JsonText json_;
};

}  // namespace regista::recording
