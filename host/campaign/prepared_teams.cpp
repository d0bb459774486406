// SPDX-License-Identifier: MIT
#include "campaign/prepared_teams.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

#include "campaign/inputs.hpp"
#include "campaign/job_setup.hpp"
#include "config/named_files.hpp"
#include "config/profiles.hpp"
#include "config/show.hpp"
#include "plugin/process_state.hpp"
#include "process/descriptor.hpp"

namespace regista::campaign {
namespace {

// A plan takes some hundred kilobytes, which every copy of the process has in its tables of pages.
constexpr std::size_t most_teams = 64;

using Files = std::vector<std::pair<std::filesystem::path, plugin::FileStamp>>;

template <class Paths>
Files stamped(const Paths& paths) {
  Files out;
  for (const auto& path : paths) out.emplace_back(path, plugin::stamp_of(path));
  return out;
}

void demand_unchanged(const Files& files) {
  for (const auto& [path, stamp] : files) {
    if (plugin::stamp_of(path) != stamp) throw Stale(path.string());
  }
}

// While it lives, what is written to standard error is kept.
class KeptErrors {
 public:
  KeptErrors()
      : file_(memfd_create("regista-output", MFD_CLOEXEC)), before_(fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 10)) {
    dup2(file_.number, STDERR_FILENO);
  }
  ~KeptErrors() { dup2(before_.number, STDERR_FILENO); }
  KeptErrors(const KeptErrors&) = delete;
  KeptErrors& operator=(const KeptErrors&) = delete;

  // Its beginning.
  std::string text() const {
    std::string out(std::size_t{1} << 16, '\0');
    const ssize_t count = pread(file_.number, out.data(), out.size(), 0);
    out.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return out;
  }

 private:
  process::FileDescriptor file_, before_;
};

template <class Profile>
std::string shown(Profile profile) {
  return config::show(config::declare(profile), config::Node(), {}, config::Remarks::without);
}

}  // namespace

const PreparedTeams::Plugins& PreparedTeams::plugins_of(const Job& job) {
  auto& opened = plugins_[fmt::format("{}", fmt::join(job.plugin_files, "\n"))];
  if (opened) {
    demand_unchanged(opened->files);
    return *opened;
  }
  Files files = stamped(job.plugin_files);
  const KeptErrors errors;
  const plugin::ProcessState before = plugin::ProcessState::now();
  const pid_t here = getpid();
  const std::vector<std::filesystem::path> paths(job.plugin_files.begin(), job.plugin_files.end());
  plugin::Catalogue catalogue = plugin::Catalogue::of_files(paths, plugin::Catalogue::Looking::here);
  if (getpid() != here) _exit(EXIT_FAILURE);  // a plugin has doubled the process: one of the two is enough
  if (const std::string left = plugin::changes_since(before); !left.empty()) throw Unfit("a plugin " + left);
  if (!catalogue.refused().empty()) throw std::runtime_error(to_string(catalogue.refused().front()));
  opened.reset(new Plugins{std::move(catalogue), std::move(files), errors.text()});
  return *opened;
}

const PreparedTeams::Team& PreparedTeams::team_of(const std::string& key, const std::string& file,
                                                  const config::Overrides& overrides, const config::Rules& rules,
                                                  const config::Robot& robot, const plugin::Catalogue& catalogue,
                                                  const std::string& root) {
  if (const auto known = teams_.find(key); known != teams_.end()) {
    demand_unchanged(known->second.files);
    return known->second;
  }
  const std::array<std::filesystem::path, 1> document{file};
  const std::vector<std::filesystem::path> named = config::named_files(document, overrides);
  for (const std::filesystem::path& each : named) {
    if (each.extension() == ".so") throw std::runtime_error(each.string() + " is pinned");
  }
  Files files = stamped(named);
  TeamSetup setup = team_setup(file, overrides, rules, robot, catalogue);
  std::vector<Input> inputs = team_inputs(*setup.plan, *setup.document, catalogue, root);
  demand_unchanged(files);
  if (teams_.size() >= most_teams) teams_.clear();
  return teams_.emplace(key, Team{std::move(setup), std::move(inputs), std::move(files)}).first->second;
}

PreparedTeams::Match PreparedTeams::prepare(const Job& job) {
  const Plugins& plugins = plugins_of(job);
  std::vector<std::vector<Input>> inputs;  // home, away
  std::string shared;                      // what both plans are functions of
  Match out;
  out.output = plugins.output;
  out.setup = match_setup(request_of(job), [&](const std::string& file, const config::Overrides& overrides,
                                               const config::Rules& rules, const config::Robot& robot) {
    if (shared.empty())
      shared = fmt::format("{}\n{}\n{}\n{}", job.root, fmt::join(job.plugin_files, "\n"), shown(rules), shown(robot));
    std::string key = fmt::format("{}\n{}", shared, file);
    for (const config::Override& each : overrides) key += '\n' + to_string(each);
    const Team& team = team_of(key, file, overrides, rules, robot, plugins.catalogue, job.root);
    inputs.push_back(team.inputs);
    return team.setup;
  });
  if (job.common_inputs.empty()) return out;  // nobody has counted them up
  // Program and mathematics are the coordinator's own.
  out.changed = what_changed(
      job, {inputs.at(0), inputs.at(1),
            common_inputs(out.setup.setup, input_of(job, program_input), input_of(job, mathematics_input))});
  return out;
}

}  // namespace regista::campaign
