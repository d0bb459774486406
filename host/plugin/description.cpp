// SPDX-License-Identifier: MIT
#include "plugin/description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <initializer_list>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "config/scalar.hpp"
#include "plugin/shared_object.hpp"
#include "texts/message.hpp"

namespace regista::plugin {
namespace {

// most_parameters also limits the choices of a parameter in received bytes: a plugin may have damaged their writer.
constexpr std::uint32_t most_parameters = 1000, most_reasons = 64;

// Returns the first member of a call table. The first member is the size of the table in the tables of all kinds.
std::uint32_t size_of_table(const void* table) {
  std::uint32_t size = 0;
  std::memcpy(&size, table, sizeof size);
  return size;
}

struct TableCheck {
  std::uint32_t size;                   // least size of the table in the host's ABI version, bytes
  bool (*complete)(const void* table);  // returns whether no call in the table is null
};

template <class Table, auto... Calls>
constexpr TableCheck check_of() {
  return {sizeof(Table), [](const void* raw) {
            const Table& table = *static_cast<const Table*>(raw);
            return ((table.*Calls != nullptr) && ...);
          }};
}

// The checks of the call tables, by kind (REGISTA_KIND_*). Kind 0 does not exist.
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

bool lower_snake_case(std::string_view name) {
  if (name.empty() || name.front() < 'a' || name.front() > 'z') return false;
  return name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string_view::npos;
}

constexpr std::size_t longest_id = 64, longest_text = 1000;  // bytes

// Returns why the program must not show a plugin's text to people; empty if the program may show the text.
std::string wrong_with_text(std::string_view text) {
  if (text.size() > longest_text) return fmt::format("is longer than {} bytes", longest_text);
  if (text.find_first_of("\r\n") != std::string_view::npos) return "is not one line";
  if (texts::visible(text) != text) return "is no plain UTF-8 text: " + texts::in_quotes(text);
  return {};
}

// Returns whether the program may show the value of a parameter to people. The value may have several lines and tabs.
bool is_plain_value(std::string_view text) {
  std::string without_tabs(text);
  std::erase(without_tabs, '\t');
  return texts::visible_lines(without_tabs) == without_tabs;
}

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

struct Text {
  const char *name, *value;
};
std::string wrong_with_texts(std::initializer_list<Text> texts) {
  for (const Text& each : texts) {
    if (each.value == nullptr) return fmt::format("{} is null", each.name);
    if (const std::string wrong = wrong_with_text(each.value); !wrong.empty()) {
      return fmt::format("{} {}", each.name, wrong);
    }
  }
  return {};
}

std::string wrong_with(const regista_parameter& p) {
  if (const std::string wrong = wrong_with_texts({{"unit", p.unit}, {"doc", p.doc}}); !wrong.empty()) return wrong;
  switch (p.type) {
    case REGISTA_TYPE_REAL:
    case REGISTA_TYPE_INTEGER:
      return wrong_with_number(p);
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

std::string wrong_with(const regista_metric& m) {
  if (const std::string wrong = wrong_with_texts({{"unit", m.unit}, {"doc", m.doc}}); !wrong.empty()) return wrong;
  if (m.combine >= REGISTA_METRIC_SUM && m.combine <= REGISTA_METRIC_OVER_TIME) return {};
  return fmt::format("there is no way {} to combine reports", m.combine);
}

// Returns element number `index` of a list whose elements are `stride` bytes apart.
template <class Item>
const Item& element(const Item* first, std::uint32_t stride, std::uint32_t index) {
  return *reinterpret_cast<const Item*>(reinterpret_cast<const char*>(first) + std::size_t{index} * stride);
}

// Returns the mistake in a list of parameters or metrics. what: "parameter" or "metric"; by: field with element size.
template <class Item>
std::string wrong_with_list(std::string_view what, std::string_view by, const Item* first, std::uint32_t stride,
                            std::uint32_t count, const char* twice) {
  if (stride < sizeof(Item) || stride % alignof(Item) != 0) {
    return fmt::format("{}s are {} bytes apart; {} needs {}", what, stride, by, sizeof(Item));
  }
  std::set<std::string_view> seen;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Item& each = element(first, stride, i);
    if (each.size < sizeof each) {
      return fmt::format("{} {} is {} bytes; {} needs {}", what, i, each.size, by, sizeof each);
    }
    if (each.name == nullptr) return fmt::format("{} {} has a null name", what, i);
    if (const std::string wrong = wrong_with_name(each.name); !wrong.empty()) {
      return fmt::format("{} {} {}", what, texts::in_quotes(each.name), wrong);
    }
    if (!seen.insert(each.name).second) return fmt::format(fmt::runtime(twice), each.name);
    if (const std::string wrong = wrong_with(each); !wrong.empty()) {
      return fmt::format("{} \"{}\": {}", what, each.name, wrong);
    }
  }
  return {};
}

std::string wrong_with_parameters(const regista_descriptor& d) {
  if (d.parameter_count == 0) return {};
  if (d.parameter_count > most_parameters) return fmt::format("declares {} parameters", d.parameter_count);
  if (d.parameters == nullptr) return "parameters are null";
  return wrong_with_list("parameter", "the interface", d.parameters, d.parameter_stride, d.parameter_count,
                         "parameter \"{}\" is declared twice");
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

const regista_metrics* metrics_of(const regista_descriptor& d) {
  if (d.extension == nullptr) return nullptr;
  return static_cast<const regista_metrics*>(d.extension(REGISTA_METRIC_EXTENSION));
}

std::string wrong_with_metrics(const regista_descriptor& d) {
  const regista_metrics* const metrics = metrics_of(d);
  if (metrics == nullptr) return {};
  if (metrics->size < sizeof *metrics) {
    return fmt::format("table of its metrics is {} bytes; {} needs {}", metrics->size, REGISTA_METRIC_EXTENSION,
                       sizeof *metrics);
  }
  constexpr std::uint32_t most = REGISTA_METRIC_MOST;
  if (metrics->count > most) return fmt::format("declares {} metrics; at most {} are taken", metrics->count, most);
  if (metrics->count == 0) return {};
  if (metrics->metrics == nullptr) return "its metrics are null";
  return wrong_with_list("metric", REGISTA_METRIC_EXTENSION, metrics->metrics, metrics->stride, metrics->count,
                         "declares the metric \"{}\" twice");
}

std::string text_of(const char* text) { return text != nullptr ? text : ""; }

std::array<const char**, 5> texts_of(regista_descriptor& d) {
  return {&d.id, &d.version, &d.summary, &d.licence, &d.build_tag};
}

// Makes the list `count` elements long. A writer has a list of this length already. Throws std::out_of_range.
template <class List>
void grow(List& list, std::uint32_t count) {
  if (count == list.size()) return;
  if (count > most_parameters) throw std::out_of_range("too many parameters or choices");
  list.resize(count);
}

}  // namespace

std::string wrong_with_name(std::string_view name) {
  if (name.size() > longest_id) {
    return fmt::format("is {} characters long; at most {} are taken", name.size(), longest_id);
  }
  return lower_snake_case(name) ? "" : "is not lower_snake_case";
}

std::string what_is_wrong(const regista_descriptor& d, std::uint32_t index) {
  // Only abi_major and abi_minor have a fixed place. Before version 1.0, each minor version is a new ABI.
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
  if (const std::string what = wrong_with_texts(
          {{"version", d.version}, {"summary", d.summary}, {"licence", d.licence}, {"build tag", d.build_tag}});
      !what.empty()) {
    return wrong(what);
  }
  if (d.table == nullptr || d.create == nullptr || d.reset == nullptr || d.destroy == nullptr) {
    return wrong("lacks one of table, create, reset, destroy");
  }
  if (const std::string what = wrong_with_parameters(d); !what.empty()) return wrong(what);
  if (const std::string what = wrong_with_tables(d); !what.empty()) return wrong(what);
  const std::string what = wrong_with_metrics(d);
  return what.empty() ? "" : wrong(what);
}

const regista_parameter& parameter(const regista_descriptor& descriptor, std::uint32_t index) {
  return element(descriptor.parameters, descriptor.parameter_stride, index);
}

std::string_view kind_name(int kind) { return kind_names.at(static_cast<std::size_t>(kind)); }

std::string range_text(const regista_parameter& p) { return config::range_text({p.minimum, p.maximum}, p.unit); }

std::string subject_names(std::uint32_t subjects) {
  constexpr std::array<std::string_view, 4> names{"self", "ball", "opponents", "teammates"};
  std::vector<std::string_view> out;
  for (std::size_t bit = 0; bit < names.size(); ++bit) {
    if ((subjects >> bit & 1u) != 0) out.push_back(names[bit]);
  }
  return fmt::format("{}", fmt::join(out, ", "));
}

const char* Description::keep(std::string text) { return texts_.emplace_back(std::move(text)).c_str(); }

Description::Description(const regista_descriptor& live) : declared_(live) {
  for (const char** each : texts_of(declared_)) *each = keep(text_of(*each));
  for (std::uint32_t i = 0; i < live.parameter_count; ++i) {
    regista_parameter& p = parameters_.emplace_back(parameter(live, i));
    for (const char** each : {&p.name, &p.unit, &p.doc}) *each = keep(text_of(*each));
    if (p.initial_text != nullptr) p.initial_text = keep(p.initial_text);
    if (p.type != REGISTA_TYPE_CHOICE) p.choice_count = 0;
    std::vector<const char*>& choices = choices_.emplace_back();
    for (std::uint32_t k = 0; k < p.choice_count; ++k) choices.push_back(keep(text_of(p.choices[k])));
    p.choices = choices.data();
  }
  declared_.parameters = parameters_.data();
  declared_.parameter_stride = sizeof(regista_parameter);
  for (int kind = 1; kind < REGISTA_KIND_END; ++kind) {
    if (live.table(kind) != nullptr) kinds_ |= 1u << kind;
  }
  if (const auto* predictor = table<regista_predictor>(live, REGISTA_KIND_PREDICTOR)) subjects_ = predictor->subjects;
  if (const auto* assigner = table<regista_assigner>(live, REGISTA_KIND_ASSIGNER)) assigner_flags_ = assigner->flags;
  if (const auto* behaviour = table<regista_behaviour>(live, REGISTA_KIND_BEHAVIOUR)) purposes_ = behaviour->flags;
  if (const auto* sender = table<regista_sender>(live, REGISTA_KIND_SENDER)) {
    reasons_.assign(sender->reasons, sender->reasons + sender->reason_count);
  }
  const regista_metrics* const metrics = metrics_of(live);
  for (std::uint32_t i = 0; metrics != nullptr && i < metrics->count; ++i) {
    const regista_metric& each = element(metrics->metrics, metrics->stride, i);
    metrics_.push_back({each.name, each.unit, each.doc, each.combine});
  }
  declared_.table = nullptr;
  declared_.create = nullptr;
  declared_.reset = nullptr;
  declared_.destroy = nullptr;
  declared_.extension = nullptr;
}

std::vector<int> Description::kinds() const {
  std::vector<int> out;
  for (int kind = 1; kind < REGISTA_KIND_END; ++kind) {
    if (implements(kind)) out.push_back(kind);
  }
  return out;
}

template <class Archive, class Text>
void Description::visit_all(Archive& archive, const Text& text) {
  regista_descriptor& d = declared_;
  archive(d.size, d.abi_major, d.abi_minor, d.parameter_count, kinds_, subjects_, assigner_flags_, purposes_,
          d.minimum_major, d.minimum_minor, d.reads);
  grow(parameters_, d.parameter_count);
  grow(choices_, d.parameter_count);
  for (const char** each : texts_of(d)) text(*each);
  archive(reasons_, metrics_);
  for (std::uint32_t i = 0; i < d.parameter_count; ++i) {
    regista_parameter& p = parameters_[i];
    bool has_text = p.initial_text != nullptr;
    archive(p.size, p.type, p.minimum, p.maximum, p.initial, p.choice_count, p.flags, has_text);
    for (const char** each : {&p.name, &p.unit, &p.doc, &p.initial_text}) text(*each);
    grow(choices_[i], p.choice_count);
    for (const char*& each : choices_[i]) text(each);
    if constexpr (std::is_same_v<Archive, texts::BytesIn>) {
      if (!has_text) p.initial_text = nullptr;
      p.choices = choices_[i].data();
    }
  }
}

void Description::write(texts::BytesOut& bytes) const {
  const_cast<Description*>(this)->visit_all(bytes, [&bytes](const char* text) {  // writing does not change this object
    std::string copy = text_of(text);
    bytes(copy);
  });
}

Description::Description(texts::BytesIn& bytes) {
  visit_all(bytes, [&](const char*& text) {
    std::string copy;
    bytes(copy);
    text = keep(std::move(copy));
  });
  declared_.parameters = parameters_.data();
  declared_.parameter_stride = sizeof(regista_parameter);
}

const regista_descriptor& loaded(const Found& plugin) {
  return plugin.object ? plugin.object->descriptor(plugin.index) : *plugin.descriptor;
}

std::string to_string(const Refused& refused) { return refused.file.string() + ": " + refused.reason; }

}  // namespace regista::plugin
