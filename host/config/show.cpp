// SPDX-License-Identifier: MIT
#include "config/show.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "config/file.hpp"
#include "config/flow.hpp"
#include "config/scalar.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

// The shortest number of the document that reads as exactly `value`.
std::string scaled_text(double value, double scale) {
  if (scale == 1.0) return real_text(value);
  const double exact = value / scale;
  for (int digits = 1; digits <= 17; ++digits) {
    const double rounded = to_real(Node::scalar(fmt::format("{:.{}g}", exact, digits), false, {}), "");
    if (scale * rounded == value) return real_text(rounded);
  }
  // Rounding has moved the quotient away: one of its neighbours gives the value back, if any number does.
  for (const double neighbour : {std::nextafter(exact, -INFINITY), std::nextafter(exact, INFINITY)}) {
    if (scale * neighbour == value) return real_text(neighbour);
  }
  return real_text(exact);
}

class Page {
 public:
  Page(std::span<const PluginDeclaration> plugins, Remarks remarks) : plugins_(plugins), remarks_(remarks) {}

  std::string take() { return std::move(text_); }

  // Writes all keys of a map. The first line begins with "- " instead of its last two spaces when `element` is set.
  void map(const Map& declared, const Node& node, int indent, bool element = false) {
    const std::size_t begin = text_.size();
    const PluginDeclaration* plugin = plugin_of(declared);
    for (const Field& each : declared.fields) {
      const bool params = plugin && each.key == "params" && std::holds_alternative<Free>(each.kind);
      if (params) {
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
    const bool there = file.member.present() && !file.member.get().empty();
    if (there) line(field, flow_text(file.member.get(), true), "", node, indent);
  }
  void write(const Field& field, const Paths& paths, const Node& node, int indent) {
    std::string all;
    for (const NamedPath& each : *paths.members) all += (all.empty() ? "" : ", ") + flow_text(each.path, true);
    if (!all.empty()) line(field, '[' + all + ']', "", node, indent);
  }
  void write(const Field& field, const Choice& choice, const Node& node, int indent) {
    line(field, choice.names[choice.get()], "", node, indent);
  }
  void write(const Field& field, const Numbers& numbers, const Node& node, int indent) {
    if (!numbers.present()) return;
    std::string values;
    for (const double* value : numbers.get()) values += (values.empty() ? "" : ", ") + real_text(*value);
    line(field, '[' + values + ']', numbers.unit, node, indent);
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
    if (list.size() == 0) {
      line(field, "[]", "", node, indent);
      return;
    }
    heading(field, indent);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::span<const Node> elements = node.elements();
      map(list.element(i), i < elements.size() ? Node(elements[i]) : Node(), indent + 4, true);
    }
  }
  void write(const Field& declared, const Dictionary& dictionary, const Node& node, int indent) {
    if (dictionary.size() == 0) {
      line(declared, "{}", "", node, indent);
      return;
    }
    heading(declared, indent);
    for (std::size_t i = 0; i < dictionary.size(); ++i) {
      const Field entry = dictionary.element(i);
      field(entry, node[entry.key], indent + 2);
    }
  }

  // The declaration of the plugin that a map names; null where it names none that is known.
  const PluginDeclaration* plugin_of(const Map& map) const {
    for (const Field& field : map.fields) {
      const Name* name = std::get_if<Name>(&field.kind);
      if (map.plugin_kind.empty() || field.key != "plugin" || !name) continue;
      const auto found = std::find_if(plugins_.begin(), plugins_.end(), [&](const PluginDeclaration& plugin) {
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
    // What the plugin does not know is shown all the same: to say that it is wrong is not for this page.
    for (const Node::Entry& entry : params.entries()) {
      const bool declared = std::any_of(plugin.parameters.begin(), plugin.parameters.end(),
                                        [&](const PluginParameter& parameter) { return parameter.name == entry.key; });
      if (declared) continue;
      line(indent + 2, fmt::format("{}: {}", flow_text(entry.key, false), flow(entry.value)),
           comment("", "unknown to the plugin", entry.value));
    }
  }

  // A file is named absolutely: the page may be read from another folder than the one it is relative to.
  static std::string written(const PluginParameter& parameter, const Node& given) {
    const bool file = parameter.type == PluginParameter::Type::file && given.kind() == Node::Kind::scalar;
    if (!file || given.text().empty()) return flow(given);
    return flow_text(std::filesystem::absolute(named_file(given, parameter.name)).string(), true);
  }

  static std::string initial(const PluginParameter& parameter) {
    switch (parameter.type) {
      case PluginParameter::Type::real:
      case PluginParameter::Type::integer:
        return real_text(parameter.initial);
      case PluginParameter::Type::boolean:
        return parameter.initial != 0.0 ? "true" : "false";
      case PluginParameter::Type::choice: {
        const auto index = static_cast<std::size_t>(std::max(0.0, parameter.initial));
        return index < parameter.choices.size() ? flow_text(parameter.choices[index], false) : "";
      }
      case PluginParameter::Type::text:
        return flow_text(parameter.initial_text, true);
      case PluginParameter::Type::file:
        return parameter.initial_text.empty() ? "" : flow_text(parameter.initial_text, true);
    }
    return "";
  }

  // A name that YAML would take for a boolean needs its quotes.
  static std::string name_text(const std::string& name) {
    std::string word = name;
    std::transform(word.begin(), word.end(), word.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
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

}  // namespace

std::string show(const Map& map, const Node& document, std::span<const PluginDeclaration> plugins, Remarks remarks) {
  Page page(plugins, remarks);
  page.map(map, document, 0);
  return page.take();
}

}  // namespace regista::config
