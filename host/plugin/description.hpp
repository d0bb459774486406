// SPDX-License-Identifier: MIT
// What a plugin declares about itself: its descriptor, and a copy of the descriptor (Description) that needs no code of
// the plugin. The host checks the descriptor before using the plugin. A process can send a Description to another
// process. <regista/abi.h> defines the fields; <regista/extensions/metric.h> defines the metrics.
#pragma once

#include <regista/abi.h>
#include <regista/extensions/metric.h>

#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "texts/bytes.hpp"

namespace regista::plugin {

// A metric: a number about a match that a plugin declares.
struct DeclaredMetric {
  std::string name, unit, doc;
  std::int32_t combine = REGISTA_METRIC_SUM;
};

template <class Archive>
void visit(Archive& archive, DeclaredMetric& metric) {
  archive(metric.name, metric.unit, metric.doc, metric.combine);
}

// Returns the first mistake in a descriptor as one line; empty if the descriptor is valid. index: the descriptor's
// number in the shared object. Reads only fields that the declared ABI version has.
std::string what_is_wrong(const regista_descriptor& descriptor, std::uint32_t index);

// Returns the mistake in an id or in a parameter's name, such as "is not lower_snake_case"; empty for a valid name.
std::string wrong_with_name(std::string_view name);

// Returns parameter number `index`, which must be less than descriptor.parameter_count.
const regista_parameter& parameter(const regista_descriptor& descriptor, std::uint32_t index);

// Returns the call table of this kind, or null. `Table` is the struct of <regista/abi.h> for this kind.
template <class Table>
const Table* table(const regista_descriptor& descriptor, int kind) {
  return static_cast<const Table*>(descriptor.table(kind));
}

// Returns the name of a kind, such as "predictor".
std::string_view kind_name(int kind);

// Returns the closed range of a real or integer parameter, such as "0.5 to 20 m".
std::string range_text(const regista_parameter& parameter);

// Returns the names of the REGISTA_SUBJECT_* bits in `subjects`, such as "ball, opponents".
std::string subject_names(std::uint32_t subjects);

// Names of events, indexed by REGISTA_EVENT_*.
inline constexpr std::array<const char*, REGISTA_EVENT_COUNT> event_names{
    "period",     "whistle", "ball_found", "goalkeeper_saw_ball", "ball_known_again", "role_changed", "ball_moved",
    "pose_moved", "fell",    "got_up",     "phase_changed",       "context_changed",  "returned",     "offer"};

class Description {
 public:
  // Copies a descriptor that what_is_wrong() has accepted. Calls the `table` function of the descriptor.
  explicit Description(const regista_descriptor& live);
  // Reads the bytes that write() made. Throws std::out_of_range for damaged bytes.
  explicit Description(texts::BytesIn& bytes);
  Description(const Description&) = delete;
  Description& operator=(const Description&) = delete;

  void write(texts::BytesOut& bytes) const;

  // Returns the copied descriptor. This object owns its texts and parameters. All its function pointers are null.
  const regista_descriptor& declared() const { return declared_; }
  bool implements(int kind) const { return (kinds_ >> kind & 1u) != 0; }  // has a call table for this kind
  std::vector<int> kinds() const;                                         // REGISTA_KIND_* values, ascending
  std::uint32_t subjects() const { return subjects_; }                    // REGISTA_SUBJECT_* of a predictor
  std::uint32_t assigner_flags() const { return assigner_flags_; }        // REGISTA_ASSIGNER_*
  std::uint32_t purposes() const { return purposes_; }                    // REGISTA_BEHAVIOUR_*
  const std::vector<std::string>& reasons() const { return reasons_; }  // names of the sender's own reasons for sending
  const std::vector<DeclaredMetric>& metrics() const { return metrics_; }

 private:
  template <class Archive, class Text>
  void visit_all(Archive& archive, const Text& text);
  const char* keep(std::string text);

  regista_descriptor declared_{};
  std::uint32_t kinds_ = 0, subjects_ = 0, assigner_flags_ = 0, purposes_ = 0;
  std::deque<std::string> texts_;
  std::vector<regista_parameter> parameters_;
  std::deque<std::vector<const char*>> choices_;
  std::vector<std::string> reasons_;
  std::vector<DeclaredMetric> metrics_;
};

class PluginFile;

// A plugin whose descriptor was checked. Its code is loaded when its first instance is created.
struct Found {
  std::filesystem::path file;
  const regista_descriptor* descriptor = nullptr;  // checked descriptor; lives as long as `description`
  std::shared_ptr<const Description> description = std::make_shared<const Description>(*descriptor);
  std::shared_ptr<PluginFile> object = nullptr;  // null in tests that pass a descriptor of their own
  std::uint32_t index = 0;                       // index of the descriptor in the file
};

// Loads the plugin's file if necessary, and returns the descriptor in this file. Throws std::runtime_error with a
// one-line reason if the file cannot be loaded, for example because the file has changed.
const regista_descriptor& loaded(const Found& plugin);

// A file that the host could not open, or whose plugins must not be used.
struct Refused {
  std::filesystem::path file;
  std::string reason;  // one line
};

std::string to_string(const Refused&);  // "file: reason"

}  // namespace regista::plugin
