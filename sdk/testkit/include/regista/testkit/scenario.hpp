// SPDX-License-Identifier: MIT
// The part that all kinds' checks share: play a scenario with an instance, and play it again where the result must be
// the same. A kind says how one step of its scenario is played; the steps' outputs, byte for byte, are the trail.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include <regista/testkit/corners.hpp>
#include <regista/testkit/findings.hpp>
#include <regista/testkit/instance.hpp>
#include <regista/testkit/options.hpp>
#include <regista/testkit/scene.hpp>

namespace regista::testkit {

// Outputs of one step, as bytes.
class Trail {
 public:
  template <class T>
  void add(const T& value) {
    static_assert(std::has_unique_object_representations_v<T> || std::is_same_v<T, double>);
    append(&value, sizeof value);
  }
  // For structs of the ABI, which have no padding. (A track has some in its union: see add_tracks.)
  template <class T>
  void add_all(const std::vector<T>& values) {
    add(static_cast<std::uint64_t>(values.size()));
    append(values.data(), values.size() * sizeof(T));
  }
  // Of tracks what means something for their subject.
  void add_tracks(std::vector<regista_track> tracks, std::uint32_t subject) {
    if ((subject & (REGISTA_SUBJECT_SELF | REGISTA_SUBJECT_TEAMMATES)) != 0) {
      for (regista_track& track : tracks) {
        const regista_track_pose pose = track.pose;
        std::memset(track.motion, 0, sizeof track.motion);
        std::memcpy(&track.pose, &pose, sizeof pose);
      }
    }
    add_all(tracks);
  }
  friend bool operator==(const Trail&, const Trail&) = default;
  const std::vector<char>& bytes() const { return bytes_; }

 private:
  void append(const void* from, std::size_t count) {
    if (count == 0) return;
    const auto* first = static_cast<const char*>(from);
    bytes_.insert(bytes_.end(), first, first + count);
  }
  std::vector<char> bytes_;
};

// One scenario for one environment.
struct Scenario {
  EnvironmentBuilder environment;
  std::size_t steps = 0;
  std::function<std::string(std::size_t)> name;  // of a step
  // Plays step `index`; says what breaks a promise; writes its output to the trail. May throw CallFailed.
  std::function<void(Instance&, std::size_t index, const Showing&, Findings&, Trail&)> play;
};

// A scenario through scenes, for the kinds whose calls read a frame. For a team of `size`, of which this is robot
// own_number(size). play(instance, scene, index, findings, trail): one step, in which the scene may be of a later host
// or show less. call: what the step calls, for findings.
Scenario scenario_of_scenes(int size, const char* call, const std::vector<Scene>& scenario,
                            const std::function<void(Instance&, const Scene&, std::size_t, Findings&, Trail&)>& play);

namespace detail {

// `body(corner, scenario, findings)` for all of them; an instance that cannot be created is a finding.
Findings everywhere(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios,
                    const std::function<void(const Corner&, const Scenario&, Findings&)>& body);

// Plays one step; a failed call becomes a finding and part of the trail.
Trail step(const Scenario& scenario, Instance& instance, std::size_t index, const Showing& showing, Findings& findings);

}  // namespace detail

// Every output is as abi.h promises.
Findings check_promises(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios);

// Two instances side by side, and one of them after a reset, do the same.
Findings check_determinism(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios);

// Larger elements and structs, as of a host of a later minor version, change nothing.
Findings check_growth(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios);

// Everything that a plugin is given stands on pages of its own, what it may only read on read-only ones: whoever goes
// beyond ends the process with a fault, after a line on standard error. With default parameters alone.
Findings check_memory(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios);

// The life of instances: created and destroyed at once, reset again and again, many side by side, destroyed in any
// order.
Findings check_life(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios);

// What a plugin does not declare to read may be missing: that changes nothing.
Findings check_reads(const Loaded& plugin, const Options& options, const std::vector<Scenario>& scenarios);

}  // namespace regista::testkit
