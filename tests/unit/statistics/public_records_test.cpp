// SPDX-License-Identifier: MIT
// Sequential tests of real engines, as they were published with their likelihood ratios rounded to hundredths.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "statistics/sequential_test.hpp"

namespace regista::statistics {
namespace {

using Row = std::map<std::string, std::string>;

std::vector<std::string> fields(const std::string& line) {
  std::vector<std::string> out(1);
  for (const char c : line) {
    if (c == ',') {
      out.emplace_back();
    } else if (c != '\r') {
      out.back() += c;
    }
  }
  return out;
}

TEST(PublicRecords, EveryRatioIsReproduced) {
  std::ifstream file(REGISTA_SHARED_DATA "/statistics/stockfish_sprt_public.csv");
  if (!file) GTEST_SKIP() << "no public records of tests here";
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> names = fields(line);
  std::map<std::string, int> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> values = fields(line);
    ASSERT_EQ(values.size(), names.size()) << line;
    Row row;
    for (std::size_t i = 0; i < names.size(); ++i) row[names[i]] = values[i];
    const std::string model = row.at("model");
    ++rows[model];
    if (model == "bayeselo_trinomial") continue;  // not offered
    const auto count = [&](const char* name) { return static_cast<Count>(std::stoll(row.at(name))); };
    const bool of_pairs = model.ends_with("_pentanomial");
    const ScoreLaw law =
        of_pairs ? score_law(PairCounts{{count("pt0"), count("pt1"), count("pt2"), count("pt3"), count("pt4")}})
                 : score_law(GameCounts{{count("losses"), count("draws"), count("wins")}});
    const Model kind = model.starts_with("normalized_") ? Model::normalized : Model::logistic;
    const auto ratio = log_likelihood_ratio(law, kind, {std::stod(row.at("elo0")), std::stod(row.at("elo1"))});
    EXPECT_EQ(ratio.method, Method::exact) << line;
    EXPECT_NEAR(ratio.value, std::stod(row.at("llr_published")), 0.015) << line;
  }
  EXPECT_EQ(rows["normalized_pentanomial"], 1840);
  EXPECT_EQ(rows["logistic_pentanomial"], 376);
  EXPECT_EQ(rows["logistic_trinomial"], 2);
  EXPECT_EQ(rows["bayeselo_trinomial"], 1135);
}

}  // namespace
}  // namespace regista::statistics
