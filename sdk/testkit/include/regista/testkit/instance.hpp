// SPDX-License-Identifier: MIT
// One instance of a plugin, with typed calls. Each call checks its status and the memory around its output; what it
// wrote is returned as it is. Throws CallFailed.
//
//   Instance striker_finder(greedy, EnvironmentBuilder{}.own(3), Values(greedy).set("reach", 20.0));
//   const std::vector<std::int32_t> columns = striker_finder.assign(scene, matrix);
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include <regista/testkit/body_builder.hpp>
#include <regista/testkit/environment_builder.hpp>
#include <regista/testkit/loaded.hpp>
#include <regista/testkit/recording_host.hpp>
#include <regista/testkit/scene.hpp>

namespace regista::testkit {

// what(): one line that begins with the call, e.g. "assign: no room for 12 tasks".
struct CallFailed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Robots x tasks in memory of its own.
class Matrix {
 public:
  Matrix(std::uint32_t rows, std::uint32_t columns, const Layout& layout = {});
  double& operator()(std::size_t row, std::size_t column) { return values_.at(row * stride_ + column); }
  double operator()(std::size_t row, std::size_t column) const { return values_.at(row * stride_ + column); }
  std::uint32_t rows() const { return rows_; }
  std::uint32_t columns() const { return columns_; }
  regista_matrix raw() const { return {values_.data(), rows_, columns_, stride_, 0}; }
  regista_matrix_room room() { return {values_.data(), rows_, columns_, stride_, 0}; }
  std::span<const double> memory() const { return values_; }

 private:
  std::uint32_t rows_, columns_, stride_;
  std::vector<double> values_;
};

struct Placed {
  std::vector<regista_waypoint> points;
  std::vector<regista_edge> edges;
  std::vector<regista_cell> cells;
  std::vector<regista_vertex> vertices;
};

struct Sent {
  std::int32_t send = 0, reason = 0;
  std::vector<std::uint64_t> granted;
};

// Room that a host gives: elements of each buffer.
struct Capacity {
  std::uint32_t points = 256, edges = 512, cells = 16, vertices = 512, tracks = 64;
};

class Instance {
 public:
  // Creates and resets with seed 1.
  Instance(const Loaded& plugin, const EnvironmentBuilder& environment, const Values& values,
           const Layout& layout = {});
  Instance(const Loaded& plugin, const EnvironmentBuilder& environment);
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  RecordingHost& host() { return *host_; }

  void reset(std::uint64_t seed);

  // --- Predictor
  void predict(double dt, const regista_motion* motion = nullptr, const regista_frame* last = nullptr);
  void correct(std::span<const regista_measurement> measurements, const regista_visible_area& area);
  void absorb(std::span<const regista_track> tracks, double age);
  std::vector<regista_track> tracks(const Capacity& capacity = {});
  // Only of predictors that have this call.
  regista_track track_at(const regista_track& told, double age);

  // --- Context. The raw answer: a sound one is 0 or 1.
  std::int32_t holds(const Scene& scene);

  // --- Positioner
  Placed place(const Scene& scene, const Capacity& capacity = {});

  // --- Utility
  Matrix score(const Scene& scene);

  // --- Assigner
  bool negotiates() const;
  std::vector<std::int32_t> assign(const Scene& scene, Matrix utilities);

  // --- Sender
  std::uint32_t reason_count() const;
  Sent decide(const Scene& scene, std::span<const regista_event> events, std::span<const regista_offer> offers,
              const regista_budget& budget);

  // --- Behaviour
  regista_action act(const Scene& scene, const BodyBuilder& body);

  // --- Mailbox
  void transmitted(std::uint64_t handle);
  void dropped(std::uint64_t handle);
  void receive(int sender, std::span<const std::uint8_t> bytes, double time_sent, double time_heard);
  // What the plugin says that these bytes say; empty when it has no words.
  std::string describe(std::span<const std::uint8_t> bytes);

 private:
  Loaded plugin_;
  Layout layout_;
  Setting setting_;
  std::unique_ptr<RecordingHost> host_;
  void* instance_ = nullptr;
};

}  // namespace regista::testkit
