// Numbers and columns into a string: what all reports print with. Independent of any locale.
#pragma once

#include "report/summary.hpp"

#include <contact2d.h>

#include <cstdint>
#include <string>

namespace app {

// Appends `value` with 12 significant digits, as printf's %.12g would; minus zero as 0.
void append_number(std::string& out, double value);
void append_integer(std::string& out, int64_t value);
// Right-aligned in `width` columns: an integer, a word, a number with `digits` digits after the point of its
// scientific form, and a number in its general form with `digits` significant digits.
void append_column(std::string& out, int64_t value, int width);
void append_column(std::string& out, const char* word, int width);
void append_scientific(std::string& out, double value, int width, int digits = 5);
void append_general(std::string& out, double value, int width, int digits = 6);

// Words of the contact statuses, of the outcomes and of the tapes; never null.
const char* status_word(int32_t status);
const char* outcome_word(int32_t outcome);
const char* breach_word(int32_t breach);
const char* tape_word(int32_t tape);
// "x = 0", "x = 0, y = 1": the lines of symmetry by images; "none".
std::string symmetry_text(const Summary& summary);

} // namespace app
