// SPDX-License-Identifier: MIT
#include "report/few_uneven.hpp"

#include <fmt/format.h>

#include <numeric>

#include "statistics/rating.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

struct Words {
  const char *one, *more;
};

Words words_of(const statistics::ScoreLaw& law) {
  return law.unit == statistics::Unit::pair ? Words{"pair", "pairs"} : Words{"game", "games"};
}

std::uint64_t units_of(const statistics::ScoreLaw& law) {
  return static_cast<std::uint64_t>(std::accumulate(law.seen.begin(), law.seen.end(), statistics::Count{0}));
}

// "The only game was", "All 30 pairs were"
std::string all_of(const statistics::ScoreLaw& law) {
  const auto [one, more] = words_of(law);
  const std::uint64_t units = units_of(law);
  return units == 1 ? fmt::format("The only {} was", one) : fmt::format("All {} {} were", units, more);
}

}  // namespace

std::string why_no_interval(const statistics::ScoreLaw& law) {
  switch (statistics::few_for_spread(law)) {
    case statistics::FewForSpread::no:
      return "";
    case statistics::FewForSpread::won:
      return fmt::format("One team won every {}, so nElo has no interval.", words_of(law).one);
    case statistics::FewForSpread::uneven:
      break;
  }
  if (law.uneven() == 0) return all_of(law) + " even, so there is no interval.";
  return fmt::format("Fewer than {} {} were uneven, so nElo has no interval.", statistics::fewest_uneven,
                     words_of(law).more);
}

std::string what_the_test_rests_on(const statistics::ScoreLaw& law) {
  if (law.uneven() == 0) return all_of(law) + " even: the test takes this for equal strength.";
  if (law.uneven() >= statistics::fewest_uneven) return "";
  return fmt::format("The test rests on {} of {} that {} uneven.", law.uneven(),
                     texts::counted(units_of(law), words_of(law).one, words_of(law).more),
                     law.uneven() == 1 ? "was" : "were");
}

std::string no_margin_of_team() {
  return fmt::format("No margin: fewer than {} pairs of the team were uneven, or it won or lost all.",
                     statistics::fewest_uneven);
}

}  // namespace regista::report
