// SPDX-License-Identifier: MIT
// What every call has in common: its status, its error text and the memory around its output are looked at.
#include <regista/testkit/instance.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <regista/testkit/room.hpp>

namespace regista::testkit {

namespace {

// An array of plain numbers with room behind it that must stay as it is.
template <class T>
class Guarded {
 public:
  Guarded(std::uint32_t capacity, const Layout& layout)
      : capacity_(capacity),
        memory_((capacity + (layout.guarded ? 0 : behind)) * sizeof(T), layout),
        bytes_(layout.guarded ? capacity * sizeof(T) : memory_.bytes()),
        original_(memory_.words().begin(), memory_.words().end()) {}
  // On guarded pages the last element ends where the memory does.
  T* data() { return reinterpret_cast<T*>(reinterpret_cast<char*>(memory_.data()) + memory_.bytes() - bytes_); }
  T& operator[](std::size_t index) { return data()[index]; }
  void check(const char* call, const char* what) const {
    const std::size_t first = capacity_ * sizeof(T);
    if (bytes_ == first) return;  // on guarded pages nothing lies behind
    if (std::memcmp(reinterpret_cast<const char*>(memory_.data()) + first,
                    reinterpret_cast<const char*>(original_.data()) + first, memory_.bytes() - first) != 0) {
      throw CallFailed(std::string(call) + ": " + what + ": wrote past the capacity of " + std::to_string(capacity_));
    }
  }
  std::vector<T> take(std::uint32_t count, const char* call, const char* what) {
    if (count > capacity_) {
      throw CallFailed(std::string(call) + ": " + what + ": says " + std::to_string(count) + " of at most " +
                       std::to_string(capacity_));
    }
    return {data(), data() + count};
  }

 private:
  static constexpr std::size_t behind = 4;
  std::size_t capacity_;
  Memory memory_;
  std::size_t bytes_;  // from data() to the end of the memory
  std::vector<std::uint64_t> original_;
};

// Bytes of a message, which a plugin may only read. On guarded pages the last one ends where the memory does.
class Payload {
 public:
  Payload(std::span<const std::uint8_t> bytes, const Layout& layout)
      : size_(bytes.size()), memory_(std::max<std::size_t>(size_, 1), {0, layout.guarded}) {
    std::ranges::copy(bytes, reinterpret_cast<std::uint8_t*>(memory_.data()) + memory_.bytes() - size_);
    original_.assign(memory_.words().begin(), memory_.words().end());
    memory_.make_read_only();
  }
  // Never null.
  const std::uint8_t* data() const {
    return reinterpret_cast<const std::uint8_t*>(memory_.data()) + memory_.bytes() - size_;
  }
  std::uint32_t size() const { return static_cast<std::uint32_t>(size_); }
  bool unchanged() const { return std::ranges::equal(memory_.words(), original_); }

 private:
  std::size_t size_;
  Memory memory_;
  std::vector<std::uint64_t> original_;
};

// A struct that a plugin writes, with memory behind it that must stay as it is.
template <class T>
Grown<T> struct_for_output(const T& value, const Layout& layout) {
  const std::uint32_t behind = layout.guarded ? 0 : 64;
  Grown<T> out(value, {layout.growth + behind, layout.guarded});
  out.get().size -= behind;
  return out;
}

// What is wrong with a room that was filled ends the call.
template <class T>
void examine(const WritableRoom<T>& room, const regista_room& written, const char* what) {
  if (const std::optional<std::string> damage = room.damage(written, what)) throw CallFailed(*damage);
}

template <class Table>
const Table& table(const Loaded& plugin, std::int32_t kind, const char* name) {
  const void* found = plugin.descriptor().table(kind);
  if (found == nullptr) throw std::logic_error(std::string("this plugin is no ") + name);
  return *static_cast<const Table*>(found);
}

template <class Body>
void guarded(const char* name, regista_error& error, Body&& body) {
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

// The output's surroundings are looked at when the call failed, too.
template <class Body, class Surroundings>
void call(RecordingHost& host, const char* name, Body&& body, Surroundings&& look_at_surroundings) {
  Guarded<regista_error> room(1, host.layout());
  regista_error& error = room[0];
  error = {};
  std::optional<CallFailed> failure;
  const auto allocated = [&host] { return host.allocated == nullptr ? 0 : host.allocated() - host.own_allocations; };
  const std::size_t allocated_before = allocated();
  const auto began = std::chrono::steady_clock::now();
  try {
    guarded(name, error, [&] { return body(&error); });
  } catch (const CallFailed& caught) {
    failure = caught;
  }
  if (host.costs != nullptr) {
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    const std::size_t allocations = allocated() - allocated_before;
    RecordingHost::CallCosts& costs = (*host.costs)[name];
    costs.seconds.push_back(took.count());
    if (host.allocated != nullptr) costs.allocations.push_back(allocations);
  }
  room.check(name, "error text");
  look_at_surroundings();
  if (failure) throw *failure;
  if (const std::string broken = host.take_broken(); !broken.empty())
    throw CallFailed(std::string(name) + ": " + broken);
}

template <class Body>
void call(RecordingHost& host, const char* name, Body&& body) {
  call(host, name, body, [] {});
}

}  // namespace

Matrix::Matrix(std::uint32_t rows, std::uint32_t columns, const Layout& layout)
    : rows_(rows),
      columns_(columns),
      stride_(columns + layout.growth / static_cast<std::uint32_t>(sizeof(double))),
      values_(std::size_t{rows_} * stride_, std::numeric_limits<double>::quiet_NaN()) {
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) (*this)(i, j) = 0.0;
  }
}

Instance::Instance(const Loaded& plugin, const EnvironmentBuilder& environment, const Values& values,
                   const Layout& layout)
    : plugin_(plugin),
      layout_(layout),
      setting_(environment.build(layout)),
      host_(std::make_unique<RecordingHost>(64, layout)) {
  host_->set_metrics(plugin.descriptor());
  regista_error error{};
  {
    const Values own = values;  // texts end with create()
    const Strided<regista_value> raw(own.raw(), layout);
    guarded("create", error, [&] {
      instance_ = plugin_.descriptor().create(&setting_.raw(), host_->raw(), raw.span(), &error);
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

Instance::Instance(const Loaded& plugin, const EnvironmentBuilder& environment)
    : Instance(plugin, environment, Values(plugin)) {}

Instance::~Instance() { plugin_.descriptor().destroy(instance_); }

void Instance::reset(std::uint64_t seed) {
  call(*host_, "reset", [&](regista_error* error) { return plugin_.descriptor().reset(instance_, seed, error); });
}

void Instance::predict(double dt, const regista_motion* motion, const regista_frame* last) {
  const auto& t = table<regista_predictor>(plugin_, REGISTA_KIND_PREDICTOR, "predictor");
  const Strided<regista_motion> moved(std::span(motion, motion == nullptr ? 0 : 1), layout_);
  const auto* const input = static_cast<const regista_motion*>(moved.span().data);
  call(*host_, "predict", [&](regista_error* error) { return t.predict(instance_, dt, input, last, error); });
  if (!moved.unchanged()) throw CallFailed("predict: wrote to the motion");
}

void Instance::correct(std::span<const regista_measurement> measurements, const regista_visible_area& area) {
  const auto& t = table<regista_predictor>(plugin_, REGISTA_KIND_PREDICTOR, "predictor");
  const Strided<regista_measurement> input(measurements, layout_);
  const Strided<regista_visible_area> visible(std::span(&area, 1), layout_);
  const auto* const view = static_cast<const regista_visible_area*>(visible.span().data);
  call(*host_, "correct", [&](regista_error* error) { return t.correct(instance_, input.span(), view, error); });
  if (!visible.unchanged()) throw CallFailed("correct: wrote to the visible area");
  if (!input.unchanged()) throw CallFailed("correct: wrote to the measurements");
}

void Instance::absorb(std::span<const regista_track> tracks, double age) {
  const auto& t = table<regista_predictor>(plugin_, REGISTA_KIND_PREDICTOR, "predictor");
  const Strided<regista_track> input(tracks, layout_);
  call(*host_, "absorb", [&](regista_error* error) { return t.absorb(instance_, input.span(), age, error); });
  if (!input.unchanged()) throw CallFailed("absorb: wrote to the tracks");
}

std::vector<regista_track> Instance::tracks(const Capacity& capacity) {
  const auto& t = table<regista_predictor>(plugin_, REGISTA_KIND_PREDICTOR, "predictor");
  WritableRoom<regista_track> out(capacity.tracks, layout_);
  Guarded<regista_room> raw(1, layout_);
  raw[0] = out.raw();
  call(
      *host_, "tracks", [&](regista_error* error) { return t.tracks(instance_, &raw[0], error); },
      [&] {
        raw.check("tracks", "room");
        examine(out, raw[0], "tracks: tracks");
      });
  return out.take(raw[0].count);
}

regista_track Instance::track_at(const regista_track& told, double age) {
  const auto& t = table<regista_predictor>(plugin_, REGISTA_KIND_PREDICTOR, "predictor");
  const Strided<regista_track> input(std::span(&told, 1), layout_);
  WritableRoom<regista_track> out(1, layout_);
  regista_room raw = out.raw();
  call(
      *host_, "track_at",
      [&](regista_error* error) {
        return t.track_at(instance_, static_cast<const regista_track*>(input.span().data), age,
                          static_cast<regista_track*>(raw.data), error);
      },
      [&] { examine(out, raw, "track_at"); });
  if (!input.unchanged()) throw CallFailed("track_at: wrote to the track");
  return out.take(1).front();
}

std::int32_t Instance::holds(const Scene& scene) {
  const auto& t = table<regista_context>(plugin_, REGISTA_KIND_CONTEXT, "context");
  Guarded<std::int32_t> out(1, layout_);
  out[0] = -77;
  call(
      *host_, "holds", [&](regista_error* error) { return t.holds(instance_, &scene.raw(), &out[0], error); },
      [&] { out.check("holds", "answer"); });
  return out[0];
}

Placed Instance::place(const Scene& scene, const Capacity& capacity) {
  const auto& t = table<regista_positioner>(plugin_, REGISTA_KIND_POSITIONER, "positioner");
  WritableRoom<regista_waypoint> points(capacity.points, layout_);
  WritableRoom<regista_edge> edges(capacity.edges, layout_);
  WritableRoom<regista_cell> cells(capacity.cells, layout_);
  WritableRoom<regista_vertex> vertices(capacity.vertices, layout_);
  regista_placement raw{};
  raw.points = points.raw();
  raw.edges = edges.raw();
  raw.cells = cells.raw();
  raw.vertices = vertices.raw();
  Grown<regista_placement> out = struct_for_output(raw, layout_);
  call(
      *host_, "place", [&](regista_error* error) { return t.place(instance_, &scene.raw(), &out.get(), error); },
      [&] {
        examine(points, out.get().points, "place: points");
        examine(edges, out.get().edges, "place: edges");
        examine(cells, out.get().cells, "place: cells");
        examine(vertices, out.get().vertices, "place: vertices");
        if (!out.tail_unchanged()) throw CallFailed("place: wrote past the end of its output struct");
      });
  const regista_placement& got = out.get();
  return {points.take(got.points.count), edges.take(got.edges.count), cells.take(got.cells.count),
          vertices.take(got.vertices.count)};
}

Matrix Instance::score(const Scene& scene) {
  const auto& t = table<regista_utility>(plugin_, REGISTA_KIND_UTILITY, "utility");
  Matrix out(scene.rows(), scene.columns(), layout_);
  Guarded<double> room(static_cast<std::uint32_t>(out.memory().size()), layout_);
  std::ranges::copy(out.memory(), room.data());
  regista_matrix_room matrix = out.room();
  double* const values = std::exchange(matrix.values, room.data());
  const Strided<regista_matrix_room> shape(std::span(&matrix, 1), layout_);
  const auto* const raw = static_cast<const regista_matrix_room*>(shape.span().data);
  call(
      *host_, "score", [&](regista_error* error) { return t.score(instance_, &scene.raw(), raw, error); },
      [&] { room.check("score", "utilities"); });
  if (!shape.unchanged()) throw CallFailed("score: wrote to the shape of its output");
  std::copy_n(room.data(), out.memory().size(), values);
  for (std::uint32_t i = 0; i < matrix.rows; ++i) {
    for (std::uint32_t j = matrix.columns; j < matrix.stride; ++j) {
      if (out(i, j) == out(i, j)) throw CallFailed("score: wrote between the rows of its output");
    }
  }
  return out;
}

bool Instance::negotiates() const {
  return (table<regista_assigner>(plugin_, REGISTA_KIND_ASSIGNER, "assigner").flags & REGISTA_ASSIGNER_NEGOTIATES) != 0;
}

std::vector<std::int32_t> Instance::assign(const Scene& scene, Matrix utilities) {
  const auto& t = table<regista_assigner>(plugin_, REGISTA_KIND_ASSIGNER, "assigner");
  const Strided<double> input(utilities.memory(), {0, layout_.guarded});
  regista_matrix matrix = utilities.raw();
  matrix.values = static_cast<const double*>(input.span().data);
  const Strided<regista_matrix> shape(std::span(&matrix, 1), layout_);
  const auto* const raw = static_cast<const regista_matrix*>(shape.span().data);
  Guarded<std::int32_t> out(matrix.rows, layout_);
  std::fill_n(out.data(), matrix.rows, std::int32_t{REGISTA_NO_TASK});
  call(
      *host_, "assign", [&](regista_error* error) { return t.assign(instance_, &scene.raw(), raw, out.data(), error); },
      [&] { out.check("assign", "columns"); });
  if (!input.unchanged() || !shape.unchanged()) throw CallFailed("assign: wrote to the utilities");
  return out.take(matrix.rows, "assign", "columns");
}

std::uint32_t Instance::reason_count() const {
  return table<regista_sender>(plugin_, REGISTA_KIND_SENDER, "sender").reason_count;
}

Sent Instance::decide(const Scene& scene, std::span<const regista_event> events, std::span<const regista_offer> offers,
                      const regista_budget& budget) {
  const auto& t = table<regista_sender>(plugin_, REGISTA_KIND_SENDER, "sender");
  const Strided<regista_event> happened(events, layout_);
  const Strided<regista_offer> pending(offers, layout_);
  Grown<regista_budget> left(budget, layout_);
  left.make_read_only();
  Guarded<std::uint64_t> granted(static_cast<std::uint32_t>(offers.size()), layout_);
  regista_send raw{};
  raw.granted = granted.data();
  Grown<regista_send> out = struct_for_output(raw, layout_);
  call(
      *host_, "decide",
      [&](regista_error* error) {
        return t.decide(instance_, &scene.raw(), happened.span(), pending.span(), &left.get(), &out.get(), error);
      },
      [&] {
        granted.check("decide", "granted");
        if (!out.tail_unchanged()) throw CallFailed("decide: wrote past the end of its output struct");
      });
  if (!happened.unchanged() || !pending.unchanged() || !left.unchanged()) {
    throw CallFailed("decide: wrote to its input");
  }
  return {out.get().send, out.get().reason, granted.take(out.get().granted_count, "decide", "granted")};
}

regista_action Instance::act(const Scene& scene, const BodyBuilder& body) {
  const auto& t = table<regista_behaviour>(plugin_, REGISTA_KIND_BEHAVIOUR, "behaviour");
  const Strided<regista_point> near(body.near(), layout_);
  regista_body raw = body.raw();
  raw.robots_near = near.span();
  Grown<regista_body> own(raw, layout_);
  own.make_read_only();
  regista_action empty{};
  empty.kick = REGISTA_NO_KICK;
  Grown<regista_action> out = struct_for_output(empty, layout_);
  const std::uint32_t size = out.get().size;
  call(
      *host_, "act",
      [&](regista_error* error) { return t.act(instance_, &scene.raw(), &own.get(), &out.get(), error); },
      [&] {
        if (!out.tail_unchanged()) throw CallFailed("act: wrote past the end of its output struct");
        if (out.get().size != size) throw CallFailed("act: wrote to the size of its output struct");
      });
  if (!own.unchanged() || !near.unchanged()) throw CallFailed("act: wrote to the body");
  regista_action action = out.get();
  action.size = sizeof action;
  return action;
}

void Instance::transmitted(std::uint64_t handle) {
  const auto& t = table<regista_mailbox>(plugin_, REGISTA_KIND_MAILBOX, "mailbox");
  call(*host_, "transmitted", [&](regista_error* error) { return t.transmitted(instance_, handle, error); });
}

void Instance::dropped(std::uint64_t handle) {
  const auto& t = table<regista_mailbox>(plugin_, REGISTA_KIND_MAILBOX, "mailbox");
  call(*host_, "dropped", [&](regista_error* error) { return t.dropped(instance_, handle, error); });
}

void Instance::receive(int sender, std::span<const std::uint8_t> bytes, double time_sent, double time_heard) {
  const auto& t = table<regista_mailbox>(plugin_, REGISTA_KIND_MAILBOX, "mailbox");
  const Payload payload(bytes, layout_);
  const regista_message heard{sender, REGISTA_MEDIUM_RADIO, time_sent, time_heard, payload.data(), payload.size(), 0};
  const Strided<regista_message> input(std::span(&heard, 1), layout_);
  const auto* const message = static_cast<const regista_message*>(input.span().data);
  call(*host_, "receive", [&](regista_error* error) { return t.receive(instance_, message, error); });
  if (!input.unchanged()) throw CallFailed("receive: wrote to the message");
  if (!payload.unchanged()) throw CallFailed("receive: wrote to the bytes of the message");
}

std::string Instance::describe(std::span<const std::uint8_t> bytes) {
  const auto& t = table<regista_mailbox>(plugin_, REGISTA_KIND_MAILBOX, "mailbox");
  if (t.size < offsetof(regista_mailbox, describe) + sizeof t.describe || t.describe == nullptr) return {};
  constexpr std::uint32_t capacity = 64;  // less than hosts give
  Guarded<char> text(capacity, layout_);
  text.data()[0] = '\0';
  const Payload payload(bytes, layout_);
  call(
      *host_, "describe",
      [&](regista_error* error) {
        return t.describe(instance_, payload.data(), payload.size(), text.data(), capacity, error);
      },
      [&] { text.check("describe", "text"); });
  if (!payload.unchanged()) throw CallFailed("describe: wrote to the bytes of the message");
  const std::string_view whole(text.data(), capacity);
  const std::size_t end = whole.find('\0');
  if (end == std::string_view::npos) throw CallFailed("describe: the text does not end within its capacity");
  const std::string_view said = whole.substr(0, end);
  if (said.find('\n') != std::string_view::npos) throw CallFailed("describe: more than one line");
  return std::string(said);
}

}  // namespace regista::testkit
