// SPDX-License-Identifier: MIT
// The stubs as a shared object, for minds that are built from a team's page.
#include "stubs.hpp"

REGISTA_PLUGINS(regista::Plugin<stubs::Still, regista::predictor>, regista::Plugin<stubs::Lucky, regista::predictor>,
                regista::Plugin<stubs::Window, regista::context>, regista::Plugin<stubs::InSetPlay, regista::context>,
                regista::Plugin<stubs::Triangle, regista::positioner>,
                regista::Plugin<stubs::Nearness, regista::utility>, regista::Plugin<stubs::InOrder, regista::assigner>,
                regista::Plugin<stubs::Steady, regista::sender>, regista::Plugin<stubs::Gossip, regista::utility>,
                regista::Plugin<stubs::Even, regista::sender>, regista::Plugin<stubs::Flat, regista::utility>,
                regista::Plugin<stubs::LargestFirst, regista::assigner>,
                regista::Plugin<stubs::NearPoints, regista::utility>, regista::Plugin<stubs::Rumour, regista::context>,
                regista::Plugin<stubs::Walks, regista::behaviour>, regista::Plugin<stubs::Seeks, regista::behaviour>,
                regista::Plugin<stubs::Asker, regista::utility>)
