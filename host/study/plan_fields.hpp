// SPDX-License-Identifier: MIT
// The fields of a plan, named once. A plan has a function
//
//   template <Like<FooPlan> Plan, class Visit> void fields(Plan& plan, Visit& visit) {
//     visit("pairs", plan.pairs, "--pairs");                        // key in JSON, value, what a difference is called
//     visit("folder", plan.folder);                                 // a difference is not reported
//     visit.maybe("question", plan.question);                       // the same of a text; an empty one is not written
//     visit("memory", plan.memory, "--memory", in_mebibytes);       // the value as it is reported
//     visit.inner("limits", [&](auto& inner) { ... });              // an object in the object
//   }
//
// beside itself, for whatever is visited as it is written to a file of results, read from there, or compared with the
// plan that is asked for. Parts of a plan may have such a function, too.
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
#include "config/json.hpp"
#include "study/opening.hpp"
#include "study/plan_names.hpp"

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

// An enumeration whose values have names: name(value), and named(text, value), which is false for another text.
template <class T>
concept HasNames = std::is_enum_v<T> && requires(T value) {
  name(value);
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
  template <class T, class... Shown>
  void operator()(const char* key, const T& value, const Shown&...) {
    out_[key] = json_of(value);
  }
  void maybe(const char* key, const std::string& text) {
    if (!text.empty()) out_[key] = text;
  }
  template <class Fields>
  void inner(const char* key, Fields fields) {
    PlanWriter inside;
    fields(inside);
    out_[key] = std::move(inside.out_);
  }
  PlanJson take() { return std::move(out_); }

 private:
  PlanJson out_ = PlanJson::object();
};

class PlanReader {
 public:
  explicit PlanReader(const PlanJson& in) : in_(in) {}
  template <class T, class... Shown>
  void operator()(const char* key, T& value, const Shown&...) {
    read(in_.at(key), value);
  }
  void maybe(const char* key, std::string& text) {
    if (in_.contains(key)) read(in_.at(key), text);
  }
  template <class Fields>
  void inner(const char* key, Fields fields) {
    PlanReader inside(in_.at(key));
    fields(inside);
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
  } else if constexpr (HasNames<T>) {
    return name(value);
  } else {
    return value;
  }
}

template <class T>
void read(const PlanJson& json, T& value) {
  if constexpr (HasFields<T>) {
    PlanReader reader(json);
    fields(value, reader);
  } else if constexpr (HasNames<T>) {
    if (!named(json.get<std::string>(), value)) throw std::out_of_range(json.get<std::string>());
  } else if constexpr (std::same_as<T, std::uint64_t>) {
    value = campaign::whole_number(json);
  } else if constexpr (std::same_as<T, int>) {
    value = static_cast<int>(campaign::whole_number(json, INT_MAX));
  } else {
    json.get_to(value);
  }
}

// --- A value in words ---

inline std::string in_words(const std::string& text) { return text; }
template <class T>
std::string in_words(const T& value) {
  if constexpr (HasNames<T>)
    return name(value);
  else
    return fmt::format("{}", value);
}
template <class T>
std::string in_words(const std::optional<T>& value) {
  return value ? in_words(*value) : "none";
}
template <class T>
std::string in_words(const std::vector<T>& values) {
  std::string out;
  for (const T& each : values) out += (out.empty() ? "" : ", ") + in_words(each);
  return out;
}

class PlanWords {
 public:
  template <class T>
  void operator()(const char*, const T&) {}
  template <class T>
  void operator()(const char*, const T& value, const char* what) {
    lines_.emplace_back(what, in_words(value));
  }
  template <class T, class Words>
  void operator()(const char*, const T& value, const char* what, const Words& words) {
    lines_.emplace_back(what, words(value));
  }
  void maybe(const char*, const std::string&) {}
  template <class Fields>
  void inner(const char*, Fields fields) {
    fields(*this);
  }
  // By field: what it is, and its value.
  const std::vector<std::pair<std::string, std::string>>& lines() const { return lines_; }

 private:
  std::vector<std::pair<std::string, std::string>> lines_;
};

// --- Whole plans ---

template <class Plan>
std::string plan_text(const char* study, int version, const Plan& plan) {
  PlanJson out{{"study", study}, {"version", version}};
  out.update(json_of(plan));
  // Names of files may be anything, JSON must be UTF-8.
  return out.dump(-1, ' ', false, PlanJson::error_handler_t::replace);
}

// read(json), or std::invalid_argument with the reason.
template <class Read>
auto read_plan(const std::string& text, const char* study, int version, Read read) {
  try {
    const PlanJson json = PlanJson::parse(text);
    if (json.at("study") != study) throw std::invalid_argument("these are results of another study");
    if (json.at("version") != version) throw std::invalid_argument("its plan is of another version");
    return read(json);
  } catch (const PlanJson::exception& error) {
    throw std::invalid_argument(fmt::format("its plan is damaged: {}", error.what()));
  } catch (const std::out_of_range&) {
    throw std::invalid_argument("its plan is damaged");
  }
}

// sound(plan): whether it is one that the study could have written. Throws std::invalid_argument with the reason.
template <class Plan, class Sound>
Plan plan_of(const char* study, int version, const std::string& text, Sound sound) {
  return read_plan(text, study, version, [&](const PlanJson& json) {
    Plan plan;
    read(json, plan);
    if (!sound(plan)) throw std::out_of_range("a number that none has");
    return plan;
  });
}

// What is said of the fields that differ: "--pairs: was 3, now 4".
template <class Plan>
std::vector<std::string> field_differences(const Plan& before, const Plan& now) {
  PlanWords then, today;
  fields(before, then);
  fields(now, today);
  std::vector<std::string> out;
  for (std::size_t i = 0; i < today.lines().size(); ++i) {
    const auto& [what, value] = today.lines()[i];
    const std::string& old = then.lines()[i].second;
    if (old != value) out.push_back(fmt::format("{}: was {}, now {}", what, old, value));
  }
  return out;
}

// Those of campaign::Limits that a study fixes.
template <class Limits, class Visit>
void limit_fields(Limits& limits, Visit& visit) {
  visit("processor_seconds", limits.processor_seconds, "--processor-seconds");
  visit("memory", limits.memory, "--memory", [](std::uint64_t bytes) { return std::to_string(bytes >> 20); });
  visit("wall_seconds", limits.wall_seconds);
  visit("match_wall_seconds", limits.match_wall_seconds);
  // How a match is played changes no result, so that a study may go on in another way.
  std::string isolation = limits.isolation == campaign::Isolation::always ? "always" : "",
              plays = limits.play_twice ? "" : "once", shared = limits.allow_shared_memory ? "allowed" : "";
  visit.maybe("isolation", isolation);
  visit.maybe("plays", plays);
  visit.maybe("shared_memory", shared);
  // But what is allowed changes what is found.
  if constexpr (requires { visit.lines(); }) visit("shared_memory", limits.allow_shared_memory, "allow_shared_memory");
  if constexpr (!std::is_const_v<Limits>) {
    limits.isolation = isolation == "always" ? campaign::Isolation::always : campaign::Isolation::after_a_death;
    limits.play_twice = plays.empty();
    limits.allow_shared_memory = !shared.empty();
  }
}

}  // namespace regista::study
