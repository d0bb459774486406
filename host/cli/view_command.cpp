// SPDX-License-Identifier: MIT
// `regista view`: a recorded match as a page that plays it back, or one moment of it as a picture.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "cli/commands.hpp"
#include "config/file.hpp"
#include "mcap/error.hpp"
#include "output/output.hpp"
#include "output/output_files.hpp"
#include "output/replaced_file.hpp"
#include "recording/match_page.hpp"
#include "recording/moment_svg.hpp"
#include "recording/recorded_match.hpp"
#include "recording/typed_moment.hpp"

namespace regista::cli {
namespace {

constexpr auto view_examples = R"(Examples:
  regista match a.yaml b.yaml --record match.mcap
  regista view match.mcap
  regista view match.mcap -o page.html --force
  regista view match.mcap --at 7:42 -o frame.svg
  regista view match.mcap --at 462.3 --robot away/5 -o frame.svg
  regista view match.mcap --at 2/3:10 --robot 3 -o frame.svg
  regista view match.mcap --at 7:42 --robot 3 --layer cells -o cells.svg

The page needs nothing but a browser. --at 7:42, or 462 (seconds), is the time since the match began, as under the field
of the page; 1/6:55 is the clock of the first half, 2/3:10 that of the second. --robot 3 is the home team's; its picture
shows the world as the robot believed it, its tasks, the utilities it chose by, and what its plugins drew and logged.
--layer cells, or --layer "voronoi: cells" (plugin and layer), leaves out all other drawings.

Exit codes: 0 done; 1 the page could not be written; 2 bad input; 3 a defect of Regista.)";

struct ViewOptions {
  std::string file, output, at, robot;
  std::vector<std::string> layers;
  bool force = false;
};

std::string required_content(const std::filesystem::path& file) {
  std::optional<std::string> out = config::file_content(file);
  if (!out) throw BadInput(fmt::format("{}: cannot be read", file.string()));
  return std::move(*out);
}

void refuse_what_no_browser_opens(const std::string& file) {
  std::error_code none;
  const std::uintmax_t size = std::filesystem::file_size(file, none);
  if (none || size <= recording::largest_recording_in_a_page) return;  // what else is wrong is found when it is read
  throw BadInput(
      fmt::format("{}: holds {} MiB; no browser opens a page with more than {} MiB; `regista view --at` and "
                  "other readers of MCAP can read it",
                  file, size >> 20, recording::largest_recording_in_a_page >> 20));
}

constexpr auto viewer_page = "share/regista/viewer.html";

std::string page(const ViewOptions& options, const Invocation& invocation) {
  const std::filesystem::path viewer = invocation.own(viewer_page);
  std::error_code none;
  if (!std::filesystem::exists(viewer, none)) {
    throw BadInput(
        fmt::format("view: this build has no viewer page ({} is missing): it is made where Node.js is installed and "
                    "`npm ci` was run in viewer/; `regista view --at` and other readers of MCAP work without it",
                    viewer.string()));
  }
  const std::string name = std::filesystem::path(options.file).filename().string();
  const auto out = recording::match_page(required_content(viewer), required_content(options.file), name);
  if (!out) throw BadInput(fmt::format("view: {} belongs to another version of Regista", viewer.string()));
  return *out;
}

std::filesystem::path output_of(const ViewOptions& options) {
  if (!options.output.empty()) return options.output;
  return std::filesystem::path(options.file).replace_extension(options.at.empty() ? ".html" : ".svg");
}

int run(const ViewOptions& options, output::OutputFiles outputs, const Invocation& invocation) {
  if (options.file.empty()) {
    throw BadInput("view: which recording? Name a file that `regista match --record FILE` wrote");
  }
  if (options.at.empty() && !options.robot.empty()) {
    throw BadInput("view: --robot belongs to --at, which is not given; the page shows all robots");
  }
  if (!options.layers.empty() && options.robot.empty()) {
    throw BadInput(options.at.empty()
                       ? "view: --layer belongs to --at and --robot, which are not given"
                       : "view: --layer belongs to --robot, which is not given; a robot's plugins draw layers");
  }
  const std::filesystem::path output = output_of(options);
  outputs.write("-o", output, Writes::page);
  outputs.read({invocation.own(viewer_page).string()}, Reads::data);
  try {
    const bool picture = !options.at.empty();
    const recording::Moment wanted = picture ? recording::parse_moment(options.at) : recording::Moment{};
    if (!picture) refuse_what_no_browser_opens(options.file);
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
      written = page(options, invocation);
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

void add_view(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("view", "see a recorded match");
  const auto options = std::make_shared<ViewOptions>();
  command.take("recording", options->file, "FILE.mcap", "file that `regista match --record` wrote", Reads::data);
  command.take("-o,--output", options->output, "FILE",
               "write this file, - for standard output; default: beside the recording, as .html or .svg", Writes::page);
  command.take("--at", options->at, "[HALF/]M:SS", "a picture of this moment instead of the page");
  command.take("--robot", options->robot, "[home/|away/]N", "of --at: the world as this robot believed it");
  command.take("--layer", options->layers, "NAME",
               "of --robot: of what its plugins drew only this layer; may be repeated");
  command.flag("--force", options->force, "replace an existing file");
  command.notes(view_examples);
  command.run = [options, &command, &invocation] {
    return run(*options, output::OutputFiles(command.given(), "view"), invocation);
  };
}

}  // namespace regista::cli
