#include "program/commands/drawn_words.hpp"

#include <contact2d.h>

#include <algorithm>
#include <cstdlib>

namespace app {
namespace {

// Warnings that only describe the mesh the program made. Those about the accuracy of results are shown.
constexpr int32_t kAboutMesh[] = {C2D_WARN_NORMALS,  C2D_WARN_KINK,  C2D_WARN_CORNER,  C2D_WARN_OFFSET,
                                  C2D_WARN_LEFT_OUT, C2D_WARN_SIZES, C2D_WARN_SURFACE, C2D_WARN_SLIT};

constexpr char kReachesEnd[] = "contact reaches the end of the facing parts and may extend beyond it";
struct Phrase {
  const char *of_mesh, *of_drawing; // `#` stands for a number
};
constexpr Phrase kPhrases[] = {
    {"the last pair at an end of a contact zone is closed: the contact may extend beyond the zone; lengthen it", kReachesEnd},
    {"exceeds half a contact element and 5 % of the contact length: its nodes no longer face each other",
     "exceeds 5 % of the contact length: pressures act at the positions before slip; moments and stresses have about the same "
     "relative error"},
    {", # elements, most of it before they touched", ", most of it before they touched"},
    {"friction is at its limit at all pairs that support ", "friction is at its limit wherever contact supports "},
    {"the position that moves the pairs least", "the position that moves the surfaces least"},
    {"the first by pairs", "the first by places"},
    {"refine at edges and corners of the contact where pairs slip", "request dissipation, or use a smaller tolerance"},
    {"; last pair #", ""},
    {" at pair #, the loads close gaps", ", the loads close gaps"},
    {" away from element #, less than its length #: part of the force is lost",
     " away from the boundary: this is too near, and part of the force is lost"},
    {"the pressure inside a contact element falls below -1 % of the largest nodal pressure: contact conditions are "
     "enforced at nodes only; refine, or use linear functions",
     "the pressure falls below -1 % of the highest pressure in places, and has an error of that size there; use a smaller "
     "tolerance"},
    {"overlaps smaller than what the elements leave open of the surfaces, pairs: #, most at",
     "overlaps too small to distinguish from contact, most at"},
    {"between the nodes of side 2 the bodies overlap by", "in contact the bodies overlap by"},
    {": contact conditions are enforced at the nodes of side 2 only; refine side 2 there",
     ", and the pressure has an error there; use a smaller tolerance"},
    {"and grow as elements get shorter; trust them from a few elements away",
     "and are unbounded; use them only at some distance"},
    {", supports too close together, or elements of very unlike size", " or supports too close together"},
    {"or *INTERFERENCE", "or interference"}};

// Length of the match of a phrase at a place of the text; 0: no match.
size_t length_of(const char* phrase, const std::string& text, size_t at) {
  const size_t begin = at;
  for (char c = *phrase; c != 0; c = *++phrase) {
    if (c != '#' && (at >= text.size() || text[at] != c)) return 0;
    if (c != '#')
      ++at;
    else
      at = std::min(text.find_first_not_of("0123456789.e+-", at), text.size());
  }
  return at - begin;
}

void replace(std::string& text, const Phrase& phrase) {
  for (size_t at = 0; at < text.size(); ++at)
    if (const size_t length = length_of(phrase.of_mesh, text, at); length > 0) text.replace(at, length, phrase.of_drawing);
}

bool accept(const std::string& text, size_t& at, const std::string& word) {
  if (text.compare(at, word.size(), word) != 0) return false;
  at += word.size();
  return true;
}

bool accept_number(const std::string& text, size_t& at, int& value) {
  const size_t begin = at;
  while (at < text.size() && text[at] >= '0' && text[at] <= '9') ++at;
  value = std::atoi(text.substr(begin, at - begin).c_str());
  return at > begin;
}

// The curves of a deck: `! curve of body 1: block.top, elements 57 to 136, nodes 57 to 137`.
struct DrawnCurve {
  int body = 0, first[2] = {0, 0}, last[2] = {0, 0}; // elements, nodes
  std::string name;
};
std::vector<DrawnCurve> curves_of(const std::string& deck) {
  std::vector<DrawnCurve> out;
  for (size_t line = 0; line < deck.size();) {
    const size_t end = std::min(deck.find('\n', line), deck.size());
    DrawnCurve curve;
    size_t at = line;
    if (accept(deck, at, "! curve of body ") && accept_number(deck, at, curve.body) && accept(deck, at, ": ")) {
      const size_t behind = deck.find(", elements ", at);
      if (behind < end) {
        curve.name = deck.substr(at, behind - at);
        at = behind;
        for (int k = 0; k < 2; ++k) {
          accept(deck, at, k == 0 ? ", elements " : ", nodes ");
          accept_number(deck, at, curve.first[k]);
          accept(deck, at, " to ");
          accept_number(deck, at, curve.last[k]);
        }
        out.push_back(curve);
      }
    }
    line = end + 1;
  }
  return out;
}

// Reads `element 3 of body 1 (block)` or `node 7 of body 2` and returns the name of the curve.
bool accept_place(const std::string& text, size_t& at, const std::vector<DrawnCurve>& curves, std::string& name) {
  size_t p = at;
  const int kind = accept(text, p, "element ") ? 0 : accept(text, p, "node ") ? 1 : -1;
  int number = 0, body = 0;
  if (kind < 0 || !accept_number(text, p, number) || !accept(text, p, " of body ") || !accept_number(text, p, body))
    return false;
  if (accept(text, p, " (")) {
    const size_t close = text.find(')', p);
    if (close == std::string::npos) return false;
    p = close + 1;
  }
  for (const DrawnCurve& curve : curves)
    if (curve.body == body && curve.first[kind] <= number && number <= curve.last[kind]) return at = p, name = curve.name, true;
  return false;
}

// Reads `pair 5 (on element 3 of body 1 (block), node 7 of body 2 (pad))` and returns both curves; `pair 5, ` is removed.
bool accept_pair(const std::string& text, size_t& at, const std::vector<DrawnCurve>& curves, std::string& words) {
  size_t p = at;
  int number = 0;
  if (!accept(text, p, "pair ") || !accept_number(text, p, number)) return false;
  std::string one, two;
  if (accept(text, p, ", ")) return words = at > 1 && text[at - 2] == 't' ? "one place, " : "", at = p, true; // at pair 5, ...
  if (!accept(text, p, " (")) return false;
  accept(text, p, "on ");
  if (!accept_place(text, p, curves, one) || !accept(text, p, ", ") || !accept_place(text, p, curves, two) ||
      !accept(text, p, ")"))
    return false;
  return at = p, words = one + " and " + two, true;
}

// `! zone 1: side 2 is the first of its statement`, and `! zone 1: the second side begins at 2.5 of 10`, of a closed curve.
constexpr char kFirstOfStatement[] = ": side 2 is the first of its statement", kBeginsAt[] = ": the second side begins at ",
               kOfAround[] = " of";

// Where the contact of a zone may continue: `! zone 1 may extend farther: pad.flat ends at ...`, for each end.
std::string beyond_zone(int zone, const std::string& deck) {
  const std::string begin = "\n! zone " + std::to_string(zone) + " may extend farther: ";
  std::string out;
  for (size_t at = deck.find(begin); at != std::string::npos; at = deck.find(begin, at)) {
    at += begin.size();
    out += (out.empty() ? "" : "; ") + deck.substr(at, deck.find('\n', at) - at);
  }
  return out;
}

constexpr char kRises[] = "and the pressure rises there to ", kToNext[] = " times that of the next";

// The meaning of a coarse contact next to a corner. The uncertainty of edges and borders is given by their stated errors.
std::string words_of_corner(const std::string& text) {
  const size_t begin = text.find(kRises), end = text.find(kToNext);
  const std::string rise =
      end == std::string::npos ? "many" : text.substr(begin + sizeof kRises - 1, end - begin - sizeof kRises + 1);
  return "at a corner of the contact the pressure rises to " + rise +
         " times the pressure beside it and may be unbounded: do not use the highest pressure there; forces and pressures "
         "farther away are correct";
}

} // namespace

bool is_at_natural_end(const c2d_error& warning, const std::string& deck) {
  return warning.status == C2D_WARN_ZONE_END && beyond_zone(warning.zone, deck).empty();
}

std::string without_cut_ends(std::string deck) {
  for (size_t at = 0;
       (at = deck.find(" may extend farther: on coarser meshes the surfaces did not touch there", at)) != std::string::npos;) {
    at = deck.rfind('\n', at);
    deck.erase(at, deck.find('\n', at + 1) - at);
  }
  return deck;
}

bool is_about_mesh(const c2d_error& warning) {
  if (warning.status == C2D_WARN_FEW_PAIRS) return std::string(warning.text).find(kRises) == std::string::npos;
  return std::find(std::begin(kAboutMesh), std::end(kAboutMesh), warning.status) != std::end(kAboutMesh);
}

std::string in_words_of_drawing(const std::string& text, const std::string& deck) {
  const std::vector<DrawnCurve> curves = curves_of(deck);
  std::string out, words;
  for (size_t at = 0; at < text.size();) {
    const bool begins = at == 0 || text[at - 1] == ' ' || text[at - 1] == '(';
    if (begins && (accept_pair(text, at, curves, words) || accept_place(text, at, curves, words)))
      out += words;
    else
      out += text[at++];
  }
  for (const Phrase& phrase : kPhrases) replace(out, phrase);
  size_t at = std::string("zone ").size();
  int zone = 0;
  if (out.find(kReachesEnd) != std::string::npos && accept_number(out, at, zone))
    if (const std::string beyond = beyond_zone(zone, deck); !beyond.empty()) out += ": " + beyond;
  if (const size_t coarse = out.find("coarse contact: "); coarse != std::string::npos)
    out.replace(coarse, std::string::npos, words_of_corner(out));
  return out;
}

void take_statements(const std::string& deck, std::vector<ZoneLine>& lines) {
  const std::string begin = "\n! zone ";
  for (size_t at = deck.find(begin); at != std::string::npos; at = deck.find(begin, at)) {
    int zone = 0;
    at += begin.size();
    if (!accept_number(deck, at, zone) || zone < 1 || static_cast<size_t>(zone) > lines.size()) continue;
    ZoneLine& line = lines[static_cast<size_t>(zone) - 1];
    if (accept(deck, at, kFirstOfStatement)) line.turned = true;
    if (!accept(deck, at, kBeginsAt)) continue;
    char* behind = nullptr;
    line.from = std::strtod(deck.c_str() + at, &behind);
    at = static_cast<size_t>(behind - deck.c_str());
    line.around = accept(deck, at, kOfAround) ? std::strtod(deck.c_str() + at, nullptr) : 0;
  }
}

} // namespace app
