#pragma once
// Tableau with delayed exchanges (exchange.hpp). It represents T - U M V^T: T is the tableau when the list of exchanges was
// last applied, U and V contain the columns and rows of the exchanges since then, and only the small matrix M changes with
// them. An exchange then needs only the column and the row of its pivot. One that reverses another removes it from the list.
// All listed exchanges are applied as one product. METHOD (11.4).
#include "contact2d_memory.h"
#include "linalg/engine.hpp"

namespace c2d {

struct DelayedExchanges {
  int32_t rows, cols; // at least as many rows as columns
  Real* t;            // T, rows x cols without gaps
  int32_t most;       // the list's length; 0: no list, T alone is the tableau
  Real* numbers;      // of the list, list_numbers() of them
  int32_t count;      // exchanges in the list
};
constexpr int32_t kMostDelayed = 64;
// The list's length. It depends on the number of rows alone, so that nothing else decides when the list is applied; 0 for
// small tableaux. The list fits into two times C2D_DELAYED_ columns.
constexpr int32_t delayed_exchanges(int64_t m) {
  const int64_t columns = C2D_DELAYED_(m);
  return columns == 0 ? 0 : static_cast<int32_t>(columns - 1 - (columns * columns + m - 1) / m);
}
constexpr int64_t list_numbers(int64_t rows, int64_t most) { return 2 * (rows + most) * most + 2 * rows; }

// Column or row of the tableau.
void read_column(const DelayedExchanges& d, const Engine& engine, int32_t column, Real* out);
void read_row(const DelayedExchanges& d, const Engine& engine, int32_t row, Real* out);
Real read_entry(const DelayedExchanges& d, int32_t row, int32_t column);
// y (rows) += factor times a column.
void add_column_to(const DelayedExchanges& d, const Engine& engine, int32_t column, Real factor, Real* y);
// The same for many columns: first the part of T for each, with the coefficients of the list summed in `by` (kMostDelayed
// numbers, from zero), then the list once.
void add_before_list(const DelayedExchanges& d, int32_t column, Real factor, Real* y, Real* by);
void subtract_list(const DelayedExchanges& d, const Engine& engine, const Real* by, Real* y);

// Exchanges y_r and z_c. A full list is applied first, and so is one that cancels most of the pivot. Returns false, with
// nothing else changed, if the pivot is below the smallest normal number. Otherwise an entry outside row r and column c has
// become T_ij - u_i v_j, with u_r = 1 / pivot and v_c = -1; `u` and `v` are valid until the next exchange, or until the list
// is applied.
bool delay_exchange(DelayedExchanges& d, const Engine& engine, int32_t r, int32_t c, const Real** u, const Real** v);
// As row_add and column_add.
void delayed_row_add(DelayedExchanges& d, int32_t target, int32_t source, Real factor);
void delayed_column_add(DelayedExchanges& d, int32_t target, int32_t source, Real factor);

// The listed exchange that an exchange of row r and column c would undo; -1: none.
int32_t place_in_list(const DelayedExchanges& d, int32_t r, int32_t c);
// Applies the list: T is the tableau, the list is empty.
void apply_delayed(DelayedExchanges& d, const Engine& engine);
// Applies all exchanges except those marked in `kept` by their places in the list: T is what the tableau would be without the
// latter. Some of them may be applied nevertheless.
void apply_all_but(DelayedExchanges& d, const Engine& engine, const bool* kept);

} // namespace c2d
