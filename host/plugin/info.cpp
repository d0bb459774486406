// SPDX-License-Identifier: MIT
#include "plugin/info.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "plugin/descriptor.hpp"
#include "texts/message.hpp"

namespace regista::plugin {
namespace {

ParameterInfo info(const regista_parameter& p) {
  ParameterInfo out;
  out.name = p.name;
  out.type = type_name(p.type);
  out.unit = p.unit;
  out.doc = p.doc;
  out.tunable = (p.flags & REGISTA_PARAMETER_TUNABLE) != 0;
  out.log_scale = (p.flags & REGISTA_PARAMETER_LOG_SCALE) != 0;
  switch (p.type) {
    case REGISTA_TYPE_REAL:
    case REGISTA_TYPE_INTEGER:
      out.initial = fmt::format("{}", p.initial);
      out.range = range_text(p);
      break;
    case REGISTA_TYPE_BOOLEAN:
      out.initial = p.initial != 0.0 ? "true" : "false";
      break;
    case REGISTA_TYPE_CHOICE:
      out.initial = p.choices[static_cast<std::size_t>(p.initial)];
      out.range = fmt::format("{}", fmt::join(p.choices, p.choices + p.choice_count, ", "));
      break;
    case REGISTA_TYPE_TEXT:
      out.initial = texts::in_quotes(p.initial_text);
      break;
    default:
      break;
  }
  return out;
}

std::string line(const ParameterInfo& p) {
  std::string out = fmt::format("  {}: {}", p.name, p.type);
  if (!p.range.empty()) out += (p.type == "choice" ? " of " : ", ") + p.range;
  out += p.initial.empty() ? "; default: none" : fmt::format("; default: {}", p.initial);
  if (p.tunable) out += p.log_scale ? "; tunable on a logarithmic scale" : "; tunable";
  return fmt::format("{}\n      {}\n", out, p.doc);
}

}  // namespace

std::string how_told(const DeclaredMetric& metric) {
  const bool plain = metric.unit.empty() || metric.unit == "1";
  return fmt::format("{}{}", combine_name(metric.combine), plain ? "" : ", " + metric.unit);
}

Info info(const Found& plugin) {
  const regista_descriptor& d = *plugin.descriptor;
  Info out;
  out.id = d.id;
  out.version = d.version;
  out.summary = d.summary;
  out.licence = d.licence;
  out.build_tag = d.build_tag;
  out.abi = fmt::format("{}.{}", d.abi_major, d.abi_minor);
  out.file = plugin.file.string();
  for (const int kind : kinds(plugin)) out.kinds.emplace_back(kind_name(kind));
  out.subjects = subject_names(subjects(plugin));
  out.negotiates = (assigner_flags(plugin) & REGISTA_ASSIGNER_NEGOTIATES) != 0;
  for (std::uint32_t i = 0; i < d.parameter_count; ++i) out.parameters.push_back(info(parameter(d, i)));
  out.metrics = metrics(plugin);
  return out;
}

std::string info_text(const Found& plugin) {
  const Info about = info(plugin);
  std::string out = fmt::format("{} {}: {}\n", about.id, about.version, about.summary);
  out += fmt::format("kind:      {}\n", fmt::join(about.kinds, ", "));
  if (!about.subjects.empty()) out += fmt::format("models:    {}\n", about.subjects);
  if (about.negotiates) out += "robots may show the same task while they have not agreed yet\n";
  out += fmt::format("file:      {}\n", about.file);
  out += fmt::format("build:     {}\n", about.build_tag);
  out += fmt::format("interface: {}\n", about.abi);
  out += fmt::format("licence:   {}\n", about.licence);
  out += about.parameters.empty() ? "parameters: none\n" : "parameters:\n";
  for (const ParameterInfo& p : about.parameters) out += line(p);
  if (!about.metrics.empty()) out += "metrics:\n";
  for (const DeclaredMetric& each : about.metrics) {
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
      if (kind == REGISTA_KIND_MAILBOX || !implements(plugin, kind)) continue;
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

}  // namespace regista::plugin
