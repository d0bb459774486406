// SPDX-License-Identifier: MIT
// Published instances: the OR-Library's assignment problems (Beasley 1990), tracking problems of py-lapsolver, the grid
// of lapjv, and small cases from the tests of other solvers. All minimise; the utilities are the costs, negated.
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

#include "algorithm.hpp"

namespace {

using hungarian::forbidden;

const std::filesystem::path folder = std::filesystem::path(REGISTA_SHARED_DATA) / "assignment";

std::string unpacked(const std::filesystem::path& file) {
  std::string text;
  gzFile in = gzopen(file.c_str(), "rb");
  if (in == nullptr) return text;
  std::vector<char> block(1 << 16);
  for (int got; (got = gzread(in, block.data(), static_cast<unsigned>(block.size()))) > 0;) {
    text.append(block.data(), static_cast<std::size_t>(got));
  }
  gzclose(in);
  return text;
}

struct Table {
  std::size_t rows = 0, columns = 0;
  std::vector<double> cost;  // NaN or infinity: forbidden
};

struct Answer {
  std::vector<std::int32_t> column_of;
  int pairs = 0;
  double total = 0.0;
};

Answer solve(const Table& table, bool maximise = false) {
  std::vector<double> utilities(table.cost.size());
  for (std::size_t k = 0; k < utilities.size(); ++k) {
    utilities[k] = std::isfinite(table.cost[k]) ? (maximise ? table.cost[k] : -table.cost[k]) : forbidden;
  }
  std::vector<std::uint32_t> order(table.columns);
  std::iota(order.begin(), order.end(), 0u);
  Answer answer;
  answer.column_of.resize(table.rows);
  hungarian::Solver solver;
  solver.assign({utilities.data(), table.rows, table.columns, table.columns}, order, answer.column_of);
  std::vector<bool> taken(table.columns, false);
  for (std::size_t i = 0; i < table.rows; ++i) {
    if (answer.column_of[i] < 0) continue;
    const auto j = static_cast<std::size_t>(answer.column_of[i]);
    EXPECT_FALSE(taken[j]);
    taken[j] = true;
    EXPECT_TRUE(std::isfinite(table.cost[i * table.columns + j]));
    answer.total += table.cost[i * table.columns + j];
    ++answer.pairs;
  }
  return answer;
}

Table transposed(const Table& table) {
  Table out{table.columns, table.rows, std::vector<double>(table.cost.size())};
  for (std::size_t i = 0; i < table.rows; ++i) {
    for (std::size_t j = 0; j < table.columns; ++j) out.cost[j * table.rows + i] = table.cost[i * table.columns + j];
  }
  return out;
}

Table read_csv(const std::string& text) {
  Table table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    ++table.rows;
    table.columns = 0;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      table.cost.push_back(std::stod(cell));
      ++table.columns;
    }
  }
  return table;
}

Table read_orlib(const std::string& text, bool sparse) {
  std::istringstream in(text);
  Table table;
  in >> table.rows;
  table.columns = table.rows;
  table.cost.assign(table.rows * table.rows, std::nan(""));
  if (sparse) {
    std::size_t i, j;
    for (double cost; in >> i >> j >> cost;) table.cost[(i - 1) * table.columns + j - 1] = cost;
  } else {
    for (double& cost : table.cost) in >> cost;
  }
  return table;
}

class Published : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no data in " << folder;
  }
};

TEST_F(Published, OrLibraryOptima) {
  std::ifstream optima(folder / "orlib" / "optima.csv");
  std::string line;
  std::getline(optima, line);
  int files = 0;
  while (std::getline(optima, line)) {
    std::istringstream cells(line);
    std::string file, format, n, optimum;
    std::getline(cells, file, ',');
    std::getline(cells, format, ',');
    std::getline(cells, n, ',');
    std::getline(cells, optimum, ',');
    const Table table = read_orlib(unpacked(folder / "orlib" / (file + ".gz")), format == "sparse");
    for (const Answer& answer : {solve(table), solve(transposed(table))}) {
      EXPECT_EQ(answer.pairs, std::stoi(n)) << file;
      EXPECT_EQ(answer.total, std::stod(optimum)) << file;
    }
    ++files;
  }
  EXPECT_EQ(files, 5);
}

TEST_F(Published, TrackingOptima) {
  std::ifstream optima(folder / "lapsolver" / "optima.csv");
  std::string line;
  std::getline(optima, line);
  int files = 0;
  while (std::getline(optima, line)) {
    std::istringstream cells(line);
    std::string file, n, optimum;
    std::getline(cells, file, ',');
    std::getline(cells, n, ',');
    std::getline(cells, optimum, ',');
    const Table table = read_csv(unpacked(folder / "lapsolver" / (file + ".gz")));
    for (const Answer& answer : {solve(table), solve(transposed(table))}) {
      EXPECT_EQ(answer.pairs, std::stoi(n)) << file;
      EXPECT_EQ(answer.total, std::stod(optimum)) << file;
    }
    ++files;
  }
  EXPECT_EQ(files, 6);
}

TEST_F(Published, GridHasOneOptimum) {
  const Answer answer = solve(read_csv(unpacked(folder / "grid100" / "cost100.csv.gz")));
  std::ifstream permutation(folder / "grid100" / "row_to_col.txt");
  std::vector<std::int32_t> expected;
  for (std::int32_t column; permutation >> column;) expected.push_back(column);
  ASSERT_EQ(expected.size(), 100u);
  EXPECT_EQ(answer.column_of, expected);
  EXPECT_NEAR(answer.total, 42609.9448418396, 1e-9);
}

double number(const nlohmann::json& cell) {
  if (cell.is_number()) return cell.get<double>();
  const std::string text = cell.get<std::string>();
  return text == "nan" ? std::nan("") : text == "-inf" ? -hungarian::infinity : hungarian::infinity;
}

Table read_table(const nlohmann::json& cost) {
  Table table;
  if (cost.is_object()) {
    table.rows = cost["shape"][0];
    table.columns = cost["shape"][1];
    return table;
  }
  table.rows = cost.size();
  table.columns = cost[0].size();
  for (const nlohmann::json& row : cost) {
    for (const nlohmann::json& cell : row) table.cost.push_back(number(cell));
  }
  return table;
}

// Every vector lands in one of the four kinds. Where it states an assignment, ours costs the same: there may be several
// of least cost.
TEST_F(Published, SmallVectors) {
  std::ifstream in(folder / "vectors.json");
  const nlohmann::json file = nlohmann::json::parse(in);
  int totals = 0, infeasible = 0, invalid = 0, limited = 0;
  for (const nlohmann::json& vector : file["vectors"]) {
    const std::string id = vector["id"];
    SCOPED_TRACE(id);
    Table table = read_table(vector["cost"]);
    const auto most = static_cast<int>(std::min(table.rows, table.columns));
    if (id == "lap_costlimit_3x3") {  // the limit of 4.99 per pair that its note states
      for (double& cost : table.cost) cost = cost > 4.99 ? std::nan("") : cost;
      const Answer answer = solve(table);
      EXPECT_EQ(answer.column_of, vector["expected_row_to_col"].get<std::vector<std::int32_t>>());
      EXPECT_EQ(answer.total, vector["expected_total"].get<double>());
      ++limited;
      continue;
    }
    const std::string error = vector["expected_error"].is_null() ? "" : vector["expected_error"].get<std::string>();
    for (const bool turned : {false, true}) {
      const Answer answer = solve(turned ? transposed(table) : table, vector["maximize"]);
      if (error.starts_with("infeasible")) {
        EXPECT_LT(answer.pairs, most);  // no complete assignment: as many pairs as there is room for
      } else if (error.starts_with("invalid")) {
        EXPECT_EQ(answer.pairs, most);  // others refuse the entry; here it is a forbidden pair, which leaves 0 in both
        EXPECT_EQ(answer.total, 0.0);
      } else {
        const nlohmann::json& total =
            vector["expected_total"].is_null() ? vector["computed_total"] : vector["expected_total"];
        EXPECT_EQ(answer.pairs, most);
        EXPECT_NEAR(answer.total, total.get<double>(), 1e-12 * std::abs(answer.total));
        if (!vector["expected_row_to_col"].is_null() && !turned) {
          double stated = 0.0;
          const auto columns = vector["expected_row_to_col"].get<std::vector<std::int32_t>>();
          for (std::size_t i = 0; i < columns.size(); ++i) {
            if (columns[i] >= 0) stated += table.cost[i * table.columns + static_cast<std::size_t>(columns[i])];
          }
          EXPECT_NEAR(answer.total, table.rows == 0 || table.columns == 0 ? 0.0 : stated, 1e-12 * std::abs(stated));
        }
      }
    }
    ++(error.starts_with("infeasible") ? infeasible : error.starts_with("invalid") ? invalid : totals);
  }
  EXPECT_EQ(totals + infeasible + invalid + limited, static_cast<int>(file["vectors"].size()));
  EXPECT_EQ(limited, 1);
  EXPECT_EQ(invalid, 2);
  EXPECT_GE(infeasible, 8);
  EXPECT_GE(totals, 45);
}

}  // namespace
