// SPDX-License-Identifier: MIT
#include "plugin/declarations.hpp"

#include <algorithm>

#include "plugin/descriptor.hpp"

namespace regista::plugin {
namespace {

config::PluginParameter::Type type_of(const regista_parameter& declared) {
  using Type = config::PluginParameter::Type;
  switch (declared.type) {
    case REGISTA_TYPE_REAL:
      return Type::real;
    case REGISTA_TYPE_INTEGER:
      return Type::integer;
    case REGISTA_TYPE_BOOLEAN:
      return Type::boolean;
    case REGISTA_TYPE_CHOICE:
      return Type::choice;
    case REGISTA_TYPE_TEXT:
      return Type::text;
    default:
      return Type::file;
  }
}

config::PluginParameter declaration(const regista_parameter& declared) {
  config::PluginParameter out;
  out.name = declared.name;
  out.type = type_of(declared);
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

}  // namespace

std::vector<config::PluginDeclaration> declarations(std::span<const Found> plugins) {
  std::vector<config::PluginDeclaration> out;
  for (const Found& plugin : plugins) {
    const regista_descriptor& d = *plugin.descriptor;
    for (const int kind : kinds(plugin)) {
      const auto same = [&](const config::PluginDeclaration& other) {
        return other.id == d.id && other.kind == kind_name(kind);
      };
      if (kind == REGISTA_KIND_MAILBOX || std::ranges::any_of(out, same)) continue;
      config::PluginDeclaration& next = out.emplace_back();
      next.id = d.id;
      next.kind = kind_name(kind);
      next.summary = d.summary;
      for (std::uint32_t i = 0; i < d.parameter_count; ++i) next.parameters.push_back(declaration(parameter(d, i)));
    }
  }
  return out;
}

}  // namespace regista::plugin
