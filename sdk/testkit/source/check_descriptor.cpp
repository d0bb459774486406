// SPDX-License-Identifier: MIT
// Name by name, parameter by parameter, table by table.
#include <regista/testkit/kind_checks.hpp>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>

#include <regista/extensions/metric.h>

namespace regista::testkit {

namespace {

bool is_lower_snake_case(std::string_view text) {
  if (text.empty() || !(text.front() >= 'a' && text.front() <= 'z') || text.back() == '_') return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (!((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_')) return false;
    if (c == '_' && text[i - 1] == '_') return false;
  }
  return true;
}

// One line of text that says something.
void need_line(Findings& findings, const std::string& what, const char* text) {
  if (text == nullptr) return findings.say(what, " is null");
  if (text[0] == '\0') return findings.say(what, " is empty");
  if (std::string_view(text).find('\n') != std::string_view::npos) findings.say(what, " has more than one line");
}

void check_number(Findings& f, const std::string& name, const regista_parameter& p) {
  if (!std::isfinite(p.minimum) || !std::isfinite(p.maximum)) return f.say(name, ": its range is not finite");
  if (p.minimum > p.maximum) f.say(name, ": its range [", p.minimum, ", ", p.maximum, "] is empty");
  if (!(p.initial >= p.minimum && p.initial <= p.maximum)) {
    f.say(name, ": its default ", p.initial, " is outside [", p.minimum, ", ", p.maximum, "]");
  }
  if (p.type == REGISTA_TYPE_INTEGER && p.initial != std::floor(p.initial)) f.say(name, ": its default is no integer");
  if ((p.flags & REGISTA_PARAMETER_LOG_SCALE) != 0 && !(p.minimum > 0.0)) {
    f.say(name, ": a logarithmic scale needs a positive range");
  }
}

void check_choice(Findings& f, const std::string& name, const regista_parameter& p) {
  if (p.choices == nullptr || p.choice_count == 0) return f.say(name, ": has no choices");
  std::set<std::string> seen;
  for (std::uint32_t c = 0; c < p.choice_count; ++c) {
    const char* word = p.choices[c];
    need_line(f, name + ": choice " + std::to_string(c), word);
    if (word != nullptr && !seen.insert(word).second) f.say(name, ": choice \"", word, "\" stands twice");
  }
  if (!(p.initial >= 0.0 && p.initial < p.choice_count && p.initial == std::floor(p.initial))) {
    f.say(name, ": its default is none of its choices");
  }
}

void check_parameter(Findings& f, const regista_parameter& p, std::size_t index, std::set<std::string>& names) {
  const std::string name = "parameter " + (p.name == nullptr ? std::to_string(index) : std::string(p.name));
  if (p.size < sizeof(regista_parameter)) return f.say(name, ": its size field says ", p.size, " bytes");
  if (p.name == nullptr || !is_lower_snake_case(p.name)) {
    f.say(name, ": its name is not in lower_snake_case");
  } else if (!names.insert(p.name).second) {
    f.say(name, ": stands twice");
  }
  need_line(f, name + ": its doc", p.doc);
  if (p.unit == nullptr) f.say(name, ": its unit is null");
  switch (p.type) {
    case REGISTA_TYPE_REAL:
    case REGISTA_TYPE_INTEGER:
      if (p.unit != nullptr && p.unit[0] == '\0') f.say(name, ": has no unit (\"1\" for a plain number)");
      return check_number(f, name, p);
    case REGISTA_TYPE_BOOLEAN:
      if (p.initial != 0.0 && p.initial != 1.0) f.say(name, ": its default is neither 0 nor 1");
      return;
    case REGISTA_TYPE_CHOICE:
      return check_choice(f, name, p);
    case REGISTA_TYPE_TEXT:
      if (p.initial_text == nullptr) f.say(name, ": its default text is null");
      return;
    case REGISTA_TYPE_FILE:
      if (p.initial_text != nullptr) f.say(name, ": a file has no default");
      return;
    default:
      f.say(name, ": unknown type ", p.type);
  }
}

void check_reasons(Findings& f, const regista_sender& sender) {
  constexpr std::uint32_t most = 64;
  if (sender.reason_count > most) return f.say("sender: names ", sender.reason_count, " reasons of at most ", most);
  if (sender.reason_count > 0 && sender.reasons == nullptr) return f.say("sender: its reasons are null");
  std::set<std::string> seen;
  for (std::uint32_t i = 0; i < sender.reason_count; ++i) {
    const char* const name = sender.reasons[i];
    if (name == nullptr || !is_lower_snake_case(name)) {
      f.say("sender: its reason ", i, " is not in lower_snake_case");
    } else if (!seen.insert(name).second) {
      f.say("sender: its reason \"", name, "\" stands twice");
    }
  }
}

void check_metrics(Findings& f, const regista_metrics& metrics) {
  constexpr std::uint32_t most = REGISTA_METRIC_MOST;
  if (metrics.size < sizeof metrics) return f.say("metrics: the size field says ", metrics.size, " bytes");
  if (metrics.count > most) return f.say("metrics: declares ", metrics.count, " of at most ", most);
  if (metrics.count == 0) return;
  if (metrics.metrics == nullptr || metrics.stride < sizeof(regista_metric) ||
      metrics.stride % alignof(regista_metric) != 0)
    return f.say("metrics: there are none");
  std::set<std::string> seen;
  for (std::uint32_t i = 0; i < metrics.count; ++i) {
    const auto& each = *reinterpret_cast<const regista_metric*>(reinterpret_cast<const char*>(metrics.metrics) +
                                                                std::size_t{i} * metrics.stride);
    const std::string name =
        "metric " + (each.name == nullptr ? std::to_string(i) : '"' + std::string(each.name) + '"');
    if (each.size < sizeof each) f.say(name, ": its size field says ", each.size, " bytes");
    if (each.name == nullptr || !is_lower_snake_case(each.name)) {
      f.say(name, ": its name is not in lower_snake_case");
    } else if (!seen.insert(each.name).second) {
      f.say(name, ": stands twice");
    }
    need_line(f, name + ": its doc", each.doc);
    need_line(f, name + ": its unit", each.unit);
    if (each.combine < REGISTA_METRIC_SUM || each.combine > REGISTA_METRIC_OVER_TIME) {
      f.say(name, ": combines in a way that does not exist: ", each.combine);
    }
  }
}

}  // namespace

Findings check_descriptor(const Loaded& plugin) {
  Findings f;
  const regista_descriptor& d = plugin.descriptor();
  static_assert(REGISTA_ABI_MAJOR == 0, "from 1.0 on, minor versions fit together");
  if (d.abi_major != REGISTA_ABI_MAJOR || d.abi_minor != REGISTA_ABI_MINOR) {
    f.say("descriptor: built for plugin interface ", d.abi_major, ".", d.abi_minor);
    return f;  // its fields are others
  }
  if (d.size < sizeof(regista_descriptor)) {
    f.say("descriptor: its size field says ", d.size, " bytes");
    return f;
  }
  if (d.id == nullptr || !is_lower_snake_case(d.id)) f.say("descriptor: its id is not in lower_snake_case");
  need_line(f, "descriptor: its version", d.version);
  need_line(f, "descriptor: its summary", d.summary);
  need_line(f, "descriptor: its licence", d.licence);
  need_line(f, "descriptor: its build tag", d.build_tag);
  if (d.version != nullptr && !(d.version[0] >= '0' && d.version[0] <= '9')) {
    f.say("descriptor: its version \"", d.version, "\" does not begin with a number");
  }
  if (d.table == nullptr || d.create == nullptr || d.reset == nullptr || d.destroy == nullptr) {
    f.say("descriptor: table, create, reset and destroy must not be null");
    return f;
  }
  if (d.reserved != 0 || d.reserved_too != 0) f.say("descriptor: a reserved field is not 0");
  if (d.extension != nullptr && d.extension("nobody.has_this/0") != nullptr) {
    f.say("descriptor: has an extension for a name that nobody gave");
  }
  if (d.parameter_count > 0 && (d.parameters == nullptr || d.parameter_stride < sizeof(regista_parameter))) {
    f.say("descriptor: its parameters have no place or too small a stride");
    return f;
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < plugin.parameter_count(); ++i) check_parameter(f, plugin.parameter(i), i, names);

  int kinds = 0;
  for (std::int32_t kind = -1; kind <= REGISTA_KIND_END + 1; ++kind) {
    const void* table = d.table(kind);
    if (table != d.table(kind)) f.say("descriptor: its table of kind ", kind, " changes from call to call");
    if (table == nullptr) continue;
    if (kind < REGISTA_KIND_PREDICTOR || kind >= REGISTA_KIND_END) {
      f.say("descriptor: has a table for kind ", kind, ", which does not exist");
    } else if (kind != REGISTA_KIND_MAILBOX) {
      ++kinds;
    }
  }
  if (kinds == 0) f.say("descriptor: implements no kind");
  const auto table_size = [&](std::int32_t kind, const char* name, std::size_t needed) {
    const void* table = d.table(kind);
    if (table == nullptr) return;
    const std::uint32_t size = *static_cast<const std::uint32_t*>(table);
    if (size < needed) f.say(name, ": the size field of its table says ", size, " bytes");
  };
  table_size(REGISTA_KIND_PREDICTOR, "predictor", sizeof(regista_predictor));
  table_size(REGISTA_KIND_CONTEXT, "context", sizeof(regista_context));
  table_size(REGISTA_KIND_POSITIONER, "positioner", sizeof(regista_positioner));
  table_size(REGISTA_KIND_UTILITY, "utility", sizeof(regista_utility));
  table_size(REGISTA_KIND_ASSIGNER, "assigner", sizeof(regista_assigner));
  table_size(REGISTA_KIND_SENDER, "sender", sizeof(regista_sender));
  table_size(REGISTA_KIND_MAILBOX, "mailbox", sizeof(regista_mailbox));
  table_size(REGISTA_KIND_BEHAVIOUR, "behaviour", sizeof(regista_behaviour));
  if (detail::says_it_negotiates(plugin) && !plugin.implements(REGISTA_KIND_MAILBOX)) {
    f.say("assigner: says that it negotiates, but receives nothing: it has no mailbox");
  }
  const auto* sender = static_cast<const regista_sender*>(d.table(REGISTA_KIND_SENDER));
  if (sender != nullptr && sender->size >= sizeof(regista_sender)) check_reasons(f, *sender);
  if (d.extension == nullptr) return f;
  const void* const metrics = d.extension(REGISTA_METRIC_EXTENSION);
  if (metrics != nullptr) check_metrics(f, *static_cast<const regista_metrics*>(metrics));
  return f;
}

}  // namespace regista::testkit
