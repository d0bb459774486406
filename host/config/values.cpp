// SPDX-License-Identifier: MIT
#include "config/values.hpp"

#include <fmt/format.h>

#include <set>
#include <type_traits>

#include "config/flow.hpp"
#include "config/parse.hpp"
#include "config/show.hpp"
#include "config/typed.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

std::string inside(const std::string& path, const std::string& key) { return path.empty() ? key : path + '.' + key; }

std::string in_words(const Node& node) {
  return !node ? "none" : node.kind() == Node::Kind::scalar ? texts::one_line(node.text()) : flow(node);
}

// Of maps whose keys nobody declares, key by key; of all else as a whole.
void compare_freely(const std::string& path, const Node& before, const Node& now, std::vector<std::string>& out) {
  if (same(before, now)) return;
  if (before.kind() != Node::Kind::map && now.kind() != Node::Kind::map) {
    out.push_back(fmt::format("{}: was {}, now {}", path, in_words(before), in_words(now)));
    return;
  }
  std::set<std::string> keys;
  for (const Node* side : {&before, &now}) {
    for (const Node::Entry& each : side->entries()) keys.insert(each.key);
  }
  for (const std::string& key : keys) compare_freely(inside(path, key), before[key], now[key], out);
}

void compare(const std::string& path, const Map& declared, const Node& before, const Node& now,
             std::vector<std::string>& out);

struct Comparison {
  const std::string& path;
  const Node &before, &now;
  std::vector<std::string>& out;

  template <class Kind>
  void operator()(const Kind&) const {
    compare_freely(path, before, now, out);
  }
  void operator()(const File&) const {}
  void operator()(const Paths&) const {}
  void operator()(const Section& section) const {
    if (before && now && section.present())
      compare(path, section.open(), before, now, out);
    else
      compare_freely(path, before, now, out);
  }
  void operator()(const List& list) const {
    const std::size_t then = before.elements().size(), today = now.elements().size();
    if (then != today) {
      out.push_back(fmt::format("the number of {}: was {}, now {}", path, then, today));
      return;
    }
    for (std::size_t i = 0; i < today && i < list.size(); ++i) {
      compare(fmt::format("{}.{}", path, i), list.element(i), before.elements()[i], now.elements()[i], out);
    }
  }
};

void compare(const std::string& path, const Map& declared, const Node& before, const Node& now,
             std::vector<std::string>& out) {
  for (const Field& each : declared.fields) {
    if (!each.decides) continue;
    const std::string name = inside(path, each.key);
    std::visit(Comparison{name, before[each.key], now[each.key], out}, each.kind);
  }
}

}  // namespace

std::string well_formed(const std::string& text) {
  using Json = nlohmann::ordered_json;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

Node values_of(const Map& declared) {
  return parse_text(well_formed(show(declared, Node(), {}, Remarks::without)), "the values in force");
}

nlohmann::ordered_json to_json(const Node& node) {
  using Json = nlohmann::ordered_json;
  switch (node.kind()) {
    case Node::Kind::absent:
    case Node::Kind::null:
      return nullptr;
    case Node::Kind::map: {
      Json out = Json::object();
      for (const Node::Entry& each : node.entries()) out[each.key] = to_json(each.value);
      return out;
    }
    case Node::Kind::sequence: {
      Json out = Json::array();
      for (const Node& each : node.elements()) out.push_back(to_json(each));
      return out;
    }
    case Node::Kind::scalar:
      break;
  }
  const std::string& text = node.text();
  if (node.quoted()) return text;
  if (text == "true" || text == "false") return text == "true";
  if (const auto number = typed_number(text)) {
    const Json parsed = Json::parse(text, nullptr, false);
    return parsed.is_number() ? parsed : Json(*number);
  }
  return text;
}

std::vector<std::string> differences(const Node& before, const Map& now) {
  std::vector<std::string> out;
  compare("", now, before, values_of(now), out);
  return out;
}

void rename_files(const Map& declared, const std::function<std::string(const std::string&)>& renamed) {
  for (const Field& each : declared.fields) {
    std::visit(
        [&](const auto& kind) {
          using Kind = std::remove_cvref_t<decltype(kind)>;
          if constexpr (std::is_same_v<Kind, File>) {
            if (kind.member.present() && !kind.member.get().empty()) kind.member.get() = renamed(kind.member.get());
          } else if constexpr (std::is_same_v<Kind, Paths>) {
            for (NamedPath& path : *kind.members) path.path = renamed(path.path);
          } else if constexpr (std::is_same_v<Kind, Section>) {
            if (kind.present()) rename_files(kind.open(), renamed);
          } else if constexpr (std::is_same_v<Kind, List>) {
            for (std::size_t i = 0; i < kind.size(); ++i) rename_files(kind.element(i), renamed);
          }
        },
        each.kind);
  }
}

}  // namespace regista::config
