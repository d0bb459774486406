// SPDX-License-Identifier: MIT
#include "campaign/job.hpp"

#include <algorithm>
#include <climits>
#include <stdexcept>
#include <string_view>

#include "campaign/match_encoding.hpp"
#include "texts/json.hpp"

namespace regista::campaign {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 5> kinds{"played", "failed", "changed", "refused", "stopped"};

// Replaces bytes that are not UTF-8, because plugins may write any bytes and JSON must be UTF-8.
std::string dump(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

template <class Read>
auto reading(const std::string& text, Read read) {
  try {
    return read(Json::parse(text));
  } catch (const Json::exception& error) {
    throw std::invalid_argument(error.what());
  } catch (const std::out_of_range& error) {
    throw std::invalid_argument(error.what());
  }
}

Json json_of(const Failure& failure) {
  return {{"side", failure.side},   {"plugin", failure.plugin}, {"call", failure.call},
          {"robot", failure.robot}, {"tick", failure.tick},     {"what", failure.what}};
}

Json json_of(const std::vector<Input>& inputs) {
  Json out = Json::array();
  for (const Input& input : inputs) out.push_back({input.name, input.hash});
  return out;
}

std::vector<Input> inputs_of(const Json& json) {
  std::vector<Input> out;
  for (const Json& input : json) out.push_back({input.at(0).get<std::string>(), input.at(1).get<std::string>()});
  return out;
}

Json json_of(const Limits& limits) {
  return {{"processor_seconds", limits.processor_seconds},
          {"memory", limits.memory},
          {"wall_seconds", limits.wall_seconds},
          {"match_wall_seconds", limits.match_wall_seconds}};
}

Limits limits_of(const Json& json) {
  Limits out;
  out.processor_seconds = static_cast<int>(whole_number(json.at("processor_seconds"), INT_MAX));
  out.memory = whole_number(json.at("memory"));
  json.at("wall_seconds").get_to(out.wall_seconds);
  json.at("match_wall_seconds").get_to(out.match_wall_seconds);
  return out;
}

Failure failure_of(const Json& json) {
  Failure out;
  out.side = static_cast<int>(whole_number(json.at("side"), 1));
  out.plugin = json.at("plugin").get<std::string>();
  out.call = json.at("call").get<std::string>();
  out.robot = static_cast<int>(whole_number(json.at("robot"), INT_MAX));
  out.tick = whole_number(json.at("tick"));
  out.what = json.at("what").get<std::string>();
  return out;
}

}  // namespace

std::uint64_t whole_number(const Json& json, std::uint64_t most) {
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > most)
    throw std::out_of_range("expected a whole number");
  return json.get<std::uint64_t>();
}

std::vector<std::string> match_arguments(const Job& job) {
  std::vector<std::string> words{"match", job.teams[0], job.teams[1], "--seed", std::to_string(job.seed)};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--opening", job.opening);
  add("--limit", job.limit);
  add("--rules", job.rules);
  add("--robot", job.robot);
  add("--disturbance", job.disturbance);
  add("--home-disturbance", job.home_disturbance);
  add("--away-disturbance", job.away_disturbance);
  for (const std::string& each : job.overrides) add("--set", each);
  for (const std::string& each : job.plugins) add("--plugins", each);
  return words;
}

std::string to_json(const Job& job) {
  return dump(Json{{"teams", job.teams},
                   {"rules", job.rules},
                   {"robot", job.robot},
                   {"disturbance", job.disturbance},
                   {"home_disturbance", job.home_disturbance},
                   {"away_disturbance", job.away_disturbance},
                   {"opening", job.opening},
                   {"overrides", job.overrides},
                   {"plugins", job.plugins},
                   {"limit", job.limit},
                   {"seed", job.seed},
                   {"record", job.record},
                   {"expects_failure", job.expects_failure},
                   {"separation", static_cast<int>(job.separation)},
                   {"elsewhere", job.perturbed},
                   {"look", static_cast<int>(job.look)},
                   {"hides", job.hides},
                   {"trail", job.trail},
                   {"limits", json_of(job.limits)},
                   {"root", job.root},
                   {"plugin_files", job.plugin_files},
                   {"home_inputs", json_of(job.home_inputs)},
                   {"away_inputs", json_of(job.away_inputs)},
                   {"common_inputs", json_of(job.common_inputs)}});
}

Job job_from_json(const std::string& text) {
  return reading(text, [](const Json& json) {
    Job job;
    json.at("teams").get_to(job.teams);
    json.at("rules").get_to(job.rules);
    json.at("robot").get_to(job.robot);
    json.at("disturbance").get_to(job.disturbance);
    job.home_disturbance = json.value("home_disturbance", "");  // missing in older results
    job.away_disturbance = json.value("away_disturbance", "");
    json.at("opening").get_to(job.opening);
    json.at("overrides").get_to(job.overrides);
    json.at("plugins").get_to(job.plugins);
    json.at("limit").get_to(job.limit);
    job.seed = whole_number(json.at("seed"));
    job.record = json.value("record", "");  // also missing in older results
    job.expects_failure = json.value("expects_failure", false);
    if (json.contains("separation")) job.separation = static_cast<Separation>(whole_number(json.at("separation"), 2));
    job.perturbed = json.value("elsewhere", false);
    if (json.contains("look"))
      job.look =
          static_cast<plugin::Inspection>(whole_number(json.at("look"), static_cast<int>(plugin::Inspection::always)));
    job.hides = json.value("hides", false);
    job.trail = json.value("trail", false);
    job.root = json.value("root", "");
    if (json.contains("limits")) job.limits = limits_of(json.at("limits"));
    if (json.contains("plugin_files")) json.at("plugin_files").get_to(job.plugin_files);
    job.home_inputs = inputs_of(json.at("home_inputs"));
    job.away_inputs = inputs_of(json.at("away_inputs"));
    job.common_inputs = inputs_of(json.at("common_inputs"));
    return job;
  });
}

std::string to_json(const Failure& failure) { return dump(json_of(failure)); }

Failure failure_from_json(const std::string& text) {
  return reading(text, [](const Json& json) { return failure_of(json); });
}

std::string to_json(const std::vector<Input>& inputs) { return dump(json_of(inputs)); }

std::vector<Input> inputs_from_json(const std::string& text) {
  return reading(text, [](const Json& json) { return inputs_of(json); });
}

std::string to_json(const Answer& answer) {
  const MatchResult& decided = answer.decided;
  Json json{{"kind", kinds[static_cast<std::size_t>(answer.kind)]},
            {"message", answer.message},
            {"score", decided.score},
            {"ended", decided.ended},
            {"hash", decided.hash},
            {"seconds", decided.seconds},
            {"from_outside", answer.from_outside}};
  if (!decided.metrics.empty()) {
    json["metrics"] = Json::object();
    add_metrics(json["metrics"], decided.metrics);
  }
  if (decided.failure) json["failure"] = json_of(*decided.failure);
  if (!decided.kept.empty()) json["kept"] = decided.kept;
  return dump(json);
}

Answer answer_from_json(const std::string& text) {
  return reading(text, [](const Json& json) {
    Answer answer;
    const auto kind = std::ranges::find(kinds, json.at("kind").get<std::string>());
    if (kind == kinds.end()) throw std::invalid_argument("no such kind of answer");
    answer.kind = static_cast<Answer::Kind>(kind - kinds.begin());
    json.at("message").get_to(answer.message);
    json.at("score").get_to(answer.decided.score);
    json.at("ended").get_to(answer.decided.ended);
    json.at("hash").get_to(answer.decided.hash);
    if (json.contains("metrics")) answer.decided.metrics = metrics_from_json(json.at("metrics"));
    json.at("seconds").get_to(answer.decided.seconds);
    answer.from_outside = json.value("from_outside", false);
    answer.decided.kept = json.value("kept", "");
    if (json.contains("failure")) answer.decided.failure = failure_of(json.at("failure"));
    if ((answer.kind == Answer::Kind::failed) != answer.decided.failure.has_value()) {
      throw std::invalid_argument("a failure belongs to an answer that says so");
    }
    return answer;
  });
}

MatchResult forfeit(const Failure& failure, double seconds) {
  constexpr int goals_of_forfeit = 10;
  MatchResult out;
  out.score[static_cast<std::size_t>(1 - failure.side)] = goals_of_forfeit;
  out.ended = "forfeit";
  out.failure = failure;
  out.seconds = seconds;
  return out;
}

}  // namespace regista::campaign
