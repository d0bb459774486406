// SPDX-License-Identifier: MIT
#include "config/declaration.hpp"

#include <fmt/format.h>

#include "config/robot.hpp"
#include "config/scalar.hpp"

namespace regista::config {

std::string range_text(Range range, const std::string& unit) {
  return fmt::format("{} to {}{}{}", real_text(range.least), real_text(range.most),
                     unit.empty() || unit == "1" ? "" : " ", unit == "1" ? "" : unit);
}

Field real(std::string key, Member<double> member, Range range, std::string unit, std::string doc) {
  return {std::move(key), std::move(doc), Real{std::move(member), range, std::move(unit), 1.0}};
}

Field degrees(std::string key, Member<double> member, Range range, std::string unit, std::string doc) {
  assert(key.ends_with("_deg"));
  return {std::move(key), std::move(doc), Real{std::move(member), range, std::move(unit), radians_per_degree}};
}

template <class Whole>
static Field whole(std::string key, const Member<Whole>& member, Range range, std::string unit, std::string doc) {
  return {std::move(key), std::move(doc),
          Integer{[member] { return static_cast<std::int64_t>(member.get()); },
                  [member](std::int64_t value) { member.get() = static_cast<Whole>(value); },
                  [member] { return member.present(); }, range, std::move(unit)}};
}
Field integer(std::string key, Member<int> member, Range range, std::string unit, std::string doc) {
  return whole(std::move(key), member, range, std::move(unit), std::move(doc));
}
Field integer(std::string key, Member<std::int64_t> member, Range range, std::string unit, std::string doc) {
  return whole(std::move(key), member, range, std::move(unit), std::move(doc));
}

Field bounds(std::string key, double& least, double& largest, Range range, std::string unit, std::string doc) {
  return {std::move(key), std::move(doc),
          Numbers{2,
                  [&least, &largest] {
                    return std::vector<double*>{&least, &largest};
                  },
                  [] { return true; }, range, std::move(unit), true}};
}

Field bounds(std::string key, std::optional<std::array<double, 2>>& member, Range range, std::string unit,
             std::string doc) {
  return numbers(std::move(key), Member<std::array<double, 2>>(member), range, std::move(unit), std::move(doc), true);
}

Field boolean(std::string key, Member<bool> member, std::string doc) {
  return {std::move(key), std::move(doc), Boolean{std::move(member)}};
}

Field name(std::string key, Member<std::string> member, std::string doc) {
  return {std::move(key), std::move(doc), Name{std::move(member)}};
}

Field file(std::string key, Member<std::string> member, std::string doc) {
  return {std::move(key), std::move(doc), File{std::move(member)}};
}

Field profile(std::string key, Member<std::string> member, std::string built_in, std::string doc) {
  return {std::move(key), std::move(doc), File{std::move(member), std::move(built_in)}};
}

Field paths(std::string key, std::vector<NamedPath>& members, std::string doc) {
  return {std::move(key), std::move(doc), Paths{&members}};
}

Field free(std::string key, Node& member, std::string definition, std::string doc) {
  return {std::move(key), std::move(doc), Free{&member, std::move(definition)}};
}

}  // namespace regista::config
