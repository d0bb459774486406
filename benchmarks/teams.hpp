// SPDX-License-Identifier: MIT
// The two teams that the benchmarks of whole matches play with.
#pragma once

#include "config/documents.hpp"
#include "match/match.hpp"
#include "mind/team_plan.hpp"
#include "plugin/catalogue.hpp"

namespace regista {

struct Teams {
  plugin::Catalogue catalogue{{REGISTA_PLUGINS}};
  match::Setup setup;
  mind::TeamPlan paper{config::read_document<config::Team>(REGISTA_CONFIGS "/teams/paper.yaml"), setup.rules,
                       setup.robots[0], catalogue};
  mind::TeamPlan fixed_rate{config::read_document<config::Team>(REGISTA_CONFIGS "/teams/fixed_rate.yaml"), setup.rules,
                            setup.robots[1], catalogue};
};

}  // namespace regista
