// SPDX-License-Identifier: MIT
// Declarations of documents. A declaration lists the keys that a document may have, each with a member of a C++ struct,
// range, unit and meaning. Reading, checking, defaults, JSON Schema and `show` use the declaration.
//
//   Map declare(BallSize& ball) {
//     return {{real("diameter", ball.diameter, {0.02, 0.5}, "m", "of the ball"),
//              real("mass", ball.mass, {0.005, 2}, "kg", "of the ball")}};
//   }
//
// A declaration refers to its object and must not outlive it. The object's values before reading are the defaults.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "config/errors.hpp"
#include "config/node.hpp"
#include "config/scalar.hpp"

namespace regista::config {

// Access to a member of a declared object. If the member is an empty std::optional, get() first creates a value in it.
template <class T>
struct Member {
  std::function<T&()> get;
  std::function<bool()> present;

  Member(T& value) : get([&value]() -> T& { return value; }), present([] { return true; }) {}
  Member(std::optional<T>& value)
      : get([&value]() -> T& { return value ? *value : value.emplace(); }),
        present([&value] { return value.has_value(); }) {}
  Member(std::function<T&()> get_, std::function<bool()> present_)
      : get(std::move(get_)), present(std::move(present_)) {}
};

struct Field;

// The keys that a map of a document may have, and the rules between these keys.
struct Map {
  std::vector<Field> fields;
  Location* where = nullptr;                           // reading stores the Location of the map here; null: not stored
  std::vector<std::string> exactly_one = {};           // the map must have exactly one of these keys; empty: no rule
  std::vector<std::array<std::string, 2>> needs = {};  // pairs of keys: a map with the first key must have the second
  std::string plugin_kind = {};  // kind of the plugin, for a map with the keys `plugin` and `params`
};

// --- The types of values that a key may have, one struct for each type

struct Real {
  Member<double> member;
  Range range;       // in the unit of the document
  std::string unit;  // unit in the document
  double scale;      // value in memory = scale * number in the document
};

struct Integer {
  std::function<std::int64_t()> get;
  std::function<void(std::int64_t)> set;
  std::function<bool()> present;
  Range range;
  std::string unit;
};

struct Boolean {
  Member<bool> member;
};

struct Name {
  Member<std::string> member;
};

// The path of an existing file, empty for a missing key. A relative path starts at the folder of the document.
struct File {
  Member<std::string> member;
  std::string built_in = {};  // this name selects built-in values if no file has this name; empty: no built-in values
};

struct NamedPath {
  std::string path;  // absolute path
  Location where;
};

// One path or a list of paths of files or folders. Each path follows the rules of File.
struct Paths {
  std::vector<NamedPath>* members;
};

struct Choice {
  std::vector<std::string> names;
  std::function<std::size_t()> get;
  std::function<void(std::size_t)> set;
};

struct Numbers {
  std::size_t count;  // the list has exactly so many numbers
  std::function<std::vector<double*>()> get;
  std::function<bool()> present;
  Range range;
  std::string unit;
  bool ascending;
};

// A value with a special syntax, which `read` and `write` implement. The schema describes the syntax as `definition`.
struct Own {
  std::string definition;
  std::function<void(const Node&, const std::string& what, Mistakes&)> read;  // throws Error or adds to the Mistakes
  std::function<Node()> write;  // returns an absent node if the key is missing
};

// A map with any keys and values. Reading stores the map unchanged.
struct Free {
  Node* member;
  std::string definition;  // name in the schema
};

struct Section {
  std::function<Map()> open;  // declares the object, and first creates it if it is a missing optional object
  std::function<bool()> present;
};

struct List {
  std::function<std::size_t()> size;
  std::function<void()> clear;
  std::function<Map()> append;
  std::function<Map(std::size_t)> element;
  std::size_t least, most;  // limits of the number of elements
};

// A map whose keys are names that the user chooses. All values have the same type.
struct Dictionary {
  std::function<std::size_t()> size;
  std::function<void()> clear;
  std::function<Field(const std::string& name)> append;
  std::function<Field(std::size_t)> element;
  std::size_t least, most;  // limits of the number of entries
};

struct Field {
  std::string key;
  std::string doc;
  std::variant<Real, Integer, Boolean, Name, File, Paths, Choice, Numbers, Own, Free, Section, List, Dictionary> kind;
  bool required = false;
  bool decides = true;  // false: the value changes only the computation or the display of results, never the results
  std::string default_from = {};  // describes the keys that decide the default; empty: the default is fixed
};

inline Field with_default_from(Field field, std::string others) {
  field.default_from = std::move(others);
  return field;
}

inline Field without_effect(Field field) {
  field.decides = false;
  return field;
}

std::vector<Field> joined(std::vector<Field> first, std::vector<Field> others);

inline Field required(Field field) {
  field.required = true;
  return field;
}

Field real(std::string key, Member<double> member, Range range, std::string unit, std::string doc);

// An angle, or an angle per s or s^2. The document has degrees (the key ends in _deg), and the member has radians.
Field degrees(std::string key, Member<double> member, Range range, std::string unit, std::string doc);

Field integer(std::string key, Member<int> member, Range range, std::string unit, std::string doc);
Field integer(std::string key, Member<std::int64_t> member, Range range, std::string unit, std::string doc);
Field boolean(std::string key, Member<bool> member, std::string doc);
Field name(std::string key, Member<std::string> member, std::string doc);
Field file(std::string key, Member<std::string> member, std::string doc, std::string built_in = {});
Field paths(std::string key, std::vector<NamedPath>& members, std::string doc);
Field free(std::string key, Node& member, std::string definition, std::string doc);

// line(): one line of text for people, empty if the key is missing. lines(): a list of such texts with their Locations.
Field line(std::string key, std::string& text, std::string doc);
Field lines(std::string key, std::vector<Node>& texts, std::string doc);

// A key whose value is one of `names`. Precondition: names[i] is the name of the enumerator with the value i.
template <class Enumeration>
Field choice(std::string key, Enumeration& member, std::vector<std::string> names, std::string doc) {
  return {std::move(key), std::move(doc),
          Choice{std::move(names), [&member] { return static_cast<std::size_t>(member); },
                 [&member](std::size_t index) { member = static_cast<Enumeration>(index); }}};
}

// A list with as many numbers as the member has elements. The member is a std::array or a std::optional<std::array>.
template <class Array>
Field numbers(std::string key, Array& array, Range range, std::string unit, std::string doc, bool ascending = false) {
  const Member member(array);
  const auto get = [member] {
    std::vector<double*> values;
    for (double& value : member.get()) values.push_back(&value);
    return values;
  };
  constexpr std::size_t count = std::tuple_size_v<std::remove_reference_t<decltype(member.get())>>;
  return {std::move(key), std::move(doc), Numbers{count, get, member.present, range, std::move(unit), ascending}};
}

// A list [least, largest] that fills two members.
Field bounds(std::string key, double& least, double& largest, Range range, std::string unit, std::string doc);

// A nested map, whose key may be missing. The function declare(T&) must be in the namespace of the object's type T.
template <class Object>
Field section(std::string key, Object& object, std::string doc) {
  const Member member(object);
  return {std::move(key), std::move(doc), Section{[member] { return declare(member.get()); }, member.present}};
}

// A list of maps, one for each element of `members`. The function declare(T&) must be in the namespace of T.
template <class T>
Field list(std::string key, std::vector<T>& members, std::size_t least, std::size_t most, std::string doc) {
  return {std::move(key), std::move(doc),
          List{[&members] { return members.size(); }, [&members] { members.clear(); },
               [&members] { return declare(members.emplace_back()); },
               [&members](std::size_t i) { return declare(members[i]); }, least, most}};
}

// A map from names to values. Each element of `members` is one entry: T::name is the name, field_of() gives the value.
template <class T, class FieldOf>
Field dictionary(std::string key, std::vector<T>& members, FieldOf field_of, std::size_t least, std::size_t most,
                 std::string doc) {
  return {std::move(key), std::move(doc),
          Dictionary{[&members] { return members.size(); }, [&members] { members.clear(); },
                     [&members, field_of](const std::string& entry) {
                       members.emplace_back().name = entry;
                       return field_of(members.back());
                     },
                     [&members, field_of](std::size_t i) { return field_of(members[i]); }, least, most}};
}

// --- What a plugin declares about itself, for the schema and `show`. Code in host/plugin fills these structs.

// A parameter of a plugin. The members mean the same as in regista_parameter of <regista/abi.h>.
struct PluginParameter {
  enum class Type { real, integer, boolean, choice, text, file };

  std::string name = {};
  Type type = Type::real;
  double minimum = 0.0, maximum = 0.0;  // closed range of a real or an integer
  std::string unit = {};                // SI symbol, "1" for a plain number, "" for no unit
  std::string doc = {};
  double initial = 0.0;                   // default value of a real, integer, boolean (0 or 1) or choice (index)
  std::string initial_text = {};          // default value of a text; empty for a file, which has no default
  std::vector<std::string> choices = {};  // only for a choice
  bool tunable = false, log_scale = false;
};

// One kind of one plugin. A plugin that implements several kinds has one PluginDeclaration for each kind.
struct PluginDeclaration {
  std::string id;
  std::string kind;  // "predictor", "context", "positioner", "utility", "assigner", "sender"
  std::string summary = {};
  std::vector<PluginParameter> parameters = {};
};

}  // namespace regista::config
