// SPDX-License-Identifier: MIT
// Teams that are read once for many matches: their plugins opened, their pages read, their inputs counted up. No code
// of a plugin runs for that but what a shared object runs when it is loaded, and the functions by which it declares its
// plugins.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "campaign/input.hpp"
#include "campaign/job.hpp"
#include "campaign/match_setup.hpp"
#include "plugin/catalogue.hpp"
#include "plugin/plugin_file.hpp"

namespace regista::campaign {

// A file is not what it was when it was read: everything must be read anew, by another process.
class Stale : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A plugin has changed, when it was loaded, what belongs to the whole process: nobody else's match may be played in it.
class Unfit : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

class PreparedTeams {
 public:
  struct Match {
    MatchSetup setup;         // must not outlive this object, which has the plugins
    std::string changed;      // as what_changed() of job_setup.hpp
    std::string_view output;  // what plugins wrote to standard error when they were loaded
  };

  // Precondition: the job names its plugin files. Throws Stale, Unfit, config::Error, config::BadInput, and
  // std::runtime_error also for a team that pins the file of a plugin: another version of a plugin may share variables
  // with the one that is loaded already.
  Match prepare(const Job& job);

 private:
  using Files = std::vector<std::pair<std::filesystem::path, plugin::FileStamp>>;  // before they were read
  struct Plugins {
    plugin::Catalogue catalogue;
    Files files;
    std::string output;
  };
  struct Team {
    TeamSetup setup;
    std::vector<Input> inputs;
    Files files;
  };
  const Plugins& plugins_of(const Job& job);
  const Team& team_of(const std::string& key, const std::string& file, const config::Overrides& overrides,
                      const config::Rules& rules, const config::Robot& robot, const plugin::Catalogue& catalogue,
                      const std::string& root);

  std::map<std::string, std::unique_ptr<Plugins>> plugins_;  // by their files; plans need them
  std::map<std::string, Team> teams_;                        // by all that a plan is a function of
};

}  // namespace regista::campaign
