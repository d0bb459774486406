// SPDX-License-Identifier: MIT
#include "campaign/job_setup.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "campaign/inputs.hpp"
#include "process/program.hpp"
#include "texts/message.hpp"

namespace regista::campaign {

MatchRequest request_of(const Job& job) {
  MatchRequest request;
  request.teams.assign(job.teams.begin(), job.teams.end());
  request.rules = job.rules;
  request.robot = job.robot;
  request.disturbance = job.disturbance;
  request.home_disturbance = job.home_disturbance;
  request.away_disturbance = job.away_disturbance;
  request.overrides = config::typed_overrides(job.overrides);
  request.seed = std::to_string(job.seed);
  request.opening = job.opening;
  request.limit = job.limit;
  return request;
}

Job job_of(const MatchRequest& request, const std::vector<std::string>& plugins) {
  Job job;
  job.teams = {request.teams.at(0), request.teams.at(1)};
  job.rules = request.rules;
  job.robot = request.robot;
  job.disturbance = request.disturbance;
  job.home_disturbance = request.home_disturbance;
  job.away_disturbance = request.away_disturbance;
  for (const config::Override& each : request.overrides) job.overrides.push_back(to_string(each));
  job.plugins = plugins;
  job.opening = request.opening;
  job.limit = request.limit;
  job.seed = parse_seed(request.seed, "--seed");
  return job;
}

std::string plain_command(const Job& job) {
  std::vector<std::string> words = match_arguments(job);
  words.insert(words.begin(), "regista");
  return process::shell_line(words);
}

std::string input_of(const Job& job, const std::string& name) {
  const auto found = std::ranges::find(job.common_inputs, name, &Input::name);
  return found == job.common_inputs.end() ? std::string() : found->hash;
}

FoundInputs inputs_of(const MatchSetup& prepared, const plugin::Catalogue& catalogue, const std::string& program,
                      const std::string& mathematics, const std::string& root) {
  return {team_inputs(*prepared.plans[0], *prepared.documents[0], catalogue, root),
          team_inputs(*prepared.plans[1], *prepared.documents[1], catalogue, root),
          common_inputs(prepared.setup, program, mathematics)};
}

std::string what_changed(const Job& job, const MatchSetup& prepared, const plugin::Catalogue& catalogue,
                         const std::string& program, const std::string& mathematics, const std::string& root) {
  if (job.common_inputs.empty()) return {};  // nobody has counted them up
  return what_changed(job, inputs_of(prepared, catalogue, program, mathematics, root));
}

std::string what_changed(const Job& job, const FoundInputs& now) {
  std::vector<std::string> changed;
  for (const auto& [before, found] :
       {std::pair{&job.home_inputs, &now.home}, {&job.away_inputs, &now.away}, {&job.common_inputs, &now.common}}) {
    for (std::string& each : differences(*before, *found)) {
      if (std::ranges::find(changed, each) == changed.end()) changed.push_back(std::move(each));
    }
  }
  return texts::join(changed);
}

}  // namespace regista::campaign
