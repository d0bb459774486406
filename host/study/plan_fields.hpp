// SPDX-License-Identifier: MIT
// Plans as JSON. A plan holds the document of its study, with everything that the user asked for (config::Tournament
// and others), and facts that the program found when it made the plan. For each type of plan, one function fields()
// names these facts. Writer and reader call the same function. A type inside a plan may have a function fields(), too:
//
//   template <Like<FooPlan> Plan, class Visit> void fields(Plan& plan, Visit& visit) {
//     visit("folder", plan.folder);                                 // key in JSON, value
//     visit.maybe("pairs_before", plan.pairs_before);               // not written if empty
//   }
#pragma once

#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>

#include <climits>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/match_setup.hpp"
#include "config/documents.hpp"
#include "config/parse.hpp"
#include "config/values.hpp"
#include "plugin/catalogue.hpp"
#include "study/settings.hpp"
#include "study/study.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::study {

using PlanJson = nlohmann::ordered_json;

// T is `Of` or `const Of`.
template <class T, class Of>
concept Like = std::same_as<std::remove_const_t<T>, Of>;

struct PlanWriter;
struct PlanReader;

template <class T>
concept HasFields = requires(T& value, const T& constant, PlanWriter& writer, PlanReader& reader) {
  fields(constant, writer);
  fields(value, reader);
};

// --- json_of() returns a value as JSON. read() sets a value; throws PlanJson::exception and std::out_of_range. ---

template <class T>
PlanJson json_of(const T& value);
template <class T>
void read(const PlanJson& json, T& value);

inline PlanJson json_of(const std::vector<campaign::Input>& inputs) {
  return PlanJson::parse(campaign::to_json(inputs));
}
inline void read(const PlanJson& json, std::vector<campaign::Input>& inputs) {
  inputs = campaign::inputs_from_json(json.dump());
}

// JSON keeps only the inputs of a plan's job. The document determines the rest of the job.
template <Like<campaign::Job> Job, class Visit>
void fields(Job& job, Visit& visit) {
  visit("home", job.home_inputs);
  visit("away", job.away_inputs);
  visit("common", job.common_inputs);
}

inline PlanJson json_of(const Opening& opening) {
  PlanJson out{{"file", opening.file}, {"input", json_of(std::vector<campaign::Input>{opening.input})}};
  if (opening.length > 0.0) out["length"] = opening.length;
  return out;
}
inline void read(const PlanJson& json, Opening& opening) {
  json.at("file").get_to(opening.file);
  opening.input = campaign::inputs_from_json(json.at("input").dump()).at(0);
  opening.length = json.value("length", 0.0);
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

struct PlanWriter {
  PlanJson out = PlanJson::object();

  template <class T>
  void operator()(const char* key, const T& value) {
    out[key] = json_of(value);
  }
  template <class T>
  void maybe(const char* key, const T& value) {
    if (value != T()) (*this)(key, value);
  }
};

struct PlanReader {
  const PlanJson& in;

  template <class T>
  void operator()(const char* key, T& value) {
    read(in.at(key), value);
  }
  template <class T>
  void maybe(const char* key, T& value) {
    if (in.contains(key)) read(in.at(key), value);
  }
};

template <class T>
PlanJson json_of(const T& value) {
  if constexpr (HasFields<T>) {
    PlanWriter writer;
    fields(value, writer);
    return std::move(writer.out);
  } else {
    return value;
  }
}

template <class T>
void read(const PlanJson& json, T& value) {
  if constexpr (HasFields<T>) {
    PlanReader reader{json};
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

inline constexpr int plan_version = 2;  // version of the plans that plan_text() writes

// The text of a plan: its document as YAML under the key "document", and its facts.
template <class Plan>
std::string plan_text(const char* study, const Plan& plan) {
  PlanJson out{{"study", study}, {"version", plan_version}, {"document", config::document_text(plan.asked)}};
  out.update(json_of(plan));
  // JSON must be UTF-8, but a file name may have any bytes.
  return out.dump(-1, ' ', false, PlanJson::error_handler_t::replace);
}

// Reads a text that plan_text() wrote. upgrade: converts the JSON of a plan of version 1. complete: checks the plan and
// adds members that JSON lacks; may throw std::out_of_range. Throws std::invalid_argument with the reason.
template <class Plan, class Upgrade, class Complete>
Plan read_plan(const std::string& text, const char* study, Upgrade upgrade, Complete complete) {
  try {
    PlanJson json = PlanJson::parse(text);
    if (json.at("study") != study) throw std::invalid_argument("these are results of another study");
    if (json.at("version") == 1) {
      json = upgrade(json);
    } else if (json.at("version") != plan_version) {
      throw std::invalid_argument("its plan is of another version");
    }
    Plan plan;
    read(json, plan);
    // Relative paths in the document start at the plan's folder. The files are not looked up: they may have moved.
    const config::Node document = config::parse_text(json.at("document").get<std::string>(), "its document");
    config::Mistakes first(config::Mistakes::After::stop, config::Mistakes::Files::as_they_stand);
    plan.asked = config::read_document<decltype(plan.asked)>(document, first);
    // Documents of older plans do not have the key `seeds`; their studies used consecutive seeds.
    if (!document["seeds"]) plan.asked.settings.seeds = config::Seeds::consecutive;
    complete(plan);
    return plan;
  } catch (const PlanJson::exception& error) {
    throw std::invalid_argument(fmt::format("its plan is damaged: {}", error.what()));
  } catch (const config::Error& error) {
    throw std::invalid_argument(fmt::format("its plan is damaged: {}", error.what()));
  } catch (const std::out_of_range&) {
    throw std::invalid_argument("its plan is damaged");
  }
}

// The differences between the documents of two plans, in words.
template <class Plan>
std::vector<std::string> document_differences(const Plan& before, const Plan& now) {
  auto asked = now.asked;
  return config::differences(config::parse_text(config::document_text(before.asked), "its document"), declare(asked));
}

// Collects the differences between the input files of two plans with the same teams and conditions, without repeats.
class InputDifferences {
 public:
  // lines: the differences that are known already.
  explicit InputDifferences(std::vector<std::string> lines = {}) : lines_(std::move(lines)) {}

  // Adds what differs between the inputs of then and today. whose: beginning of each line, such as "the opponent: ".
  void add(const std::string& whose, std::span<const campaign::Input> then, std::span<const campaign::Input> today) {
    for (const std::string& each : campaign::differences(then, today)) texts::add_once(lines_, whose + each);
  }

  // Adds the differences between scenes and returns all. Reports the order of scenes only if nothing else differs.
  std::vector<std::string> with_openings(std::span<const Opening> then, std::span<const Opening> today) && {
    const std::vector<campaign::Input> before = inputs_of(then), now = inputs_of(today);
    add("", before, now);
    if (lines_.empty() && before != now) lines_.push_back("the openings come in another order");
    return std::move(lines_);
  }

 private:
  std::vector<std::string> lines_;
};

// Each function converts a plan of version 1, which held no document, into a plan of plan_version. Throws
// nlohmann::json::exception, std::out_of_range and config::Error for a damaged plan.
PlanJson tournament_of_version_1(const PlanJson& plan);
PlanJson experiment_of_version_1(const PlanJson& plan);
PlanJson tuning_of_version_1(const PlanJson& plan);

// --- What the planners of all studies begin with: the document, its plugins, and a plan with the facts that need no
// plugin. mistakes: gets the mistakes of the document, or throws the first one.
template <class Plan>
class Planner {
 public:
  // plugins: folders of the catalogue.
  Planner(const config::Node& document, const std::vector<std::string>& plugins, const plugin::Catalogue& catalogue,
          config::Mistakes& mistakes)
      : document_(document), catalogue_(catalogue), mistakes_(mistakes) {
    plan_.asked = config::read_document<decltype(plan_.asked)>(document);
    config::rename_files(declare(plan_.asked), from_here);
    plan_.folder = std::filesystem::current_path().string();
    plan_.plugins = plugins;
  }

 protected:
  const config::Node& document_;
  const plugin::Catalogue& catalogue_;
  config::Mistakes& mistakes_;
  const std::string program_ = campaign::program_hash(), mathematics_ = campaign::mathematics_fingerprint();
  Plan plan_;
};

}  // namespace regista::study
