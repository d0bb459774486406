// SPDX-License-Identifier: MIT
#include "plugin/description.hpp"

#include <stdexcept>
#include <utility>

#include "plugin/descriptor.hpp"

namespace regista::plugin {
namespace {

// The bytes come from a process that a plugin may have damaged.
constexpr std::uint32_t most = 1000;  // parameters, or choices of one

std::string text_of(const char* text) { return text != nullptr ? text : ""; }

}  // namespace

const char* Description::keep(std::string text) { return texts_.emplace_back(std::move(text)).c_str(); }

Description::Description(const regista_descriptor& live) : declared_(live) {
  declared_.id = keep(text_of(live.id));
  declared_.version = keep(text_of(live.version));
  declared_.summary = keep(text_of(live.summary));
  declared_.licence = keep(text_of(live.licence));
  declared_.build_tag = keep(text_of(live.build_tag));
  for (std::uint32_t i = 0; i < live.parameter_count; ++i) {
    regista_parameter& p = parameters_.emplace_back(parameter(live, i));
    p.name = keep(text_of(p.name));
    p.unit = keep(text_of(p.unit));
    p.doc = keep(text_of(p.doc));
    if (p.initial_text != nullptr) p.initial_text = keep(p.initial_text);
    if (p.type != REGISTA_TYPE_CHOICE) {
      p.choices = nullptr;
      p.choice_count = 0;
      continue;
    }
    std::vector<const char*>& choices = choices_.emplace_back();
    for (std::uint32_t k = 0; k < p.choice_count; ++k) choices.push_back(keep(text_of(p.choices[k])));
    p.choices = choices.data();
  }
  declared_.parameters = parameters_.data();
  declared_.parameter_stride = sizeof(regista_parameter);
  for (const int kind : plugin::kinds(live)) kinds_ |= 1u << kind;
  if (const auto* predictor = table<regista_predictor>(live, REGISTA_KIND_PREDICTOR)) subjects_ = predictor->subjects;
  if (const auto* assigner = table<regista_assigner>(live, REGISTA_KIND_ASSIGNER)) assigner_flags_ = assigner->flags;
  if (const auto* behaviour = table<regista_behaviour>(live, REGISTA_KIND_BEHAVIOUR)) purposes_ = behaviour->flags;
  if (const auto* sender = table<regista_sender>(live, REGISTA_KIND_SENDER)) reasons_ = reasons_of(*sender);
  metrics_ = declared_metrics(live);
  declared_.table = nullptr;
  declared_.create = nullptr;
  declared_.reset = nullptr;
  declared_.destroy = nullptr;
  declared_.extension = nullptr;
}

template <class Archive>
void Description::visit_numbers(Archive& archive) {
  archive(declared_.size, declared_.abi_major, declared_.abi_minor, declared_.parameter_count, kinds_, subjects_,
          assigner_flags_, purposes_, declared_.minimum_major, declared_.minimum_minor, declared_.reads);
}

void Description::write(texts::BytesOut& bytes) const {
  const_cast<Description*>(this)->visit_numbers(bytes);  // which only reads
  const auto put = [&bytes](const char* text) {
    const std::string copy = text_of(text);
    bytes(copy);
  };
  for (const char* text :
       {declared_.id, declared_.version, declared_.summary, declared_.licence, declared_.build_tag}) {
    put(text);
  }
  bytes(reasons_, metrics_);
  for (const regista_parameter& p : parameters_) {
    const bool has_text = p.initial_text != nullptr;
    bytes(p.size, p.type, p.minimum, p.maximum, p.initial, p.choice_count, p.flags, has_text);
    for (const char* text : {p.name, p.unit, p.doc, p.initial_text}) put(text);
    for (std::uint32_t k = 0; k < p.choice_count; ++k) put(p.choices[k]);
  }
}

Description::Description(texts::BytesIn& bytes) {
  const auto take = [&] {
    std::string text;
    bytes(text);
    return keep(std::move(text));
  };
  visit_numbers(bytes);
  if (declared_.parameter_count > most) throw std::out_of_range("too many parameters");
  declared_.id = take();
  declared_.version = take();
  declared_.summary = take();
  declared_.licence = take();
  declared_.build_tag = take();
  bytes(reasons_, metrics_);
  for (std::uint32_t i = 0; i < declared_.parameter_count; ++i) {
    regista_parameter p{};
    bool has_text = false;
    bytes(p.size, p.type, p.minimum, p.maximum, p.initial, p.choice_count, p.flags, has_text);
    if (p.choice_count > most) throw std::out_of_range("too many choices");
    p.name = take();
    p.unit = take();
    p.doc = take();
    const char* const text = take();
    p.initial_text = has_text ? text : nullptr;
    std::vector<const char*>& choices = choices_.emplace_back();
    for (std::uint32_t k = 0; k < p.choice_count; ++k) choices.push_back(take());
    p.choices = p.choice_count == 0 ? nullptr : choices.data();
    parameters_.push_back(p);
  }
  declared_.parameters = parameters_.data();
  declared_.parameter_stride = sizeof(regista_parameter);
}

}  // namespace regista::plugin
