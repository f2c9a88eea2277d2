// Formats numbers and columns into strings, for all reports. Independent of the locale.
#pragma once

#include "post/summary.hpp"

#include <contact2d.h>

#include <cstdint>
#include <string>

namespace app {

// Appends `value` with 12 significant digits, as printf's %.12g would; minus zero as 0.
void append_number(std::string& out, double value);
void append_integer(std::string& out, int64_t value);
// With the fewest digits that give the same double, and with so many significant ones.
std::string shortest(double value);
std::string rounded(double value, int digits = 6);
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
// "body 2" or, if it has a name, "body 2 (bolt)"; "zone 1 (thread)"; "body 2 on body 3": the bodies of a zone, that of side 1
// first. Names are UTF-8.
std::string body_text(const Summary& summary, int64_t body);
std::string zone_text(const Summary& summary, int64_t zone);
std::string bodies_text(const Summary& summary, const c2d_zone& zone);
// Bytes of the character of UTF-8 that begins there; 0: none that can be shown does. How many characters a text has.
size_t character_at(const std::string& text, size_t i);
size_t characters_in(const std::string& text);
// The text with a question mark for every byte that begins no printable character: control bytes never reach a terminal.
std::string shown(const std::string& text);
// Lines of symmetry by images, as in Summary::symmetry, without the axis of bodies of revolution.
int32_t mirror_lines(const Summary& summary);
// "x = 0", "x = 0, y = 1": the lines of symmetry by images; "none".
std::string symmetry_text(const Summary& summary);

} // namespace app
