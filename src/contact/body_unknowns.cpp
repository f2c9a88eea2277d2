#include "contact/body_unknowns.hpp"

namespace c2d {

bool next_range(const Model& m, int b, UnknownRange& range) {
  for (;;) {
    if (++range.side > 1) {
      range.side = 0;
      ++range.zone;
    }
    if (range.zone >= m.head->zones) return false;
    const Zone& z = m.zone[range.zone];
    if (z.body[range.side] != b) continue;
    const Pair& last = m.pair[z.first_pair + z.pairs - 1];
    range.all = m.pair[z.first_pair].dof;
    range.count = last.dof + 1 + last.tangential - range.all;
    range.own = range.all + z.shift[range.side];
    range.other = z.body[1 - range.side];
    range.other_own = range.all + z.shift[1 - range.side];
    return true;
  }
}

bool next_pair_of(const Model& m, int b, PairSide& at) {
  for (;;) {
    if (++at.side > 1) {
      at.side = 0;
      ++at.pair;
    }
    if (at.pair >= m.head->pairs) return false;
    if (body_on(m, m.pair[at.pair], at.side) == b) return true;
  }
}

bool has_kept(const Model& m, int32_t zone) {
  return keeps_equations(m, m.zone[zone].body[0]) || keeps_equations(m, m.zone[zone].body[1]);
}

} // namespace c2d
