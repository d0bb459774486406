// SPDX-License-Identifier: MIT
// What a plugin declares about itself, as a copy that needs no code of the plugin: it can be made in one process and
// read in another.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <regista/abi.h>

#include "plugin/declared_metrics.hpp"
#include "texts/bytes.hpp"

namespace regista::plugin {

class Description {
 public:
  // Copies a descriptor that was checked (what_is_wrong() is empty). Calls its `table`.
  explicit Description(const regista_descriptor& live);
  // From the bytes that write() made. Throws std::out_of_range for damaged ones.
  explicit Description(texts::BytesIn& bytes);
  Description(const Description&) = delete;
  Description& operator=(const Description&) = delete;

  void write(texts::BytesOut& bytes) const;

  // Texts and parameters belong to this description; the calls are null.
  const regista_descriptor& declared() const { return declared_; }
  bool implements(int kind) const { return (kinds_ >> kind & 1u) != 0; }
  std::uint32_t subjects() const { return subjects_; }                  // REGISTA_SUBJECT_*, of a predictor
  std::uint32_t assigner_flags() const { return assigner_flags_; }      // REGISTA_ASSIGNER_*
  std::uint32_t purposes() const { return purposes_; }                  // REGISTA_BEHAVIOUR_*
  const std::vector<std::string>& reasons() const { return reasons_; }  // of a sender, its own
  const std::vector<DeclaredMetric>& metrics() const { return metrics_; }

 private:
  template <class Archive>
  void visit_numbers(Archive& archive);
  const char* keep(std::string text);

  regista_descriptor declared_{};
  std::uint32_t kinds_ = 0, subjects_ = 0, assigner_flags_ = 0, purposes_ = 0;
  std::deque<std::string> texts_;
  std::vector<regista_parameter> parameters_;
  std::deque<std::vector<const char*>> choices_;
  std::vector<std::string> reasons_;
  std::vector<DeclaredMetric> metrics_;
};

}  // namespace regista::plugin
