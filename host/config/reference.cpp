// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <set>
#include <string_view>
#include <vector>

#include "config/documents.hpp"
#include "config/scalar.hpp"
#include "config/team.hpp"
#include "config/team_document.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

using Json = nlohmann::ordered_json;

std::string with_unit(const std::string& doc, const std::string& unit) {
  return unit.empty() || unit == "1" ? doc : fmt::format("{} [{}]", doc, unit);
}

Json number(Range range) { return {{"type", "number"}, {"minimum", range.least}, {"maximum", range.most}}; }
Json text() { return {{"type", "string"}, {"minLength", 1}}; }
Json reference(const std::string& name) { return {{"$ref", "#/$defs/" + name}}; }
Json list_of(const Json& items, std::size_t least = 1) {
  return {{"type", "array"}, {"items", items}, {"minItems", least}};
}
Json list_of(const Json& items, std::size_t least, std::size_t most) {
  Json out = list_of(items, least);
  out["maxItems"] = most;
  return out;
}

// Writes the schema of a map in one of two forms: a strict form, and a variant for a file with `extends`. In a variant
// no key is required, and null removes a key. A list replaces the whole extended list, so its elements have the strict
// form. A map from names to values may change single elements of an extended list with named elements.
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

  // Adds the ids of all known plugins of this kind, and the parameters of each plugin.
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
        result = text();
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

  // Adds the description. A variant also accepts null, which removes the key.
  Json described(const Json& json, const std::string& doc) const {
    Json result = variant_ ? Json{{"anyOf", {json, {{"type", "null"}}}}} : json;
    result["description"] = doc;
    return result;
  }

  Json value(const Real& real) const {
    Json result = number(real.range);
    if (real.member.present()) {
      const double exact = real.member.get() / real.scale;
      result["default"] = std::stod(fmt::format("{:.12g}", exact));  // hides the rounding error of the conversion
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
  Json value(const Paths&) const { return reference("paths"); }
  Json value(const File&) const { return text(); }
  Json value(const Choice& choice) const { return {{"enum", choice.names}}; }
  Json value(const Numbers& numbers) const { return list_of(number(numbers.range), numbers.count, numbers.count); }
  Json value(const Own& own) const { return reference(own.definition); }
  Json value(const Free& free) const { return reference(free.definition); }
  Json value(const Section& section) const { return map(section.open()); }
  Json value(const List& list) const {
    const Map element = list.append();
    const Json whole = list_of(strict().map(element), list.least, list.most);
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

// The schema of a tuned path: `path`, or `{path: ..., range: [least, largest]}`.
Json tuned_paths() {
  const Json narrowed{{"type", "object"},
                      {"properties", {{"path", reference("line")}, {"range", list_of({{"type", "number"}}, 2, 2)}}},
                      {"required", {"path"}},
                      {"additionalProperties", false}};
  return list_of({{"anyOf", {reference("line"), narrowed}}});
}

// The schemas that Own::definition and Free::definition refer to, by name.
Json definitions() {
  const Json point = list_of(number(coordinates), 2, 2);
  const std::span<const std::string> anchors = anchor_names();
  const Json anchor{{"enum", std::vector<std::string>(anchors.begin(), anchors.end())}};
  const Json robot{{"type", "integer"}, {"minimum", 1}, {"maximum", 22}}, moment = number({0, 1e6});
  Json robots = list_of(robot), shirts = list_of({{"type", "integer"}, {"minimum", 1}, {"maximum", most_shirt_number}});
  robots["uniqueItems"] = shirts["uniqueItems"] = true;
  std::vector<std::string> keys = usable_keys();
  std::erase(keys, "roles");
  return {
      {"place", {{"anyOf", {anchor, point}}}},
      {"line", {{"type", "string"}, {"pattern", "^[^\n]*$"}}},
      {"shirt_numbers", {{"anyOf", {{{"type", "integer"}, {"minimum", 0}, {"maximum", most_shirt_number}}, shirts}}}},
      {"robots", {{"anyOf", {{{"enum", {"all", "any"}}}, robot, robots}}}},
      {"moments", {{"anyOf", {moment, list_of(moment)}}}},
      {"segment", list_of(reference("place"), 2, 2)},
      {"lines", list_of(reference("line"))},
      {"pairs", list_of(list_of(reference("line"), 2, 2))},
      {"values", {{"type", "array"}, {"minItems", 1}, {"uniqueItems", true}}},
      {"paths", {{"anyOf", {text(), list_of(text())}}}},
      {"settings", {{"type", "object"}}},
      {"measured",
       {{"anyOf",
         {reference("line"),
          {{"type", "object"}, {"additionalProperties", {{"type", "number"}}}, {"minProperties", 1}}}}}},
      {"tuned", tuned_paths()},
      {"points", list_of({{"type", "object"}, {"additionalProperties", {{"type", "number"}}}})},
      {"params", {{"type", "object"}}},
      {"use",
       {{"type", "object"},
        {"properties", {{"roles", {{"type", "string"}, {"pattern", name_pattern}}}}},
        {"propertyNames", {{"pattern", fmt::format("^(roles|({})(\\..+)?)$", fmt::join(keys, "|"))}}}}}};
}

struct Form {
  std::string_view name, text;
};

// The descriptions of the definitions that Own and Free name, except descriptions with generated text.
constexpr std::array forms{
    Form{"segment", "A list of two places: `[ball, own_goal]`."},
    Form{"line", "A text of one line."},
    Form{"lines", "A list of texts, each of one line."},
    Form{"pairs", "A list of pairs of texts: `[[a, b], [a, c]]`."},
    Form{"values", "A list of different values, of whatever the path leads to."},
    Form{"paths", "A file or a folder, or a list of these. Relative names begin at the folder of the document."},
    Form{"shirt_numbers", "A shirt number, or a list of different ones: `[1, 2]`."},
    Form{"robots", "`all`, `any`, a shirt number, or a list of shirt numbers."},
    Form{"moments", "Seconds of the match, a number or a list of numbers."},
    Form{"settings", "A map from paths to values, as `--set` takes them: `{a.sender.params.reserve: 20}`."},
    Form{"measured",
         "The name of a number of a match ([metrics.md](metrics.md)), or a map from such names to weights."},
    Form{"tuned", "A list of paths, each as a text or as `{path: PATH, range: [least, largest]}`."},
    Form{"points", "A list of maps from paths of parameters to numbers: `[{utility.terms.distance.weight: 0.4}]`."},
    Form{"plugin",
         "`{plugin: ID, params: {NAME: VALUE}}`: a plugin of that kind with its parameters "
         "([plugin-reference.md](plugin-reference.md)). `file: FILE` beside it names a certain shared object, instead "
         "of the one that the search finds."},
    Form{"params", "A map from parameters of the plugin to their values ([plugin-reference.md](plugin-reference.md))."},
};

std::string text_of_form(const std::string& name) {
  if (name == "place") {
    return fmt::format("A point of the field: `{}`, or `[x, y]` in metres.", fmt::join(anchor_names(), "`, `"));
  }
  if (name == "use") {
    return fmt::format(
        "A map from paths of the team, beginning with one of `{}`, to the values that hold instead; "
        "`roles` names a list of roles.",
        fmt::join(usable_keys(), "`, `"));
  }
  const auto form = std::ranges::find(forms, name, &Form::name);
  assert(form != forms.end());
  return std::string(form->text);
}

std::string in_cell(std::string_view text) { return texts::with_backslashes(text, "|"); }

// Number of the keys of a plugin: plugin, file and params.
constexpr std::size_t plugin_keys = 3;

class TableWriter {
 public:
  explicit TableWriter(std::set<std::string>& used) : used_(used) {}

  void map(const Map& declared, const std::string& prefix) {
    for (const Field& each : declared.fields) {
      if (!declared.plugin_kind.empty() && each.key == "plugin") {
        row(prefix + each.key, "id of " + texts::with_article(declared.plugin_kind), each);
      } else {
        field(each, prefix);
      }
    }
    const std::vector<std::string> keys = texts::names_of(
        declared.exactly_one, [&](const std::string& key) { return fmt::format("`{}{}`", prefix, key); });
    const std::string start = prefix.empty() ? "E" : fmt::format("Within `{}` e", prefix.substr(0, prefix.size() - 1));
    if (!keys.empty()) remarks_ += fmt::format("\n{}xactly one of {} must be given.\n", start, fmt::join(keys, ", "));
    for (const auto& [key, other] : declared.needs) {
      remarks_ += fmt::format("\n`{0}{1}` goes with `{0}{2}`.\n", prefix, key, other);
    }
  }

  std::string text() const { return "| key | value | default | meaning |\n|---|---|---|---|\n" + rows_ + remarks_; }

 private:
  void row(const std::string& path, const std::string& value, const Field& field, const std::string& initial = {}) {
    const std::string shown = field.required                ? "required"
                              : !field.default_from.empty() ? "from " + field.default_from
                              : initial.empty()             ? ""
                                                            : fmt::format("`{}`", initial);
    rows_ += fmt::format("| `{}` | {} | {} | {} |\n", path, in_cell(value), shown, in_cell(field.doc));
  }

  void field(const Field& field, const std::string& prefix) {
    std::visit([&](const auto& kind) { write(field, kind, prefix + field.key); }, field.kind);
  }

  void write(const Field& field, const Real& real, const std::string& path) {
    row(path, range_text(real.range, real.unit), field,
        real.member.present() ? fmt::format("{:.10g}", real.member.get() / real.scale) : "");
  }
  void write(const Field& field, const Integer& integer, const std::string& path) {
    row(path, "whole, " + range_text(integer.range, integer.unit), field,
        integer.present() ? fmt::format("{}", integer.get()) : "");
  }
  void write(const Field& field, const Boolean& boolean, const std::string& path) {
    row(path, "`true` or `false`", field, !boolean.member.present() ? "" : boolean.member.get() ? "true" : "false");
  }
  void write(const Field& field, const Name& name, const std::string& path) {
    row(path, "a name", field, name.member.present() ? name.member.get() : "");
  }
  void write(const Field& field, const File& file, const std::string& path) {
    row(path, "a file", field, file.built_in);
  }
  void write(const Field& field, const Paths&, const std::string& path) { form(field, "paths", path); }
  void write(const Field& field, const Choice& choice, const std::string& path) {
    row(path, fmt::format("`{}`", fmt::join(choice.names, "`, `")), field, choice.names[choice.get()]);
  }
  void write(const Field& field, const Numbers& numbers, const std::string& path) {
    const auto number = [](const double* each) { return Node::scalar(fmt::format("{:.10g}", *each)); };
    row(path,
        fmt::format("a list of {}{} numbers, {}", numbers.count, numbers.ascending ? " ascending" : "",
                    range_text(numbers.range, numbers.unit)),
        field, numbers.present() ? flow(sequence_of(numbers.get(), number)) : "");
  }
  void write(const Field& field, const Own& own, const std::string& path) { form(field, own.definition, path); }
  void write(const Field& field, const Free& free, const std::string& path) { form(field, free.definition, path); }
  void form(const Field& field, const std::string& name, const std::string& path) {
    used_.insert(name);
    row(path, fmt::format("[{0}](#{0})", name), field);
  }
  void write(const Field& field, const Section& section, const std::string& path) {
    const Map inside = section.open();
    if (!inside.plugin_kind.empty() && inside.fields.size() == plugin_keys) {
      used_.insert("plugin");
      row(path, fmt::format("{}, a [plugin](#plugin)", texts::with_article(inside.plugin_kind)), field);
      return;
    }
    row(path, "a map", field);
    map(inside, path + '.');
  }
  void write(const Field& field, const List& list, const std::string& path) {
    row(path, fmt::format("a list of {} to {} maps", list.least, list.most), field);
    map(list.append(), path + "[].");
  }
  void write(const Field& declared, const Dictionary& dictionary, const std::string& path) {
    row(path, fmt::format("a map of {} to {} names", dictionary.least, dictionary.most), declared);
    field(dictionary.append("NAME"), path + '.');
  }

  std::set<std::string>& used_;
  std::string rows_, remarks_;
};

}  // namespace

std::string schema(const DocumentKind& kind, std::span<const PluginDeclaration> plugins) {
  Json parts;
  kind.with_defaults([&](const Map& map) {
    parts = {{"document", SchemaWriter(plugins, false).map(map)}, {"variant", SchemaWriter(plugins, true).map(map)}};
  });
  parts["variant"]["properties"]["extends"] = {
      {"type", "string"}, {"minLength", 1}, {"description", "file that this one is a variant of, relative to it"}};
  // Adds only definitions that the schema uses. The loop goes backwards, because a definition may use earlier ones.
  const Json all = definitions();
  for (auto definition = all.rbegin(); definition != all.rend(); ++definition) {
    const std::string reference = fmt::format("\"#/$defs/{}\"", definition.key());
    if (parts.dump().find(reference) != std::string::npos) parts[definition.key()] = definition.value();
  }
  const Json document{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                      {"title", fmt::format("Regista {}", kind.name)},
                      {"type", "object"},
                      {"if", {{"required", {"extends"}}}},
                      {"then", {{"$ref", "#/$defs/variant"}}},
                      {"else", {{"$ref", "#/$defs/document"}}},
                      {"$defs", parts}};
  return document.dump(2) + '\n';
}

std::string reference_text(std::span<const DocumentKind> kinds) {
  std::string out =
      "# Documents\n\nWritten by `regista config reference` from the declarations by which documents are read. "
      "`roles.NAME[].target` is the key\n`target` of each element of the list that stands under a name of yours in "
      "`roles`.\n";
  std::set<std::string> used;
  for (const DocumentKind& kind : kinds) {
    TableWriter writer(used);
    kind.with_defaults([&](const Map& declared) { writer.map(declared, ""); });
    out += fmt::format("\n## {}\n\n{}\n\n{}", kind.name, kind.about, writer.text());
  }
  if (!used.empty()) out += "\n## Forms of values\n";
  for (const std::string& name : used) out += fmt::format("\n### {}\n\n{}\n", name, text_of_form(name));
  return out;
}

}  // namespace regista::config
