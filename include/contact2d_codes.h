/* contact2d: the numbers that calls answer with: what they return, how a path ended, what a warning is about. contact2d.h
   includes it. None of them ever changes; c2d_message and c2d_outcome_message put them into words. */
#ifndef CONTACT2D_CODES_H
#define CONTACT2D_CODES_H

#include <stdint.h>

typedef int32_t c2d_status; /* what a call returns */
enum {
  C2D_OK = 0,
  C2D_ERR_ARGUMENT = 1,       /* a null pointer, a number out of range                              */
  C2D_ERR_STATE = 2,          /* not legal now: table of section 9 in contact2d.h                   */
  C2D_ERR_BUSY = 3,           /* called from inside one of this solver's callbacks                  */
  C2D_ERR_MEMORY = 4,         /* workspace too small; c2d_error.bytes_needed would do               */
  C2D_ERR_OVERFLOW = 5,       /* a number of bytes beyond 64 bits or this machine's addresses       */
  C2D_ERR_LIMIT = 6,          /* more of something than c2d_limits allows                           */
  C2D_ERR_INPUT = 7,          /* the deck or the model is wrong; every fault went to c2d_port.log   */
  C2D_ERR_READ = 8,           /* the caller's read_line failed (c2d_error.host_code)                */
  C2D_ERR_CANCELLED = 9,      /* c2d_port.cancel said so, or c2d_cancel was called                  */
  C2D_ERR_SINGULAR = 10,      /* elimination met a column without a usable pivot                    */
  C2D_ERR_CALLBACK = 11,      /* a caller's function returned non-zero (c2d_error.host_code)        */
  /* The port's own call failed (c2d_error.host_code): */
  C2D_ERR_STORE_OPEN = 20, C2D_ERR_STORE_READ = 21, C2D_ERR_STORE_WRITE = 22, C2D_ERR_STORE_SYNC = 23, C2D_ERR_STORE_CLOSE = 24,
  C2D_ERR_STORE_FORMAT = 30,  /* what was read is no block of ours: never written, or overwritten   */
  C2D_ERR_STORE_VERSION = 31, /* a block of another format version, byte order or scalar size       */
  C2D_ERR_STORE_SHORT = 32,   /* a block shorter or longer than what was written: torn              */
  C2D_ERR_STORE_CHECKSUM = 33,/* a flipped bit in header or data                                    */
  C2D_ERR_STORE_SWAPPED = 34, /* a sound block of another tape or place                             */
  C2D_ERR_STORE_STALE = 35,   /* a sound block of another run or an earlier generation              */
  C2D_ERR_MISMATCH = 40,      /* a saved state of another model, scalar size or format              */
  C2D_ERR_INTERNAL = 99       /* a broken promise inside the library: please report it              */
};

typedef int32_t c2d_outcome; /* how the load path ended; the call itself worked */
enum {
  C2D_REACHED = 0,             /* the load asked for                                                */
  C2D_FREE_MOTION = 1,         /* a body can fly away: nothing holds one of its rigid motions       */
  C2D_GROSS_SLIDING = 2,       /* the whole contact slides: friction can carry no more              */
  C2D_NO_ADMISSIBLE_CHANGE = 3,/* no change of a pair's status leads on                             */
  C2D_NO_PROGRESS = 4,         /* changes of status follow each other without progress              */
  C2D_UNDECIDED = 5,           /* whether the path goes on could not be decided                     */
  C2D_TIPPING = 6,             /* a body turns over: it stays in contact where it turns             */
  C2D_BEYOND_LIMITS = 7        /* what comes next is not accurate enough; this is the last state that is */
};
enum { /* c2d_summary.breach: what was not accurate enough with C2D_BEYOND_LIMITS */
  C2D_BREACH_NONE = 0, C2D_BREACH_TABLEAU = 1, C2D_BREACH_EQUATIONS = 2, /* residual of the contact tableau, of its equations */
  C2D_BREACH_BALANCE = 3,      /* force and moment of the body that contact has to hold             */
  C2D_BREACH_SIGN = 4, C2D_BREACH_CONE = 5, /* pressure or gap below zero; friction above mu times the pressure */
  C2D_BREACH_SLIP = 6,         /* a pair that slips the way its friction pushes                     */
  C2D_BREACH_SINGULAR = 7, C2D_BREACHES = 8 /* no tableau: the statuses leave a motion free         */
};

enum { /* c2d_error.status of warnings; src/report/OUTPUT.md tells what to do about each */
  C2D_WARN_ZONE_END = 201,         /* the last pair at an end of a zone closed: the zone may be too short  */
  C2D_WARN_FEW_PAIRS = 202,        /* fewer than 4 elements from an edge to the peak, or in a zone of slip */
  C2D_WARN_LARGE_SLIP = 203,       /* slip since the pair last touched exceeds half a contact element      */
  C2D_WARN_NORMALS = 204, C2D_WARN_KINK = 205, /* normals of a pair > 15 degrees apart; a kink > 10 degrees in a zone */
  C2D_WARN_POINT_LOAD = 206,       /* a point load within one element length of the boundary               */
  C2D_WARN_TENSION = 207,          /* pressure inside an element below -1 % of the largest nodal pressure  */
  C2D_WARN_CORNER = 208,           /* one shared unknown traction where the ends' directions differ by > 1 degree */
  C2D_WARN_INCREMENT = 209,        /* an increment of the deck's stepping did not converge; finished by events    */
  C2D_WARN_RESIDUAL = 210, C2D_WARN_CONDITION = 211, /* numbers beyond their limits; badly conditioned elimination */
  C2D_WARN_OFFSET = 212,           /* nodes of a pair are more than half an element apart along the surface */
  C2D_WARN_LEFT_OUT = 213,         /* free zone: an element of side 2 that faces side 1 in part is left out */
  C2D_WARN_OVERLAP = 214,          /* free zone: an initial overlap that the elements are too coarse to tell */
  C2D_WARN_NOT_UNIQUE = 215, C2D_WARN_UNDEFINED_PLACE = 216, /* several solutions; nothing fixes where a body is */
  C2D_WARN_STRAIN = 217,           /* strains above 0.05: the results are for small ones                   */
  C2D_WARN_FRICTION = 218,         /* a coefficient of friction above 3 that is not meant as adhesion      */
  C2D_WARN_CONSTANT = 219,         /* constant functions miss even a uniform stress                        */
  C2D_WARN_FAR = 220, C2D_WARN_SIZES = 221, /* surfaces that hardly come nearer; unlike elements face each other */
  C2D_WARN_SURFACE = 222,          /* the error of a surface matters beside how far the bodies come closer */
  C2D_WARN_ENERGY = 223            /* between turns of the loads work and friction differ by more than 10 % */
};

#endif
