// SPDX-License-Identifier: MIT
#include "study/experiment_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "campaign/inputs.hpp"
#include "campaign/job_setup.hpp"
#include "campaign/mathematics.hpp"
#include "config/bad_input.hpp"
#include "config/documents.hpp"
#include "config/flow.hpp"
#include "config/read.hpp"
#include "config/scalar.hpp"
#include "config/text.hpp"
#include "match/names.hpp"
#include "match/teams.hpp"
#include "plugin/declarations.hpp"
#include "study/document_settings.hpp"
#include "study/experiment.hpp"
#include "study/measure.hpp"
#include "study/packets_spent.hpp"
#include "study/study_inputs.hpp"

namespace regista::study {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_matches = 1'000'000;  // of all arms
constexpr std::size_t most_conditions = 2000;

struct Reading {
  const config::Node& document;
  const config::Experiment& experiment;
  const plugin::Catalogue& catalogue;
  std::vector<std::string> plugins;
};

campaign::Job job_of(const Reading& reading, std::size_t arm, std::size_t side, const std::vector<Setting>& settings) {
  const config::Experiment& experiment = reading.experiment;
  campaign::Job out;
  const std::string& team = experiment.arms[arm].team;
  out.teams[side] = from_here(team.empty() ? experiment.team : team);
  out.teams[1 - side] = from_here(experiment.opponent);
  out.rules = from_here(experiment.rules);
  out.robot = from_here(experiment.robot);
  const std::string own = from_here(experiment.disturbance), other = from_here(experiment.opponent_disturbance);
  out.home_disturbance = side == 0 ? own : other;
  out.away_disturbance = side == 0 ? other : own;
  for (const Setting& each : settings) out.overrides.push_back(override_of(each, side));
  out.plugins = reading.plugins;
  if (experiment.limit) out.limit = config::real_text(*experiment.limit);
  return out;
}

// What the clock of the game says at the end of a match that no difference of goals ends, of all halves together; the
// clock runs on in the Ready and Set that follow a goal, so Playing is less. It stands before each half's kick-off,
// which counts for the limit alone.
double clock_seconds(const match::Setup& setup) {
  constexpr double initial = 1.0;  // s; match/referee.hpp
  const config::Durations& durations = setup.rules.durations;
  if (setup.opening) return setup.limit.value_or(setup.opening->length);
  double seconds = 0.0, left = setup.limit.value_or(HUGE_VAL);
  for (int half = 0; half < durations.halves; ++half) {
    left -= initial + durations.ready + durations.set;
    const double played = std::clamp(left, 0.0, durations.half);
    seconds += played;
    left -= played;
  }
  return seconds;
}

// With --minutes or --matches in the place of what the document says.
config::Overrides overrides_of(const ExperimentRequest& options) {
  config::Overrides out = options.overrides;
  if (!options.minutes.empty() && !options.matches.empty())
    throw config::BadInput("--minutes and --matches: one of them");
  const std::string wanted = options.minutes.empty() ? "matches" : "minutes";
  const std::string& value = options.minutes.empty() ? options.matches : options.minutes;
  if (value.empty()) return out;
  const config::Node document = config::load(options.file, out);
  for (const char* other : {"minutes", "matches"}) {
    if (other != wanted && document[other]) out.push_back(fmt::format("{}=~", other));
  }
  out.push_back(fmt::format("{}={}", wanted, value));
  return out;
}

class Planner {
 public:
  Planner(const ExperimentRequest& options, const plugin::Catalogue& catalogue, config::Mistakes& mistakes)
      : options_(options),
        mistakes_(mistakes),
        overrides_(overrides_of(options)),
        document_(config::load(options.file, overrides_)),
        experiment_(config::read_experiment(document_)),
        reading_{document_, experiment_, catalogue, options.plugins} {}

  ExperimentPlan plan() {
    describe();
    make_conditions();
    if (!mistakes_.none()) return {};  // what comes next needs them all
    mistakes_.attempt("", [&] { add_openings(); });
    mistakes_.attempt("", [&] { count_pairs(); });
    choose_measures();
    choose_comparisons();
    return std::move(plan_);
  }

 private:
  void describe() {
    plan_.name = experiment_.name;
    plan_.question = experiment_.question;
    plan_.opponent = from_here(experiment_.opponent);
    plan_.first_seed = static_cast<std::uint64_t>(experiment_.seed);
    plan_.confidence = experiment_.confidence;
    plan_.limits =
        campaign::limits_of(options_, experiment_.isolation, experiment_.play_twice, experiment_.allow_shared_memory);
    plan_.folder = fs::current_path().string();
    plan_.file = options_.file;
    plan_.overrides = overrides_;
    for (const config::Experiment::Arm& arm : experiment_.arms) {
      Arm& out = plan_.arms.emplace_back();
      out.name = arm.name;
      out.file = from_here(arm.team.empty() ? experiment_.team : arm.team);
      for (const config::Node::Entry& entry : arm.set.entries()) {
        out.settings.push_back(fmt::format("{}={}", entry.key, config::flow(entry.value)));
      }
    }
    if (experiment_.sweep) {
      plan_.sweep = experiment_.sweep->path;
      for (const config::Node& value : experiment_.sweep->values) plan_.values.push_back(config::flow(value));
    } else {
      plan_.values = {""};
    }
    if (plan_.arms.size() * plan_.values.size() > most_conditions) {
      config::refuse(document_, {"sweep.values"},
                     fmt::format("{} arms at {} values: at most {} can be played", plan_.arms.size(),
                                 plan_.values.size(), most_conditions));
    }
  }

  void make_conditions() {
    const std::string program = campaign::program_hash(), mathematics = campaign::mathematics_fingerprint();
    const auto declarations = plugin::declarations(reading_.catalogue.plugins());
    const auto shown = [&](const config::Node& document) {
      return config::show(document, declarations, config::Remarks::without);
    };
    std::string opponent;
    const auto make = [&](std::size_t arm, std::size_t value) {
      Condition& condition = plan_.conditions.emplace_back();
      condition.arm = arm;
      condition.value = value;
      const std::vector<Setting> settings = settings_of(experiment_, document_, arm, value);
      for (const std::size_t side : {0u, 1u}) {
        campaign::Job& job = condition.jobs[side];
        job = job_of(reading_, arm, side, settings);
        campaign::MatchSetup prepared =
            settled_match(job, side, settings, job_of(reading_, arm, 0, {}), reading_.catalogue);
        job.home_inputs = campaign::team_inputs(*prepared.plans[0], *prepared.documents[0], reading_.catalogue);
        job.away_inputs = campaign::team_inputs(*prepared.plans[1], *prepared.documents[1], reading_.catalogue);
        job.common_inputs = campaign::common_inputs(prepared.setup, program, mathematics);
        if (side == 1) continue;
        if (value == 0) plan_.documents.push_back(shown(*prepared.documents[0]));
        if (opponent.empty()) opponent = shown(*prepared.documents[1]);
        paths_.push_back(metric_paths_of(*prepared.plans[0]));
        if (value == 0) roles_.push_back(roles_of(*prepared.plans[0]));
        setups_.push_back(std::move(prepared.setup));
      }
    };
    for (std::size_t value = 0; value < plan_.values.size(); ++value) {
      for (std::size_t arm = 0; arm < plan_.arms.size(); ++arm) {
        mistakes_.attempt("", [&] { make(arm, value); });
      }
    }
    plan_.documents.push_back(opponent);
  }

  // Names of the roles that are played while nothing special is going on: of the first list.
  static std::vector<std::string> roles_of(const mind::TeamPlan& team) {
    const std::vector<match::Role> roles = match::roles(team);
    const std::vector<std::string> names = match::role_names(roles);
    std::vector<std::string> out;
    for (std::size_t i = 0; i < roles.size(); ++i) {
      if (roles[i].list == roles.front().list) out.push_back(names[i]);
    }
    return out;
  }

  // Each scene must fit the rules and robots of every condition.
  void add_openings() {
    DocumentScenes found = document_scenes(experiment_.openings, setups_);
    plan_.openings = std::move(found.openings);
    scenes_ = std::move(found.read);
  }

  // The shortest match of any condition decides how many make the minutes.
  void count_pairs() {
    if (experiment_.matches) {
      plan_.pairs = static_cast<std::uint64_t>(*experiment_.matches) / 2;
    } else {
      double shortest = HUGE_VAL;
      for (match::Setup setup : setups_) {
        if (scenes_.empty()) shortest = std::min(shortest, clock_seconds(setup));
        for (const config::Opening& scene : scenes_) {
          setup.opening = scene;
          shortest = std::min(shortest, clock_seconds(setup));
        }
      }
      if (!(shortest > 0.0)) {
        config::refuse(document_, {"limit", "minutes"},
                       "limit: matches would end before their first kick-off, so they make no minutes of the clock");
      }
      plan_.pairs = static_cast<std::uint64_t>(std::ceil(*experiment_.minutes * 60.0 / (2.0 * shortest) - 1e-9));
    }
    plan_.pairs = std::max<std::uint64_t>(plan_.pairs, 1);
    const std::uint64_t each = 2 * plan_.conditions.size();
    if (plan_.pairs <= most_matches / each) return;
    config::refuse(
        document_, {"minutes", "matches"},
        fmt::format("{} arms and values make more than {} matches in all", plan_.conditions.size(), most_matches));
  }

  // Every measure that a match of any condition has.
  std::vector<std::string> known_measures() const {
    std::vector<std::string> out(measures_of_score.begin(), measures_of_score.end());
    for (const auto& of_team : paths_) {
      for (const std::string& path : of_team) {
        if (std::ranges::find(out, path) == out.end()) out.push_back(path);
      }
    }
    return out;
  }

  void require_measure(const std::string& measure, const config::Location& where, const char* what,
                       const std::vector<std::string>& known) const {
    const bool short_games = !plan_.openings.empty() || !plan_.conditions.front().jobs[0].limit.empty();
    if (const std::string why = why_missing(measure, short_games); !why.empty()) {
      throw config::Error(where, fmt::format("{}: {}", what, why));
    }
    if (std::ranges::find(known, measure) != known.end()) return;
    throw config::Error(where, config::unknown("measure", measure, what, known));
  }

  void choose_measures() {
    const std::vector<std::string> known = known_measures();
    const auto add = [&](const std::string& measure) {
      if (std::ranges::find(plan_.measures, measure) == plan_.measures.end()) plan_.measures.push_back(measure);
    };
    for (const config::Node& each : experiment_.measures) {
      const std::string measure(match::without_roles(each.text()));
      mistakes_.attempt("", [&] { require_measure(measure, each.where(), "measures", known); });
      add(measure);
    }
    if (plan_.measures.empty()) {
      for (const std::string& each : usual_measures(known)) add(each);
    }
    if (!experiment_.primary) return;
    plan_.primary = match::without_roles(experiment_.primary->measure);
    mistakes_.attempt(
        "", [&] { require_measure(plan_.primary, document_["primary"]["measure"].where(), "primary", known); });
    add(plan_.primary);
    plan_.test = experiment_.primary->test == config::PairedTest::sign_flip ? PairTest::sign_flip : PairTest::paired_t;
  }

  // What all roles sum up to, then what the paper shows of each role by itself (of a sweep only the sums: each becomes
  // a curve), then how the team knew and did.
  std::vector<std::string> usual_measures(const std::vector<std::string>& known) const {
    std::vector<std::string> roles;
    for (const auto& of_team : roles_) {
      for (const std::string& role : of_team) {
        if (std::ranges::find(roles, role) == roles.end()) roles.push_back(role);
      }
    }
    std::vector<std::string> sums, out;
    for (const std::string& path : known) {
      const bool of_roles = std::ranges::any_of(
          roles, [&](const std::string& role) { return std::ranges::find(known, role + '.' + path) != known.end(); });
      if (of_roles) sums.push_back(path);
    }
    out = sums;
    if (!plan_.swept()) {
      for (const char* of_each : {"overlap_seconds", "uncovered_seconds", "switches"}) {
        for (const std::string& role : roles) {
          const std::string path = role + '.' + of_each;
          if (std::ranges::find(known, path) != known.end()) out.push_back(path);
        }
      }
    }
    for (const char* each : {"agreement", "agreement_before_silence", "agreement_after_silence", "goals",
                             "goals_against", "points", "packets"}) {
      if (std::ranges::find(known, each) != known.end()) out.push_back(each);
    }
    return out;
  }

  // Arms at each value; a single arm at each value with the first one.
  void choose_comparisons() {
    const std::size_t arms = plan_.arms.size(), values = plan_.values.size();
    if (arms == 1) {
      for (std::size_t value = 1; value < values; ++value) plan_.comparisons.push_back({value, 0});
      return;
    }
    std::vector<Comparison> of_arms;
    if (experiment_.primary && !experiment_.primary->compare.empty()) {
      const auto index = [&](const config::Node& name) {
        return static_cast<std::size_t>(std::ranges::find(plan_.arms, name.text(), &Arm::name) - plan_.arms.begin());
      };
      for (const config::Node& pair : experiment_.primary->compare) {
        of_arms.push_back({index(pair.elements()[0]), index(pair.elements()[1])});
      }
    } else {
      for (std::size_t first = 0; first < arms; ++first) {
        for (std::size_t second = first + 1; second < arms; ++second) of_arms.push_back({first, second});
      }
    }
    for (std::size_t value = 0; value < values; ++value) {
      for (const Comparison& each : of_arms) {
        plan_.comparisons.push_back({plan_.condition(each.first, value), plan_.condition(each.second, value)});
      }
    }
  }

  const ExperimentRequest& options_;
  config::Mistakes& mistakes_;
  config::Overrides overrides_;
  config::Node document_;
  config::Experiment experiment_;
  Reading reading_;
  ExperimentPlan plan_;
  std::vector<match::Setup> setups_;             // by condition
  std::vector<std::vector<std::string>> paths_;  // of metrics, by condition
  std::vector<std::vector<std::string>> roles_;  // by arm
  std::vector<config::Opening> scenes_;
};

}  // namespace

ExperimentPlan planned_experiment(const ExperimentRequest& options, const plugin::Catalogue& catalogue) {
  config::Mistakes first(config::Mistakes::After::stop);
  return Planner(options, catalogue, first).plan();
}

void check_experiment(const ExperimentRequest& options, const plugin::Catalogue& catalogue,
                      config::Mistakes& mistakes) {
  Planner(options, catalogue, mistakes).plan();
}

}  // namespace regista::study
