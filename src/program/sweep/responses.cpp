#include "program/sweep/responses.hpp"

#include "program/sweep/tolerance_response.hpp"
#include "program/sweep/wanted_response.hpp"
#include "program/words/near_word.hpp"
#include "program/words/read_number.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace app {

const char kResponseWords[] =
    "max or min of tn, tt, un1, ut1, un2, ut2, gap, slip; a quantity of --summary, or x, y or along of its place (contact "
    "edge 1 x); stress or a column of --interior with the number of a point; touching, sticking, slipping, load; then, if "
    "needed, zone Z and the number of an edge or border; a number that a sketch requests (SWT of top, largest stress along "
    "hole), or x, y or plane of it; with tolerances of parameters derivative or share of a number by a parameter (share peak "
    "pressure by R), its worst case or root of squares";

namespace {

struct Word {
  const char* word;
  int32_t which;
};
const Word kColumns[] = {{"tn", C2D_TN},   {"tt", C2D_TT},   {"un1", C2D_UN1}, {"ut1", C2D_UT1},
                         {"un2", C2D_UN2}, {"ut2", C2D_UT2}, {"gap", C2D_GAP}, {"slip", C2D_SLIP_SUM}};
const Word kPointColumns[] = {{"stress", C2D_POINT_VON_MISES},
                              {"von_mises", C2D_POINT_VON_MISES},
                              {"ux", C2D_POINT_UX},
                              {"uy", C2D_POINT_UY},
                              {"sxx", C2D_POINT_SXX},
                              {"syy", C2D_POINT_SYY},
                              {"sxy", C2D_POINT_SXY},
                              {"szz", C2D_POINT_SZZ},
                              {"max_shear", C2D_POINT_MAX_SHEAR},
                              {"principal1", C2D_POINT_PRINCIPAL1},
                              {"principal2", C2D_POINT_PRINCIPAL2}};
const Word kCounts[] = {{"touching", -1}, {"sticking", C2D_STICK}, {"slipping", C2D_SLIP}};

template <size_t n> const Word* find_word(const Word (&words)[n], const std::string& word) {
  for (const Word& w : words)
    if (word == w.word) return &w;
  return nullptr;
}

bool read_ordinal(const std::string& word, int32_t& number) { return read_number(word, number) && number > 0; }

// Takes `zone Z` and a number off the end.
void take_tail(std::vector<std::string>& words, Response& r) {
  for (bool more = true; more && words.size() > 1;) {
    int32_t number = 0;
    more = false;
    const bool is_number = read_ordinal(words.back(), number),
               of_zone = is_number && words.size() > 2 && words[words.size() - 2] == "zone";
    if (of_zone && r.zone == 0)
      r.zone = number, words.resize(words.size() - 2), more = true;
    else if (is_number && !of_zone && r.item == 0)
      r.item = number, words.pop_back(), more = true;
  }
}

bool is_quantity(const std::string& text, Response& r) {
  const MeasureRow* row = find_measure(text.c_str());
  if (row == nullptr) return false;
  r.of = Response::Of::kQuantity, r.which = static_cast<int32_t>(row->what);
  return true;
}

// The meaning of the words before zone and number.
bool take_head(const std::vector<std::string>& words, Response& r) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  if (is_quantity(text, r)) return true;
  const bool extreme = words.size() == 2 && (words[0] == "max" || words[0] == "min");
  if (const Word* column = find_word(kColumns, words.back()); column != nullptr && (extreme || words.size() == 1)) {
    r.of = Response::Of::kPairs, r.which = column->which;
    r.least = extreme && words[0] == "min", r.size = !extreme;
    return r.item == 0;
  }
  if (words.size() != 1) return false;
  if (const Word* column = find_word(kPointColumns, words[0]); column != nullptr) {
    r.of = Response::Of::kPoint, r.which = column->which;
    return r.item > 0 && r.zone == 0;
  }
  if (const Word* count = find_word(kCounts, words[0]); count != nullptr) {
    r.of = Response::Of::kCount, r.which = count->which;
    return r.item == 0;
  }
  r.of = Response::Of::kLoad;
  return words[0] == "load" && r.item == 0 && r.zone == 0;
}

// `contact edge 1 x`: where a quantity is that has a place.
bool take_place(std::vector<std::string> words, Response& r) {
  const std::pair<const char*, Response::Part> parts[] = {
      {"x", Response::Part::kX}, {"y", Response::Part::kY}, {"along", Response::Part::kAlong}};
  for (const auto& [word, part] : parts)
    if (words.back() == word) r.part = part;
  if (r.part == Response::Part::kValue || words.size() < 2) return false;
  words.pop_back();
  take_tail(words, r);
  return take_head(words, r) && r.of == Response::Of::kQuantity &&
         row_of(static_cast<Measure>(r.which)).place != PlaceKind::kNone;
}

std::vector<std::string> split_words(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> out;
  for (std::string word; in >> word;) out.push_back(word);
  return out;
}

std::string with_blanks(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

bool read_response(const std::vector<std::string>& all, Response& r) {
  std::vector<std::string> words = all;
  r.words = with_blanks(words);
  if (take_tolerance_words(words, r)) {
    take_tail(words, r);
    r.number = with_blanks(words);
    return is_name_of_wanted(r.number);
  }
  take_tail(words, r);
  return take_head(words, r) || take_place(words, r) || take_wanted_words(all, r);
}

std::vector<std::string> quantity_names() {
  std::vector<std::string> out;
  for (size_t i = 0; i < kMeasures; ++i)
    if (const char* name = name_of(static_cast<Measure>(i)); find_measure(name) != nullptr) out.emplace_back(name);
  return out;
}

std::vector<std::string> response_words() {
  std::vector<std::string> out{"zone", "x", "y", "along", "plane", "max", "min", "load"};
  for (const Word& w : kColumns) out.emplace_back(w.word);
  for (const Word& w : kPointColumns) out.emplace_back(w.word);
  for (const Word& w : kCounts) out.emplace_back(w.word);
  for (const std::string& word : tolerance_words()) out.push_back(word);
  for (const std::string& name : quantity_names())
    for (const std::string& word : split_words(name)) out.push_back(word);
  return out;
}

// The words with each unknown one replaced by the known one nearest to it.
std::vector<std::string> corrected(std::vector<std::string> words) {
  const std::vector<std::string> known = response_words();
  for (std::string& word : words) {
    int32_t number = 0;
    if (read_number(word, number) || std::find(known.begin(), known.end(), word) != known.end()) continue;
    if (const std::string near = nearest(word, known); !near.empty()) word = near;
  }
  return words;
}

// What may be meant by words that are no response: those with misspelt words corrected, a name with its blanks elsewhere, or
// all names in which the words occur.
std::vector<std::string> suggested(const std::vector<std::string>& words) {
  const std::vector<std::string> near = corrected(words), names = quantity_names();
  if (Response r; near != words && read_response(near, r)) return {r.words};
  if (const std::string name = nearest(with_blanks(words), names); !name.empty() && name != with_blanks(words)) return {name};
  std::vector<std::string> out;
  for (const std::string& name : names) {
    const std::vector<std::string> parts = split_words(name);
    const auto occurs = [&](const std::string& word) { return std::find(parts.begin(), parts.end(), word) != parts.end(); };
    if (std::all_of(near.begin(), near.end(), occurs)) out.push_back(name);
  }
  return out;
}

std::string why_unknown(const std::vector<std::string>& words) {
  const std::vector<std::string> names = suggested(words);
  std::string out = "'" + with_blanks(words) + "'";
  if (names.empty()) return out + ": expected " + kResponseWords;
  for (size_t i = 0; i < names.size(); ++i)
    out += (i == 0 ? ", did you mean '" : i + 1 < names.size() ? ", '" : " or '") + names[i] + "'";
  return out + "?";
}

double of_pairs(const Response& r, const CoefficientRecord& c) {
  double best = NAN, count = 0;
  for (size_t at = 0; at + C2D_PAIR_FIELDS <= c.table.size(); at += C2D_PAIR_FIELDS) {
    if (r.zone != 0 && static_cast<int32_t>(c.table[at + C2D_PAIR_ZONE]) != r.zone) continue;
    const int32_t status = static_cast<int32_t>(c.table[at + C2D_STATUS]);
    const bool touches = status == C2D_STICK || status == C2D_SLIP;
    if (r.of == Response::Of::kCount ? touches && (r.which < 0 || status == r.which) : true) count += 1;
    double value = r.of == Response::Of::kPairs ? c.table[at + static_cast<size_t>(r.which)] : 0.0;
    if (r.size) value = std::fabs(value);
    if (std::isnan(best) || (r.least ? value < best : value > best)) best = value;
  }
  return r.of == Response::Of::kCount ? count : best;
}

double of_quantities(const Response& r, const CoefficientRecord& c) {
  if (c.steps.empty()) return NAN;
  for (const Quantity& q : c.steps.back().quantities) {
    const bool zone = r.zone == 0 || q.zone == r.zone, item = r.item == 0 ? q.item <= 1 : q.item == r.item;
    if (static_cast<int>(q.what) != r.which || !zone || !item) continue;
    const double parts[] = {q.value, q.at[0], q.at[1], q.along};
    return parts[static_cast<size_t>(r.part)];
  }
  return NAN;
}

double of_point(const Response& r, const RunRecord& record) {
  const size_t i = static_cast<size_t>(r.item) - 1;
  if (record.interior == nullptr || i >= record.interior->points.size()) return NAN;
  const InteriorPoint& p = record.interior->points[i];
  return flag_of(p) == C2D_POINT_OUTSIDE ? NAN : p.values[r.which];
}

} // namespace

bool read_responses(const std::string& text, std::vector<Response>& responses, std::string& error) {
  std::istringstream list(text);
  for (std::string part; std::getline(list, part, ';');) {
    const std::vector<std::string> words = split_words(part);
    if (words.empty()) continue;
    Response r;
    if (!read_response(words, r)) return error = why_unknown(words), false;
    responses.push_back(r);
  }
  if (responses.empty()) error = std::string("no response is given, expected ") + kResponseWords;
  return error.empty();
}

double evaluate(const Response& r, const RunRecord& record) {
  if (r.of == Response::Of::kPoint) return of_point(r, record);
  if (r.of == Response::Of::kTolerance) return of_tolerances(r, record.meshes.tolerances);
  if (r.of == Response::Of::kWanted) return of_wanted(r, record.meshes.stated);
  if (record.coefficients.empty()) return NAN;
  const CoefficientRecord& c = record.coefficients.back();
  if (r.of == Response::Of::kQuantity) return of_quantities(r, c);
  return r.of == Response::Of::kLoad ? c.load : of_pairs(r, c);
}

std::string csv_number(double value) {
  std::string text;
  if (std::isfinite(value)) append_number(text, value);
  return text;
}

std::string results_text(const std::vector<Response>& responses, const std::vector<double>& values) {
  std::string out;
  for (size_t i = 0; i < responses.size(); ++i) {
    const std::string number = csv_number(values[i]);
    out += (number.empty() ? "nan" : number) + " " + responses[i].words + "\n"; // the words follow a number
  }
  return out;
}

std::string failure_text(const std::string& why) {
  std::string line = why.substr(0, why.find('\n'));
  return "FAIL " + (line.empty() ? "reason unknown" : line) + "\n";
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

} // namespace app
