// SPDX-License-Identifier: MIT
#include "plugin/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "plugin/descriptor.hpp"
#include "plugin/info.hpp"
#include "plugin/markdown_text.hpp"

namespace regista::plugin {
namespace {

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

std::string row(const ParameterInfo& p) {
  const std::string range = p.range.empty() ? p.type : p.range;
  const std::string tuned = !p.tunable ? "" : p.log_scale ? "yes, log" : "yes";
  return fmt::format("| `{}` | {} | {} | {} | {} |\n", p.name, as_text(range),
                     p.initial.empty() ? "none" : as_code(p.initial), tuned, as_text(p.doc));
}

std::string section(const Found& plugin) {
  const Info about = info(plugin);
  std::string out = fmt::format("\n### {}\n\n{}.", about.id, as_paragraph(about.summary));
  if (!about.subjects.empty()) out += fmt::format(" Models: {}.", about.subjects);
  if (about.negotiates) out += " Robots may show the same task while they have not agreed yet.";
  out += fmt::format(" Licence: {}.\n", as_text(about.licence));
  if (about.parameters.empty()) {
    out += "\nNo parameters.\n";
  } else {
    out += "\n| parameter | range | default | tunable | meaning |\n|---|---|---|---|---|\n";
    for (const ParameterInfo& p : about.parameters) out += row(p);
  }
  if (about.metrics.empty()) return out;
  out += "\n| metric | number of a match | meaning |\n|---|---|---|\n";
  for (const DeclaredMetric& each : about.metrics) {
    out += fmt::format("| `{}` | {} | {} |\n", each.name, as_text(how_told(each)), as_text(each.doc));
  }
  return out;
}

}  // namespace

std::string reference_text(const Catalogue& catalogue) {
  std::vector<const Found*> plugins;
  for (const Found& plugin : catalogue.plugins()) plugins.push_back(&plugin);
  std::ranges::stable_sort(plugins, {}, [](const Found* plugin) { return std::string_view(plugin->descriptor->id); });

  std::string out =
      "# Plugins\n\nWritten by `regista plugin reference` from what the plugins declare about themselves. How to write "
      "one is said in\n[plugins.md](plugins.md).\n";
  for (const Chapter& chapter : chapters) {
    out += fmt::format("\n## {}\n\n{}\n", chapter.title, chapter.question);
    for (const Found* plugin : plugins) {
      if (implements(*plugin, chapter.kind)) out += section(*plugin);
    }
  }
  return out;
}

}  // namespace regista::plugin
