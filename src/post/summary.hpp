// The summary of the library, with data of each body and zone.
#pragma once

#include <contact2d.h>

#include <initializer_list>
#include <string>
#include <vector>

namespace app {

// By any kind of number, from 0.
class Bodies {
public:
  template <class Number> const c2d_body_result& operator[](Number i) const { return list_[static_cast<size_t>(i)]; }
  std::vector<c2d_body_result>& list() { return list_; }

private:
  std::vector<c2d_body_result> list_;
};

struct Summary : c2d_summary {
  Summary() : c2d_summary(C2D_INIT(c2d_summary)) {}
  Bodies body;
  std::vector<c2d_zone> zone;                    // from 0; empty as long as there is no complete model
  std::vector<std::string> body_name, zone_name; // from 0; empty: none
  std::vector<int32_t> cut;                      // per body from 0, the lines of symmetry it meets: 1 x, 2 y, 3 both
  // Can a zone have other bodies than body 1 on side 1 and body 2 on side 2, or has anything a name? Then bodies are
  // named.
  bool names_bodies() const;
  bool is_platen(int32_t number) const { return body[number - 1].elements == 0; } // has no mesh of its own
  // Whose elements a platen moves, and which: "elements 8 to 11 of body 2".
  std::string moved_by(int32_t platen) const;
};
c2d_status get_summary(c2d_solver* solver, Summary& out);

// A number of every pair, by pair from 0.
struct PairField {
  int32_t field;
  std::vector<double>& values;
};
c2d_status get_pairs(c2d_solver* solver, const Summary& summary, std::initializer_list<PairField> fields);

// `fields` of all element ends of a body, one vector per field.
c2d_status get_ends(c2d_solver* solver, const Summary& summary, int32_t body, const int32_t* fields, int32_t count,
                    std::vector<std::vector<double>>& out);

} // namespace app
