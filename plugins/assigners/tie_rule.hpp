// SPDX-License-Identifier: MIT
// Which of several optimal assignments: the lexicographically least, so that robots that compute on equal matrices
// agree. Column by column in order of importance, each goes to the lowest robot that it can have in any optimal
// assignment that keeps the columns before it.
//
// By complementary slackness an assignment is optimal exactly when it uses only tight pairs (reduced cost 0 under one
// optimal dual) and leaves free only rows and columns whose dual allows it. Add a row and a column "nobody" for those
// that stay free, and optimal assignments are the perfect matchings of the tight pairs; one follows from another along
// alternating cycles (Fukuda and Matsui, "Finding all the perfect matchings in bipartite graphs", Applied Mathematics
// Letters 7(1), 1994). One search per column finds every robot that could have it.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "shortest_paths.hpp"

namespace assignment {

// A row of bits.
class Bits {
 public:
  explicit Bits(std::uint64_t* words) : words_(words) {}
  bool has(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1u) != 0; }
  void set(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  void unset(std::size_t i) { words_[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }
  std::uint64_t& word(std::size_t k) { return words_[k]; }

 private:
  std::uint64_t* words_;
};

class TieRule {
 public:
  void reserve(std::size_t rows, std::size_t columns) {
    const std::size_t row_words = (rows + 63) / 64, column_words = (columns + 63) / 64;
    tight_of_row_.reserve(rows * column_words);
    tight_of_column_.reserve(columns * row_words);
    for (auto* words : {&free_rows_, &open_rows_}) words->reserve(row_words);
    for (auto* words : {&free_columns_, &open_columns_, &reached_}) words->reserve(column_words);
    taker_.reserve(columns);
    queue_.reserve(2 * rows);
  }
  // Forgets all pairs. Then name those that are tight, and the rows and columns that may stay free.
  void begin(std::size_t rows, std::size_t columns) {
    rows_ = rows;
    columns_ = columns;
    row_words_ = (rows + 63) / 64;
    column_words_ = (columns + 63) / 64;
    tight_of_row_.assign(rows * column_words_, 0);
    tight_of_column_.assign(columns * row_words_, 0);
    free_rows_.assign(row_words_, 0);
    free_columns_.assign(column_words_, 0);
  }
  void tight(std::size_t row, std::size_t column) {
    of_row(row).set(column);
    of_column(column).set(row);
  }
  void row_may_stay_free(std::size_t row) { Bits(free_rows_.data()).set(row); }
  void column_may_stay_free(std::size_t column) { Bits(free_columns_.data()).set(column); }

  // Changes an optimal assignment (nobody = -1) into the lexicographically least optimal one. order: every column once,
  // the most important first. A column that stays free counts as given to a robot after the last.
  void apply(std::span<const std::uint32_t> order, std::span<std::int32_t> column_of, std::span<std::int32_t> row_of) {
    open_rows_.assign(row_words_, 0);
    open_columns_.assign(column_words_, 0);
    for (std::size_t i = 0; i < rows_; ++i) Bits(open_rows_.data()).set(i);
    for (std::size_t j = 0; j < columns_; ++j) Bits(open_columns_.data()).set(j);
    taker_.resize(columns_);
    for (const std::uint32_t column : order) {
      Bits(open_columns_.data()).unset(column);  // settled below: no later column may move it
      if (somebody_lower_is_tight(column, row_of[column])) improve(column, column_of, row_of);
      if (row_of[column] != nobody) Bits(open_rows_.data()).unset(static_cast<std::size_t>(row_of[column]));
    }
  }

 private:
  Bits of_row(std::size_t row) { return Bits(tight_of_row_.data() + row * column_words_); }
  Bits of_column(std::size_t column) { return Bits(tight_of_column_.data() + column * row_words_); }

  // Word k of the open rows below `limit` that are tight with the column.
  std::uint64_t lower_rows(std::size_t column, std::size_t k, std::size_t limit) {
    std::uint64_t word = of_column(column).word(k) & open_rows_[k];
    if (limit < (k + 1) * 64) word &= limit <= k * 64 ? 0 : ~std::uint64_t{0} >> (64 - (limit - k * 64));
    return word;
  }

  bool somebody_lower_is_tight(std::size_t column, std::int32_t holder) {
    const std::size_t limit = holder == nobody ? rows_ : static_cast<std::size_t>(holder);
    for (std::size_t k = 0; k * 64 < limit; ++k) {
      if (lower_rows(column, k, limit) != 0) return true;
    }
    return false;
  }

  // Gives the column to the lowest row that can have it, if that is lower than its holder.
  void improve(std::size_t column, std::span<std::int32_t> column_of, std::span<std::int32_t> row_of) {
    const std::int32_t loser = row_of[column];
    grow(loser, column_of, row_of);
    const std::size_t limit = loser == nobody ? rows_ : static_cast<std::size_t>(loser);
    for (std::size_t k = 0; k * 64 < limit; ++k) {
      for (std::uint64_t word = lower_rows(column, k, limit); word != 0; word &= word - 1) {
        const std::size_t row = k * 64 + static_cast<std::size_t>(std::countr_zero(word));
        const std::int32_t given_up = column_of[row];
        const bool can =
            given_up == nobody ? nobody_reached_ : Bits(reached_.data()).has(static_cast<std::size_t>(given_up));
        if (!can) continue;
        column_of[row] = static_cast<std::int32_t>(column);
        row_of[column] = static_cast<std::int32_t>(row);
        hand_on(given_up, loser, column_of, row_of);
        return;
      }
    }
  }

  // The alternating tree from the row that loses its column: reached_ are the columns that somebody in the tree could
  // take over (taker_), each of which sets its holder free to take another.
  void grow(std::int32_t loser, std::span<const std::int32_t> column_of, std::span<const std::int32_t> row_of) {
    reached_.assign(column_words_, 0);
    queue_.clear();
    nobody_reached_ = false;
    if (loser == nobody) {
      reach_nobody(nobody, nobody, column_of, row_of);
    } else {
      queue_.push_back(loser);
    }
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      const auto row = static_cast<std::size_t>(queue_[next]);
      spread(&tight_of_row_[row * column_words_], queue_[next], column_of, row_of);
      if (!nobody_reached_ && Bits(free_rows_.data()).has(row)) {
        reach_nobody(nobody, queue_[next], column_of, row_of);
      }
    }
  }

  void spread(const std::uint64_t* columns, std::int32_t taker, std::span<const std::int32_t> column_of,
              std::span<const std::int32_t> row_of) {
    for (std::size_t k = 0; k < column_words_; ++k) {
      std::uint64_t word = columns[k] & open_columns_[k] & ~reached_[k];
      reached_[k] |= word;
      for (; word != 0; word &= word - 1) {
        const std::size_t column = k * 64 + static_cast<std::size_t>(std::countr_zero(word));
        taker_[column] = taker;
        if (row_of[column] != nobody) {
          queue_.push_back(row_of[column]);
        } else if (!nobody_reached_) {
          reach_nobody(static_cast<std::int32_t>(column), nobody, column_of, row_of);
        }
      }
    }
  }

  // "Nobody" gives up the free column `through_column`, or takes in `through_row` as one more row without a column.
  // Then it can take any column that may stay free, and every row without a column can be called upon.
  void reach_nobody(std::int32_t through_column, std::int32_t through_row, std::span<const std::int32_t> column_of,
                    std::span<const std::int32_t> row_of) {
    nobody_reached_ = true;
    through_column_ = through_column;
    through_row_ = through_row;
    for (std::size_t i = 0; i < rows_; ++i) {
      if (column_of[i] == nobody) queue_.push_back(static_cast<std::int32_t>(i));
    }
    spread(free_columns_.data(), nobody, column_of, row_of);
  }

  // Walks from the column that the winner gave up to the loser; everybody takes the column over that comes along.
  void hand_on(std::int32_t column, std::int32_t loser, std::span<std::int32_t> column_of,
               std::span<std::int32_t> row_of) {
    while (true) {
      std::int32_t taker;
      if (column != nobody) {
        taker = taker_[static_cast<std::size_t>(column)];
        row_of[static_cast<std::size_t>(column)] = taker;
      } else {
        taker = nobody;
      }
      if (taker == nobody) {
        if (loser == nobody) return;
        if (through_row_ == nobody) {
          column = through_column_;
          continue;
        }
        taker = through_row_;
        column = nobody;
      }
      const std::int32_t given_up = column_of[static_cast<std::size_t>(taker)];
      column_of[static_cast<std::size_t>(taker)] = column;
      if (taker == loser) return;
      column = given_up;
    }
  }

  std::size_t rows_ = 0, columns_ = 0, row_words_ = 0, column_words_ = 0;
  std::vector<std::uint64_t> tight_of_row_, tight_of_column_, free_rows_, free_columns_;
  std::vector<std::uint64_t> open_rows_, open_columns_, reached_;
  std::vector<std::int32_t> taker_, queue_;
  bool nobody_reached_ = false;
  std::int32_t through_column_ = nobody, through_row_ = nobody;
};

}  // namespace assignment
