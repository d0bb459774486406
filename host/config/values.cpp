// SPDX-License-Identifier: MIT
#include "config/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "config/document_files.hpp"
#include "config/parse.hpp"
#include "config/read.hpp"
#include "config/scalar.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

// Returns the shortest document number that reads as exactly `value`.
std::string scaled_text(double value, double scale) {
  if (scale == 1.0) return real_text(value);
  const double exact = value / scale;
  for (int digits = 1; digits <= 17; ++digits) {
    const double rounded = to_real(Node::scalar(fmt::format("{:.{}g}", exact, digits), false, {}), "");
    if (scale * rounded == value) return real_text(rounded);
  }
  // `exact` is rounded, so none of the numbers above may read as exactly `value`. Then a neighbour of `exact` may.
  for (const double neighbour : {std::nextafter(exact, -INFINITY), std::nextafter(exact, INFINITY)}) {
    if (scale * neighbour == value) return real_text(neighbour);
  }
  return real_text(exact);
}

class Page {
 public:
  Page(std::span<const PluginDeclaration> plugins, Remarks remarks) : plugins_(plugins), remarks_(remarks) {}

  std::string take() { return std::move(text_); }

  // Writes all keys of a map. For an element of a list, "- " replaces the last two spaces before the first key.
  void map(const Map& declared, const Node& node, int indent, bool element = false) {
    const std::size_t begin = text_.size();
    const PluginDeclaration* plugin = plugin_of(declared);
    for (const Field& each : declared.fields) {
      if (plugin && each.key == "params" && std::holds_alternative<Free>(each.kind)) {
        parameters(*plugin, node["params"], indent);
      } else {
        field(each, node[each.key], indent);
      }
    }
    if (element) text_.replace(begin + static_cast<std::size_t>(indent) - 2, 2, "- ");
  }

 private:
  void field(const Field& field, const Node& node, int indent) {
    std::visit([&](const auto& kind) { write(field, kind, node, indent); }, field.kind);
  }

  void write(const Field& field, const Real& real, const Node& node, int indent) {
    if (real.member.present()) line(field, scaled_text(real.member.get(), real.scale), real.unit, node, indent);
  }
  void write(const Field& field, const Integer& integer, const Node& node, int indent) {
    if (integer.present()) line(field, fmt::format("{}", integer.get()), integer.unit, node, indent);
  }
  void write(const Field& field, const Boolean& boolean, const Node& node, int indent) {
    if (boolean.member.present()) line(field, boolean.member.get() ? "true" : "false", "", node, indent);
  }
  void write(const Field& field, const Name& name, const Node& node, int indent) {
    if (name.member.present()) line(field, name_text(name.member.get()), "", node, indent);
  }
  void write(const Field& field, const File& file, const Node& node, int indent) {
    if (file.member.present() && !file.member.get().empty())
      line(field, flow_text(file.member.get(), true), "", node, indent);
  }
  void write(const Field& field, const Paths& paths, const Node& node, int indent) {
    const auto path = [](const NamedPath& each) { return Node::scalar(each.path, true); };
    if (!paths.members->empty()) line(field, flow(sequence_of(*paths.members, path)), "", node, indent);
  }
  void write(const Field& field, const Choice& choice, const Node& node, int indent) {
    line(field, choice.names[choice.get()], "", node, indent);
  }
  void write(const Field& field, const Numbers& numbers, const Node& node, int indent) {
    const auto number = [](const double* each) { return Node::scalar(real_text(*each)); };
    if (numbers.present()) line(field, flow(sequence_of(numbers.get(), number)), numbers.unit, node, indent);
  }
  void write(const Field& field, const Own& own, const Node& node, int indent) {
    if (const Node value = own.write()) line(field, flow(value), "", node, indent);
  }
  void write(const Field& field, const Free& free, const Node& node, int indent) {
    if (*free.member) line(field, flow(*free.member), "", node, indent);
  }
  void write(const Field& field, const Section& section, const Node& node, int indent) {
    if (!section.present()) return;
    heading(field, indent);
    map(section.open(), node, indent + 2);
  }
  void write(const Field& field, const List& list, const Node& node, int indent) {
    if (list.size() == 0) return line(field, "[]", "", node, indent);
    heading(field, indent);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::span<const Node> elements = node.elements();
      map(list.element(i), i < elements.size() ? Node(elements[i]) : Node(), indent + 4, true);
    }
  }
  void write(const Field& declared, const Dictionary& dictionary, const Node& node, int indent) {
    if (dictionary.size() == 0) return line(declared, "{}", "", node, indent);
    heading(declared, indent);
    for (std::size_t i = 0; i < dictionary.size(); ++i) {
      const Field entry = dictionary.element(i);
      field(entry, node[entry.key], indent + 2);
    }
  }

  // Returns the declaration of the plugin that a map names; null if the plugin is unknown.
  const PluginDeclaration* plugin_of(const Map& map) const {
    for (const Field& field : map.fields) {
      const Name* name = std::get_if<Name>(&field.kind);
      if (map.plugin_kind.empty() || field.key != "plugin" || !name) continue;
      const auto found = std::ranges::find_if(plugins_, [&](const PluginDeclaration& plugin) {
        return plugin.kind == map.plugin_kind && plugin.id == name->member.get();
      });
      if (found != plugins_.end()) return &*found;
    }
    return nullptr;
  }

  void parameters(const PluginDeclaration& plugin, const Node& params, int indent) {
    if (plugin.parameters.empty() && params.entries().empty()) return;
    line(indent, "params:", "parameters of the plugin");
    for (const PluginParameter& parameter : plugin.parameters) {
      const Node given = params[parameter.name];
      const std::string value = given ? written(parameter, given) : initial(parameter);
      if (value.empty()) continue;
      line(indent + 2, fmt::format("{}: {}", flow_text(parameter.name, false), value),
           comment(parameter.unit, parameter.doc, given));
    }
    // Shows unknown parameters, too. Another function reports them as mistakes.
    for (const Node::Entry& entry : params.entries()) {
      const auto declared = std::ranges::find(plugin.parameters, entry.key, &PluginParameter::name);
      if (declared != plugin.parameters.end()) continue;
      line(indent + 2, fmt::format("{}: {}", flow_text(entry.key, false), flow(entry.value)),
           comment("", "unknown to the plugin", entry.value));
    }
  }

  // Returns the value as YAML. A file name becomes an absolute path, because a reader may have another current folder.
  static std::string written(const PluginParameter& parameter, const Node& given) {
    const bool file = parameter.type == PluginParameter::Type::file && given.kind() == Node::Kind::scalar;
    if (!file || given.text().empty()) return flow(given);
    return flow_text(std::filesystem::absolute(named_file(given, parameter.name)).string(), true);
  }

  static std::string initial(const PluginParameter& parameter) {
    using Type = PluginParameter::Type;
    if (parameter.type == Type::boolean) return parameter.initial != 0.0 ? "true" : "false";
    if (parameter.type == Type::file && parameter.initial_text.empty()) return "";
    if (parameter.type == Type::file || parameter.type == Type::text) return flow_text(parameter.initial_text, true);
    if (parameter.type != Type::choice) return real_text(parameter.initial);
    const auto index = static_cast<std::size_t>(std::max(0.0, parameter.initial));
    return index < parameter.choices.size() ? flow_text(parameter.choices[index], false) : "";
  }

  // A name that YAML would read as a boolean needs quotes.
  static std::string name_text(const std::string& name) {
    const std::string word = texts::lower(name);
    return flow_text(name, word == "true" || word == "false");
  }

  static std::string comment(const std::string& unit, const std::string& doc, const Node& origin) {
    const std::string measure = unit.empty() || unit == "1" ? "" : unit + ", ";
    return fmt::format("{}{}; {}", measure, doc, origin ? to_string(origin.where()) : "default");
  }

  void line(const Field& field, const std::string& value, const std::string& unit, const Node& node, int indent) {
    line(indent, fmt::format("{}: {}", name_text(field.key), value), comment(unit, field.doc, node));
  }
  void heading(const Field& field, int indent) { line(indent, name_text(field.key) + ':', field.doc); }
  void line(int indent, const std::string& content, const std::string& remark) {
    constexpr std::size_t column = 44;
    const std::string text = std::string(static_cast<std::size_t>(indent), ' ') + content;
    text_ +=
        remarks_ == Remarks::with ? fmt::format("{:<{}}  # {}\n", text, column, texts::one_line(remark)) : text + '\n';
  }

  std::span<const PluginDeclaration> plugins_;
  Remarks remarks_;
  std::string text_;
};

using Json = nlohmann::ordered_json;

std::string in_words(const Node& node) {
  return !node ? "none" : node.kind() == Node::Kind::scalar ? texts::one_line(node.text()) : flow(node);
}

// Adds the differences of two values without a declaration. Maps are compared key by key, other values as a whole.
void compare_freely(const std::string& path, const Node& before, const Node& now, std::vector<std::string>& out) {
  if (same(before, now)) return;
  if (before.kind() != Node::Kind::map && now.kind() != Node::Kind::map)
    return out.push_back(fmt::format("{}: was {}, now {}", path, in_words(before), in_words(now)));
  std::set<std::string> keys;
  for (const Node* side : {&before, &now}) {
    for (const Node::Entry& each : side->entries()) keys.insert(each.key);
  }
  for (const std::string& key : keys) compare_freely(inside(path, key), before[key], now[key], out);
}

void compare(const std::string& path, const Map& declared, const Node& before, const Node& now,
             std::vector<std::string>& out) {
  for (const Field& each : declared.fields) {
    if (!each.decides || std::holds_alternative<File>(each.kind) || std::holds_alternative<Paths>(each.kind)) continue;
    const std::string name = inside(path, each.key);
    const Node then = before[each.key], today = now[each.key];
    if (const List* const list = std::get_if<List>(&each.kind)) {
      const std::size_t count = today.elements().size();
      if (then.elements().size() != count) {
        out.push_back(fmt::format("the number of {}: was {}, now {}", name, then.elements().size(), count));
        continue;
      }
      for (std::size_t i = 0; i < count && i < list->size(); ++i) {
        compare(fmt::format("{}.{}", name, i), list->element(i), then.elements()[i], today.elements()[i], out);
      }
    } else if (const Section* const section = std::get_if<Section>(&each.kind);
               section != nullptr && then && today && section->present()) {
      compare(name, section->open(), then, today, out);
    } else {
      compare_freely(name, then, today, out);
    }
  }
}

// Converts a list of maps with different names into a map from these names to the maps. Returns another node unchanged.
Node by_names(const Node& node) {
  if (node.kind() != Node::Kind::sequence || node.elements().empty()) return node;
  std::vector<Node::Entry> entries;
  for (const Node& each : node.elements()) {
    const Node name = each["name"];
    const auto same_key = [&](const Node::Entry& other) { return other.key == name.text(); };
    if (!name || std::ranges::any_of(entries, same_key)) return node;
    entries.push_back({name.text(), each.where(), each});
  }
  return Node::map(std::move(entries), node.where());
}

void compare(const std::string& path, const Node& left, const Node& right, std::vector<Difference>& out) {
  const Node first = by_names(left), second = by_names(right);
  if (first.kind() == Node::Kind::map && second.kind() == Node::Kind::map) {
    for (const Node::Entry& each : first.entries()) compare(inside(path, each.key), each.value, second[each.key], out);
    for (const Node::Entry& each : second.entries()) {
      if (!first[each.key]) compare(inside(path, each.key), {}, each.value, out);
    }
  } else if (!same(left, right)) {
    out.push_back({path, left ? flow(left) : "", right ? flow(right) : ""});
  }
}

}  // namespace

std::string show(const Map& map, const Node& document, std::span<const PluginDeclaration> plugins, Remarks remarks) {
  Page page(plugins, remarks);
  page.map(map, document, 0);
  return page.take();
}

std::string document_text(const Map& declared) {
  const Json text = show(declared, Node(), {}, Remarks::without);
  return Json::parse(text.dump(-1, ' ', false, Json::error_handler_t::replace)).get<std::string>();
}

Node values_of(const Map& declared) { return parse_text(document_text(declared), "the values in force"); }

nlohmann::ordered_json to_json(const Node& node) {
  if (node.kind() == Node::Kind::map) {
    Json out = Json::object();
    for (const Node::Entry& each : node.entries()) out[each.key] = to_json(each.value);
    return out;
  }
  if (node.kind() == Node::Kind::sequence) {
    Json out = Json::array();
    for (const Node& each : node.elements()) out.push_back(to_json(each));
    return out;
  }
  if (node.kind() != Node::Kind::scalar) return nullptr;
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

std::vector<Difference> differences(const Node& first, const Node& second) {
  std::vector<Difference> out;
  compare("", first, second, out);
  return out;
}

void rename_files(const Map& declared, const std::function<std::string(const std::string&)>& renamed) {
  for (const Field& each : declared.fields) {
    if (const File* const file = std::get_if<File>(&each.kind)) {
      if (file->member.present() && !file->member.get().empty()) file->member.get() = renamed(file->member.get());
    } else if (const Paths* const paths = std::get_if<Paths>(&each.kind)) {
      for (NamedPath& path : *paths->members) path.path = renamed(path.path);
    } else if (const Section* const section = std::get_if<Section>(&each.kind)) {
      if (section->present()) rename_files(section->open(), renamed);
    } else if (const List* const list = std::get_if<List>(&each.kind)) {
      for (std::size_t i = 0; i < list->size(); ++i) rename_files(list->element(i), renamed);
    }
  }
}

}  // namespace regista::config
