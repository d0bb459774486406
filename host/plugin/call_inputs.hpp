// SPDX-License-Identifier: MIT
// The inputs of a plugin's call: every byte to which the call's arguments point, directly or indirectly. The host
// hashes the inputs before and after the call, so the host detects a plugin that writes to an input. The records of
// calls identify a plugin that fails, or a plugin whose answer depends on more than its arguments.
#pragma once

#include <regista/abi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "texts/bytes.hpp"

namespace regista::plugin {

class Inputs {
 public:
  // These functions add an input. Each `name` must be a string literal. A null pointer adds nothing.
  void add(const char* name, const void* data, std::size_t bytes) { add(name, "", data, bytes); }
  template <class T>
  void add(const char* name, const T* value) {
    add(name, value, value == nullptr ? 0 : sizeof(T));
  }
  void add(const char* name, const regista_span& elements) { add(name, "", elements); }
  void add(const char* name, const char* text);
  // These functions also add all data that the argument points to.
  void add(const char* name, const regista_frame* frame);
  void add(const char* name, const regista_matrix* matrix);
  void add(const char* name, const regista_message* message);
  void add(const char* name, const regista_body* body);
  void add(const char* name, const regista_environment* environment);

  // Returns the name of the most deeply nested input that has changed, such as "frame.mine.robots"; empty if no input
  // has changed. Follows no pointer that the plugin could have changed.
  std::string changed() const;

 private:
  struct Part {
    const char *whole, *part;  // for example "frame" and ".mine.robots"
    const void* data;
    std::size_t bytes;
    std::uint64_t fingerprint;
  };

  void add(const char* whole, const char* part, const void* data, std::size_t bytes);
  void add(const char* whole, const char* part, const regista_span& elements);
  void add(const char* whole, const char* part, const regista_matrix& matrix);
  void add_world(const char* whole, const char* const (&parts)[4], const regista_world* world);

  std::vector<Part> parts_;
};

// Makes a frame that contains only the data that a plugin declares to read (REGISTA_READS_*). All other data are null,
// empty or NaN. So the answer of a plugin that reads undeclared data differs from its answer to the complete frame.
class DeclaredReads {
 public:
  explicit DeclaredReads(std::uint32_t reads) : reads_(reads) {}

  // Returns a reduced copy of `frame`, valid until the next call of of().
  const regista_frame* of(const regista_frame& frame);

 private:
  struct World {
    regista_world raw{};
    regista_ball ball{};
    std::vector<regista_robot> robots;
    std::vector<regista_opponent> opponents;
  };
  bool reads(std::uint32_t part) const { return (reads_ & part) != 0; }
  const regista_world* shown(const regista_world& whole, std::uint32_t opponents, World& copy) const;

  std::uint32_t reads_;
  regista_frame frame_{};
  std::array<World, 2> worlds_;
  std::vector<regista_task> tasks_;
};

// --- Records of plugin calls: a note of the current call (CallNote), and a trail with the answer of each call. The
// note may be in memory that another process reads. If the process of a match dies, the process that started it reads
// there which plugin was working. The trail has each answer as one number. Two plays of the same match have equal
// arguments up to the first answer that differs. The plugin of this answer depends on more than its arguments.

// A note of the current or last call. Consists of plain bytes. If all bytes are zero, no plugin has been called yet.
struct CallNote {
  std::array<char, 64> plugin{};   // id of the plugin, cut if it is too long; ends with a zero
  std::array<char, 16> call{};     // name of the call, such as "assign"; ends with a zero
  std::uint64_t tick = 0;          // decision number of the robot
  std::int32_t robot = 0;          // robot number, from 1
  std::int32_t side = 0;           // 0 home, 1 away
  std::uint32_t inside = 0;        // 1 while the plugin works, 0 after its return
  const void* instance = nullptr;  // instance of `plugin`: an address in the process that writes the note
  friend bool operator==(const CallNote&, const CallNote&) = default;
};

struct CallAnswer;

// How often the host inspects the calls of a robot closely. In a close inspection the host checks all memory around the
// answer. With `often` and `always` the host also compares the inputs before and after the call.
enum class Inspection : std::uint8_t {
  seldom,   // inspects the calls of one decision in 127
  answers,  // inspects the calls of every decision, but does not compare inputs
  often,    // inspects the calls of one decision in 13
  always,   // inspects the calls of every decision
};

// What the host records and inspects of the calls of one side.
struct CallTracing {
  CallNote* note = nullptr;  // note to which calls write; null: calls write no note
  std::int32_t side = 0;
  Inspection look = Inspection::seldom;
  std::vector<CallAnswer>* trail = nullptr;  // null: no trail; a trail requires a note and Inspection::always
  bool hides = false;  // true: an inspected call gets only the data that its plugin declares to read
};

// Returns a plugin id in the form of CallNote::plugin.
inline std::array<char, 64> note_of_id(std::string_view id) {
  std::array<char, 64> out{};
  std::copy_n(id.data(), std::min(id.size(), out.size() - 1), out.data());
  return out;
}

struct CallAnswer {
  std::array<char, 64> plugin{};  // the members `plugin` and `call` have the form of CallNote
  std::array<char, 16> call{};
  std::uint64_t digest = 0;
  friend bool operator==(const CallAnswer&, const CallAnswer&) = default;
};

// Serializes an answer for another process: see texts/bytes.hpp.
template <class Archive>
void visit(Archive& archive, CallAnswer& answer) {
  for (char& each : answer.plugin) archive(each);
  for (char& each : answer.call) archive(each);
  archive(answer.digest);
}

// The XXH3 hash of values. Hashes each field of a struct, because the padding between fields may have any bytes.
class AnswerDigest {
 public:
  template <class... Values>
  AnswerDigest& operator()(const Values&... values) {
    (add(values), ...);
    return *this;
  }
  std::uint64_t value() const;

 private:
  template <class T>
  requires std::is_arithmetic_v<T>
  void add(T value) { bytes_(value); }
  template <class T, std::size_t N>
  requires std::is_arithmetic_v<T>
  void add(const T (&values)[N]) { bytes_.raw(values, sizeof values); }
  template <class T>
  void add(std::span<const T> list) {
    add(list.size());
    for (const T& each : list) add(each);
  }
  void add(const regista_waypoint& p) { operator()(p.x, p.y, p.score, p.task, p.robot); }
  void add(const regista_edge& e) { operator()(e.from, e.to); }
  void add(const regista_cell& c) { operator()(c.robot, c.first, c.count); }
  void add(const regista_vertex& v) { operator()(v.x, v.y); }
  void add(const regista_disc& d) { operator()(d.x, d.y, d.radius); }
  // Adds a track without the members that only some subjects of tracks have.
  void add(const regista_track& t) {
    operator()(t.label, t.flags, t.x, t.y, t.vx, t.vy, t.weight, t.age, t.covariance);
  }

  texts::BytesOut bytes_;
};

// The answers of one decision, in the order of the calls.
using CallTrail = std::vector<CallAnswer>;

// Largest number of answers in a trail, because a plugin may make any number of offers. add() ignores later answers.
inline constexpr std::size_t most_answers = 4096;

inline void add(CallTrail& trail, const CallNote& note, std::uint64_t digest) {
  if (trail.size() < most_answers) trail.push_back({note.plugin, note.call, digest});
}

// Adds the name of a host function, such as "offer", that the plugin called during the call that `note` describes.
inline void add(CallTrail& trail, const CallNote& note, std::string_view done, std::uint64_t digest) {
  if (trail.size() >= most_answers) return;
  CallAnswer& out = trail.emplace_back(CallAnswer{note.plugin, {}, digest});
  std::memcpy(out.call.data(), done.data(), std::min(done.size(), out.call.size() - 1));
}

}  // namespace regista::plugin
