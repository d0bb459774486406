// SPDX-License-Identifier: MIT
// The facts of a plan, named once. Beside its study's document, which says what is asked (config::Tournament and
// others), a plan holds what was found out when it was made: a function
//
//   template <Like<FooPlan> Plan, class Visit> void fields(Plan& plan, Visit& visit) {
//     visit("folder", plan.folder);                                 // key in JSON, value
//     visit.maybe("pairs_before", plan.pairs_before);               // of a text; an empty one is not written
//   }
//
// names them, for whatever is visited as it is written to a file of results or read from there. Parts of a plan may
// have such a function, too.
#pragma once

#include <fmt/format.h>

#include <climits>
#include <concepts>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/whole_number.hpp"
#include "config/parse.hpp"
#include "config/values.hpp"
#include "study/opening.hpp"
#include "study/plan_names.hpp"
#include "texts/json.hpp"

namespace regista::study {

using PlanJson = nlohmann::ordered_json;

// T is this type, or a constant of it.
template <class T, class Of>
concept Like = std::same_as<std::remove_const_t<T>, Of>;

class PlanWriter;
class PlanReader;

template <class T>
concept HasFields = requires(T& value, const T& constant, PlanWriter& writer, PlanReader& reader) {
  fields(constant, writer);
  fields(value, reader);
};

// --- A value as JSON, and back. Reading throws Json::exception and std::out_of_range. ---

template <class T>
PlanJson json_of(const T& value);
template <class T>
void read(const PlanJson& json, T& value);

inline PlanJson json_of(const campaign::Job& job) { return PlanJson::parse(campaign::to_json(job)); }
inline void read(const PlanJson& json, campaign::Job& job) { job = campaign::job_from_json(json.dump()); }

inline PlanJson json_of(const std::vector<campaign::Input>& inputs) {
  return PlanJson::parse(campaign::to_json(inputs));
}
inline void read(const PlanJson& json, std::vector<campaign::Input>& inputs) {
  inputs = campaign::inputs_from_json(json.dump());
}

inline PlanJson json_of(const Opening& opening) {
  return {{"file", opening.file}, {"input", json_of(std::vector<campaign::Input>{opening.input})}};
}
inline void read(const PlanJson& json, Opening& opening) {
  json.at("file").get_to(opening.file);
  opening.input = campaign::inputs_from_json(json.at("input").dump()).at(0);
}

template <class T>
PlanJson json_of(const std::optional<T>& value) {
  return value ? json_of(*value) : PlanJson();
}
template <class T>
void read(const PlanJson& json, std::optional<T>& value) {
  value.reset();
  if (!json.is_null()) read(json, value.emplace());
}

template <class T>
PlanJson json_of(const std::vector<T>& values) {
  PlanJson out = PlanJson::array();
  for (const T& each : values) out.push_back(json_of(each));
  return out;
}
template <class T>
void read(const PlanJson& json, std::vector<T>& values) {
  if (!json.is_array()) throw std::out_of_range("expected a list");
  values.clear();
  for (const PlanJson& each : json) read(each, values.emplace_back());
}

class PlanWriter {
 public:
  template <class T>
  void operator()(const char* key, const T& value) {
    out_[key] = json_of(value);
  }
  void maybe(const char* key, const std::string& text) {
    if (!text.empty()) out_[key] = text;
  }
  PlanJson take() { return std::move(out_); }

 private:
  PlanJson out_ = PlanJson::object();
};

class PlanReader {
 public:
  explicit PlanReader(const PlanJson& in) : in_(in) {}
  template <class T>
  void operator()(const char* key, T& value) {
    read(in_.at(key), value);
  }
  void maybe(const char* key, std::string& text) {
    if (in_.contains(key)) read(in_.at(key), text);
  }

 private:
  const PlanJson& in_;
};

template <class T>
PlanJson json_of(const T& value) {
  if constexpr (HasFields<T>) {
    PlanWriter writer;
    fields(value, writer);
    return writer.take();
  } else {
    return value;
  }
}

template <class T>
void read(const PlanJson& json, T& value) {
  if constexpr (HasFields<T>) {
    PlanReader reader(json);
    fields(value, reader);
  } else if constexpr (std::same_as<T, std::uint64_t>) {
    value = campaign::whole_number(json);
  } else if constexpr (std::same_as<T, int>) {
    value = static_cast<int>(campaign::whole_number(json, INT_MAX));
  } else {
    json.get_to(value);
  }
}

// --- Whole plans ---

// Its document as YAML, under "document", and its facts.
template <class Plan>
std::string plan_text(const char* study, int version, const Plan& plan) {
  PlanJson out{{"study", study}, {"version", version}, {"document", config::document_text(plan.asked)}};
  out.update(json_of(plan));
  // Names of files may be anything, JSON must be UTF-8.
  return out.dump(-1, ' ', false, PlanJson::error_handler_t::replace);
}

// read(json), or std::invalid_argument with the reason. upgrade: from a plan of version 1.
template <class Upgrade, class Read>
auto read_plan(const std::string& text, const char* study, int version, Upgrade upgrade, Read read) {
  try {
    const PlanJson json = PlanJson::parse(text);
    if (json.at("study") != study) throw std::invalid_argument("these are results of another study");
    if (json.at("version") == 1) return read(upgrade(json));
    if (json.at("version") != version) throw std::invalid_argument("its plan is of another version");
    return read(json);
  } catch (const PlanJson::exception& error) {
    throw std::invalid_argument(fmt::format("its plan is damaged: {}", error.what()));
  } catch (const config::Error& error) {
    throw std::invalid_argument(fmt::format("its plan is damaged: {}", error.what()));
  } catch (const std::out_of_range&) {
    throw std::invalid_argument("its plan is damaged");
  }
}

// The document of a plan, which names files as they were seen from its folder.
inline config::Node document_of(const PlanJson& json) {
  return config::parse_text(json.at("document").get<std::string>(), "its document");
}

// For readers of such a document, whose files may be elsewhere by now.
inline config::Mistakes mistakes_of_a_plan() {
  return config::Mistakes(config::Mistakes::After::stop, config::Mistakes::Files::as_they_stand);
}

// The document of a plan in memory.
template <class Plan>
config::Node asked_by(const Plan& plan) {
  return config::parse_text(config::document_text(plan.asked), "its document");
}

}  // namespace regista::study
