// SPDX-License-Identifier: MIT
// A plugin out of its shared object, and values for its parameters:
//
//   const Loaded greedy(REGISTA_PLUGIN_FILE, "greedy");
//   const Values far = Values(greedy).set("reach", 20.0);
#pragma once

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <regista/abi.h>

namespace regista::testkit {

class Loaded {
 public:
  // Opens the file and takes the descriptor with this id. Throws std::runtime_error with one line.
  Loaded(const std::filesystem::path& file, std::string_view id) {
    // Never unloaded: dlclose does not take everything back that a C++ library has set up.
    void* library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (library == nullptr) throw std::runtime_error(dlerror());
    const auto entry = reinterpret_cast<decltype(&regista_plugin_entry)>(dlsym(library, REGISTA_ENTRY_NAME));
    if (entry == nullptr) throw std::runtime_error(file.string() + ": exports no " REGISTA_ENTRY_NAME);
    std::string others;
    for (std::uint32_t i = 0; const regista_descriptor* found = entry(REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR, i); ++i) {
      if (i == 1000) throw std::runtime_error(file.string() + ": its descriptors do not end");
      if (found->id != nullptr && found->id == id) {
        if (found->abi_major != REGISTA_ABI_MAJOR || found->abi_minor > REGISTA_ABI_MINOR) {
          throw std::runtime_error(file.string() + ": built for plugin interface " + version(*found));
        }
        descriptor_ = found;
        return;
      }
      others += (others.empty() ? "" : ", ") + std::string(found->id == nullptr ? "(null)" : found->id);
    }
    throw std::runtime_error(file.string() + ": no plugin \"" + std::string(id) + "\" in it; it has: " + others);
  }
  // One that is open already.
  explicit Loaded(const regista_descriptor& descriptor) : descriptor_(&descriptor) {}

  const regista_descriptor& descriptor() const { return *descriptor_; }
  const regista_parameter& parameter(std::size_t index) const {
    return *reinterpret_cast<const regista_parameter*>(reinterpret_cast<const char*>(descriptor_->parameters) +
                                                       index * descriptor_->parameter_stride);
  }
  std::size_t parameter_count() const { return descriptor_->parameter_count; }
  bool implements(std::int32_t kind) const { return descriptor_->table(kind) != nullptr; }

 private:
  static std::string version(const regista_descriptor& d) {
    return std::to_string(d.abi_major) + "." + std::to_string(d.abi_minor);
  }
  const regista_descriptor* descriptor_ = nullptr;
};

// One value for each parameter; the declared defaults until set.
class Values {
 public:
  explicit Values(const Loaded& plugin) : plugin_(plugin) {
    for (std::size_t i = 0; i < plugin.parameter_count(); ++i) {
      const regista_parameter& declared = plugin.parameter(i);
      numbers_.push_back(declared.initial);
      texts_.emplace_back(declared.initial_text == nullptr ? "" : declared.initial_text);
      has_text_.push_back(declared.initial_text != nullptr);
    }
  }
  // real, integer, boolean (0 or 1), choice by index.
  Values& set(std::string_view name, double number) { return numbers_[index(name)] = number, *this; }
  // text, the content of a file, choice by name.
  Values& set(std::string_view name, std::string_view text) {
    const std::size_t i = index(name);
    const regista_parameter& declared = plugin_.parameter(i);
    if (declared.type == REGISTA_TYPE_CHOICE) {
      for (std::uint32_t c = 0; c < declared.choice_count; ++c) {
        if (text == declared.choices[c]) return numbers_[i] = c, *this;
      }
      throw std::logic_error(std::string(name) + ": no choice \"" + std::string(text) + "\"");
    }
    texts_[i] = text;
    has_text_[i] = true;
    return *this;
  }
  // As create() takes them; the texts live in *this.
  std::vector<regista_value> raw() const {
    std::vector<regista_value> out;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
      const bool text = has_text_[i];
      out.push_back({numbers_[i], text ? texts_[i].c_str() : nullptr, text ? texts_[i].size() : 0});
    }
    return out;
  }
  double number(std::size_t i) const { return numbers_[i]; }

 private:
  std::size_t index(std::string_view name) const {
    for (std::size_t i = 0; i < plugin_.parameter_count(); ++i) {
      if (name == plugin_.parameter(i).name) return i;
    }
    throw std::logic_error("no parameter \"" + std::string(name) + "\"");
  }

  Loaded plugin_;
  std::vector<double> numbers_;
  std::vector<std::string> texts_;
  std::vector<bool> has_text_;
};

}  // namespace regista::testkit
