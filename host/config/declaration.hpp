// SPDX-License-Identifier: MIT
// What a document may hold, declared once for each type of value: key, member, range, unit, meaning. Reading, checking,
// defaults, JSON Schema and `show` all walk these declarations, so none of them can disagree with another.
//
//   Map declare(BallSize& ball) {
//     return {{real("diameter", ball.diameter, {0.02, 0.5}, "m", "of the ball"),
//              real("mass", ball.mass, {0.005, 2}, "kg", "of the ball")}};
//   }
//
// A declaration is bound to the object it was made for and must not outlive it. The value that the object has is the
// default. Nothing here reads a file or writes a text.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "config/mistakes.hpp"
#include "config/node.hpp"

namespace regista::config {

struct Range {
  double least, most;  // closed
};

// "0 to 1.5 m"; unit: "1" and "" of numbers without one.
std::string range_text(Range range, const std::string& unit);

// A member of a declared object, or one that may be missing, which is created when it is asked for.
template <class T>
class Member {
 public:
  Member(T& value) : get_([&value]() -> T& { return value; }), present_([] { return true; }) {}
  Member(std::optional<T>& value)
      : get_([&value]() -> T& { return value ? *value : value.emplace(); }),
        present_([&value] { return value.has_value(); }) {}
  Member(std::function<T&()> get, std::function<bool()> present) : get_(std::move(get)), present_(std::move(present)) {}

  T& get() const { return get_(); }
  bool present() const { return present_(); }

 private:
  std::function<T&()> get_;
  std::function<bool()> present_;
};

struct Field;

// What a map may hold, and what holds between its keys.
struct Map {
  std::vector<Field> fields;
  Location* where = nullptr;                           // takes the place of the map
  std::vector<std::string> exactly_one = {};           // of these keys
  std::vector<std::array<std::string, 2>> needs = {};  // the first key makes sense only beside the second
  std::string plugin_kind = {};                        // when it has `plugin` and `params`
};

// --- What a key may be -----------------------------------------------------------------------------------------------

struct Real {
  Member<double> member;
  Range range;       // in the unit of the document
  std::string unit;  // of the document
  double scale;      // value = scale * number of the document
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

// A file, resolved against the one that names it; must exist. Empty is the same as not there.
struct File {
  Member<std::string> member;
  std::string built_in = {};  // a name that means the built-in values, unless a file has it; empty: there are none
};

struct NamedPath {
  std::string path;  // absolute
  Location where;
};

// Files or folders, one or a list of them, each as a file is.
struct Paths {
  std::vector<NamedPath>* members;
};

struct Choice {
  std::vector<std::string> names;
  std::function<std::size_t()> get;
  std::function<void(std::size_t)> set;
};

// A list of a fixed number of numbers.
struct Numbers {
  std::size_t count;
  std::function<std::vector<double*>()> get;
  std::function<bool()> present;
  Range range;
  std::string unit;
  bool ascending;
};

// A value with a grammar of its own; `definition` names it for the schema.
struct Own {
  std::string definition;
  std::function<void(const Node&, const std::string& what, Mistakes&)> read;  // throws Error, or tells of several
  std::function<Node()> write;                                                // absent: leave the key out
};

// Any map at all, kept as it is.
struct Free {
  Node* member;
  std::string definition;  // names it for the schema
};

struct Section {
  std::function<Map()> open;  // creates it where it is optional
  std::function<bool()> present;
};

struct List {
  std::function<std::size_t()> size;
  std::function<void()> clear;
  std::function<Map()> append;
  std::function<Map(std::size_t)> element;
  std::size_t least, most;  // elements
};

// A map from names that the user chooses to values of one kind.
struct Dictionary {
  std::function<std::size_t()> size;
  std::function<void()> clear;
  std::function<Field(const std::string& name)> append;
  std::function<Field(std::size_t)> element;
  std::size_t least, most;  // entries
};

struct Field {
  std::string key;
  std::string doc;
  std::variant<Real, Integer, Boolean, Name, File, Paths, Choice, Numbers, Own, Free, Section, List, Dictionary> kind;
  bool required = false;
  bool decides = true;            // what comes of the document; else it says only how that is worked out or told
  std::string default_from = {};  // the keys that the default follows from, in words, where it is no fixed value
};

inline Field with_default_from(Field field, std::string others) {
  field.default_from = std::move(others);
  return field;
}

inline Field without_effect(Field field) {
  field.decides = false;
  return field;
}

inline Field required(Field field) {
  field.required = true;
  return field;
}

// --- Making fields
// -----------------------------------------------------------------------------------------------------

Field real(std::string key, Member<double> member, Range range, std::string unit, std::string doc);

// An angle, or anything per angle: degrees in the document (key ends in _deg), radians in memory.
Field degrees(std::string key, Member<double> member, Range range, std::string unit, std::string doc);

Field integer(std::string key, Member<int> member, Range range, std::string unit, std::string doc);
Field integer(std::string key, Member<std::int64_t> member, Range range, std::string unit, std::string doc);
Field boolean(std::string key, Member<bool> member, std::string doc);
Field name(std::string key, Member<std::string> member, std::string doc);
Field file(std::string key, Member<std::string> member, std::string doc);
Field profile(std::string key, Member<std::string> member, std::string built_in, std::string doc);
Field paths(std::string key, std::vector<NamedPath>& members, std::string doc);
Field free(std::string key, Node& member, std::string definition, std::string doc);

// The enumerators must count from 0 in the order of the names.
template <class Enumeration>
Field choice(std::string key, Enumeration& member, std::vector<std::string> names, std::string doc) {
  return {std::move(key), std::move(doc),
          Choice{std::move(names), [&member] { return static_cast<std::size_t>(member); },
                 [&member](std::size_t index) { member = static_cast<Enumeration>(index); }}};
}

template <std::size_t count>
Field numbers(std::string key, Member<std::array<double, count>> member, Range range, std::string unit, std::string doc,
              bool ascending = false) {
  const auto get = [member] {
    std::vector<double*> values;
    for (double& value : member.get()) values.push_back(&value);
    return values;
  };
  return {std::move(key), std::move(doc),
          Numbers{count, get, [member] { return member.present(); }, range, std::move(unit), ascending}};
}
template <std::size_t count>
Field numbers(std::string key, std::array<double, count>& member, Range range, std::string unit, std::string doc) {
  return numbers(std::move(key), Member<std::array<double, count>>(member), range, std::move(unit), std::move(doc));
}
template <std::size_t count>
Field numbers(std::string key, std::optional<std::array<double, count>>& member, Range range, std::string unit,
              std::string doc) {
  return numbers(std::move(key), Member<std::array<double, count>>(member), range, std::move(unit), std::move(doc));
}

// [least, largest]: one list for two members.
Field bounds(std::string key, double& least, double& largest, Range range, std::string unit, std::string doc);
Field bounds(std::string key, std::optional<std::array<double, 2>>& member, Range range, std::string unit,
             std::string doc);

// A nested map; `declare(T&)` is found beside T.
template <class T>
Field section(std::string key, Member<T> member, std::string doc) {
  return {std::move(key), std::move(doc),
          Section{[member] { return declare(member.get()); }, [member] { return member.present(); }}};
}
template <class T>
Field section(std::string key, T& member, std::string doc) {
  return section(std::move(key), Member<T>(member), std::move(doc));
}
template <class T>
Field section(std::string key, std::optional<T>& member, std::string doc) {
  return section(std::move(key), Member<T>(member), std::move(doc));
}

// A list of maps.
template <class T>
Field list(std::string key, std::vector<T>& members, std::size_t least, std::size_t most, std::string doc) {
  return {std::move(key), std::move(doc),
          List{[&members] { return members.size(); }, [&members] { members.clear(); },
               [&members] { return declare(members.emplace_back()); },
               [&members](std::size_t i) { return declare(members[i]); }, least, most}};
}

// A map from names, which are kept in T::name, to what `field_of(T&)`, a Field whose key is that name, says.
template <class T>
Field dictionary(std::string key, std::vector<T>& members, Field (*field_of)(T&), std::size_t least, std::size_t most,
                 std::string doc) {
  return {std::move(key), std::move(doc),
          Dictionary{[&members] { return members.size(); }, [&members] { members.clear(); },
                     [&members, field_of](const std::string& entry) {
                       members.emplace_back().name = entry;
                       return field_of(members.back());
                     },
                     [&members, field_of](std::size_t i) { return field_of(members[i]); }, least, most}};
}

}  // namespace regista::config
