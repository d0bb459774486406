// SPDX-License-Identifier: MIT
#include "study/experiment_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "campaign/inputs.hpp"
#include "campaign/mathematics.hpp"
#include "config/documents.hpp"
#include "config/read.hpp"
#include "config/values.hpp"
#include "match/names.hpp"
#include "match/teams.hpp"
#include "plugin/declarations.hpp"
#include "study/experiment.hpp"
#include "study/measure.hpp"
#include "study/packets_spent.hpp"
#include "study/settings.hpp"
#include "study/study_inputs.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_matches = 1'000'000;  // of all arms
constexpr std::size_t most_conditions = 2000;

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

class Planner {
 public:
  Planner(const config::Node& document, const std::vector<std::string>& plugins, const plugin::Catalogue& catalogue,
          config::Mistakes& mistakes)
      : document_(document), catalogue_(catalogue), mistakes_(mistakes) {
    plan_.asked = config::read_document<config::Experiment>(document);
    config::rename_files(declare(plan_.asked), from_here);
    plan_.folder = fs::current_path().string();
    plan_.plugins = plugins;
  }

  ExperimentPlan plan() {
    if (plan_.arms() * plan_.values() > most_conditions) {
      config::refuse(
          document_, {"sweep.values"},
          fmt::format("{} arms at {} values: at most {} can be played", plan_.arms(), plan_.values(), most_conditions));
    }
    make_jobs(plan_, document_);
    look_at_conditions();
    if (!mistakes_.none()) return {};  // what comes next needs them all
    mistakes_.attempt("", [&] { add_openings(); });
    mistakes_.attempt("", [&] { count_pairs(); });
    choose_measures();
    return std::move(plan_);
  }

 private:
  void look_at_conditions() {
    const std::string program = campaign::program_hash(), mathematics = campaign::mathematics_fingerprint();
    const auto declarations = plugin::declarations(catalogue_.plugins());
    const auto shown = [&](const config::Node& document) {
      return config::show(document, declarations, config::Remarks::without);
    };
    std::string opponent;
    const auto look_at = [&](Condition& condition) {
      const config::Overrides settings = settings_of(plan_.asked, document_, condition.arm, condition.value);
      for (const std::size_t side : {0u, 1u}) {
        campaign::Job& job = condition.jobs[side];
        campaign::MatchSetup prepared = match_of(job, on_side(settings, side), settings, catalogue_);
        job.home_inputs = campaign::team_inputs(*prepared.plans[0], *prepared.documents[0], catalogue_);
        job.away_inputs = campaign::team_inputs(*prepared.plans[1], *prepared.documents[1], catalogue_);
        job.common_inputs = campaign::common_inputs(prepared.setup, program, mathematics);
        if (side == 1) continue;
        if (condition.value == 0) plan_.documents.push_back(shown(*prepared.documents[0]));
        if (opponent.empty()) opponent = shown(*prepared.documents[1]);
        paths_.push_back(metric_paths_of(*prepared.plans[0]));
        if (condition.value == 0) roles_.push_back(roles_of(*prepared.plans[0]));
        setups_.push_back(std::move(prepared.setup));
      }
    };
    for (Condition& each : plan_.conditions) mistakes_.attempt("", [&] { look_at(each); });
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
    DocumentScenes found = document_scenes(plan_.asked.settings.openings, setups_);
    plan_.openings = std::move(found.openings);
    scenes_ = std::move(found.read);
  }

  // The shortest match of any condition decides how many make the minutes.
  void count_pairs() {
    if (plan_.asked.matches) {
      plan_.pairs = static_cast<std::uint64_t>(*plan_.asked.matches) / 2;
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
      plan_.pairs = static_cast<std::uint64_t>(std::ceil(*plan_.asked.minutes * 60.0 / (2.0 * shortest) - 1e-9));
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
    const bool short_games = !plan_.openings.empty() || plan_.asked.settings.limit;
    if (const std::string why = why_missing(measure, short_games); !why.empty()) {
      throw config::Error(where, fmt::format("{}: {}", what, why));
    }
    if (std::ranges::find(known, measure) != known.end()) return;
    throw config::Error(where, texts::unknown("measure", measure, what, known));
  }

  void choose_measures() {
    const std::vector<std::string> known = known_measures();
    const auto add = [&](const std::string& measure) {
      if (std::ranges::find(plan_.measures, measure) == plan_.measures.end()) plan_.measures.push_back(measure);
    };
    for (const config::Node& each : plan_.asked.measures) {
      const std::string measure(match::without_roles(each.text()));
      mistakes_.attempt("", [&] { require_measure(measure, each.where(), "measures", known); });
      add(measure);
    }
    if (plan_.measures.empty()) {
      for (const std::string& each : usual_measures(known)) add(each);
    }
    const std::string primary = plan_.primary();
    if (primary.empty()) return;
    mistakes_.attempt("", [&] { require_measure(primary, document_["primary"]["measure"].where(), "primary", known); });
    add(primary);
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

  const config::Node& document_;
  const plugin::Catalogue& catalogue_;
  config::Mistakes& mistakes_;
  ExperimentPlan plan_;
  std::vector<match::Setup> setups_;             // by condition
  std::vector<std::vector<std::string>> paths_;  // of metrics, by condition
  std::vector<std::vector<std::string>> roles_;  // by arm
  std::vector<config::Opening> scenes_;
};

}  // namespace

ExperimentPlan planned_experiment(const config::Node& document, const std::vector<std::string>& plugins,
                                  const plugin::Catalogue& catalogue) {
  config::Mistakes first(config::Mistakes::After::stop);
  return Planner(document, plugins, catalogue, first).plan();
}

void check_experiment(const config::Node& document, const std::vector<std::string>& plugins,
                      const plugin::Catalogue& catalogue, config::Mistakes& mistakes) {
  Planner(document, plugins, catalogue, mistakes).plan();
}

}  // namespace regista::study
