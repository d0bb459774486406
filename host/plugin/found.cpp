// SPDX-License-Identifier: MIT
#include "plugin/found.hpp"

#include "plugin/descriptor.hpp"
#include "plugin/plugin_file.hpp"

namespace regista::plugin {

bool implements(const Found& plugin, int kind) {
  return plugin.description ? plugin.description->implements(kind) : implements(*plugin.descriptor, kind);
}

std::vector<int> kinds(const Found& plugin) {
  std::vector<int> out;
  for (int kind = 1; kind < REGISTA_KIND_END; ++kind) {
    if (implements(plugin, kind)) out.push_back(kind);
  }
  return out;
}

std::uint32_t subjects(const Found& plugin) {
  if (plugin.description) return plugin.description->subjects();
  const auto* const predictor = table<regista_predictor>(*plugin.descriptor, REGISTA_KIND_PREDICTOR);
  return predictor == nullptr ? 0 : predictor->subjects;
}

std::uint32_t assigner_flags(const Found& plugin) {
  if (plugin.description) return plugin.description->assigner_flags();
  const auto* const assigner = table<regista_assigner>(*plugin.descriptor, REGISTA_KIND_ASSIGNER);
  return assigner == nullptr ? 0 : assigner->flags;
}

std::uint32_t purposes(const Found& plugin) {
  if (plugin.description) return plugin.description->purposes();
  const auto* const behaviour = table<regista_behaviour>(*plugin.descriptor, REGISTA_KIND_BEHAVIOUR);
  return behaviour == nullptr ? 0 : behaviour->flags;
}

std::vector<std::string> reasons(const Found& plugin) {
  if (plugin.description) return plugin.description->reasons();
  const auto* const sender = table<regista_sender>(*plugin.descriptor, REGISTA_KIND_SENDER);
  return sender == nullptr ? std::vector<std::string>{} : reasons_of(*sender);
}

std::vector<DeclaredMetric> metrics(const Found& plugin) {
  return plugin.description ? plugin.description->metrics() : declared_metrics(*plugin.descriptor);
}

const regista_descriptor& loaded(const Found& plugin) {
  return plugin.object ? plugin.object->descriptor(plugin.index) : *plugin.descriptor;
}

std::string to_string(const Refused& refused) { return refused.file.string() + ": " + refused.reason; }

}  // namespace regista::plugin
