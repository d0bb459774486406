// SPDX-License-Identifier: MIT
// Turns an ordinary class into a plugin. A class needs
//
//   static constexpr auto id = "greedy", version = "1.0.0", summary = "Best free robot per role, by priority";
//   and the functions of the kinds it implements (see the header of each kind);
// and may have
//   static constexpr std::tuple parameters{...};        see parameters.hpp
//   static constexpr auto licence = "Apache-2.0";       SPDX expression; MIT when absent
//   static constexpr unsigned reads = REGISTA_READS_...; the parts of frames that it reads, or-ed; all when absent
//   void setup(const regista::Environment&);            after the parameters are set, before reset
//   void setup(const regista::Environment&, regista::Mailbox);   when it wants to offer bytes
//   void setup(const regista::Environment&, const regista::Host&);   when it wants more of the host; see host.hpp
//   static constexpr std::array metrics{...};           numbers that it reports; see metric.hpp
//   void reset(std::uint64_t seed);                     the beginning of a match
//
// and one line at the end of its .cpp:
//
//   REGISTA_PLUGIN(Greedy, regista::assigner)                 one class, one or several kinds
//   REGISTA_PLUGINS(regista::Plugin<A, regista::assigner>, regista::Plugin<B, regista::utility>)
//
// Exceptions may be thrown freely: here they become the one line that the host reports.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <regista/abi.h>
#include <regista/extensions/metric.h>
#include <regista/frame.hpp>
#include <regista/host.hpp>
#include <regista/mailbox.hpp>
#include <regista/parameters.hpp>

#ifndef REGISTA_BUILD_TAG
#define REGISTA_BUILD_TAG "unknown build"
#endif

namespace regista {
namespace detail {

inline void say(regista_error* error, const char* text) noexcept {
  const std::size_t length = std::min(std::strlen(text), sizeof error->text - 1);
  std::memcpy(error->text, text, length);
  error->text[length] = '\0';
}

// Runs `body`; whatever it throws ends as a line in `error`.
template <class Body>
std::int32_t guarded(regista_error* error, Body&& body) noexcept {
  try {
    body();
    return REGISTA_OK;
  } catch (const std::exception& exception) {
    say(error, exception.what());
  } catch (...) {
    say(error, "threw something that is no std::exception");
  }
  return REGISTA_FAILED;
}

// Ends the call that reached outside of its output.
[[noreturn]] inline void outside(const char* what, std::size_t row, std::size_t column, std::size_t rows,
                                 std::size_t columns) {
  throw std::out_of_range(std::string(what) + '(' + std::to_string(row) + ", " + std::to_string(column) +
                          ") is outside of its " + std::to_string(rows) + " x " + std::to_string(columns));
}

}  // namespace detail

// Hidden, also where a file is built by hand: a static object that others see is one for the whole process
// (STB_GNU_UNIQUE), so that of two builds of a plugin the second would run the first one's code.
#pragma GCC visibility push(hidden)

// The descriptor of `Class`, which implements the kinds `Kinds`.
template <class Class, class... Kinds>
struct Plugin {
  static const regista_descriptor* descriptor() {
    static const regista_descriptor built = build();
    return &built;
  }

 private:
  static constexpr std::size_t count = detail::parameter_count<Class>();

  static const std::array<regista_parameter, count>& declared() {
    [[maybe_unused]] static const Class initial{};  // texts of defaults live in it
    static const std::array<regista_parameter, count> table = [] {
      std::array<regista_parameter, count> out{};
      if constexpr (count > 0) {
        static_assert(detail::MemberOf<std::remove_cvref_t<decltype(Class::parameters)>, Class>,
                      "a parameter is bound to a member of another class");
        std::size_t next = 0;
        detail::each_parameter(initial, Class::parameters, [&](const auto& each, const auto& member) {
          out[next++] = detail::describe(each, member);
        });
      }
      return out;
    }();
    return table;
  }

  static const void* table(std::int32_t kind) {
    const void* found = nullptr;
    ((kind == Kinds::kind ? void(found = Kinds::template table<Class>()) : void()), ...);
    if constexpr (takes_messages<Class>) {
      if (kind == REGISTA_KIND_MAILBOX) found = mailbox_table<Class>();
    }
    return found;
  }

  static void* create(const regista_environment* environment, const regista_host* host, regista_span values,
                      regista_error* error) {
    std::unique_ptr<Class> plugin;
    const std::int32_t status = detail::guarded(error, [&] {
      plugin = std::make_unique<Class>();
      if constexpr (count > 0) {
        std::size_t next = 0;
        detail::each_parameter(*plugin, Class::parameters, [&](const auto&, auto& member) {
          detail::assign(member, Span<regista_value>(values)[next++]);
        });
      }
      if constexpr (requires { plugin->setup(Environment(*environment), Host(host)); }) {
        plugin->setup(Environment(*environment), Host(host));
      } else if constexpr (requires { plugin->setup(Environment(*environment), Mailbox(host)); }) {
        plugin->setup(Environment(*environment), Mailbox(host));
      } else if constexpr (requires { plugin->setup(Environment(*environment)); }) {
        plugin->setup(Environment(*environment));
      }
    });
    return status == REGISTA_OK ? plugin.release() : nullptr;
  }

  static const void* extension(const char* id) {
    if constexpr (requires { std::bool_constant<(Class::metrics.size() > 0)>{}; }) {
      static constexpr regista_metrics declared_metrics{sizeof(regista_metrics),
                                                        static_cast<std::uint32_t>(Class::metrics.size()),
                                                        Class::metrics.data(), sizeof(regista_metric), 0};
      if (std::strcmp(id, REGISTA_METRIC_EXTENSION) == 0) return &declared_metrics;
    }
    return nullptr;
  }

  static std::int32_t reset(void* instance, std::uint64_t seed, regista_error* error) {
    if constexpr (requires(Class & plugin) { plugin.reset(seed); }) {
      return detail::guarded(error, [&] { static_cast<Class*>(instance)->reset(seed); });
    } else {
      return REGISTA_OK;
    }
  }

  static void destroy(void* instance) { delete static_cast<Class*>(instance); }

  static regista_descriptor build() {
    regista_descriptor out{};
    out.size = sizeof out;
    out.abi_major = REGISTA_ABI_MAJOR;
    out.abi_minor = REGISTA_ABI_MINOR;
    out.parameter_count = count;
    out.id = Class::id;
    out.version = Class::version;
    out.summary = Class::summary;
    if constexpr (requires { Class::licence; }) {
      out.licence = Class::licence;
    } else {
      out.licence = "MIT";
    }
    out.build_tag = REGISTA_BUILD_TAG;
    out.parameters = declared().data();
    out.parameter_stride = sizeof(regista_parameter);
    out.table = &table;
    out.create = &create;
    out.reset = &reset;
    out.destroy = &destroy;
    out.minimum_major = REGISTA_ABI_MAJOR;
    out.minimum_minor = REGISTA_ABI_MINOR;
    out.reads = REGISTA_READS_ALL;
    if constexpr (requires { Class::reads; }) out.reads = Class::reads;
    out.extension = &extension;
    return out;
  }
};

#pragma GCC visibility pop

}  // namespace regista

#define REGISTA_PLUGINS(...)                                                               \
  extern "C" const regista_descriptor* regista_plugin_entry(std::uint32_t, std::uint32_t,  \
                                                            std::uint32_t regista_index) { \
    return ::regista::detail::nth_descriptor<__VA_ARGS__>(regista_index);                  \
  }

#define REGISTA_PLUGIN(...) REGISTA_PLUGINS(::regista::Plugin<__VA_ARGS__>)

namespace regista::detail {

#pragma GCC visibility push(hidden)
template <class... Plugins>
const regista_descriptor* nth_descriptor(std::uint32_t index) {
  using Descriptor = const regista_descriptor* (*)();
  constexpr std::array<Descriptor, sizeof...(Plugins)> all{&Plugins::descriptor...};
  return index < all.size() ? all[index]() : nullptr;
}
#pragma GCC visibility pop

}  // namespace regista::detail
