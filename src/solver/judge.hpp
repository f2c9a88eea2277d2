#pragma once
// No state of a path is shown unjudged (METHOD 14): every sixteen exchanges and before every row the residuals of
// tableau and contact equations, seen through one fixed vector of signs v, the balance of forces of every body that contact
// has to hold, signs and cone. v.T, v.M, ... are found once, so that a look costs a few products of length m. The last
// state that was found good is kept (pairs, loads, energies, values). A tableau that has drifted is built anew from the
// tape. Where decisions may have been wrong already, the path is taken up again from the state kept, with a new tableau
// after every change; if that does not help, the path ends there: C2D_BEYOND_LIMITS.
#include "contact/basis.hpp"
#include "solver/session.hpp"

namespace c2d {

// Limits, all relative: residuals to the sum of the magnitudes they are the rest of, forces to the largest of the path,
// pressures, friction and gaps to the largest pressure and displacement. They are multiples of the last digit of a
// stored number.
constexpr double kDigit = sizeof(Real) == 8 ? 2.2e-16 : 1.2e-7;
// Exchanges between pairs that stand well leave 1e-15 after thousands of them; what is above this comes from a pivot that
// cancelled, and a new tableau takes it away. So results have ten digits of a new tableau.
constexpr double kDriftLimit = 1e4 * kDigit;
// From here on loads of events and statuses may have been decided on wrong numbers: the path is taken up again.
constexpr double kRepeatLimit = 10 * kDriftLimit;
// What nothing takes away: eight digits of twelve are left to judge statuses by (contact/settle.cpp: 1e-9 of the rates).
constexpr double kResidualLimit = 5e7 * kDigit < 1e-2 ? 5e7 * kDigit : 1e-2;
// Reduction and tableau hold the balance to 1e-12; one that is worse than this means displacements without bound.
constexpr double kBalanceLimit = kResidualLimit;
// Statuses are decided within 1e-9; deck stepping within 1e-12.
constexpr double kSignLimit = kResidualLimit;

// What a preparation warns of: the part of the displacements that may be round-off (measured on strips of every order in
// closed form: never more than told, and not less than a twentieth of it).
constexpr double kLossLimit = sizeof(Real) == 8 ? 1e-6 : 1e-2;

constexpr c2d_status kUnsound = -1; // of a state, within the library: limits are exceeded, breach says which

// Everything above that does not depend on the path, after the reduction. Errors: the block store's.
c2d_status build_judge(c2d_solver* solver);
// The path begins with the state that there is.
void begin_judging(Session& session);
// What the statuses are to agree with: nothing yet; the values, so that signs count and a good state is kept; the rates
// along the path's direction, too.
enum class Agree { nothing, values, rates };
// Judge the state. The tableau may be built anew, and statuses settled once more; y and dy are then new as well. Errors:
// kUnsound, the block store's.
c2d_status judge(Session& session, Agree with);
// Is the state within its limits, as it stands? Nothing is changed or kept.
bool may_be_shown(Session& session, Agree with);
// Back to the last good state, with a new tableau. Errors: C2D_ERR_SINGULAR (there is no tableau: values are those kept,
// and the path cannot go on), the block store's.
c2d_status return_to_good(Session& session);
// v, as good as drawn by lot.
// Columns of A, so many of these slots, have been made on demand; they stand 2 m apart.
c2d_status note_demanded(Session& session, const Form& form, int32_t count, const int32_t* dof, const Real* columns);
inline double sign_of(int32_t row) {
  uint32_t mixed = static_cast<uint32_t>(row) * 2654435761u + 40503u;
  mixed = (mixed ^ mixed >> 15) * 2246822519u;
  return (mixed >> 16 & 1) != 0 ? 1.0 : -1.0;
}

// c2d_solver::condition, after the elimination (solver/condition.cpp). Errors: the block store's.
c2d_status find_condition(c2d_solver* solver);
// Tells how much that costs, if it is much.
void warn_condition(c2d_solver* solver);

} // namespace c2d
