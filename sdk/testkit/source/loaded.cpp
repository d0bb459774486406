// SPDX-License-Identifier: MIT
// Opens a shared object as a host does, and keeps values beside the declared parameters.
#include <regista/testkit/loaded.hpp>

#include <dlfcn.h>

#include <cfenv>
#include <filesystem>
#include <stdexcept>

namespace regista::testkit {

namespace {

std::string version(const regista_descriptor& d) {
  return std::to_string(d.abi_major) + "." + std::to_string(d.abi_minor);
}

}  // namespace

Loaded::Loaded(const std::string& file, std::string_view id) {
  // Never unloaded: dlclose does not take everything back that a C++ library has set up.
  // What its constructors did to rounding is undone, as the host undoes it.
  std::fenv_t arithmetic;
  std::fegetenv(&arithmetic);
  void* library = dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  std::fesetenv(&arithmetic);
  if (library == nullptr) throw std::runtime_error(dlerror());
  const auto entry = reinterpret_cast<decltype(&regista_plugin_entry)>(dlsym(library, REGISTA_ENTRY_NAME));
  if (entry == nullptr) throw std::runtime_error(file + ": exports no " REGISTA_ENTRY_NAME);
  std::string others;
  for (std::uint32_t i = 0; const regista_descriptor* found = entry(REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR, i); ++i) {
    if (i == 1000) throw std::runtime_error(file + ": its descriptors do not end");
    if (found->id != nullptr && found->id == id) {
      static_assert(REGISTA_ABI_MAJOR == 0, "from 1.0 on, minor versions fit together");
      if (found->abi_major != REGISTA_ABI_MAJOR || found->abi_minor != REGISTA_ABI_MINOR) {
        throw std::runtime_error(file + ": built for plugin interface " + version(*found));
      }
      descriptor_ = found;
      return;
    }
    others += (others.empty() ? "" : ", ") + std::string(found->id == nullptr ? "(null)" : found->id);
  }
  throw std::runtime_error(file + ": no plugin \"" + std::string(id) + "\" in it; it has: " + others);
}

const regista_parameter& Loaded::parameter(std::size_t index) const {
  return *reinterpret_cast<const regista_parameter*>(reinterpret_cast<const char*>(descriptor_->parameters) +
                                                     index * descriptor_->parameter_stride);
}

Values::Values(const Loaded& plugin) : plugin_(plugin) {
  for (std::size_t i = 0; i < plugin.parameter_count(); ++i) {
    const regista_parameter& declared = plugin.parameter(i);
    numbers_.push_back(declared.initial);
    texts_.emplace_back(declared.initial_text == nullptr ? "" : declared.initial_text);
    has_text_.push_back(declared.initial_text != nullptr);
  }
}

Values& Values::set(std::string_view name, double number) { return numbers_[index(name)] = number, *this; }

Values& Values::set(std::string_view name, std::string_view text) {
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

std::vector<regista_value> Values::raw() const {
  std::vector<regista_value> out;
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    const bool text = has_text_[i];
    out.push_back({numbers_[i], text ? texts_[i].c_str() : nullptr, text ? texts_[i].size() : 0});
  }
  return out;
}

std::size_t Values::index(std::string_view name) const {
  for (std::size_t i = 0; i < plugin_.parameter_count(); ++i) {
    if (name == plugin_.parameter(i).name) return i;
  }
  throw std::logic_error("no parameter \"" + std::string(name) + "\"");
}

}  // namespace regista::testkit
