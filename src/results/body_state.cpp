#include "results/body_state.hpp"

#include "bie/columns.hpp"
#include "memory/parts.hpp"
#include "model/pair_frame.hpp"
#include "results/transferred.hpp"

namespace c2d {

C2D_USES(FreeZonePart);

namespace {

// The contact's share of an element, from tau itself in its own measure.
void add_contact_end(const Session& session, const PairSide& at, const EndResultant& w, double out[3]) {
  const ModelHeader& head = *session.model.head;
  const PairState now = pair_state(*session.follower.t, at.pair, session.follower.y);
  const double scale = sign_of_side(at.side) * head.stress_unit * head.length_unit;
  double t[2];
  to_global(session.model.pair[at.pair], now.p * scale, now.q * scale, t);
  add_force(out, w.w * t[0], w.w * t[1], head.length_unit * (w.wx * t[1] - w.wy * t[0]));
}

} // namespace

void contact_resultant(const Session& session, int b, double out[3]) {
  const Model& m = session.model;
  out[0] = out[1] = out[2] = 0.0;
  for (int32_t element = 0; element < end_of_elements(m, b); ++element) {
    ZonePlace place;
    if (!find_contact_element(m, b, element, &place) || !is_integrated(m, b, element)) continue;
    EndResultant shared[kElementNodes];
    end_resultants(m, b, element, Measure::contact, shared);
    for (int l = 0; l < m.head->function_nodes; ++l) {
      const PairSide at = pair_of_end(m, b, element, l);
      if (at.pair >= 0) add_contact_end(session, at, shared[l], out);
    }
  }
  if (m.body[b].free_rows > 0) kFreeZonePart.add_transferred_force(session, b, out);
}

} // namespace c2d
