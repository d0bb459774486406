// SPDX-License-Identifier: MIT
// The parameters of one use of a plugin: from YAML to the values that its create() receives, checked against what the
// plugin declares.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <regista/abi.h>

#include "config/mistakes.hpp"
#include "config/team.hpp"

namespace regista::plugin {

// A file whose content became the value of a parameter.
struct FileUsed {
  std::string parameter;
  std::filesystem::path path;
  std::string hash;  // of its content, see content_hash.hpp
};

// Largest file that a parameter may name, in bytes.
inline constexpr std::uintmax_t largest_parameter_file = 16'000'000;

// Cheap to copy; copies share the values.
class Parameters {
 public:
  Parameters() : data_(std::make_shared<const Data>()) {}  // of a plugin that has none
  // One for each declared parameter, in declared order. Texts live as long as any copy of this.
  std::span<const regista_value> values() const { return data_->values; }
  std::span<const FileUsed> files() const { return data_->files; }

 private:
  friend Parameters resolve(const regista_descriptor&, const config::PluginUse&, config::Mistakes&);
  struct Data {
    std::vector<regista_value> values;
    std::vector<std::string> texts;  // one for each value; most are empty
    std::vector<FileUsed> files;
  };
  explicit Parameters(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
  std::shared_ptr<const Data> data_;
};

// Reads use.params. A parameter that is absent or null keeps its default; a file is named relative to the YAML file in
// which its name stands. Throws config::Error where the value stands: unknown name (with the nearest), another
// type, not finite, out of range, no such choice, file missing or larger than largest_parameter_file.
Parameters resolve(const regista_descriptor& plugin, const config::PluginUse& use);

// The same, telling of every mistake; what is mistaken keeps its default.
Parameters resolve(const regista_descriptor& plugin, const config::PluginUse& use, config::Mistakes& mistakes);

}  // namespace regista::plugin
