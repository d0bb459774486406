// SPDX-License-Identifier: MIT
// Parameters of a plugin, declared once:
//
//   struct Greedy {
//     double reach = 12.0;                     // the initial value is the default
//     static constexpr std::tuple parameters{
//         regista::real("reach", &Greedy::reach, {0.5, 20.0}, "m", "Ignore farther tasks").tunable()};
//   };
//
// An algorithm with settings of its own keeps them and their defaults: within() binds to members of a struct inside of
// the plugin class.
//
//   struct Greedy {
//     greedy::Settings settings;
//     static constexpr std::tuple parameters{regista::within(
//         &Greedy::settings,
//         regista::real("reach", &greedy::Settings::reach, {0.5, 20.0}, "m", "Ignore farther tasks").tunable())};
//   };
//
// A std::tuple of declarations may stand wherever one of them may: plugins share what they have in common. The order is
// that in which they are written.
//
// From this come the check of the YAML, the tuner's bounds, `regista plugin info` and the reference page.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include <regista/abi.h>

namespace regista {

// Closed.
struct Range {
  double minimum, maximum;
};

// A declared parameter, bound to a member of type `Value`. `Class` is the plugin class, a struct inside of it, or a
// base of either.
template <class Class, class Value>
struct Parameter {
  std::int32_t type;
  const char* name;
  Value Class::*member;
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

// Declarations, or tuples of them, that are bound to what `step` leads to.
template <class Step, class... Declared>
struct Within {
  Step step;
  std::tuple<Declared...> declared;
};

namespace detail {

template <class Outer, class Step>
constexpr auto& follow(Outer& outer, const Step& step) {
  if constexpr (std::is_member_object_pointer_v<Step>) {
    return outer.*step;
  } else {
    return step(outer);
  }
}

template <class Outer, class Step>
using Inner = std::remove_reference_t<decltype(follow(std::declval<Outer&>(), std::declval<const Step&>()))>;

// Whether what is declared is bound to members of `Owner`.
template <class Declared, class Owner>
inline constexpr bool belongs = false;
template <class Class, class Value, class Owner>
inline constexpr bool belongs<Parameter<Class, Value>, Owner> = std::is_convertible_v<Value Class::*, Value Owner::*>;
template <class Step, class... Declared, class Owner>
inline constexpr bool belongs<Within<Step, Declared...>, Owner> = (belongs<Declared, Inner<Owner, Step>> && ...);
template <class Class, class Value, class... Declared, class Owner>
inline constexpr bool belongs<Within<Value Class::*, Declared...>, Owner> =  // within() has looked at what is inside
    std::is_convertible_v<Value Class::*, Value Owner::*>;
template <class... Declared, class Owner>
inline constexpr bool belongs<std::tuple<Declared...>, Owner> = (belongs<Declared, Owner> && ...);

template <class Declared, class Owner>
concept MemberOf = std::is_class_v<Owner> && belongs<Declared, Owner>;

}  // namespace detail

// Binds to members of a member of the plugin class, or of a struct inside of it.
template <class Outer, class Inner, detail::MemberOf<Inner>... Declared>
constexpr auto within(Inner Outer::*member, const Declared&... declared) {
  return Within<Inner Outer::*, Declared...>{member, {declared...}};
}

// The same where no member pointer leads, such as into an array: step(outer) returns a reference, whether `outer` is
// const or not.
template <class Step, class... Declared>
requires std::is_class_v<Step>
constexpr auto within(const Step& step, const Declared&... declared) {
  return Within<Step, Declared...>{step, {declared...}};
}

namespace detail {

template <class Value>
regista_parameter describe(const auto& declared, const Value& initial) {
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
    if (declared.type == REGISTA_TYPE_TEXT) out.initial_text = initial.c_str();
  } else {
    out.initial = static_cast<double>(initial);
  }
  return out;
}

template <class Value>
void assign(Value& member, const regista_value& value) {
  if constexpr (std::is_same_v<Value, std::string>) {
    if (value.text != nullptr) member.assign(value.text, static_cast<std::size_t>(value.text_size));
  } else if constexpr (std::is_same_v<Value, bool>) {
    member = value.number != 0.0;
  } else if constexpr (std::is_enum_v<Value>) {
    member = static_cast<Value>(static_cast<int>(value.number));
  } else {
    member = static_cast<Value>(value.number);
  }
}

template <class Declared>
inline constexpr std::size_t count_of = 1;
template <class... Declared>
inline constexpr std::size_t count_of<std::tuple<Declared...>> = (std::size_t{0} + ... + count_of<Declared>);
template <class Step, class... Declared>
inline constexpr std::size_t count_of<Within<Step, Declared...>> = count_of<std::tuple<Declared...>>;

template <class Plugin>
constexpr std::size_t parameter_count() {
  if constexpr (requires { Plugin::parameters; }) {
    return count_of<std::remove_cvref_t<decltype(Plugin::parameters)>>;
  } else {
    return 0;
  }
}

// Calls use(parameter, its member in `owner`) for each, in their order.
template <class Owner, class Class, class Value, class Use>
void each_parameter(Owner& owner, const Parameter<Class, Value>& declared, const Use& use) {
  use(declared, owner.*declared.member);
}
template <class Owner, class Step, class... Declared, class Use>
void each_parameter(Owner& owner, const Within<Step, Declared...>& inside, const Use& use);
template <class Owner, class... Declared, class Use>
void each_parameter(Owner& owner, const std::tuple<Declared...>& list, const Use& use) {
  std::apply([&](const auto&... declared) { (each_parameter(owner, declared, use), ...); }, list);
}
template <class Owner, class Step, class... Declared, class Use>
void each_parameter(Owner& owner, const Within<Step, Declared...>& inside, const Use& use) {
  each_parameter(follow(owner, inside.step), inside.declared, use);
}

}  // namespace detail
}  // namespace regista
