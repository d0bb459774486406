// SPDX-License-Identifier: MIT
#include "config/declaration.hpp"

#include <cassert>
#include <iterator>

#include "config/robot.hpp"

namespace regista::config {

std::vector<Field> joined(std::vector<Field> first, std::vector<Field> others) {
  first.insert(first.end(), std::make_move_iterator(others.begin()), std::make_move_iterator(others.end()));
  return first;
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
                  [member](std::int64_t value) { member.get() = static_cast<Whole>(value); }, member.present, range,
                  std::move(unit)}};
}
Field integer(std::string key, Member<int> member, Range range, std::string unit, std::string doc) {
  return whole(std::move(key), member, range, std::move(unit), std::move(doc));
}
Field integer(std::string key, Member<std::int64_t> member, Range range, std::string unit, std::string doc) {
  return whole(std::move(key), member, range, std::move(unit), std::move(doc));
}

Field bounds(std::string key, double& least, double& largest, Range range, std::string unit, std::string doc) {
  const auto ends = [&least, &largest] { return std::vector<double*>{&least, &largest}; };
  return {std::move(key), std::move(doc), Numbers{2, ends, [] { return true; }, range, std::move(unit), true}};
}

Field boolean(std::string key, Member<bool> member, std::string doc) {
  return {std::move(key), std::move(doc), Boolean{std::move(member)}};
}

Field name(std::string key, Member<std::string> member, std::string doc) {
  return {std::move(key), std::move(doc), Name{std::move(member)}};
}

Field file(std::string key, Member<std::string> member, std::string doc, std::string built_in) {
  return {std::move(key), std::move(doc), File{std::move(member), std::move(built_in)}};
}

Field paths(std::string key, std::vector<NamedPath>& members, std::string doc) {
  return {std::move(key), std::move(doc), Paths{&members}};
}

Field free(std::string key, Node& member, std::string definition, std::string doc) {
  return {std::move(key), std::move(doc), Free{&member, std::move(definition)}};
}

Field line(std::string key, std::string& text, std::string doc) {
  const auto read = [&text](const Node& node, const std::string& what, Mistakes&) { text = to_line(node, what); };
  return {std::move(key), std::move(doc),
          Own{"line", read, [&text] { return text.empty() ? Node() : Node::scalar(text, true); }}};
}

Field lines(std::string key, std::vector<Node>& texts, std::string doc) {
  const auto read = [&texts](const Node& node, const std::string& what, Mistakes& mistakes) {
    const auto elements = elements_of(node, what, "a list of texts");
    for (const Node& each : elements) mistakes.attempt(what, [&] { to_line(each, what); });
    texts.assign(elements.begin(), elements.end());
  };
  return {std::move(key), std::move(doc),
          Own{"lines", read, [&texts] { return texts.empty() ? Node() : Node::sequence(texts); }}};
}

}  // namespace regista::config
