// SPDX-License-Identifier: MIT
// The parameters of one use of a plugin. resolve() checks YAML values and makes the values for the plugin's create().
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <regista/abi.h>

#include "config/errors.hpp"
#include "config/team.hpp"

namespace regista::plugin {

// A file whose content is the value of a parameter.
struct FileUsed {
  std::string parameter;
  std::filesystem::path path;
  std::string hash;  // hash of the file's content, see content_hash() in shared_object.hpp
};

// The values of all parameters of a plugin. Cheap to copy; copies share the values.
class Parameters {
 public:
  Parameters() : data_(std::make_shared<const Data>()) {}  // no values, for a plugin without parameters
  // One value for each declared parameter, in declared order. The texts live as long as any copy of this object.
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

// Reads use.params. A parameter that is absent or null gets its default. A file name is relative to the folder of its
// YAML file. Throws config::Error at the value for an unknown name (with the nearest name), a wrong type, an unknown
// choice, an infinite number, NaN, a number out of range, and a file that is missing or too large.
Parameters resolve(const regista_descriptor& plugin, const config::PluginUse& use);

// Like the function above, but reports every mistake. A parameter with a wrong value gets its default.
Parameters resolve(const regista_descriptor& plugin, const config::PluginUse& use, config::Mistakes& mistakes);

}  // namespace regista::plugin
