// SPDX-License-Identifier: MIT
// The parts of the page of a tournament, each empty where there is nothing to show.
#pragma once

#include <string_view>

#include "report/html.hpp"
#include "report/html_table.hpp"
#include "report/tournament_page.hpp"

namespace regista::report {

Html standing_section(const PageSource& source);       // who stands where
Html curves_section(const PageSource& source);         // Elo and test over pairs
Html goals_section(const PageSource& source);          // goal differences
Html roles_section(const PageSource& source);          // overlap, uncovered, switches
Html packets_section(const PageSource& source);        // packets by event
Html plugins_section(const PageSource& source);        // numbers that plugins report
Html variance_section(const PageSource& source);       // what pairing gained
Html failures_section(const PageSource& source);       // forfeits and how to play them again
Html recordings_section(const PageSource& source);     // matches to look at
Html configuration_section(const PageSource& source);  // where the teams differ

// What they share.
Html team_name(const PageSource& source, std::size_t team);
// Empty where there is no such figure.
inline Html figure(const PageSource& source, std::string_view name) { return figure(source.figures, name); }

}  // namespace regista::report
