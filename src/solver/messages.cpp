// Words for numbers: any integer has some.
#include "solver/solver.hpp"

namespace c2d {

namespace {

struct Word {
  int32_t number;
  const char* text;
};

const Word kStatusWords[] = {
    {C2D_OK, "no error"},
    {C2D_ERR_ARGUMENT, "an argument is null or out of range"},
    {C2D_ERR_STATE, "this call is not legal in the solver's present state"},
    {C2D_ERR_BUSY, "called from inside one of the solver's own callbacks"},
    {C2D_ERR_MEMORY, "the workspace is too small"},
    {C2D_ERR_OVERFLOW, "a size is too large for this machine"},
    {C2D_ERR_LIMIT, "more than the limits allow"},
    {C2D_ERR_INPUT, "the deck or the model has faults"},
    {C2D_ERR_READ, "the deck could not be read"},
    {C2D_ERR_CANCELLED, "cancelled"},
    {C2D_ERR_SINGULAR, "the equations have no unique solution"},
    {C2D_ERR_CALLBACK, "one of the caller's functions reported a failure"},
    {C2D_ERR_STORE_OPEN, "block store: a tape could not be opened"},
    {C2D_ERR_STORE_READ, "block store: reading failed"},
    {C2D_ERR_STORE_WRITE, "block store: writing failed"},
    {C2D_ERR_STORE_SYNC, "block store: the data could not be made durable"},
    {C2D_ERR_STORE_CLOSE, "block store: closing failed"},
    {C2D_ERR_STORE_FORMAT, "block store: not a block of this program"},
    {C2D_ERR_STORE_VERSION, "block store: a block of another format version, byte order or number type"},
    {C2D_ERR_STORE_SHORT, "block store: a torn block"},
    {C2D_ERR_STORE_CHECKSUM, "block store: a damaged block"},
    {C2D_ERR_STORE_SWAPPED, "block store: a block of another place"},
    {C2D_ERR_STORE_STALE, "block store: a block of an earlier run"},
    {C2D_ERR_MISMATCH, "saved by another model, number type or format"},
    {C2D_ERR_INTERNAL, "internal error: please report it"},
    {C2D_WARN_ZONE_END, "contact reaches the end of its zone"},
    {C2D_WARN_FEW_PAIRS, "coarse contact"},
    {C2D_WARN_LARGE_SLIP, "large slip"},
    {C2D_WARN_NORMALS, "normals of a pair differ"},
    {C2D_WARN_KINK, "kink inside a contact zone"},
    {C2D_WARN_POINT_LOAD, "point load near the boundary"},
    {C2D_WARN_TENSION, "tension inside a contact element"},
    {C2D_WARN_CORNER, "one traction at a corner"},
    {C2D_WARN_INCREMENT, "an increment did not converge"},
    {C2D_WARN_RESIDUAL, "numbers beyond their limits"},
    {C2D_WARN_CONDITION, "badly conditioned equations"},
    {C2D_WARN_OFFSET, "nodes of a pair are shifted"},
    {C2D_WARN_LEFT_OUT, "an element is left out of a contact zone"},
    {C2D_WARN_OVERLAP, "overlaps that the elements are too coarse to tell"},
    {C2D_WARN_NOT_UNIQUE, "the contact state is not unique"},
    {C2D_WARN_UNDEFINED_PLACE, "the place of a body is undefined"},
    {C2D_WARN_STRAIN, "large strains"},
    {C2D_WARN_FRICTION, "very high friction"},
    {C2D_WARN_CONSTANT, "constant functions"},
    {C2D_WARN_FAR, "a contact zone whose surfaces stay far apart"},
    {C2D_WARN_SIZES, "elements of very different length face each other"},
    {C2D_WARN_SURFACE, "a surface that is not certain enough"},
    {C2D_WARN_UNHELD, "nothing holds some motions of bodies"},
    {C2D_WARN_TIE_END, "stresses are singular where a tie of unlike materials ends"},
    {C2D_WARN_COMPRESSED, "inexact compression"},
    {C2D_WARN_BETWEEN, "overlap between nodes"},
    {C2D_WARN_SHIFTED, "nodes of pairs are shifted a little"},
    {C2D_WARN_OVERLAPPING, "bodies overlap where no zone is"},
    {C2D_WARN_SIDEWAYS, "moved sideways before it touched"},
    {C2D_WARN_ROTATION, "large rotations"},
    {C2D_WARN_SLIT, "a slit narrower than its elements"},
    {C2D_WARN_ENERGY, "the work of friction is not certain enough"},
};

const Word kOutcomeWords[] = {
    {C2D_REACHED, "reached"},
    {C2D_FREE_MOTION, "free motion"},
    {C2D_GROSS_SLIDING, "gross sliding"},
    {C2D_NO_ADMISSIBLE_CHANGE, "no admissible change"},
    {C2D_NO_PROGRESS, "changes without progress"},
    {C2D_UNDECIDED, "could not be decided"},
    {C2D_TIPPING, "tipping"},
    {C2D_BEYOND_LIMITS, "beyond the limits of accuracy"},
};

} // namespace

const char* status_text(int32_t status) {
  for (const Word& word : kStatusWords)
    if (word.number == status) return word.text;
  return "unknown status";
}

const char* outcome_text(int32_t outcome) {
  for (const Word& word : kOutcomeWords)
    if (word.number == outcome) return word.text;
  return "unknown outcome";
}

} // namespace c2d
