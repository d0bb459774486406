// SPDX-License-Identifier: MIT
// Parameters of a plugin, declared once:
//
//   struct Greedy {
//     double reach = 12.0;                     // the initial value is the default
//     static constexpr std::tuple parameters{
//         regista::real("reach", &Greedy::reach, {0.5, 20.0}, "m", "Ignore farther tasks").tunable()};
//   };
//
// From this come the check of the YAML, the tuner's bounds, `regista plugin info` and the reference page.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>

#include <regista/abi.h>

namespace regista {

// Closed.
struct Range {
  double minimum, maximum;
};

// A declared parameter of the plugin class `Plugin`, bound to a member of type `Value`.
template <class Plugin, class Value>
struct Parameter {
  std::int32_t type;
  const char* name;
  Value Plugin::*member;
  Range range;
  const char* unit;
  const char* doc;
  const char* const* choices = nullptr;
  std::uint32_t choice_count = 0;
  std::uint32_t flags = 0;

  // The tuner may search it.
  constexpr Parameter tunable() const {
    Parameter copy = *this;
    copy.flags |= REGISTA_PARAMETER_TUNABLE;
    return copy;
  }
  // The tuner searches its logarithm; the range is positive.
  constexpr Parameter log_scale() const {
    Parameter copy = *this;
    copy.flags |= REGISTA_PARAMETER_LOG_SCALE;
    return copy;
  }
};

template <class P>
constexpr auto real(const char* name, double P::*member, Range range, const char* unit, const char* doc) {
  return Parameter<P, double>{REGISTA_TYPE_REAL, name, member, range, unit, doc};
}

template <class P>
constexpr auto integer(const char* name, int P::*member, Range range, const char* unit, const char* doc) {
  return Parameter<P, int>{REGISTA_TYPE_INTEGER, name, member, range, unit, doc};
}

template <class P>
constexpr auto boolean(const char* name, bool P::*member, const char* doc) {
  return Parameter<P, bool>{REGISTA_TYPE_BOOLEAN, name, member, {0.0, 1.0}, "", doc};
}

// A word out of `names`, which lives as long as the program; the member is an enum that counts from 0 in their order.
template <class P, class Enum, std::size_t N>
requires std::is_enum_v<Enum>
constexpr auto choice(const char* name, Enum P::*member, const std::array<const char*, N>& names, const char* doc) {
  return Parameter<P, Enum>{
      REGISTA_TYPE_CHOICE,          name, member, {0.0, static_cast<double>(N - 1)}, "", doc, names.data(),
      static_cast<std::uint32_t>(N)};
}

template <class P>
constexpr auto text(const char* name, std::string P::*member, const char* doc) {
  return Parameter<P, std::string>{REGISTA_TYPE_TEXT, name, member, {0.0, 0.0}, "", doc};
}

// The YAML names a file; the member receives its bytes. Empty when none is named.
template <class P>
constexpr auto file(const char* name, std::string P::*member, const char* doc) {
  return Parameter<P, std::string>{REGISTA_TYPE_FILE, name, member, {0.0, 0.0}, "", doc};
}

namespace detail {

template <class Plugin, class Value>
regista_parameter describe(const Parameter<Plugin, Value>& declared, const Plugin& initial) {
  regista_parameter out{};
  out.size = sizeof out;
  out.type = declared.type;
  out.name = declared.name;
  out.unit = declared.unit;
  out.doc = declared.doc;
  out.minimum = declared.range.minimum;
  out.maximum = declared.range.maximum;
  out.choices = declared.choices;
  out.choice_count = declared.choice_count;
  out.flags = declared.flags;
  if constexpr (std::is_same_v<Value, std::string>) {
    if (declared.type == REGISTA_TYPE_TEXT) out.initial_text = (initial.*declared.member).c_str();
  } else {
    out.initial = static_cast<double>(initial.*declared.member);
  }
  return out;
}

template <class Plugin, class Value>
void assign(const Parameter<Plugin, Value>& declared, Plugin& plugin, const regista_value& value) {
  if constexpr (std::is_same_v<Value, std::string>) {
    if (value.text != nullptr) (plugin.*declared.member).assign(value.text, static_cast<std::size_t>(value.text_size));
  } else if constexpr (std::is_same_v<Value, bool>) {
    plugin.*declared.member = value.number != 0.0;
  } else if constexpr (std::is_enum_v<Value>) {
    plugin.*declared.member = static_cast<Value>(static_cast<int>(value.number));
  } else {
    plugin.*declared.member = static_cast<Value>(value.number);
  }
}

template <class Plugin>
constexpr std::size_t parameter_count() {
  if constexpr (requires { Plugin::parameters; }) {
    return std::tuple_size_v<std::remove_cvref_t<decltype(Plugin::parameters)>>;
  } else {
    return 0;
  }
}

}  // namespace detail
}  // namespace regista
