// SPDX-License-Identifier: MIT
// Two forms of every map: strict, and variant for a file with `extends`, in which nothing is required and null removes
// a key. A list replaces the one below it as a whole, so its elements are strict; one whose elements have names may be
// extended by a map of these names instead.
#include "config/schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "config/place.hpp"
#include "config/scalar.hpp"
#include "config/team_page.hpp"
#include "texts/json.hpp"

namespace regista::config {
namespace {

using Json = nlohmann::ordered_json;

std::string with_unit(const std::string& doc, const std::string& unit) {
  return unit.empty() || unit == "1" ? doc : fmt::format("{} [{}]", doc, unit);
}

Json number(Range range) { return {{"type", "number"}, {"minimum", range.least}, {"maximum", range.most}}; }

class SchemaWriter {
 public:
  SchemaWriter(std::span<const PluginDeclaration> plugins, bool variant) : plugins_(plugins), variant_(variant) {}

  Json map(const Map& declared) const {
    Json properties = Json::object(), required = Json::array();
    for (const Field& each : declared.fields) {
      properties[each.key] = field(each);
      if (each.required) required.push_back(each.key);
    }
    Json result{{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
    if (!variant_ && !required.empty()) result["required"] = required;
    if (!variant_ && !declared.exactly_one.empty()) {
      Json one = Json::array();
      for (const std::string& key : declared.exactly_one) one.push_back({{"required", {key}}});
      result["oneOf"] = one;
    }
    if (!variant_) {
      for (const auto& [key, other] : declared.needs) result["dependentRequired"][key] = {other};
    }
    if (!declared.plugin_kind.empty() && !plugins_.empty()) discriminate(result, declared.plugin_kind);
    return result;
  }

 private:
  SchemaWriter strict() const { return {plugins_, false}; }

  // Which plugins there are of a kind, and for each its own parameters.
  void discriminate(Json& result, const std::string& kind) const {
    Json ids = Json::array(), cases = Json::array();
    for (const PluginDeclaration& plugin : plugins_) {
      if (plugin.kind != kind) continue;
      ids.push_back(plugin.id);
      Json params = Json::object();
      for (const PluginParameter& each : plugin.parameters) params[each.name] = parameter(each);
      const Json object{{"type", "object"}, {"properties", params}, {"additionalProperties", false}};
      cases.push_back({{"if", {{"properties", {{"plugin", {{"const", plugin.id}}}}}, {"required", {"plugin"}}}},
                       {"then", {{"description", plugin.summary}, {"properties", {{"params", object}}}}}});
    }
    Json& plugin = result["properties"]["plugin"];
    plugin = described({{"enum", ids}}, plugin["description"]);
    if (!cases.empty()) result["allOf"] = cases;
  }

  Json parameter(const PluginParameter& parameter) const {
    Json result;
    switch (parameter.type) {
      case PluginParameter::Type::real:
        result = number({parameter.minimum, parameter.maximum});
        result["default"] = parameter.initial;
        break;
      case PluginParameter::Type::integer:
        result = number({parameter.minimum, parameter.maximum});
        result["type"] = "integer";
        result["default"] = static_cast<std::int64_t>(parameter.initial);
        break;
      case PluginParameter::Type::boolean:
        result = {{"type", "boolean"}, {"default", parameter.initial != 0.0}};
        break;
      case PluginParameter::Type::choice:
        result = {{"enum", parameter.choices}};
        break;
      case PluginParameter::Type::text:
        result = {{"type", "string"}, {"default", parameter.initial_text}};
        break;
      case PluginParameter::Type::file:
        result = {{"type", "string"}, {"minLength", 1}};
        break;
    }
    return described(result, with_unit(parameter.doc, parameter.unit) + (parameter.tunable ? " (tunable)" : ""));
  }

  Json field(const Field& field) const {
    Json result = std::visit([this](const auto& kind) { return value(kind); }, field.kind);
    std::string unit;
    if (const Real* real = std::get_if<Real>(&field.kind)) unit = real->unit;
    if (const Integer* integer = std::get_if<Integer>(&field.kind)) unit = integer->unit;
    if (const Numbers* numbers = std::get_if<Numbers>(&field.kind)) unit = numbers->unit;
    return described(result, with_unit(field.doc, unit));
  }

  // In a variant null removes the key.
  Json described(const Json& json, const std::string& doc) const {
    Json result = variant_ ? Json{{"anyOf", {json, {{"type", "null"}}}}} : json;
    result["description"] = doc;
    return result;
  }

  Json value(const Real& real) const {
    Json result = number(real.range);
    if (real.member.present()) {
      const double exact = real.member.get() / real.scale;
      result["default"] = std::stod(fmt::format("{:.12g}", exact));  // degrees without the traces of their conversion
    }
    return result;
  }
  Json value(const Integer& integer) const {
    Json result{{"type", "integer"},
                {"minimum", static_cast<std::int64_t>(integer.range.least)},
                {"maximum", static_cast<std::int64_t>(integer.range.most)}};
    if (integer.present()) result["default"] = integer.get();
    return result;
  }
  Json value(const Boolean& boolean) const {
    Json result{{"type", "boolean"}};
    if (boolean.member.present()) result["default"] = boolean.member.get();
    return result;
  }
  Json value(const Name&) const { return {{"type", "string"}, {"pattern", name_pattern}, {"maxLength", 64}}; }
  Json value(const Paths&) const { return {{"$ref", "#/$defs/paths"}}; }
  Json value(const File&) const { return {{"type", "string"}, {"minLength", 1}}; }
  Json value(const Choice& choice) const { return {{"enum", choice.names}}; }
  Json value(const Numbers& numbers) const {
    return {
        {"type", "array"}, {"items", number(numbers.range)}, {"minItems", numbers.count}, {"maxItems", numbers.count}};
  }
  Json value(const Own& own) const { return {{"$ref", "#/$defs/" + own.definition}}; }
  Json value(const Free& free) const { return {{"$ref", "#/$defs/" + free.definition}}; }
  Json value(const Section& section) const { return map(section.open()); }
  Json value(const List& list) const {
    const Map element = list.append();
    const Json whole{
        {"type", "array"}, {"items", strict().map(element)}, {"minItems", list.least}, {"maxItems", list.most}};
    const bool has_names =
        std::ranges::any_of(element.fields, [](const Field& each) { return each.key == "name" && each.required; });
    if (!variant_ || !has_names) return whole;
    Json by_name = map(element);
    for (const char* const place : {"before", "after"}) {
      by_name["properties"][place] = {{"type", "string"},
                                      {"description", fmt::format("the element that it stands {}", place)}};
    }
    return {
        {"anyOf", {whole, {{"type", "object"}, {"additionalProperties", {{"anyOf", {by_name, {{"type", "null"}}}}}}}}}};
  }
  Json value(const Dictionary& dictionary) const {
    Json result{{"type", "object"},
                {"propertyNames", {{"pattern", name_pattern}}},
                {"additionalProperties", field(dictionary.append("name"))},
                {"maxProperties", dictionary.most}};
    if (!variant_) result["minProperties"] = dictionary.least;
    return result;
  }

  std::span<const PluginDeclaration> plugins_;
  bool variant_;
};

// `path`, or `{path: ..., range: [least, largest]}`.
Json tuned_paths() {
  const Json range{{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}};
  const Json narrowed{{"type", "object"},
                      {"properties", {{"path", {{"$ref", "#/$defs/line"}}}, {"range", range}}},
                      {"required", {"path"}},
                      {"additionalProperties", false}};
  const Json path{{"anyOf", {{{"$ref", "#/$defs/line"}}, narrowed}}};
  return {{"type", "array"}, {"items", path}, {"minItems", 1}};
}

// What Own and Free refer to.
Json definitions() {
  const Json coordinate = number({-farthest_coordinate, farthest_coordinate});
  const Json point{{"type", "array"}, {"items", coordinate}, {"minItems", 2}, {"maxItems", 2}};
  const std::span<const std::string> anchors = anchor_names();
  const Json anchor{{"enum", std::vector<std::string>(anchors.begin(), anchors.end())}};
  const Json robot{{"type", "integer"}, {"minimum", 1}, {"maximum", 22}};
  const Json robots{{"type", "array"}, {"items", robot}, {"minItems", 1}, {"uniqueItems", true}};
  const Json moment = number({0, 1e6}), moments{{"type", "array"}, {"items", moment}, {"minItems", 1}};
  std::string keys;
  for (const std::string& key : usable_keys()) {
    if (key != "roles") keys += (keys.empty() ? "" : "|") + key;
  }
  return {{"place", {{"anyOf", {anchor, point}}}},
          {"line", {{"type", "string"}, {"pattern", "^[^\n]*$"}}},
          {"robots", {{"anyOf", {{{"enum", {"all", "any"}}}, robot, robots}}}},
          {"moments", {{"anyOf", {moment, moments}}}},
          {"segment", {{"type", "array"}, {"items", {{"$ref", "#/$defs/place"}}}, {"minItems", 2}, {"maxItems", 2}}},
          {"lines", {{"type", "array"}, {"items", {{"$ref", "#/$defs/line"}}}, {"minItems", 1}}},
          {"pairs",
           {{"type", "array"},
            {"items", {{"type", "array"}, {"items", {{"$ref", "#/$defs/line"}}}, {"minItems", 2}, {"maxItems", 2}}},
            {"minItems", 1}}},
          {"values", {{"type", "array"}, {"minItems", 1}, {"uniqueItems", true}}},
          {"paths",
           {{"anyOf",
             {{{"type", "string"}, {"minLength", 1}},
              {{"type", "array"}, {"items", {{"type", "string"}, {"minLength", 1}}}, {"minItems", 1}}}}}},
          {"settings", {{"type", "object"}}},
          {"measured",
           {{"anyOf",
             {{{"$ref", "#/$defs/line"}},
              {{"type", "object"}, {"additionalProperties", {{"type", "number"}}}, {"minProperties", 1}}}}}},
          {"tuned", tuned_paths()},
          {"params", {{"type", "object"}}},
          {"use",
           {{"type", "object"},
            {"properties", {{"roles", {{"type", "string"}, {"pattern", name_pattern}}}}},
            {"propertyNames", {{"pattern", fmt::format("^(roles|({})(\\..+)?)$", keys)}}}}}};
}

}  // namespace

std::string schema(const Map& map, const std::string& title, std::span<const PluginDeclaration> plugins) {
  Json parts{{"document", SchemaWriter(plugins, false).map(map)}, {"variant", SchemaWriter(plugins, true).map(map)}};
  parts["variant"]["properties"]["extends"] = {
      {"type", "string"}, {"minLength", 1}, {"description", "file that this one is a variant of, relative to it"}};
  // Only the definitions that are referred to; a later one may refer to an earlier one.
  const Json all = definitions();
  for (auto definition = all.rbegin(); definition != all.rend(); ++definition) {
    const std::string reference = fmt::format("\"#/$defs/{}\"", definition.key());
    if (parts.dump().find(reference) != std::string::npos) parts[definition.key()] = definition.value();
  }
  const Json document{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                      {"title", title},
                      {"type", "object"},
                      {"if", {{"required", {"extends"}}}},
                      {"then", {{"$ref", "#/$defs/variant"}}},
                      {"else", {{"$ref", "#/$defs/document"}}},
                      {"$defs", parts}};
  return document.dump(2) + '\n';
}

}  // namespace regista::config
