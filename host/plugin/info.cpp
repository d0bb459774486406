// SPDX-License-Identifier: MIT
#include "plugin/info.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "texts/message.hpp"

namespace regista::plugin {
namespace {

using config::PluginParameter;
using Type = PluginParameter::Type;

bool is_number(const PluginParameter& p) { return p.type == Type::real || p.type == Type::integer; }

PluginParameter declaration(const regista_parameter& declared) {
  PluginParameter out;
  out.name = declared.name;
  constexpr std::array types{Type::real, Type::integer, Type::boolean, Type::choice, Type::text, Type::file};
  static_assert(REGISTA_TYPE_REAL == 1 && REGISTA_TYPE_FILE == types.size());
  out.type = types.at(static_cast<std::size_t>(declared.type) - 1);
  out.minimum = declared.minimum;
  out.maximum = declared.maximum;
  out.unit = declared.unit;
  out.doc = declared.doc;
  out.initial = declared.initial;
  if (declared.initial_text != nullptr) out.initial_text = declared.initial_text;
  if (declared.type == REGISTA_TYPE_CHOICE) {
    out.choices.assign(declared.choices, declared.choices + declared.choice_count);
  }
  out.tunable = (declared.flags & REGISTA_PARAMETER_TUNABLE) != 0;
  out.log_scale = (declared.flags & REGISTA_PARAMETER_LOG_SCALE) != 0;
  return out;
}

// Returns "0.5 to 20 m", or the choices "first, best"; empty for other types.
std::string range(const PluginParameter& p) {
  if (is_number(p)) return config::range_text({p.minimum, p.maximum}, p.unit);
  return fmt::format("{}", fmt::join(p.choices, ", "));
}

std::string line(const PluginParameter& p) {
  std::string out = fmt::format("  {}: {}", p.name, type_name(p.type));
  if (const std::string of = range(p); !of.empty()) out += (p.type == Type::choice ? " of " : ", ") + of;
  const std::string initial = default_text(p);
  out += initial.empty() ? "; default: none" : fmt::format("; default: {}", initial);
  if (p.tunable) out += p.log_scale ? "; tunable on a logarithmic scale" : "; tunable";
  return fmt::format("{}\n      {}\n", out, p.doc);
}

bool one_of(char c, std::string_view characters) { return characters.find(c) != std::string_view::npos; }

struct Chapter {
  int kind;
  std::string_view title, question;
};

constexpr Chapter chapters[] = {
    {REGISTA_KIND_PREDICTOR, "Predictors", "What is known of the own pose, the ball, the opponents or the teammates?"},
    {REGISTA_KIND_CONTEXT, "Contexts", "Does this situation hold now?"},
    {REGISTA_KIND_POSITIONER, "Positioners", "Which points of the field are worth being at?"},
    {REGISTA_KIND_UTILITY, "Utilities", "How well would each robot do each task?"},
    {REGISTA_KIND_ASSIGNER, "Assigners", "Who takes which task?"},
    {REGISTA_KIND_BEHAVIOUR, "Behaviours", "How does a robot act that has this role?"},
    {REGISTA_KIND_SENDER, "Senders", "Is this moment worth one of the team's packets?"},
};

std::string row(const PluginParameter& p) {
  const std::string of = range(p), initial = default_text(p);
  const std::string tuned = !p.tunable ? "" : p.log_scale ? "yes, log" : "yes";
  return fmt::format("| `{}` | {} | {} | {} | {} |\n", p.name, as_text(of.empty() ? type_name(p.type) : of),
                     initial.empty() ? "none" : as_code(initial), tuned, as_text(p.doc));
}

// Returns how the values of a metric are combined, and the unit of the metric: "sum, s".
std::string how_told(const DeclaredMetric& metric) {
  constexpr std::array<std::string_view, 6> names{"", "sum", "mean", "least", "greatest", "mean over time"};
  const bool plain = metric.unit.empty() || metric.unit == "1";
  return fmt::format("{}{}", names.at(static_cast<std::size_t>(metric.combine)), plain ? "" : ", " + metric.unit);
}

std::string section(const Found& plugin) {
  const regista_descriptor& d = *plugin.descriptor;
  const std::string subjects = subject_names(plugin.description->subjects());
  std::string out = fmt::format("\n### {}\n\n{}.", d.id, as_paragraph(d.summary));
  if (!subjects.empty()) out += fmt::format(" Models: {}.", subjects);
  if (negotiates(plugin)) out += " Robots may show the same task while they have not agreed yet.";
  out += fmt::format(" Licence: {}.\n", as_text(d.licence));
  if (d.parameter_count == 0) {
    out += "\nNo parameters.\n";
  } else {
    out += "\n| parameter | range | default | tunable | meaning |\n|---|---|---|---|---|\n";
    for (const PluginParameter& p : parameters(plugin)) out += row(p);
  }
  if (plugin.description->metrics().empty()) return out;
  out += "\n| metric | number of a match | meaning |\n|---|---|---|\n";
  for (const DeclaredMetric& each : plugin.description->metrics()) {
    out += fmt::format("| `{}` | {} | {} |\n", each.name, as_text(how_told(each)), as_text(each.doc));
  }
  return out;
}

}  // namespace

std::string_view type_name(Type type) {
  constexpr std::array<std::string_view, 6> names{"real", "integer", "boolean", "choice", "text", "file"};
  return names.at(static_cast<std::size_t>(type));
}

std::string default_text(const PluginParameter& p) {
  if (is_number(p)) return fmt::format("{}", p.initial);
  if (p.type == Type::boolean) return p.initial != 0.0 ? "true" : "false";
  if (p.type == Type::choice) return p.choices[static_cast<std::size_t>(p.initial)];
  return p.type == Type::text ? texts::in_quotes(p.initial_text) : "";
}

bool negotiates(const Found& plugin) {
  return (plugin.description->assigner_flags() & REGISTA_ASSIGNER_NEGOTIATES) != 0;
}

std::vector<PluginParameter> parameters(const Found& plugin) {
  std::vector<PluginParameter> out;
  for (std::uint32_t i = 0; i < plugin.descriptor->parameter_count; ++i) {
    out.push_back(declaration(parameter(*plugin.descriptor, i)));
  }
  return out;
}

std::string info_text(const Found& plugin) {
  const regista_descriptor& d = *plugin.descriptor;
  const std::string subjects = subject_names(plugin.description->subjects());
  std::string out = fmt::format("{} {}: {}\n", d.id, d.version, d.summary);
  out += fmt::format("kind:      {}\n", fmt::join(texts::names_of(plugin.description->kinds(), kind_name), ", "));
  if (!subjects.empty()) out += fmt::format("models:    {}\n", subjects);
  if (negotiates(plugin)) out += "robots may show the same task while they have not agreed yet\n";
  out += fmt::format("file:      {}\n", plugin.file.string());
  out += fmt::format("build:     {}\n", d.build_tag);
  out += fmt::format("interface: {}.{}\n", d.abi_major, d.abi_minor);
  out += fmt::format("licence:   {}\n", d.licence);
  out += d.parameter_count == 0 ? "parameters: none\n" : "parameters:\n";
  for (const PluginParameter& p : parameters(plugin)) out += line(p);
  if (!plugin.description->metrics().empty()) out += "metrics:\n";
  for (const DeclaredMetric& each : plugin.description->metrics()) {
    out += fmt::format("  {}: {}\n      {}\n", each.name, how_told(each), each.doc);
  }
  return out;
}

std::string list_text(const Catalogue& catalogue) {
  std::size_t width = 0;
  for (const Found& plugin : catalogue.plugins()) {
    width = std::max(width, std::string_view(plugin.descriptor->id).size());
  }
  std::string out;
  for (int kind = 1; kind < REGISTA_KIND_END; ++kind) {
    for (const Found& plugin : catalogue.plugins()) {
      const regista_descriptor& d = *plugin.descriptor;
      if (kind == REGISTA_KIND_MAILBOX || !plugin.description->implements(kind)) continue;
      out += fmt::format("{:<10}  {:<{}}  {}  {}  ({})\n", kind_name(kind), d.id, width, d.version, d.summary,
                         plugin.file.string());
    }
  }
  if (out.empty()) out = "no plugins\n";
  for (const Refused& refused : catalogue.refused()) out += fmt::format("refused: {}\n", to_string(refused));
  for (const Refused& remarked : catalogue.remarked()) out += fmt::format("remark: {}\n", to_string(remarked));
  for (const std::string& folder : catalogue.searched()) out += fmt::format("searched: {}\n", folder);
  return out;
}

std::string as_text(std::string_view text) {
  const bool paired = std::ranges::count(text, '`') % 2 == 0 && text.find("``") == std::string_view::npos;
  bool in_code = false;
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '`' && paired) in_code = !in_code;
    const bool begins_tag = c == '<' && i + 1 < text.size() && text[i + 1] != ' ';
    const bool escaped = c == '|' || (c == '`' && !paired) || (!in_code && (begins_tag || one_of(c, "\\*[]")));
    if (escaped) out += '\\';
    out += c;
  }
  return out;
}

std::string as_paragraph(std::string_view text) {
  std::string out;
  if (!text.empty() && one_of(text.front(), "#+-=~>")) out += '\\';
  return out += as_text(text);
}

std::string as_code(std::string_view text) {
  std::size_t longest = 0, run = 0;
  std::string inside;
  for (const char c : text) {
    run = c == '`' ? run + 1 : 0;
    longest = std::max(longest, run);
    if (c == '|') inside += '\\';  // GitHub ends a table cell at `|`, even within code
    inside += c;
  }
  return fmt::format("{0}{1}{2}{1}{0}", std::string(longest + 1, '`'), longest == 0 ? "" : " ", inside);
}

std::string reference_text(const Catalogue& catalogue) {
  std::vector<const Found*> plugins;
  for (const Found& plugin : catalogue.plugins()) plugins.push_back(&plugin);
  std::ranges::stable_sort(plugins, {}, [](const Found* plugin) { return std::string_view(plugin->descriptor->id); });

  std::string out =
      "# Plugins\n\nWritten by `regista plugin reference` from what the plugins declare about themselves. "
      "[plugins.md](plugins.md) says\nhow to write one.\n";
  for (const Chapter& chapter : chapters) {
    out += fmt::format("\n## {}\n\n{}\n", chapter.title, chapter.question);
    for (const Found* plugin : plugins) {
      if (plugin->description->implements(chapter.kind)) out += section(*plugin);
    }
  }
  return out;
}

std::vector<config::PluginDeclaration> declarations(std::span<const Found> plugins) {
  std::vector<config::PluginDeclaration> out;
  for (const Found& plugin : plugins) {
    const regista_descriptor& d = *plugin.descriptor;
    for (const int kind : plugin.description->kinds()) {
      const auto same = [&](const config::PluginDeclaration& other) {
        return other.id == d.id && other.kind == kind_name(kind);
      };
      if (kind == REGISTA_KIND_MAILBOX || std::ranges::any_of(out, same)) continue;
      out.push_back({d.id, std::string(kind_name(kind)), d.summary, parameters(plugin)});
    }
  }
  return out;
}

}  // namespace regista::plugin
