// SPDX-License-Identifier: MIT
#include "plugin/descriptor.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <set>

#include "plugin/declared_metrics.hpp"
#include "texts/message.hpp"
#include "texts/visible.hpp"

namespace regista::plugin {
namespace {

constexpr std::uint32_t most_parameters = 1000, most_reasons = 64;

// Tables of all kinds begin with their size.
std::uint32_t size_of_table(const void* table) {
  std::uint32_t size = 0;
  std::memcpy(&size, table, sizeof size);
  return size;
}

struct TableCheck {
  std::uint32_t size;                   // that the host's version needs
  bool (*complete)(const void* table);  // no call is missing
};

template <class Table, auto... Calls>
constexpr TableCheck check_of() {
  return {sizeof(Table), [](const void* raw) {
            const Table& table = *static_cast<const Table*>(raw);
            return ((table.*Calls != nullptr) && ...);
          }};
}

// By kind; there is no kind 0.
constexpr std::array<TableCheck, REGISTA_KIND_END> table_checks{
    TableCheck{0, nullptr},
    check_of<regista_predictor, &regista_predictor::predict, &regista_predictor::correct, &regista_predictor::absorb,
             &regista_predictor::tracks>(),
    check_of<regista_context, &regista_context::holds>(),
    check_of<regista_positioner, &regista_positioner::place>(),
    check_of<regista_utility, &regista_utility::score>(),
    check_of<regista_assigner, &regista_assigner::assign>(),
    check_of<regista_sender, &regista_sender::decide>(),
    check_of<regista_mailbox, &regista_mailbox::transmitted, &regista_mailbox::dropped, &regista_mailbox::receive>(),
    check_of<regista_behaviour, &regista_behaviour::act>()};

constexpr std::array<std::string_view, REGISTA_KIND_END> kind_names{
    "", "predictor", "context", "positioner", "utility", "assigner", "sender", "mailbox", "behaviour"};
constexpr std::array<std::string_view, REGISTA_KIND_END> kinds_with_article{
    "", "a predictor", "a context", "a positioner", "a utility", "an assigner", "a sender", "a mailbox", "a behaviour"};
constexpr std::array<std::string_view, 7> type_names{"", "real", "integer", "boolean", "choice", "text", "file"};

bool lower_snake_case(std::string_view name) {
  if (name.empty() || name.front() < 'a' || name.front() > 'z') return false;
  return name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string_view::npos;
}

constexpr std::size_t longest_id = 64, longest_text = 1000;  // bytes

// Why people cannot be shown this text; empty when they can. What passes here is not cleaned again anywhere.
std::string wrong_with_text(std::string_view text) {
  if (text.size() > longest_text) return fmt::format("is longer than {} bytes", longest_text);
  if (text.find_first_of("\r\n") != std::string_view::npos) return "is not one line";
  if (texts::visible(text) != text) return "is no plain UTF-8 text: " + texts::in_quotes(text);
  return {};
}

// The same of a value, which may have lines.
bool is_plain_value(std::string_view text) {
  std::string without_tabs(text);
  std::erase(without_tabs, '\t');
  return texts::visible_lines(without_tabs) == without_tabs;
}

bool is_number(std::int32_t type) { return type == REGISTA_TYPE_REAL || type == REGISTA_TYPE_INTEGER; }

std::string wrong_with_number(const regista_parameter& p) {
  if (!std::isfinite(p.minimum) || !std::isfinite(p.maximum) || p.minimum > p.maximum) {
    return fmt::format("{} to {} is no range", p.minimum, p.maximum);
  }
  if (!(p.initial >= p.minimum && p.initial <= p.maximum)) {
    return fmt::format("default {} is outside its range {}", p.initial, range_text(p));
  }
  if (p.type == REGISTA_TYPE_INTEGER && p.initial != std::floor(p.initial)) {
    return fmt::format("default {} is not an integer", p.initial);
  }
  if ((p.flags & REGISTA_PARAMETER_LOG_SCALE) != 0 && p.minimum <= 0.0) {
    return fmt::format("has a logarithmic scale, but its range begins at {}", p.minimum);
  }
  return {};
}

std::string wrong_with_choice(const regista_parameter& p) {
  if (p.choices == nullptr || p.choice_count == 0) return "has no choices";
  std::set<std::string_view> seen;
  for (std::uint32_t i = 0; i < p.choice_count; ++i) {
    if (p.choices[i] == nullptr) return fmt::format("choice {} is null", i);
    if (const std::string wrong = wrong_with_text(p.choices[i]); !wrong.empty()) {
      return fmt::format("choice {} {}", i, wrong);
    }
    if (!seen.insert(p.choices[i]).second) return fmt::format("offers the choice \"{}\" twice", p.choices[i]);
  }
  if (!(p.initial >= 0.0 && p.initial < p.choice_count) || p.initial != std::floor(p.initial)) {
    return fmt::format("default {} is not the index of one of its {} choices", p.initial, p.choice_count);
  }
  return {};
}

std::string wrong_with(const regista_parameter& p) {
  if (p.unit == nullptr) return "unit is null";
  if (p.doc == nullptr) return "doc is null";
  if (const std::string wrong = wrong_with_text(p.unit); !wrong.empty()) return "unit " + wrong;
  if (const std::string wrong = wrong_with_text(p.doc); !wrong.empty()) return "doc " + wrong;
  if (is_number(p.type)) return wrong_with_number(p);
  switch (p.type) {
    case REGISTA_TYPE_BOOLEAN:
      return p.initial == 0.0 || p.initial == 1.0 ? "" : fmt::format("default {} is neither 0 nor 1", p.initial);
    case REGISTA_TYPE_CHOICE:
      return wrong_with_choice(p);
    case REGISTA_TYPE_TEXT:
      if (p.initial_text == nullptr) return "default is null";
      return is_plain_value(p.initial_text) ? "" : "default is no plain UTF-8 text";
    case REGISTA_TYPE_FILE:
      return p.initial_text == nullptr ? "" : "a file has no default";
    default:
      return fmt::format("type {} is unknown", p.type);
  }
}

std::string wrong_with_parameters(const regista_descriptor& d) {
  if (d.parameter_count == 0) return {};
  if (d.parameter_count > most_parameters) return fmt::format("declares {} parameters", d.parameter_count);
  if (d.parameters == nullptr) return "parameters are null";
  if (d.parameter_stride < sizeof(regista_parameter) || d.parameter_stride % alignof(regista_parameter) != 0) {
    return fmt::format("parameters are {} bytes apart; the interface needs {}", d.parameter_stride,
                       sizeof(regista_parameter));
  }
  std::set<std::string_view> seen;
  for (std::uint32_t i = 0; i < d.parameter_count; ++i) {
    const regista_parameter& p = parameter(d, i);
    if (p.size < sizeof p) {
      return fmt::format("parameter {} is {} bytes; the interface needs {}", i, p.size, sizeof p);
    }
    if (p.name == nullptr) return fmt::format("parameter {} has a null name", i);
    if (const std::string wrong = wrong_with_name(p.name); !wrong.empty()) {
      return fmt::format("parameter {} {}", texts::in_quotes(p.name), wrong);
    }
    if (!seen.insert(p.name).second) return fmt::format("parameter \"{}\" is declared twice", p.name);
    if (const std::string wrong = wrong_with(p); !wrong.empty()) {
      return fmt::format("parameter \"{}\": {}", p.name, wrong);
    }
  }
  return {};
}

std::string wrong_with_reasons(const regista_sender& sender) {
  if (sender.reason_count > most_reasons)
    return fmt::format("names {} reasons; at most {} are taken", sender.reason_count, most_reasons);
  if (sender.reason_count > 0 && sender.reasons == nullptr) return "its reasons are null";
  std::set<std::string_view> seen;
  for (std::uint32_t i = 0; i < sender.reason_count; ++i) {
    if (sender.reasons[i] == nullptr) return fmt::format("reason {} is null", i);
    const std::string_view name = sender.reasons[i];
    if (const std::string wrong = wrong_with_name(name); !wrong.empty()) {
      return fmt::format("reason {} {}", texts::in_quotes(sender.reasons[i]), wrong);
    }
    if (!seen.insert(name).second) return fmt::format("names the reason \"{}\" twice", name);
  }
  return {};
}

std::string wrong_with_tables(const regista_descriptor& d) {
  bool any = false;
  for (int kind = 1; kind < REGISTA_KIND_END; ++kind) {
    const void* const found = d.table(kind);
    if (found == nullptr) continue;
    any = any || kind != REGISTA_KIND_MAILBOX;
    const TableCheck& check = table_checks[static_cast<std::size_t>(kind)];
    if (size_of_table(found) < check.size) {
      return fmt::format("table of the {} is {} bytes; the interface needs {}", kind_name(kind), size_of_table(found),
                         check.size);
    }
    if (!check.complete(found)) return fmt::format("table of the {} lacks a call", kind_name(kind));
  }
  if (!any) return "implements no kind of plugin";
  if (const auto* predictor = table<regista_predictor>(d, REGISTA_KIND_PREDICTOR);
      predictor != nullptr && predictor->subjects == 0) {
    return "is a predictor of nothing";
  }
  const auto* sender = table<regista_sender>(d, REGISTA_KIND_SENDER);
  return sender == nullptr ? "" : wrong_with_reasons(*sender);
}

}  // namespace

std::string wrong_with_name(std::string_view name) {
  if (name.size() > longest_id) {
    return fmt::format("is {} characters long; at most {} are taken", name.size(), longest_id);
  }
  return lower_snake_case(name) ? "" : "is not lower_snake_case";
}

std::string what_is_wrong(const regista_descriptor& d, std::uint32_t index) {
  // Only these fields keep their places in every major version. Before 1.0 each minor version is another interface.
  static_assert(REGISTA_ABI_MAJOR == 0);
  if (d.abi_major != REGISTA_ABI_MAJOR || d.abi_minor != REGISTA_ABI_MINOR) {
    const char* why = d.abi_major == 1 && d.abi_minor == 0
                          ? ", whose number is lower because the interface was opened again before it is frozen"
                          : "";
    return fmt::format("built for Regista plugin interface {}.{}; this host speaks {}.{}{}: build it anew", d.abi_major,
                       d.abi_minor, REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR, why);
  }
  if (d.size < sizeof d) {
    return fmt::format("descriptor {} is {} bytes; the interface needs {}", index, d.size, sizeof d);
  }
  if (d.id == nullptr) return fmt::format("descriptor {}: id is null", index);
  const auto wrong = [&d](std::string_view what) { return fmt::format("plugin {}: {}", texts::in_quotes(d.id), what); };
  if (const std::string what = wrong_with_name(d.id); !what.empty()) return wrong("id " + what);
  struct Text {
    const char *name, *value;
  };
  for (const Text& text :
       {Text{"version", d.version}, {"summary", d.summary}, {"licence", d.licence}, {"build tag", d.build_tag}}) {
    if (text.value == nullptr) return wrong(fmt::format("{} is null", text.name));
    if (const std::string what = wrong_with_text(text.value); !what.empty()) {
      return wrong(fmt::format("{} {}", text.name, what));
    }
  }
  if (d.table == nullptr || d.create == nullptr || d.reset == nullptr || d.destroy == nullptr) {
    return wrong("lacks one of table, create, reset, destroy");
  }
  if (const std::string what = wrong_with_parameters(d); !what.empty()) return wrong(what);
  if (const std::string what = wrong_with_tables(d); !what.empty()) return wrong(what);
  if (const std::string what = wrong_with_metrics(d, wrong_with_name, wrong_with_text); !what.empty()) {
    return wrong(what);
  }
  return {};
}

const regista_parameter& parameter(const regista_descriptor& descriptor, std::uint32_t index) {
  const char* const first = reinterpret_cast<const char*>(descriptor.parameters);
  return *reinterpret_cast<const regista_parameter*>(first + std::size_t{index} * descriptor.parameter_stride);
}

std::vector<std::string> reasons_of(const regista_sender& sender) {
  return {sender.reasons, sender.reasons + sender.reason_count};
}

bool implements(const regista_descriptor& descriptor, int kind) { return descriptor.table(kind) != nullptr; }

std::vector<int> kinds(const regista_descriptor& descriptor) {
  std::vector<int> out;
  for (int kind = 1; kind < REGISTA_KIND_END; ++kind) {
    if (implements(descriptor, kind)) out.push_back(kind);
  }
  return out;
}

std::string_view kind_name(int kind) { return kind_names.at(static_cast<std::size_t>(kind)); }

std::string_view kind_with_article(int kind) { return kinds_with_article.at(static_cast<std::size_t>(kind)); }

std::optional<int> kind_of_name(std::string_view name) {
  for (int kind = 1; kind < REGISTA_KIND_END; ++kind) {
    if (kind_name(kind) == name) return kind;
  }
  return std::nullopt;
}

std::string_view type_name(std::int32_t type) { return type_names.at(static_cast<std::size_t>(type)); }

std::string range_text(const regista_parameter& p) {
  const std::string_view unit = p.unit;
  return fmt::format("{} to {}{}{}", p.minimum, p.maximum, unit.empty() || unit == "1" ? "" : " ",
                     unit == "1" ? "" : unit);
}

std::string subject_names(std::uint32_t subjects) {
  constexpr std::array<std::string_view, 4> names{"self", "ball", "opponents", "teammates"};
  std::string out;
  for (std::size_t bit = 0; bit < names.size(); ++bit) {
    if ((subjects >> bit & 1u) == 0) continue;
    if (!out.empty()) out += ", ";
    out += names[bit];
  }
  return out;
}

}  // namespace regista::plugin
