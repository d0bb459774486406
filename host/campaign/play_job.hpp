// SPDX-License-Identifier: MIT
// Plays one match of a campaign in its own process, so that plugins that damage this process harm no other match.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/match_setup.hpp"
#include "campaign/worker.hpp"
#include "plugin/catalogue.hpp"

namespace regista::campaign {

// Plays a match. program: "regista 0.1.0", for recordings. Throws config::BadInput, Fault, std::runtime_error and the
// exceptions of plugins.
Answer play_job(const Job& job, MatchSetup prepared, const std::string& program, WorkerNote& note);

// Returns what `play` returns. If `play` throws, returns an answer that describes the exception.
Answer answer_of(const std::function<Answer()>& play);

// Sends the answer to the coordinator. Returns false if no process reads the answer.
bool hand_over(const Answer& answer);

struct Surroundings {
  std::string program;  // "regista 0.1.0", for recordings
  // Opens the plugins of these folders and of the program's own folder, for a job that names no plugin files.
  std::function<plugin::Catalogue(const std::vector<std::string>& folders)> open_plugins;
};

// The main function of a worker (worker.hpp): reads a job from standard input, plays the match, and sends the answer.
// Returns false if no process reads the answer. Throws BadInput if no coordinator has started this process. Plugins may
// have registered exit handlers, so the caller must then end the process without exit handlers.
bool play_one(const Surroundings& surroundings);

}  // namespace regista::campaign
