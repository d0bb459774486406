// SPDX-License-Identifier: MIT
// A plugin out of its shared object, and values for its parameters:
//
//   const Loaded greedy(REGISTA_PLUGIN_FILE, "greedy");
//   const Values far = Values(greedy).set("reach", 20.0);
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <regista/abi.h>

// The path of the plugin that a test of regista_add_plugin is for: REGISTA_PLUGIN_FILE.
extern const char regista_plugin_file[];

namespace regista::testkit {

class Loaded {
 public:
  // Opens the file and takes the descriptor with this id. Throws std::runtime_error with one line.
  Loaded(const std::string& file, std::string_view id);
  // One that is open already.
  explicit Loaded(const regista_descriptor& descriptor) : descriptor_(&descriptor) {}

  const regista_descriptor& descriptor() const { return *descriptor_; }
  const regista_parameter& parameter(std::size_t index) const;
  std::size_t parameter_count() const { return descriptor_->parameter_count; }
  bool implements(std::int32_t kind) const { return descriptor_->table(kind) != nullptr; }

 private:
  const regista_descriptor* descriptor_ = nullptr;
};

// One value for each parameter; the declared defaults until set.
class Values {
 public:
  explicit Values(const Loaded& plugin);
  // real, integer, boolean (0 or 1), choice by index.
  Values& set(std::string_view name, double number);
  // text, the content of a file, choice by name.
  Values& set(std::string_view name, std::string_view text);
  // As create() takes them; the texts live in *this.
  std::vector<regista_value> raw() const;
  double number(std::size_t i) const { return numbers_[i]; }

 private:
  std::size_t index(std::string_view name) const;

  Loaded plugin_;
  std::vector<double> numbers_;
  std::vector<std::string> texts_;
  std::vector<bool> has_text_;
};

}  // namespace regista::testkit
