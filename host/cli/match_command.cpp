// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "campaign/blame.hpp"
#include "campaign/forked_match.hpp"
#include "campaign/match_setup.hpp"
#include "cli/common_options.hpp"
#include "config/scalar.hpp"
#include "mcap/file_io.hpp"
#include "output/output_files.hpp"
#include "output/replaced_file.hpp"
#include "plugin/fatal_signal.hpp"
#include "plugin/shared_object.hpp"
#include "process/file_descriptor.hpp"
#include "recording/moment_svg.hpp"
#include "recording/recorded_match.hpp"
#include "report/what_was_played.hpp"
#include "results/played_match.hpp"
#include "results/replay.hpp"
#include "results/results_file.hpp"
#include "study/study.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

// --- `regista match`: plays one match.

constexpr auto match_examples = R"(Examples:
  regista match configs/teams/paper.yaml configs/teams/fixed_rate.yaml
  regista match a.yaml b.yaml --seed 7 --json
  regista match a.yaml a.yaml --set a.utility.terms.distance.weight=0.5
  regista match a.yaml b.yaml --limit 60 --decisions decisions.jsonl
  regista match a.yaml b.yaml --record match.mcap
  regista match a.yaml b.yaml --metrics numbers.csv
  regista match a.yaml b.yaml --log debug
  regista match a.yaml b.yaml --opening configs/openings/counter_three_on_two.yaml
  regista match --from tournament.db --row 12

--from plays a match of a tournament or an experiment again: the same teams, plugins, profiles and seed, or it says what has changed; and
compares the hashes; one that was forfeited, or could not be played, is played under the limits of that study. Rows are those of
`regista report --csv`.
A path of --set begins with a (the first team, at home), b (the second), rules, robot, disturbance (of both teams),
a_disturbance, b_disturbance or opening; without one of these it goes to both teams.)";

const std::vector<std::string> log_levels{"debug", "info", "warning", "error", "none"};

// Returns the stored match that --from and --row name; nullopt without --from.
std::optional<results::StoredMatch> stored_match_of(const results::MatchOptions& options,
                                                    const Invocation& invocation) {
  if (options.from.empty()) {
    if (!options.row.empty())
      throw BadInput(fmt::format("--row {}: belongs to --from, which is not given", options.row));
    return std::nullopt;
  }
  if (options.row.empty()) throw BadInput("--from: which match? Say --row N; `regista report --csv` lists them");
  const results::MatchOptions unset;
  const bool more = !options.teams.empty() || !options.rules.empty() || !options.robot.empty() ||
                    !options.disturbance.empty() || !options.home_disturbance.empty() ||
                    !options.away_disturbance.empty() || !options.set.empty() || !options.opening.empty() ||
                    !options.limit.empty() || !options.plugins.empty() || options.seed != unset.seed;
  if (more) throw BadInput("--from: the file says what is played; teams and options that change it cannot be given");
  return results::read_stored_match(options.from, options.row, invocation.studies);
}

// Refuses outputs that would overwrite inputs. outputs: made before stored_match_of() changes the working folder,
// because output paths are relative to the earlier folder.
void check_what_is_written(output::OutputFiles outputs, const results::MatchOptions& options,
                           const campaign::Job& played, const plugin::Catalogue& catalogue) {
  std::vector<std::string> documents(played.teams.begin(), played.teams.end());
  documents.insert(documents.end(), {played.rules, played.robot, played.disturbance, played.home_disturbance,
                                     played.away_disturbance, played.opening});
  outputs.read(documents, Reads::documents, played.overrides);
  outputs.read(folders_of(catalogue), Reads::plugins);
  outputs.check(options.force);
}

// Describes a failure: "plugin greedy of away (b.yaml), robot 3, tick 41: assign: Segmentation fault"
std::string failure_text(const campaign::Job& job, const campaign::Failure& failure) {
  const std::string team =
      fmt::format("{} ({})", failure.side == 0 ? "home" : "away", job.teams[failure.side == 0 ? 0 : 1]);
  if (failure.plugin.empty()) return fmt::format("a plugin of {}: {}", team, failure.what);
  return fmt::format("plugin {} of {}, robot {}, tick {}: {}: {}", failure.plugin, team, failure.robot, failure.tick,
                     failure.call, failure.what);
}

constexpr auto not_alone = "played with each team in a process of its own it did not, so no team is to blame";

campaign::Limits limits_of(const results::MatchOptions& options) {
  campaign::Limits out;
  out.processor_seconds =
      static_cast<int>(config::parse_whole("--processor-seconds", options.processor_seconds, 1, 1'000'000));
  out.wall_seconds = static_cast<double>(config::parse_whole("--wall-seconds", options.wall_seconds, 1, 1'000'000));
  return out;
}

// Finds the guilty team after a crash or a broken promise in a process that both teams share. loss: this event, with
// the suspected team. Repeats the match with one process per team, as a study does. Throws BadInput with the name of
// the team that fails again; returns if no team fails.
void blame(campaign::Job job, campaign::Limits limits, const campaign::ChildDeath& loss) {
  limits.isolation = campaign::Isolation::always;
  job.record.clear();
  try {
    const campaign::MatchResult again = campaign::play_alone(job, limits);
    if (!again.failure) return;
    const campaign::Failure& failure = *again.failure;
    const plugin::CallNote& call = loss.note.call;
    const bool as_said = failure.side == call.side && failure.robot == call.robot && failure.tick == call.tick &&
                         loss.what.ends_with(fmt::format("{}: {}", failure.call, failure.what));
    throw BadInput(as_said ? loss.what : failure_text(job, failure));
  } catch (const campaign::CampaignError& error) {
    throw BadInput(error.what());
  }
}

// The files of the teams' plugins, to find out later whether they have changed.
using Files = std::vector<std::shared_ptr<plugin::PluginFile>>;

Files files_of(const campaign::MatchSetup& prepared) {
  Files out;
  for (const auto& plan : prepared.plans) {
    for (const mind::Part* part : plan->parts()) texts::add_once(out, part->found->object);
  }
  return out;
}

// Reports why the process of the match died. Returns the exit code, or throws BadInput.
int explain_loss(const results::MatchOptions& options, campaign::Job job, const campaign::Limits& limits,
                 const Files& files, const campaign::ChildDeath& loss) {
  for (const std::string& written : {options.record, options.decisions}) {
    std::error_code none;
    if (!written.empty() && std::filesystem::exists(written, none))
      complain(fmt::format("{} holds the match as far as it came", written));
  }
  for (const auto& file : files) {
    if (file->has_changed()) {
      throw BadInput(
          fmt::format("{}: was overwritten while the match was played ({})", file->file().string(), loss.what));
    }
  }
  const std::string died = campaign::in_words(loss.what, loss.note.call);
  blame(std::move(job), limits, loss);
  // A signal from outside comes from a person or the system. Any other end of the process comes from a plugin.
  if (loss.from_outside) {
    complain(fmt::format("the match was ended: {}", died));
    return exit_no;
  }
  throw BadInput(fmt::format("the match died: {}; {}", died, not_alone));
}

int play(results::MatchOptions options, const output::OutputFiles& outputs, const Invocation& invocation) {
  // Output paths become absolute, because stored_match_of() changes the working folder.
  for (std::string* written : {&options.decisions, &options.record, &options.metrics}) {
    if (!options.from.empty() && !written->empty()) *written = std::filesystem::absolute(*written).string();
  }
  if (std::ranges::find(log_levels, options.log) == log_levels.end()) {
    throw BadInput(texts::unknown("value", options.log, "--log", log_levels));
  }
  campaign::refuse_unknown_sides(config::typed_overrides(options.set));
  if (options.force && options.record.empty()) throw BadInput("--force: belongs to --record, which is not given");
  const std::optional<results::StoredMatch> stored = stored_match_of(options, invocation);
  if (!stored && options.teams.size() != 2) {
    throw BadInput(
        fmt::format("match: expected two files of teams, {} given; see: regista match --help", options.teams.size()));
  }
  std::vector<std::string> folders = stored ? stored->job.plugins : options.plugins;
  // Folders become absolute, because the program reads the documents of a stored match in another folder.
  for (std::string& each : folders) each = stored ? std::filesystem::absolute(each).string() : each;
  const plugin::Catalogue catalogue =
      stored ? results::open_stored_plugins(options.from, folders, invocation) : open_plugins(folders, invocation);
  std::unique_ptr<campaign::StoredSetup> as_then;
  if (stored) {
    as_then = set_up(*stored, catalogue, invocation.arguments.front());
    if (!as_then->changed().empty() && !options.quiet) {
      complain(fmt::format("row {}: its files have changed ({}); played as {} holds them", options.row,
                           as_then->changed(), options.from));
    }
  }
  campaign::Job job = as_then ? as_then->job() : job_of(options);
  campaign::MatchSetup prepared = as_then ? as_then->take() : campaign::match_setup(job, catalogue);
  tell_what_is_not_used(catalogue, folders);
  // A user who replays a stored match does not need these warnings.
  if (!stored) {
    for (const config::Warning& each : prepared.warnings) complain(to_string(each));
  }
  check_what_is_written(outputs, options, job, catalogue);
  const bool failed = stored && (stored->decided.failure || stored->decided.set_aside());
  if (failed && !options.in_process) {
    if (!options.metrics.empty()) {
      throw BadInput(fmt::format("--metrics: row {} {}, so it has none", options.row,
                                 stored->decided.failure ? "was forfeited" : "could not be played"));
    }
    return results::play_failed(options, *stored, std::move(job));
  }
  job.plugin_files = catalogue.used_files();
  const Files files = files_of(prepared);
  const report::WhatWasPlayed what = results::what_is_played(job, prepared, catalogue);
  if (failed && !options.quiet) {
    complain(texts::one_line(fmt::format("row {} {}; it is played in this process now, without limits", options.row,
                                         results::end_in_words(stored->decided))));
  }
  const auto work = [&](campaign::WorkerNote& note) {
    // A failed match has no hash, so the program does not compare the replay with the stored match.
    const std::optional<results::StoredMatch> none;
    return results::play_prepared(options, invocation.arguments, failed ? none : stored, what, std::move(prepared),
                                  note);
  };
  if (options.in_process) {
    campaign::WorkerNote note;
    try {
      return work(note);
    } catch (const campaign::LeftoverState& disorder) {
      throw BadInput(disorder.what());
    }
  }
  const campaign::Limits limits = limits_of(options);
  const auto explained = [&](campaign::WorkerNote& note) {
    try {
      return work(note);
    } catch (const campaign::LeftoverState&) {
      throw;  // the supervising process reports this exception
    } catch (const plugin::Failure& failure) {
      // Destructors of plugin objects ran after the failure and overwrote the note. So write the caller again.
      if (const auto& caller = failure.caller()) {
        note.call.side = caller->tracing.side;
        note.call.robot = caller->robot;
        note.call.tick = caller->tick;
      }
      throw campaign::LeftoverState(failure.what());  // the other team's plugin may have caused the failure
    } catch (const std::bad_alloc&) {
      throw;
    } catch (...) {
      return explain_current_exception();
    }
  };
  const auto interrupted = [](int signal_number, bool has_spoken) {
    if (!has_spoken) complain("interrupted");
    return exit_by_signal(signal_number);
  };
  return campaign::run_supervised(
      limits,
      {explained, [&](const campaign::ChildDeath& loss) { return explain_loss(options, job, limits, files, loss); },
       interrupted});
}

// --- `regista view`: shows a recorded match or a study's match as an HTML page, or one moment of a match as a picture.

constexpr auto view_examples = R"(Examples:
  regista match a.yaml b.yaml --record match.mcap
  regista view match.mcap
  regista view tournament.db --row 17
  regista view match.mcap -o page.html --force
  regista view match.mcap --at 7:42 -o frame.svg
  regista view match.mcap --at 462.3 --robot away/5 -o frame.svg
  regista view match.mcap --at 2/3:10 --robot 3 -o frame.svg
  regista view match.mcap --at 7:42 --robot 3 --layer trail -o trail.svg

The page needs nothing but a browser. --row shows a match of a study: it uses the recording of that match, or plays it
again, and writes the page NAME.replays/ROW.html beside the results NAME.db. --at 7:42, or 462 (seconds), is the time since the match began, as under the field
of the page; 1/6:51 would be the clock of the first half, 2/3:10 that of the second. --robot 3 is the home team's; its picture
shows the world as the robot believed it, its tasks, the utilities it chose by, and what its plugins drew and logged.
--layer trail, or --layer "my_walk: trail" (plugin and layer), leaves out all other drawings. Plugins draw layers for
those who write them; the shipped ones draw none.)";

struct ViewOptions {
  std::string file, output, at, robot, row;
  std::vector<std::string> layers;
  bool force = false;
};

// Writes the HTML page of one match of a study.
int view_row(const ViewOptions& options, output::OutputFiles outputs, const Invocation& invocation) {
  if (!options.at.empty() || !options.robot.empty() || !options.layers.empty())
    throw BadInput("view: --row writes the page of a match; --at, --robot and --layer belong to a recording");
  if (options.output == "-") throw BadInput("view: --row writes a file; -o - belongs to a recording");
  constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
  const std::uint64_t row = config::parse_whole("--row", options.row, 1, most);
  const campaign::Store store = results::read_results(options.file);
  const std::filesystem::path page = options.output.empty()
                                         ? study::replay_file(options.file, static_cast<std::int64_t>(row))
                                         : std::filesystem::path(options.output);
  if (!options.output.empty()) outputs.write("-o", page, Writes::page);
  outputs.read({options.file}, Reads::results);
  outputs.read({results::viewer_file(invocation).string()}, Reads::data);
  outputs.check(options.force);
  const report::ListedMatch match = results::listed_match({options.file, store, invocation.studies}, row);
  const results::Replay shown = results::replay(options.file, match, results::Recorded::used, page, invocation);
  if (!shown.remark.empty()) complain(shown.remark);
  complain(shown.words);
  output::print(shown.page.string() + '\n');
  return shown.same ? exit_done : exit_no;
}

int run(const ViewOptions& options, output::OutputFiles outputs, const Invocation& invocation) {
  if (options.file.empty()) {
    throw BadInput("view: which recording? Name a file that `regista match --record FILE` wrote");
  }
  if (!options.row.empty()) return view_row(options, std::move(outputs), invocation);
  std::error_code none;
  if (std::filesystem::is_regular_file(options.file, none) && output::is_database(options.file))
    throw BadInput(fmt::format("view: {} holds many matches; which one? Say --row N", options.file));
  if (options.at.empty() && !options.robot.empty()) {
    throw BadInput("view: --robot belongs to --at, which is not given; the page shows all robots");
  }
  if (!options.layers.empty() && options.robot.empty()) {
    throw BadInput(options.at.empty()
                       ? "view: --layer belongs to --at and --robot, which are not given"
                       : "view: --layer belongs to --robot, which is not given; a robot's plugins draw layers");
  }
  std::filesystem::path output = options.output;
  if (output.empty())
    output = std::filesystem::path(options.file).replace_extension(options.at.empty() ? ".html" : ".svg");
  outputs.write("-o", output, Writes::page);
  outputs.read({results::viewer_file(invocation).string()}, Reads::data);
  try {
    const bool picture = !options.at.empty();
    const recording::Moment wanted = picture ? recording::parse_moment(options.at) : recording::Moment{};
    if (!picture) results::require_small_enough(options.file);
    const recording::RecordedMatch match(options.file);
    outputs.check(options.force);
    if (!match.damage().empty()) complain(match.damage());
    std::string written;
    if (picture) {
      std::optional<recording::RobotName> robot;
      if (!options.robot.empty()) robot = recording::parse_robot(options.robot, match.team_size());
      recording::RecordedMoment moment = match.at(recording::time_of(match, wanted), robot);
      recording::keep_layers(moment.drawings, options.layers);
      written = recording::moment_svg(match, moment, robot);
    } else {
      const std::filesystem::path file = options.file;
      std::optional<process::TemporaryFolder> folder;
      if (!match.fits_page()) match.write_for_page(folder.emplace().path() / "copy.mcap");
      written =
          results::viewer_page(folder ? folder->path() / "copy.mcap" : file, file.filename().string(), {}, invocation);
    }
    if (output == "-") {
      output::print(written);
      return exit_done;
    }
    output::write_whole(output, written, options.force ? output::Existing::replaced : output::Existing::refused);
    output::print(output.string() + '\n');
  } catch (const mcap::Error& error) {
    throw BadInput(error.what());
  }
  return exit_done;
}

}  // namespace

void add_match(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("match", "play one match between two teams");
  const auto options = std::make_shared<results::MatchOptions>();
  command.take("teams", options->teams, "A.yaml B.yaml", "the teams' files: home, then away", Reads::documents);
  command.take("--seed", options->seed, "N", "all chance of the match comes from it; default 1");
  command.take("--rules", options->rules, "FILE", "rules profile; default: spl2023, built in", Reads::documents);
  command.take("--robot", options->robot, "FILE", "robot profile of both teams; default: nao, built in",
               Reads::documents);
  command.take("--disturbance", options->disturbance, "FILE", "disturbance profile of both teams; default: none",
               Reads::documents);
  command.take("--home-disturbance", options->home_disturbance, "FILE", "of the home team alone", Reads::documents);
  command.take("--away-disturbance", options->away_disturbance, "FILE", "of the away team alone", Reads::documents);
  command.take("--opening", options->opening, "FILE", "scene that the game starts from; default: kick-off",
               Reads::documents);
  command.take("--set", options->set, "PATH=VALUE", "a value laid over a document; may be repeated");
  command.take("--limit", options->limit, "SECONDS", "end the match after so many simulated seconds");
  command.take("--from", options->from, "RESULTS.db", "play a match of these results again", Reads::results);
  command.take("--row", options->row, "N", "which one, from 1");
  add_plugin_folders(command, options->plugins);
  command.flag("--json", options->json, "write the result as JSON");
  command.take("--decisions", options->decisions, "FILE", "write what the robots believed and chose as JSON lines",
               Writes::decisions);
  command.take("--record", options->record, "FILE", "write the match as an MCAP file, for `regista view` and others",
               Writes::recording);
  command.take("--metrics", options->metrics, "FILE", "write all numbers of the match as a table (CSV)",
               Writes::metrics);
  command.flag("--force", options->force, "let --record replace a recording");
  command.flag("--quiet", options->quiet, "no live line on the terminal");
  command.choose("--log", options->log, log_levels, "show lines of plugins from this level on; default info");
  command.take("--processor-seconds", options->processor_seconds, "SECONDS",
               "processor time of one call of a plugin; default 10");
  command.take("--wall-seconds", options->wall_seconds, "SECONDS", "wall time of one call of a plugin; default 200");
  command.flag("--in-process", options->in_process,
               "play in the program's own process, for a debugger: what ends it is not explained");
  command.flag("--verbose", options->verbose, "a line on standard error for each goal");
  command.notes(match_examples, "0 played; 1 the result could not be written, or is not that of --from",
                command::interruptible);
  command.run = [options, &command, &invocation] { return play(*options, command.outputs("match"), invocation); };
}

void add_view(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("view", "see a recorded match");
  const auto options = std::make_shared<ViewOptions>();
  command.take("recording", options->file, "FILE", "recording of a match, or with --row the results of a study",
               Reads::data);
  command.take("--row", options->row, "N", "of results: the page of this match, from 1");
  command.take("-o,--output", options->output, "FILE",
               "write this file, - for standard output; default: beside the recording, as .html or .svg", Writes::page);
  command.take("--at", options->at, "[HALF/]M:SS", "a picture of this moment instead of the page");
  command.take("--robot", options->robot, "[home/|away/]N", "of --at: the world as this robot believed it");
  command.take("--layer", options->layers, "NAME",
               "of --robot: of what its plugins drew only this layer; may be repeated");
  command.flag("--force", options->force, "replace an existing file");
  command.notes(view_examples, "0 done; 1 the page could not be written, or the match of --row came out otherwise",
                command::interruptible);
  command.run = [options, &command, &invocation] { return run(*options, command.outputs("view"), invocation); };
}

}  // namespace regista::cli
