// SPDX-License-Identifier: MIT
// One instance of a plugin, with typed calls. Each call checks its status and the memory around its output; what it
// wrote is returned as it is. Throws CallFailed.
//
//   Instance striker_finder(greedy, EnvironmentBuilder{}.own(3), Values(greedy).set("reach", 20.0));
//   const std::vector<std::int32_t> columns = striker_finder.assign(scene, matrix);
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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
  Matrix(std::uint32_t rows, std::uint32_t columns, Growth growth = {})
      : rows_(rows),
        columns_(columns),
        stride_(columns + growth.bytes / static_cast<std::uint32_t>(sizeof(double))),
        values_(std::size_t{rows_} * stride_, std::numeric_limits<double>::quiet_NaN()) {
    for (std::uint32_t i = 0; i < rows; ++i) {
      for (std::uint32_t j = 0; j < columns; ++j) (*this)(i, j) = 0.0;
    }
  }
  double& operator()(std::size_t row, std::size_t column) { return values_.at(row * stride_ + column); }
  double operator()(std::size_t row, std::size_t column) const { return values_.at(row * stride_ + column); }
  std::uint32_t rows() const { return rows_; }
  std::uint32_t columns() const { return columns_; }
  regista_matrix raw() { return {values_.data(), rows_, columns_, stride_, 0}; }
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
  Instance(const Loaded& plugin, const EnvironmentBuilder& environment, const Values& values, Growth growth = {})
      : plugin_(plugin),
        growth_(growth),
        setting_(environment.build(growth)),
        host_(std::make_unique<RecordingHost>(64, growth)) {
    regista_error error{};
    {
      const Values own = values;  // texts end with create()
      std::vector<regista_value> raw = own.raw();
      guarded("create", error, [&] {
        instance_ = plugin_.descriptor().create(&setting_.raw(), host_->raw(), raw.data(), &error);
        return instance_ != nullptr ? REGISTA_OK : REGISTA_FAILED;
      });
    }
    setting_.end_of_create();
    try {
      reset(1);
    } catch (...) {
      plugin_.descriptor().destroy(instance_);
      throw;
    }
  }
  Instance(const Loaded& plugin, const EnvironmentBuilder& environment)
      : Instance(plugin, environment, Values(plugin)) {}
  ~Instance() { plugin_.descriptor().destroy(instance_); }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  RecordingHost& host() { return *host_; }

  void reset(std::uint64_t seed) {
    call("reset", [&](regista_error* error) { return plugin_.descriptor().reset(instance_, seed, error); });
  }

  // --- Predictor
  void predict(double dt, const regista_motion* motion = nullptr, const regista_frame* last = nullptr) {
    const auto& t = table<regista_predictor>(REGISTA_KIND_PREDICTOR, "predictor");
    call("predict", [&](regista_error* error) { return t.predict(instance_, dt, motion, last, error); });
  }
  void correct(std::span<const regista_measurement> measurements, const regista_visible_area& area) {
    const auto& t = table<regista_predictor>(REGISTA_KIND_PREDICTOR, "predictor");
    const Strided<regista_measurement> input(measurements, growth_);
    call("correct", [&](regista_error* error) { return t.correct(instance_, input.span(), &area, error); });
    if (!input.unchanged()) throw CallFailed("correct: wrote to the measurements");
  }
  void absorb(std::span<const regista_track> tracks, double age) {
    const auto& t = table<regista_predictor>(REGISTA_KIND_PREDICTOR, "predictor");
    const Strided<regista_track> input(tracks, growth_);
    call("absorb", [&](regista_error* error) { return t.absorb(instance_, input.span(), age, error); });
    if (!input.unchanged()) throw CallFailed("absorb: wrote to the tracks");
  }
  std::vector<regista_track> tracks(const Capacity& capacity = {}) {
    const auto& t = table<regista_predictor>(REGISTA_KIND_PREDICTOR, "predictor");
    Guarded<regista_track> out(capacity.tracks);
    std::uint32_t count = std::numeric_limits<std::uint32_t>::max();
    call(
        "tracks", [&](regista_error* error) { return t.tracks(instance_, out.data(), capacity.tracks, &count, error); },
        [&] { out.check("tracks"); });
    return out.take(count, "tracks");
  }

  // --- Context. The raw answer: a sound one is 0 or 1.
  std::int32_t holds(const Scene& scene) {
    const auto& t = table<regista_context>(REGISTA_KIND_CONTEXT, "context");
    std::int32_t out = -77;
    call("holds", [&](regista_error* error) { return t.holds(instance_, &scene.raw(), &out, error); });
    return out;
  }

  // --- Positioner
  Placed place(const Scene& scene, const Capacity& capacity = {}) {
    const auto& t = table<regista_positioner>(REGISTA_KIND_POSITIONER, "positioner");
    Guarded<regista_waypoint> points(capacity.points);
    Guarded<regista_edge> edges(capacity.edges);
    Guarded<regista_cell> cells(capacity.cells);
    Guarded<regista_vertex> vertices(capacity.vertices);
    regista_placement raw{};
    raw.point_capacity = capacity.points;
    raw.edge_capacity = capacity.edges;
    raw.cell_capacity = capacity.cells;
    raw.vertex_capacity = capacity.vertices;
    raw.points = points.data();
    raw.edges = edges.data();
    raw.cells = cells.data();
    raw.vertices = vertices.data();
    Grown<regista_placement> out(raw, growth_);
    call(
        "place", [&](regista_error* error) { return t.place(instance_, &scene.raw(), &out.get(), error); },
        [&] {
          points.check("points");
          edges.check("edges");
          cells.check("cells");
          vertices.check("vertices");
          if (!out.tail_unchanged()) throw CallFailed("place: wrote past the end of its output struct");
        });
    const regista_placement& got = out.get();
    return {points.take(got.point_count, "points"), edges.take(got.edge_count, "edges"),
            cells.take(got.cell_count, "cells"), vertices.take(got.vertex_count, "vertices")};
  }

  // --- Utility
  Matrix score(const Scene& scene) {
    const auto& t = table<regista_utility>(REGISTA_KIND_UTILITY, "utility");
    Matrix out(scene.rows(), scene.columns(), growth_);
    const regista_matrix raw = out.raw();
    call("score", [&](regista_error* error) { return t.score(instance_, &scene.raw(), &raw, error); });
    for (std::uint32_t i = 0; i < raw.rows; ++i) {
      for (std::uint32_t j = raw.columns; j < raw.stride; ++j) {
        if (out(i, j) == out(i, j)) throw CallFailed("score: wrote between the rows of its output");
      }
    }
    return out;
  }

  // --- Assigner
  bool negotiates() const {
    return (table<regista_assigner>(REGISTA_KIND_ASSIGNER, "assigner").flags & REGISTA_ASSIGNER_NEGOTIATES) != 0;
  }
  std::vector<std::int32_t> assign(const Scene& scene, Matrix utilities) {
    const auto& t = table<regista_assigner>(REGISTA_KIND_ASSIGNER, "assigner");
    const regista_matrix raw = utilities.raw();
    const std::vector<double> before(utilities.memory().begin(), utilities.memory().end());
    Guarded<std::int32_t> out(raw.rows);
    std::fill(out.data(), out.data() + raw.rows, std::int32_t{REGISTA_NO_TASK});
    call(
        "assign", [&](regista_error* error) { return t.assign(instance_, &scene.raw(), &raw, out.data(), error); },
        [&] { out.check("rows"); });
    if (!before.empty() && std::memcmp(before.data(), raw.values, before.size() * sizeof(double)) != 0) {
      throw CallFailed("assign: wrote to the utilities");
    }
    return out.take(raw.rows, "rows");
  }

  // --- Sender
  Sent decide(const Scene& scene, std::span<const regista_event> events, std::span<const regista_offer> offers,
              const regista_budget& budget) {
    const auto& t = table<regista_sender>(REGISTA_KIND_SENDER, "sender");
    const Strided<regista_event> happened(events, growth_);
    const Strided<regista_offer> pending(offers, growth_);
    const Grown<regista_budget> left(budget, growth_);
    Guarded<std::uint64_t> granted(static_cast<std::uint32_t>(offers.size()));
    regista_send raw{};
    raw.granted = granted.data();
    Grown<regista_send> out(raw, growth_);
    call(
        "decide",
        [&](regista_error* error) {
          return t.decide(instance_, &scene.raw(), happened.span(), pending.span(), &left.get(), &out.get(), error);
        },
        [&] {
          granted.check("granted");
          if (!out.tail_unchanged()) throw CallFailed("decide: wrote past the end of its output struct");
        });
    if (!happened.unchanged() || !pending.unchanged() || !left.unchanged()) {
      throw CallFailed("decide: wrote to its input");
    }
    return {out.get().send, out.get().reason, granted.take(out.get().granted_count, "granted")};
  }

  // --- Mailbox
  void transmitted(std::uint64_t handle) {
    const auto& t = table<regista_mailbox>(REGISTA_KIND_MAILBOX, "mailbox");
    call("transmitted", [&](regista_error* error) { return t.transmitted(instance_, handle, error); });
  }
  void dropped(std::uint64_t handle) {
    const auto& t = table<regista_mailbox>(REGISTA_KIND_MAILBOX, "mailbox");
    call("dropped", [&](regista_error* error) { return t.dropped(instance_, handle, error); });
  }
  void receive(int sender, std::span<const std::uint8_t> bytes, double time_sent, double time_heard) {
    const auto& t = table<regista_mailbox>(REGISTA_KIND_MAILBOX, "mailbox");
    const regista_message message{
        sender, REGISTA_MEDIUM_RADIO, time_sent, time_heard, bytes.data(), static_cast<std::uint32_t>(bytes.size()), 0};
    call("receive", [&](regista_error* error) { return t.receive(instance_, &message, error); });
  }

 private:
  // An output buffer with room behind it that must stay as it is.
  template <class T>
  class Guarded {
   public:
    explicit Guarded(std::uint32_t capacity)
        : capacity_(capacity), bytes_(detail::words((capacity + behind) * sizeof(T))), original_(bytes_) {}
    T* data() { return reinterpret_cast<T*>(bytes_.data()); }
    void check(const char* what) const {
      const std::size_t first = capacity_ * sizeof(T);
      if (std::memcmp(reinterpret_cast<const char*>(bytes_.data()) + first,
                      reinterpret_cast<const char*>(original_.data()) + first, behind * sizeof(T)) != 0) {
        throw CallFailed(std::string(what) + ": wrote past the capacity of " + std::to_string(capacity_));
      }
    }
    std::vector<T> take(std::uint32_t count, const char* what) {
      if (count > capacity_) {
        throw CallFailed(std::string(what) + ": says " + std::to_string(count) + " of at most " +
                         std::to_string(capacity_));
      }
      return {data(), data() + count};
    }

   private:
    static constexpr std::size_t behind = 4;
    std::size_t capacity_;
    std::vector<std::uint64_t> bytes_, original_;
  };

  template <class Table>
  const Table& table(std::int32_t kind, const char* name) const {
    const void* found = plugin_.descriptor().table(kind);
    if (found == nullptr) throw std::logic_error(std::string("this plugin is no ") + name);
    return *static_cast<const Table*>(found);
  }

  template <class Body>
  static void guarded(const char* name, regista_error& error, Body&& body) {
    const std::string head = std::string(name) + ": ";
    std::int32_t status = REGISTA_OK;
    try {
      status = body();
    } catch (...) {
      throw CallFailed(head + "threw an exception across the boundary");
    }
    if (std::memchr(error.text, 0, sizeof error.text) == nullptr) throw CallFailed(head + "error text does not end");
    if (status == REGISTA_OK) return;
    if (status != REGISTA_FAILED) throw CallFailed(head + "returned " + std::to_string(status));
    if (error.text[0] == '\0') throw CallFailed(head + "failed and did not say why");
    if (std::strchr(error.text, '\n') != nullptr) throw CallFailed(head + "its error has more than one line");
    throw CallFailed(head + error.text);
  }

  template <class Body>
  static void call(const char* name, Body&& body) {
    call(name, body, [] {});
  }
  // `memory` looks at the output's surroundings, also when the call failed.
  template <class Body, class Memory>
  static void call(const char* name, Body&& body, Memory&& memory) {
    regista_error error{};
    std::optional<CallFailed> failure;
    try {
      guarded(name, error, [&] { return body(&error); });
    } catch (const CallFailed& caught) {
      failure = caught;
    }
    memory();
    if (failure) throw *failure;
  }

  Loaded plugin_;
  Growth growth_;
  Setting setting_;
  std::unique_ptr<RecordingHost> host_;
  void* instance_ = nullptr;
};

}  // namespace regista::testkit
