// SPDX-License-Identifier: MIT
// Glue between the algorithm and Regista: what it is called, what can be set, which call it answers.
#include <regista/sender.hpp>

#include "algorithm.hpp"

namespace {

// Events that the others had better know of; all that there are stand in <regista/abi.h>.
constexpr bool is_news(int event) {
  return event == REGISTA_EVENT_BALL_KNOWN_AGAIN || event == REGISTA_EVENT_BALL_MOVED || event == REGISTA_EVENT_FELL;
}

struct Plugin {
  static constexpr auto id = "@NAME@", version = "0.1.0", summary = "A packet on news, else after a while";
  // Of a frame it reads nothing but what every plugin is shown; see REGISTA_READS_* in <regista/abi.h>.
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  Thrift thrift;
  int reserve = 30;
  static constexpr std::tuple parameters{
      regista::within(&Plugin::thrift,
                      regista::real("period", &Thrift::period, {0.5, 120.0}, "s",
                                    "Time between two packets of a robot that has no news")
                          .tunable(),
                      regista::real("after_news", &Thrift::after_news, {0.1, 60.0}, "s",
                                    "Least time between two packets of a robot")
                          .tunable()),
      regista::integer("reserve", &Plugin::reserve, {0, 1000}, "1",
                       "Packets of the team that are never spent: the count of them comes late")};

  std::optional<int> decide(const regista::Frame&, const regista::SendQuery& query, regista::Grants out) {
    const regista::Budget& budget = query.budget;
    int reason = REGISTA_EVENT_PERIOD;
    for (const regista::Event& event : query.events) {
      if (is_news(event.kind)) reason = event.kind;
    }
    const int kept = regista::in_this_game(reserve, budget);
    const bool news = reason != REGISTA_EVENT_PERIOD;
    if (!due(thrift, budget.since_own, news, budget.packets_left - kept, budget.line - kept)) return std::nullopt;
    // What other plugins want to send goes along as far as it fits.
    for (const regista::Offer& offer : query.offers) out.grant(offer);
    return reason;
  }
};

}  // namespace

REGISTA_PLUGIN(Plugin, regista::sender)
