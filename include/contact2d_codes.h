/* contact2d: numeric codes: return codes of calls, outcomes of a path, warnings, fields of results. contact2d.h includes it.
   No code ever changes; c2d_message and c2d_outcome_message return their texts. */
#ifndef CONTACT2D_CODES_H
#define CONTACT2D_CODES_H

#include <stdint.h>

typedef int32_t c2d_status; /* what a call returns */
enum {
  C2D_OK = 0,
  C2D_ERR_ARGUMENT = 1,       /* a null pointer, a number out of range                              */
  C2D_ERR_STATE = 2,          /* not legal now: table of section 9 in contact2d.h                   */
  C2D_ERR_BUSY = 3,           /* called from inside one of this solver's callbacks                  */
  C2D_ERR_MEMORY = 4,         /* workspace too small; c2d_error.bytes_needed are sufficient         */
  C2D_ERR_OVERFLOW = 5,       /* a number of bytes beyond 64 bits or this machine's addresses       */
  C2D_ERR_LIMIT = 6,          /* more of something than c2d_limits allows                           */
  C2D_ERR_INPUT = 7,          /* the deck or the model is wrong; c2d_port.log received every fault  */
  C2D_ERR_READ = 8,           /* the caller's read_line failed (c2d_error.host_code)                */
  C2D_ERR_CANCELLED = 9,      /* by c2d_port.cancel or c2d_cancel                                   */
  C2D_ERR_SINGULAR = 10,      /* elimination found a column without a usable pivot                  */
  C2D_ERR_CALLBACK = 11,      /* a caller's function returned non-zero (c2d_error.host_code)        */
  /* The call of the port failed (c2d_error.host_code): */
  C2D_ERR_STORE_OPEN = 20, C2D_ERR_STORE_READ = 21, C2D_ERR_STORE_WRITE = 22, C2D_ERR_STORE_SYNC = 23, C2D_ERR_STORE_CLOSE = 24,
  C2D_ERR_STORE_FORMAT = 30,  /* not a block of this library: never written, or overwritten         */
  C2D_ERR_STORE_VERSION = 31, /* a block of another format version, byte order or scalar size       */
  C2D_ERR_STORE_SHORT = 32,   /* a torn block: shorter or longer than written                       */
  C2D_ERR_STORE_CHECKSUM = 33,/* a flipped bit in header or data                                    */
  C2D_ERR_STORE_SWAPPED = 34, /* a valid block of another tape or place                             */
  C2D_ERR_STORE_STALE = 35,   /* a valid block of another run or an earlier generation              */
  C2D_ERR_MISMATCH = 40,      /* a saved state of another model, scalar size or format              */
  C2D_ERR_INTERNAL = 99       /* an internal check failed: please report it                         */
};

typedef int32_t c2d_outcome; /* how the load path ended; the call itself worked */
enum {
  C2D_REACHED = 0,             /* the requested load                                                */
  C2D_FREE_MOTION = 1,         /* a body has a rigid-body motion without support: it can fly away   */
  C2D_GROSS_SLIDING = 2,       /* the whole contact slides: friction is exhausted                   */
  C2D_NO_ADMISSIBLE_CHANGE = 3,/* no change of status of any pair continues the path                */
  C2D_NO_PROGRESS = 4,         /* changes of status follow each other without progress              */
  C2D_UNDECIDED = 5,           /* whether the path continues could not be decided                   */
  C2D_TIPPING = 6,             /* a body tips over about a point that stays in contact              */
  C2D_BEYOND_LIMITS = 7        /* the next state is not accurate enough; this is the last accurate one */
};
enum { /* c2d_summary.breach: the violated limit with C2D_BEYOND_LIMITS */
  C2D_BREACH_NONE = 0, C2D_BREACH_TABLEAU = 1, C2D_BREACH_EQUATIONS = 2, /* residual of the contact tableau, of its equations */
  C2D_BREACH_BALANCE = 3,      /* force and moment of a body supported by contact alone             */
  C2D_BREACH_SIGN = 4, C2D_BREACH_CONE = 5, /* negative pressure or gap; friction above mu times the pressure */
  C2D_BREACH_SLIP = 6,         /* a pair slips in the direction of its friction                     */
  C2D_BREACH_SINGULAR = 7, C2D_BREACHES = 8 /* no unique solution: the statuses leave a motion free */
};

enum { /* fields of c2d_get */
  /* per pair (body is ignored); also the columns of c2d_step.table */
  C2D_X = 0, C2D_Y = 1,       /* position on side 1                                                 */
  C2D_STATUS = 2,             /* C2D_OPEN, C2D_STICK, C2D_SLIP, C2D_TIED                            */
  C2D_TN = 3, C2D_TT = 4,     /* pressure and friction on side 2, see the conventions               */
  C2D_UN1 = 5, C2D_UT1 = 6, C2D_UN2 = 7, C2D_UT2 = 8, /* displacements of both sides in the pair's frame */
  C2D_GAP = 9, C2D_SLIP_SUM = 10, /* current normal gap; accumulated tangential slip (u2-u1).t      */
  C2D_NX = 11, C2D_NY = 12,   /* the frame's normal                                                 */
  C2D_PAIR_NODE1 = 13, C2D_PAIR_NODE2 = 14, C2D_PAIR_ZONE = 15, C2D_PAIR_FIELDS = 16, /* functional nodes; zone */
  /* per element end of a body: entry (element-1)*function_nodes + local */
  C2D_END_X = 100, C2D_END_Y = 101, C2D_END_NODE = 102,
  C2D_END_UX = 103, C2D_END_UY = 104, C2D_END_TX = 105, C2D_END_TY = 106, /* traction per own length */
  C2D_END_STATUS = 107,       /* of the pair at this end, -1: none, as on side 1 of a free zone, whose pairs lie between its nodes
                                 (C2D_PAIR_ELEMENT1)                                                */
  C2D_END_SXX = 108, C2D_END_SYY = 109, C2D_END_SXY = 110, /* stress: from this end's traction and the slope of the displacement
                                 along the boundary, recovered at Gauss points                      */
  C2D_END_SZZ = 111, C2D_END_HOOP = 112, /* out of the plane; normal stress along the boundary      */
  C2D_END_VON_MISES = 113, C2D_END_MAX_SHEAR = 114, C2D_END_PRINCIPAL1 = 115, C2D_END_PRINCIPAL2 = 116,
  /* per geometry node of a body */
  C2D_NODE_X = 120, C2D_NODE_Y = 121,
  /* per pair, no columns of the table: its position on side 1, an element and its local coordinate -1 ... 1 */
  C2D_PAIR_ELEMENT1 = 130, C2D_PAIR_ETA1 = 131,
  /* per element of a body: the point of its surface over the element's middle, METHOD 8.1 */
  C2D_SURFACE_X = 140, C2D_SURFACE_Y = 141
};

/* Columns of c2d_indicators, METHOD 16.6. Contact conditions and equations are satisfied at nodes; at 1/4, 1/2 and 3/4 of every
   element the equations give displacements, and these give gap, penetration and drift. Refine where energies are large: for
   contact tractions CONTACT_ENERGY on both bodies (over LENGTH, where their meshes match, for the mean square error); for the
   rest of a boundary, as for stresses at a notch, EQUATION_ENERGY. They are indicators, not errors or bounds. For a path take
   the largest over its reversals. The cost is three equations per element, and as many for the facing ones (five in free
   zones); many elements in one call cost less than one by one. Nothing else is solved. Elements of zero length, and elements
   replaced by images, have zero energies. */
enum {
  C2D_OFF_LENGTH = 0,         /* of the element                                                     */
  C2D_OFF_ZONE = 1, C2D_OFF_SIDE = 2, /* contact zone and side, 1 or 2; 0: none                     */
  C2D_OFF_STATUSES = 3,       /* sum of 1: partly open, 2: sticks, 4: slips, 8: tied; 0: in no zone */
  C2D_OFF_EQUATION = 4,       /* length: largest deviation from the interpolated displacement       */
  C2D_OFF_GAP = 5,            /* length: largest gap where it is closed, or penetration anywhere    */
  C2D_OFF_DRIFT = 6,          /* length: largest tangential motion where it sticks, without locked-in slip */
  C2D_OFF_EQUATION_ENERGY = 7, C2D_OFF_CONTACT_ENERGY = 8, /* per thickness: of the first, of the other two; the latter also has
                                 pressure times gap where partly open, spare friction times slip where partly sticking */
  C2D_OFF_FIELDS = 9
};

enum { /* c2d_error.status of warnings; src/report/OUTPUT.md explains each of them */
  C2D_WARN_ZONE_END = 201,         /* the last pair at an end of a zone closed: the zone may be too short  */
  C2D_WARN_FEW_PAIRS = 202,        /* fewer than 4 elements from an edge to the peak, or in a zone of slip */
  C2D_WARN_LARGE_SLIP = 203,       /* slip since the last contact exceeds half a contact element            */
  C2D_WARN_NORMALS = 204, C2D_WARN_KINK = 205, /* normals of a pair > 15 degrees apart; a kink > 10 degrees in a zone */
  C2D_WARN_POINT_LOAD = 206,       /* a point load within one element length of the boundary               */
  C2D_WARN_TENSION = 207,          /* pressure inside an element below -1 % of the largest nodal pressure  */
  C2D_WARN_CORNER = 208,           /* one shared unknown traction where the ends' directions differ by > 1 degree */
  C2D_WARN_INCREMENT = 209,        /* an increment of the deck's stepping did not converge; finished by events    */
  C2D_WARN_RESIDUAL = 210, C2D_WARN_CONDITION = 211, /* a limit of accuracy violated; ill-conditioned elimination  */
  C2D_WARN_OFFSET = 212,           /* nodes of a pair are more than half an element apart along the surface */
  C2D_WARN_LEFT_OUT = 213,         /* free zone: an element of side 2 that faces side 1 in part is excluded */
  C2D_WARN_OVERLAP = 214,          /* free zone: an initial overlap below the uncertainty of the surface   */
  C2D_WARN_NOT_UNIQUE = 215, C2D_WARN_UNDEFINED_PLACE = 216, /* several solutions; undetermined position of a body */
  C2D_WARN_STRAIN = 217,           /* strains above 0.05: the theory assumes small strains                 */
  C2D_WARN_FRICTION = 218,         /* a coefficient of friction above 3 (and below 1e6, which is adhesion) */
  C2D_WARN_CONSTANT = 219,         /* constant functions cannot represent a uniform stress                 */
  C2D_WARN_FAR = 220, C2D_WARN_SIZES = 221, /* surfaces stay far apart; elements of unlike length face each other */
  C2D_WARN_SURFACE = 222,          /* the uncertainty of a surface matters compared with the approach      */
  C2D_WARN_ENERGY = 223,           /* between load reversals work and friction differ by more than 10 %     */
  C2D_WARN_UNHELD = 224,           /* motions of bodies without support, tie or possible contact           */
  C2D_WARN_TIE_END = 225,          /* stresses are singular where a tie of unlike materials ends           */
  C2D_WARN_COMPRESSED = 226,       /* the residual of compressed elimination suggests errors above 1e-9    */
  C2D_WARN_BETWEEN = 227,          /* free zone: the bodies overlap between the nodes of side 2             */
  C2D_WARN_SHIFTED = 228,          /* nodes of pairs are shifted along the surface by up to half an element */
  C2D_WARN_OVERLAPPING = 229,      /* bodies overlap outside any zone between them                         */
  C2D_WARN_SIDEWAYS = 230,         /* a pair moved tangentially by more than an element before it touched  */
  C2D_WARN_ROTATION = 231,         /* rotations above 0.1: the theory assumes small rotations              */
  C2D_WARN_SLIT = 232              /* linear functions: a slit in a body is narrower than half an element  */
};

#endif
