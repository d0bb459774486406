// SPDX-License-Identifier: MIT
// The settings of a study for its matches: rules, robot and limit, and values that replace values of the documents. In
// experiments and tunings, the path of such a value belongs to the study's own team (the arm's team or the tuned team),
// unless the path begins with b (the other team), rules, robot, a_disturbance (of the own team) or b_disturbance.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/engine.hpp"
#include "campaign/job.hpp"
#include "campaign/match_setup.hpp"
#include "campaign/store.hpp"
#include "config/declaration.hpp"
#include "config/experiment.hpp"
#include "config/match_settings.hpp"
#include "config/node.hpp"
#include "config/opening.hpp"
#include "config/overlay.hpp"
#include "match/match.hpp"
#include "mind/team_plan.hpp"
#include "plugin/catalogue.hpp"

namespace regista::study {

// A scene from which matches of a study start.
struct Opening {
  std::string file;
  campaign::Input input;
  double length = 0.0;  // s of play until the game ends; 0: unknown, as in plans of earlier versions
};

std::vector<campaign::Input> inputs_of(std::span<const Opening> openings);

// "matches", or "games from scenes" if there are openings.
const char* games_in_words(std::span<const Opening> openings);

// "43 scenes of about 42 s": number of scenes, and their mean length if known. limit: latest end of every scene, s.
std::string scenes_in_words(std::span<const Opening> openings, std::optional<double> limit);

// Makes the match of a job start from this scene.
inline void start_from(const Opening& opening, campaign::Job& job) {
  job.opening = opening.file;
  job.common_inputs.push_back(opening.input);
}

// Returns the index of an opening, drawn by the seed. openings: number of openings, one or more. A test may stop at any
// pair, so its result must not depend on the order in which a person listed the openings. Philox: J. K. Salmon et al.,
// "Parallel Random Numbers: As Easy as 1, 2, 3", 2011.
std::size_t drawn_opening(std::uint64_t seed, std::size_t openings);

// The first key of a path: "sender" for "sender.params.period".
std::string_view first_part(std::string_view path);

// Throws config::Error for a path of version 0.2, which called the other team "opponent". Stored studies may have such
// paths, and settings_of() reads them.
void require_present_names(const config::Node& set, const std::string& what);

// The settings in a map of a document. what: the map's name in messages. Throws config::Error for an impossible path.
config::Overrides settings_of(const config::Node& set, const std::string& what);

// The settings of an arm at a value of the sweep. value: index of the sweep's value, 0 without a sweep. If two settings
// have the same path, the later setting applies. document: the source of `experiment`. Throws config::Error for an
// impossible path, or for a path that both arm and sweep set.
config::Overrides settings_of(const config::Experiment& experiment, const config::Node& document, std::size_t arm,
                              std::size_t value);

// Returns whether a path belongs to the study's own team.
bool is_of_own_team(std::string_view path);

// on_side(): translates the paths from the study's document to a match with the own team on this side (0 home, 1 away).
// as_typed(): the settings as texts PATH=VALUE, as the user types them after `--set`.
config::Overrides on_side(const config::Overrides& settings, std::size_t side);
std::vector<std::string> as_typed(const config::Overrides& settings);

// The seed of pair 0 of a study. Pair k has this seed plus k. If the study hashes its seed, the result is below 2^32.
std::uint64_t first_seed(std::int64_t seed, config::Seeds seeds);

// What the plans of all studies have in common. Asked: the document of the study.
template <class Asked>
struct StudyPlan {
  Asked asked;                       // relative paths start at `folder`
  std::vector<Opening> openings;     // all scenes of the document; empty: matches start with kick-off
  std::string folder;                // absolute path of the folder in which the study began
  std::vector<std::string> plugins;  // folders of --plugins
  std::string program;               // version of the program that began the study; empty: unknown

  std::uint64_t first_seed() const { return study::first_seed(asked.seed, asked.settings.seeds); }
  campaign::Limits limits() const { return campaign::limits_of(asked.settings); }
  // Returns whether an opening or a limit may end matches earlier than whole matches.
  bool short_games() const { return !openings.empty() || asked.settings.limit; }
};

// A job with the rules, robot and limit of these settings. plugins: folders of plugins.
campaign::Job job_under(const config::MatchSettings& settings, const std::vector<std::string>& plugins);

// Sets up the match of a job with `settings` in place of the job's own overrides. said: the same settings with the
// paths of the study's document, which error messages show. Throws config::Error at the mistake in a document.
campaign::MatchSetup match_of(const campaign::Job& job, const config::Overrides& settings,
                              const config::Overrides& said, const plugin::Catalogue& catalogue);

// The two matches of the study's own team against an opponent: [0] with the own team at home, [1] away.
using OwnJobs = std::array<campaign::Job, 2>;

// Files and settings of both OwnJobs. An empty file name means the built-in values.
struct OwnMatches {
  std::string team, opponent, disturbance, opponent_disturbance;
  config::Overrides settings;  // with paths as the study's document has them; on_side() translates them for a match
};

// Makes both jobs again, with the rules, robot and limit of `under`. Keeps only the inputs (Job::home_inputs, ...).
void ask_for(OwnJobs& jobs, const OwnMatches& asked, const config::MatchSettings& under,
             const std::vector<std::string>& plugins);

// Sets up both matches and stores their inputs in the jobs. Returns the match with the own team at home. program,
// mathematics: see campaign::common_inputs. Throws like match_of().
campaign::MatchSetup find_inputs(OwnJobs& jobs, const config::Overrides& settings, const plugin::Catalogue& catalogue,
                                 const std::string& program, const std::string& mathematics);

// Returns the fixture of a job (the match without its seed) with its key. The job must have its inputs.
campaign::Store::Fixture fixture_of(campaign::Job job);

// Returns `path` if it is a file. For a folder, returns all its .yaml files, sorted by name. Throws config::BadInput
// for a folder that cannot be read or has no .yaml file. who: the beginning of the message.
std::vector<std::string> opening_files(const std::string& path, const std::string& who);

// Adds a scene. Throws config::BadInput if `scenes` has a scene of this name. who: the beginning of its message.
void add_scene(std::vector<Opening>& scenes, Opening scene, const std::string& name, const std::string& who);

// document_scenes(): reads the scenes that a document names. openings: path, hash and length of each scene. read:
// content of each scene. Throws config::Error if a scene does not fit the rules and robots of one of `setups`.
struct DocumentScenes {
  std::vector<Opening> openings;
  std::vector<config::Opening> read;
};
DocumentScenes document_scenes(const std::vector<config::NamedPath>& paths, std::span<match::Setup> setups);

// The path relative to the working folder if the file is inside that folder, else the absolute path.
std::string from_here(const std::string& absolute);

// The paths of all metrics that a match of this team will have.
std::vector<std::string> metric_paths_of(const mind::TeamPlan& team);

}  // namespace regista::study
