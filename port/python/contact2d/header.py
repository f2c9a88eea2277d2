"""The C interface of contact2d, name by name: constants, structs, callbacks and functions of its headers.

Made by port/python/generate.py from the headers; do not edit.
"""

from ctypes import CFUNCTYPE, POINTER, Structure, c_char, c_char_p, c_double, c_int32, c_int64, c_size_t, c_uint32
from ctypes import c_uint64, c_void_p, sizeof
from typing import Any, Dict, List, Tuple


class Struct(Structure):
    """A struct of the interface; one that grows (struct_size) knows its size, as C2D_INIT makes it."""

    def __init__(self, *values, **members):
        if not values and hasattr(type(self), "struct_size"):
            members.setdefault("struct_size", sizeof(self))
        super().__init__(*values, **members)

    def __repr__(self):
        return "%s(%s)" % (type(self).__name__, ", ".join("%s=%r" % (m[0], getattr(self, m[0])) for m in self._fields_))

C2D_OK = 0
C2D_ERR_ARGUMENT = 1
C2D_ERR_STATE = 2
C2D_ERR_BUSY = 3
C2D_ERR_MEMORY = 4
C2D_ERR_OVERFLOW = 5
C2D_ERR_LIMIT = 6
C2D_ERR_INPUT = 7
C2D_ERR_READ = 8
C2D_ERR_CANCELLED = 9
C2D_ERR_SINGULAR = 10
C2D_ERR_CALLBACK = 11
C2D_ERR_STORE_OPEN = 20
C2D_ERR_STORE_READ = 21
C2D_ERR_STORE_WRITE = 22
C2D_ERR_STORE_SYNC = 23
C2D_ERR_STORE_CLOSE = 24
C2D_ERR_STORE_FORMAT = 30
C2D_ERR_STORE_VERSION = 31
C2D_ERR_STORE_SHORT = 32
C2D_ERR_STORE_CHECKSUM = 33
C2D_ERR_STORE_SWAPPED = 34
C2D_ERR_STORE_STALE = 35
C2D_ERR_MISMATCH = 40
C2D_ERR_INTERNAL = 99
C2D_REACHED = 0
C2D_FREE_MOTION = 1
C2D_GROSS_SLIDING = 2
C2D_NO_ADMISSIBLE_CHANGE = 3
C2D_NO_PROGRESS = 4
C2D_UNDECIDED = 5
C2D_TIPPING = 6
C2D_BEYOND_LIMITS = 7
C2D_BREACH_NONE = 0
C2D_BREACH_TABLEAU = 1
C2D_BREACH_EQUATIONS = 2
C2D_BREACH_BALANCE = 3
C2D_BREACH_SIGN = 4
C2D_BREACH_CONE = 5
C2D_BREACH_SLIP = 6
C2D_BREACH_SINGULAR = 7
C2D_BREACHES = 8
C2D_X = 0
C2D_Y = 1
C2D_STATUS = 2
C2D_TN = 3
C2D_TT = 4
C2D_UN1 = 5
C2D_UT1 = 6
C2D_UN2 = 7
C2D_UT2 = 8
C2D_GAP = 9
C2D_SLIP_SUM = 10
C2D_NX = 11
C2D_NY = 12
C2D_PAIR_NODE1 = 13
C2D_PAIR_NODE2 = 14
C2D_PAIR_ZONE = 15
C2D_PAIR_FIELDS = 16
C2D_END_X = 100
C2D_END_Y = 101
C2D_END_NODE = 102
C2D_END_UX = 103
C2D_END_UY = 104
C2D_END_TX = 105
C2D_END_TY = 106
C2D_END_STATUS = 107
C2D_END_SXX = 108
C2D_END_SYY = 109
C2D_END_SXY = 110
C2D_END_SZZ = 111
C2D_END_HOOP = 112
C2D_END_VON_MISES = 113
C2D_END_MAX_SHEAR = 114
C2D_END_PRINCIPAL1 = 115
C2D_END_PRINCIPAL2 = 116
C2D_NODE_X = 120
C2D_NODE_Y = 121
C2D_PAIR_ELEMENT1 = 130
C2D_PAIR_ETA1 = 131
C2D_SURFACE_X = 140
C2D_SURFACE_Y = 141
C2D_OFF_LENGTH = 0
C2D_OFF_ZONE = 1
C2D_OFF_SIDE = 2
C2D_OFF_STATUSES = 3
C2D_OFF_EQUATION = 4
C2D_OFF_GAP = 5
C2D_OFF_DRIFT = 6
C2D_OFF_EQUATION_ENERGY = 7
C2D_OFF_CONTACT_ENERGY = 8
C2D_OFF_FIELDS = 9
C2D_WARN_ZONE_END = 201
C2D_WARN_FEW_PAIRS = 202
C2D_WARN_LARGE_SLIP = 203
C2D_WARN_NORMALS = 204
C2D_WARN_KINK = 205
C2D_WARN_POINT_LOAD = 206
C2D_WARN_TENSION = 207
C2D_WARN_CORNER = 208
C2D_WARN_INCREMENT = 209
C2D_WARN_RESIDUAL = 210
C2D_WARN_CONDITION = 211
C2D_WARN_OFFSET = 212
C2D_WARN_LEFT_OUT = 213
C2D_WARN_OVERLAP = 214
C2D_WARN_NOT_UNIQUE = 215
C2D_WARN_UNDEFINED_PLACE = 216
C2D_WARN_STRAIN = 217
C2D_WARN_FRICTION = 218
C2D_WARN_CONSTANT = 219
C2D_WARN_FAR = 220
C2D_WARN_SIZES = 221
C2D_WARN_SURFACE = 222
C2D_WARN_ENERGY = 223
C2D_WARN_UNHELD = 224
C2D_WARN_TIE_END = 225
C2D_WARN_COMPRESSED = 226
C2D_WARN_BETWEEN = 227
C2D_WARN_SHIFTED = 228
C2D_WARN_OVERLAPPING = 229
C2D_WARN_SIDEWAYS = 230
C2D_WARN_ROTATION = 231
C2D_WARN_SLIT = 232
C2D_VERSION_MAJOR = 0
C2D_VERSION_MINOR = 2
C2D_VERSION_PATCH = 0
C2D_OPEN = 0
C2D_STICK = 1
C2D_SLIP = 2
C2D_TIED = 3
C2D_PLANE_STRAIN = 0
C2D_PLANE_STRESS = 1
C2D_AXISYMMETRIC = 2
C2D_NOTE = 0
C2D_WARNING = 1
C2D_FAULT = 2


class c2d_error(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("status", c_int32),
        ("severity", c_int32),
        ("host_code", c_int32),
        ("line", c_int32),
        ("column", c_int32),
        ("column_end", c_int32),
        ("body", c_int32),
        ("zone", c_int32),
        ("pair", c_int32),
        ("element", c_int32),
        ("node", c_int32),
        ("tape", c_int32),
        ("block", c_int64),
        ("bytes_needed", c_uint64),
        ("load", c_double),
        ("text", c_char * 320),
    ]


class c2d_body_limits(Struct):
    _fields_ = [
        ("points", c_int32),
        ("elements", c_int32),
        ("regions", c_int32),
        ("reserved", c_int32),
    ]


class c2d_limits(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("bodies", c_int32),
        ("body", POINTER(c2d_body_limits)),
        ("function_nodes", c_int32),
        ("zones", c_int32),
        ("pairs", c_int32),
        ("contact_elements", c_int32),
        ("point_loads", c_int32),
        ("coefficients", c_int32),
        ("paths", c_int32),
        ("load_cases", c_int32),
        ("panel_columns", c_int32),
        ("free_pairs", c_int32),
        ("point_sets", c_int32),
        ("curves", c_int32),
        ("platens", c_int32),
        ("touching", c_int32),
        ("cycle_states", c_int32),
        ("reserved", c_int32),
    ]


class c2d_progress(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("phase", c_int32),
        ("body", c_int32),
        ("done", c_int64),
        ("total", c_int64),
        ("load", c_double),
        ("target", c_double),
    ]


C2D_PHASE_READ = 0
C2D_PHASE_ASSEMBLE = 1
C2D_PHASE_ELIMINATE = 2
C2D_PHASE_REDUCE = 3
C2D_PHASE_CONTACT = 4
C2D_PHASE_BACK = 5
C2D_PHASE_WRITE = 6
C2D_PHASES = 7
C2D_TAPE_CONTROL = 0
C2D_TAPE_LOWER = 1
C2D_TAPE_UPPER = 2
C2D_TAPE_CONTACT = 3
C2D_TAPES = 4


class c2d_port(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("context", c_void_p),
        ("open", CFUNCTYPE(c_int32, c_void_p, c_int32, c_uint64, c_uint64)),
        ("read", CFUNCTYPE(c_int32, c_void_p, c_int32, c_uint64, c_void_p, c_uint64)),
        ("write", CFUNCTYPE(c_int32, c_void_p, c_int32, c_uint64, c_void_p, c_uint64)),
        ("sync", CFUNCTYPE(c_int32, c_void_p, c_int32)),
        ("close", CFUNCTYPE(c_int32, c_void_p, c_int32)),
        ("start_read", CFUNCTYPE(c_int32, c_void_p, c_int32, c_uint64, c_void_p, c_uint64, POINTER(c_int32))),
        ("start_write", CFUNCTYPE(c_int32, c_void_p, c_int32, c_uint64, c_void_p, c_uint64, POINTER(c_int32))),
        ("wait", CFUNCTYPE(c_int32, c_void_p, c_int32)),
        ("parallel_for", CFUNCTYPE(None, c_void_p, c_int32, CFUNCTYPE(None, c_void_p, c_int32), c_void_p)),
        ("progress", CFUNCTYPE(None, c_void_p, POINTER(c2d_progress))),
        ("cancel", CFUNCTYPE(c_int32, c_void_p)),
        ("log", CFUNCTYPE(None, c_void_p, POINTER(c2d_error))),
        ("clock", CFUNCTYPE(c_double, c_void_p)),
        ("threads", c_int32),
    ]


c2d_read_line = CFUNCTYPE(c_int32, c_void_p, c_void_p, c_int32)
c2d_report = CFUNCTYPE(None, c_void_p, POINTER(c2d_error))
C2D_ANALYSIS_CHECK = -1
C2D_ANALYSIS_STRESS = 0
C2D_ANALYSIS_CONTACT = 1
C2D_ANALYSIS_FULL = 2
C2D_ANALYSIS_ITERATIONS = 3


class c2d_problem(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("plane", c_int32),
        ("analysis", c_int32),
        ("iteration_limit", c_int32),
        ("title", c_char * 80),
    ]


class c2d_body(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("element_nodes", c_int32),
        ("elements", c_int32),
        ("regions", c_int32),
        ("youngs_modulus", c_double),
        ("poisson_ratio", c_double),
        ("open_regions", c_int32),
        ("reserved", c_int32),
    ]


C2D_ZONE_MATCHING = 0
C2D_ZONE_FREE = 1
C2D_ZONE_TIED = 2
C2D_ZONE_SELF = 4


class c2d_side(Struct):
    _fields_ = [
        ("body", c_int32),
        ("first_element", c_int32),
        ("last_element", c_int32),
        ("elements", c_int32),
        ("first_node", c_int32),
        ("last_node", c_int32),
    ]


class c2d_zone(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("pairs", c_int32),
        ("side1", c2d_side),
        ("side2", c2d_side),
    ]


C2D_CURVE_LINE = 0
C2D_CURVE_ARC = 1
C2D_CURVE_SPLINE = 2


class c2d_curve(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("body", c_int32),
        ("first_element", c_int32),
        ("last_element", c_int32),
        ("line", c_int32),
        ("centre", c_double * 2),
        ("radius", c_double),
    ]


C2D_POINTS_ONE = 0
C2D_POINTS_LINE = 1
C2D_POINTS_GRID = 2


class c2d_points(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("body", c_int32),
        ("count", c_int32 * 2),
        ("line", c_int32),
        ("from", c_double * 2),
        ("to", c_double * 2),
    ]


C2D_NAME_BODY = 0
C2D_NAME_ZONE = 1
C2D_QUADRATURE_ACCURATE = 0
C2D_QUADRATURE_THESIS = 1
C2D_STEPPING_EVENTS = 0
C2D_STEPPING_DECK = 1
C2D_SYMMETRY_DECK = 0
C2D_SYMMETRY_IMAGES = 1
C2D_ELIMINATION_DENSE = 0
C2D_ELIMINATION_COMPRESSED = 1
C2D_ELIMINATION_BY_SIZE = 2


class c2d_options(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("quadrature", c_int32),
        ("stepping", c_int32),
        ("every_change", c_int32),
        ("symmetry", c_int32),
        ("keep_factors", c_int32),
        ("elimination", c_int32),
    ]


C2D_STEP_RECORDED = 0
C2D_STEP_CHANGE = 1
C2D_STEP_STOPPED = 2
C2D_STEP_CYCLE = 3


class c2d_step(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("coefficient", c_int32),
        ("step", c_int32),
        ("pairs", c_int32),
        ("changes", c_int32),
        ("iterations", c_int32),
        ("outcome", c_int32),
        ("stride", c_int64),
        ("mu", c_double),
        ("load", c_double),
        ("table", POINTER(c_double)),
        ("cases", c_int32),
        ("reserved", c_int32),
        ("loads", POINTER(c_double)),
        ("work_by_case", POINTER(c_double)),
        ("work", c_double),
        ("dissipated", c_double),
        ("elastic", c_double),
        ("energy_defect", c_double),
    ]


c2d_step_fn = CFUNCTYPE(c_int32, c_void_p, POINTER(c2d_step))
C2D_POINT_UX = 0
C2D_POINT_UY = 1
C2D_POINT_SXX = 2
C2D_POINT_SYY = 3
C2D_POINT_SXY = 4
C2D_POINT_SZZ = 5
C2D_POINT_VON_MISES = 6
C2D_POINT_MAX_SHEAR = 7
C2D_POINT_PRINCIPAL1 = 8
C2D_POINT_PRINCIPAL2 = 9
C2D_POINT_FLAG = 10
C2D_POINT_FIELDS = 11
C2D_POINT_INSIDE = 0
C2D_POINT_NEAR_NODE = 1
C2D_POINT_BOUNDARY = 2
C2D_POINT_OUTSIDE = 3


class c2d_summary(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("state", c_int32),
        ("outcome", c_int32),
        ("outcome_body", c_int32),
        ("outcome_pair", c_int32),
        ("bodies", c_int32),
        ("function_nodes", c_int32),
        ("pairs", c_int32),
        ("zones", c_int32),
        ("steps", c_int32),
        ("coefficients", c_int32),
        ("contact_unknowns", c_int32),
        ("analysis", c_int32),
        ("plane", c_int32),
        ("stepping", c_int32),
        ("quadrature", c_int32),
        ("iteration_limit", c_int32),
        ("paths", c_int32),
        ("panel_columns", c_int32),
        ("warnings", c_int32),
        ("events", c_int64),
        ("exchanges", c_int64),
        ("tableau_rebuilds", c_int64),
        ("minimum_bytes", c_uint64),
        ("in_core_bytes", c_uint64),
        ("workspace_bytes", c_uint64),
        ("peak_bytes", c_uint64),
        ("tape_blocks", c_uint64 * 4),
        ("tape_bytes_written", c_uint64 * 4),
        ("tape_bytes_read", c_uint64 * 4),
        ("tape_writes", c_uint64 * 4),
        ("tape_reads", c_uint64 * 4),
        ("seconds", c_double * 7),
        ("load", c_double),
        ("mu", c_double),
        ("max_residual", c_double),
        ("elimination_residual", c_double),
        ("condition", c_double),
        ("force_applied", c_double),
        ("force_contact", c_double),
        ("force_error", c_double),
        ("free_motion", c_double * 3),
        ("tension_ratio", c_double),
        ("title", c_char * 80),
        ("unit_length", c_char * 16),
        ("unit_force", c_char * 16),
        ("load_cases", c_int32),
        ("run_coefficient", c_int32),
        ("work", c_double),
        ("dissipated", c_double),
        ("elastic", c_double),
        ("energy_defect", c_double),
        ("least_dissipation", c_double),
        ("symmetry", c_int32),
        ("breach", c_int32),
        ("symmetry_at", c_double * 2),
        ("breach_size", c_double),
        ("point_loads", c_int32),
        ("point_sets", c_int32),
        ("curves", c_int32),
        ("run_step", c_int32),
        ("compressed_bodies", c_int32),
        ("reserved", c_int32),
        ("compression_residual", c_double),
        ("compression_error", c_double),
    ]


class c2d_body_result(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("element_nodes", c_int32),
        ("elements", c_int32),
        ("regions", c_int32),
        ("open_regions", c_int32),
        ("points", c_int32),
        ("nodes", c_int32),
        ("unknowns", c_int32),
        ("youngs_modulus", c_double),
        ("poisson_ratio", c_double),
        ("applied", c_double * 3),
        ("contact", c_double * 3),
    ]


class c2d_zone_state(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("open", c_int32),
        ("stick", c_int32),
        ("slip", c_int32),
        ("near_change", c_int32),
        ("reserved", c_int32),
        ("force", c_double * 2),
        ("moment", c_double),
        ("approach", c_double),
        ("shift", c_double),
        ("largest_pressure", c_double),
        ("largest_friction", c_double),
        ("length", c_double),
        ("dissipated", c_double),
    ]


class c2d_body_state(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("is_rigid", c_int32),
        ("contact", c_double * 3),
        ("motion", c_double * 3),
        ("point", c_double * 2),
        ("load", c_double * 3),
    ]


C2D_STATE_EMPTY = 0
C2D_STATE_BUILDING = 1
C2D_STATE_MODEL = 2
C2D_STATE_PREPARED = 3
C2D_STATE_RUNNING = 4
C2D_STATE_BROKEN = 5
C2D_CARD_FREE = 0
C2D_CARD_HEADING = 1
C2D_CARD_INTEGER = 2
C2D_CARD_REAL = 3
C2D_CARD_LETTER = 4
C2D_CARD_REMARK = 5
C2D_CARD_COMMENT = 6
C2D_CARD_EXTENSION = 7


class c2d_card(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("kind", c_int32),
        ("line", c_int32),
        ("column", c_int32),
        ("width", c_int32),
        ("length", c_int32),
        ("text", c_void_p),
        ("value", c_double),
    ]


c2d_card_fn = CFUNCTYPE(None, c_void_p, POINTER(c2d_card))
C2D_CYCLES_EXACT = 0
C2D_CYCLES_PLAIN = 1
C2D_CYCLES_FAST = 2


class c2d_cycle_request(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("corners", c_int32),
        ("cases", c_int32),
        ("limit", c_int32),
        ("mode", c_int32),
        ("reserved", c_int32),
        ("tolerance", c_double),
        ("load", POINTER(c_double)),
    ]


C2D_CYCLE_NOT_STEADY = 0
C2D_CYCLE_SHAKES_DOWN = 1
C2D_CYCLE_SLIPS = 2
C2D_CYCLE_RATCHETS = 3
C2D_CYCLE_STOPPED = 4


class c2d_cycle_state(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("result", c_int32),
        ("outcome", c_int32),
        ("cycles", c_int32),
        ("extrapolations", c_int32),
        ("repeated", c_int32),
        ("stuck", c_int32),
        ("slipped", c_int32),
        ("range_pair", c_int32),
        ("walk_pair", c_int32),
        ("change", c_double),
        ("dissipated", c_double),
        ("slip_range", c_double),
        ("walk", c_double),
    ]


c2d_cycle_fn = CFUNCTYPE(c_int32, c_void_p, POINTER(c2d_cycle_state))
C2D_START_AS_LOADED = 0
C2D_START_WITHOUT_FRICTION = 1
C2D_START_COMPARED = 2
C2D_CYCLE_RANGE = 0
C2D_CYCLE_WALK = 1
C2D_CYCLE_STUCK = 2
C2D_CYCLE_TOUCHED = 3


class c2d_cycle_zone(Struct):
    _fields_ = [
        ("struct_size", c_uint32),
        ("touched", c_int32),
        ("stuck", c_int32),
        ("slipped", c_int32),
        ("walk", c_double),
        ("slip_range", c_double),
    ]


C2D_MEMORY_STORE_FULL = 1
C2D_MEMORY_STORE_TAPE = 2
C2D_MEMORY_STORE_RANGE = 3


class c2d_memory_store(Struct):
    _fields_ = [
        ("region", c_void_p),
        ("bytes", c_uint64),
        ("used", c_uint64),
        ("offset", c_uint64 * C2D_TAPES),
        ("room", c_uint64 * C2D_TAPES),
        ("blocks", c_uint64 * C2D_TAPES),
        ("block_bytes", c_uint64 * C2D_TAPES),
        ("wanted", c_uint64 * C2D_TAPES),
        ("is_open", c_int32 * C2D_TAPES),
    ]


C2D_POSIX_STORE_FOLDER = "contact2d.store"
C2D_POSIX_STORE_TAPE = -1
C2D_POSIX_STORE_RANGE = -2
C2D_POSIX_STORE_END = -3
C2D_POSIX_STORE_LOCKED = -4
C2D_POSIX_STORE_STUCK = -5
C2D_POSIX_STORE_TICKET = -6
C2D_POSIX_STORE_FOREIGN = -7


class c2d_posix_store(Struct):
    _fields_ = [
        ("parent", c_int32),
        ("folder", c_int32),
        ("lock", c_int32),
        ("file", c_int32 * C2D_TAPES),
        ("blocks", c_uint64 * C2D_TAPES),
        ("block_bytes", c_uint64 * C2D_TAPES),
        ("helper", c_void_p),
        ("expected", c_uint64 * C2D_TAPES),
    ]


C2D_STDIO_STORE_TAPE = -1
C2D_STDIO_STORE_RANGE = -2
C2D_STDIO_STORE_END = -3
C2D_STDIO_STORE_FAILED = -4
C2D_STDIO_STORE_NAME = -5


class c2d_stdio_store(Struct):
    _fields_ = [
        ("folder", c_char * 1000),
        ("file", c_void_p * C2D_TAPES),
        ("blocks", c_uint64 * C2D_TAPES),
        ("block_bytes", c_uint64 * C2D_TAPES),
    ]


C2D_THREADS_MOST = 64


class c2d_threads(Struct):
    _fields_ = [
        ("room", c_uint64 * 192),
    ]


c2d_threads_task = CFUNCTYPE(None, c_void_p, c_int32)


# Of every function: what it returns; name, type, whether it is only read, and length of every argument; the
# declaration and the header's comment.
FUNCTIONS: Dict[str, Tuple[Any, List[Tuple[str, Any, bool, Any]], str]] = {
    "c2d_memory_need": (c_int32, [
        ("limits", POINTER(c2d_limits), True, None),
        ("minimum", POINTER(c_uint64), False, None),
        ("in_core", POINTER(c_uint64), False, None),
        ("why", POINTER(c2d_error), False, None),
    ], """c2d_status c2d_memory_need(const c2d_limits* limits, uint64_t* minimum, uint64_t* in_core, c2d_error* why);

Bytes of workspace: `minimum` solves any model within the limits in the smallest blocks (stacked slender bodies: c2d_prepare reports), `in_core` stores the whole matrix of a body; threads use more. Outputs, why may be null. Errors: OVERFLOW."""),
    "c2d_create": (c_int32, [
        ("out", POINTER(c_void_p), False, None),
        ("memory", c_void_p, False, None),
        ("bytes", c_size_t, False, None),
        ("limits", POINTER(c2d_limits), True, None),
        ("port", POINTER(c2d_port), True, None),
        ("why", POINTER(c2d_error), False, None),
    ], """c2d_status c2d_create(c2d_solver** out, void* memory, size_t bytes, const c2d_limits* limits, const c2d_port* port, c2d_error* why);

Create a solver in memory[0 .. bytes), in state empty; *out points into it. `port` is copied, its context must stay valid; null: no store, the model can only be checked. `why` may be null. Errors: OVERFLOW, MEMORY with why->bytes_needed."""),
    "c2d_attach": (c_int32, [
        ("out", POINTER(c_void_p), False, None),
        ("memory", c_void_p, False, None),
        ("bytes", c_size_t, False, None),
        ("port", POINTER(c2d_port), True, None),
        ("why", POINTER(c2d_error), False, None),
    ], """c2d_status c2d_attach(c2d_solver** out, void* memory, size_t bytes, const c2d_port* port, c2d_error* why);

Continue with a solver whose memory was moved, reloaded or passed to another process of the same build: memory[0 .. bytes) is a copy, made between calls, of all the memory given to c2d_create, at any alignment, possibly longer. It continues with identical results; every earlier c2d_solver* is invalid. `port` reopens the tapes that were open; their contents must be unchanged. On failure the image can still be attached. Its data are trusted: contact2d_image.h attaches by checksum. Errors: ARGUMENT: the memory has no solver; MISMATCH: one of another version, size of pointers or scalar, or prepared by a program linked without energies; MEMORY with why->bytes_needed; BUSY: copied inside a callback; STORE_OPEN."""),
    "c2d_close": (c_int32, [
        ("solver", c_void_p, False, None),
    ], """c2d_status c2d_close(c2d_solver* solver);

Close the store (Errors: STORE_CLOSE). The memory belongs to the caller again, whatever the call returns."""),
    "c2d_scan_deck": (c_int32, [
        ("read", c2d_read_line, False, None),
        ("context", c_void_p, False, None),
        ("out", POINTER(c2d_limits), False, None),
        ("why", POINTER(c2d_error), False, None),
    ], """c2d_status c2d_scan_deck(c2d_read_line read, void* context, c2d_limits* out, c2d_error* why);

Sizes of a deck, without a workspace: fills *out and out->body, an array for out->bodies bodies. c2d_read_deck may still refuse a deck that passes. c2d_scan_deck puts the first fault into *why, c2d_check_deck passes every fault to `report`; either may be null. Errors: INPUT, READ: out->body is undefined; LIMIT: only out->bodies is set, to the number of bodies."""),
    "c2d_check_deck": (c_int32, [
        ("read", c2d_read_line, False, None),
        ("context", c_void_p, False, None),
        ("out", POINTER(c2d_limits), False, None),
        ("report", c2d_report, False, None),
        ("report_context", c_void_p, False, None),
    ], """c2d_status c2d_check_deck(c2d_read_line read, void* context, c2d_limits* out, c2d_report report, void* report_context);"""),
    "c2d_read_deck": (c_int32, [
        ("solver", c_void_p, False, None),
        ("read", c2d_read_line, False, None),
        ("context", c_void_p, False, None),
    ], """c2d_status c2d_read_deck(c2d_solver* solver, c2d_read_line read, void* context);

Read a whole deck and complete the model; c2d_port.log receives all faults. Errors: INPUT, READ, LIMIT."""),
    "c2d_set_problem": (c_int32, [
        ("solver", c_void_p, False, None),
        ("problem", POINTER(c2d_problem), True, None),
    ], """c2d_status c2d_set_problem(c2d_solver* solver, const c2d_problem* problem);"""),
    "c2d_set_body": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("data", POINTER(c2d_body), True, None),
    ], """c2d_status c2d_set_body(c2d_solver* solver, int32_t body, const c2d_body* data);

A second call may change the moduli, not the numbers of elements or regions."""),
    "c2d_add_region": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("first_element", c_int32, False, None),
        ("last_element", c_int32, False, None),
    ], """c2d_status c2d_add_region(c2d_solver* solver, int32_t body, int32_t first_element, int32_t last_element);

Elements first ... last form a closed curve, or an open one; regions follow one another without a gap."""),
    "c2d_set_nodes": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("first", c_int32, False, None),
        ("count", c_int32, False, None),
        ("xy", POINTER(c_double), True, None),
        ("stride", c_int64, False, None),
    ], """c2d_status c2d_set_nodes(c2d_solver* solver, int32_t body, int32_t first, int32_t count, const double* xy, int64_t stride);

Boundary points first ... first+count-1: x and y of the k-th at xy[k * stride], xy[k * stride + 1], in global coordinates. Element e of a region has its first geometry node at (e-1)*(element_nodes-1)+1, plus the open regions before it."""),
    "c2d_set_line_nodes": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("first", c_int32, False, None),
        ("last", c_int32, False, None),
        ("origin", POINTER(c_double), True, 2),
        ("from", POINTER(c_double), True, 2),
        ("to", POINTER(c_double), True, 2),
    ], """c2d_status c2d_set_line_nodes(c2d_solver* solver, int32_t body, int32_t first, int32_t last, const double origin[2], const double from[2], const double to[2]);

Boundary points first ... last, both ends included, at equal distances along a straight line, or along an arc between two angles (degrees, counter-clockwise from the x axis; downwards if the second is smaller), as between two node cards of a deck, with identical bits. `from` and `to` are relative to `origin` (null: (0, 0)). last > first, radius >= 0."""),
    "c2d_set_arc_nodes": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("first", c_int32, False, None),
        ("last", c_int32, False, None),
        ("centre", POINTER(c_double), True, 2),
        ("radius", c_double, False, None),
        ("from_degrees", c_double, False, None),
        ("to_degrees", c_double, False, None),
    ], """c2d_status c2d_set_arc_nodes(c2d_solver* solver, int32_t body, int32_t first, int32_t last, const double centre[2], double radius, double from_degrees, double to_degrees);"""),
    "c2d_set_condition": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("element", c_int32, False, None),
        ("local", c_int32, False, None),
        ("load_case", c_int32, False, None),
        ("codes", POINTER(c_int32), True, 4),
        ("values", POINTER(c_double), True, 4),
    ], """c2d_status c2d_set_condition(c2d_solver* solver, int32_t body, int32_t element, int32_t local, int32_t load_case, const int32_t codes[4], const double values[4]);

Condition at local functional node `local` of an element: codes[4] and values[4] in the order tx ty ux uy, global components; code 0: known, with this value; 1: unknown. Ends without a condition are free of traction. The contact determines the traction at the ends of its pairs: a prescribed one is refused. All values scale with the factor of the load case."""),
    "c2d_set_values": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("element", c_int32, False, None),
        ("local", c_int32, False, None),
        ("load_case", c_int32, False, None),
        ("values", POINTER(c_double), True, 4),
    ], """c2d_status c2d_set_values(c2d_solver* solver, int32_t body, int32_t element, int32_t local, int32_t load_case, const double values[4]);

Prescribed values of an end in a load case: values[4] as above; the codes stay. local 0: all ends of the element. Refused are a non-zero value of an unknown or a contact quantity, and a displacement that differs from that of the other end at the same node (while building 0 leaves it unchanged). In state model every known quantity takes its value, zero included; displacements of contact nodes and those fixed by symmetry are then refused as well."""),
    "c2d_add_point_load": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("load_case", c_int32, False, None),
        ("x", c_double, False, None),
        ("y", c_double, False, None),
        ("fx", c_double, False, None),
        ("fy", c_double, False, None),
    ], """c2d_status c2d_add_point_load(c2d_solver* solver, int32_t body, int32_t load_case, double x, double y, double fx, double fy);

Force (fx, fy) at (x, y) inside the body; axisymmetric: of the circle. On a line of symmetry: along it, the part's share."""),
    "c2d_set_body_force": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("load_case", c_int32, False, None),
        ("force", POINTER(c_double), True, 2),
        ("rho_omega2", c_double, False, None),
        ("axis", POINTER(c_double), True, 2),
    ], """c2d_status c2d_set_body_force(c2d_solver* solver, int32_t body, int32_t load_case, const double force[2], double rho_omega2, const double axis[2]);

Body force per area, of bodies of revolution per volume: `force` (weight) plus rho_omega2 (x - axis[0], y - axis[1]), density times angular velocity squared; axis may be null where rho_omega2 is 0. One per body and load case, a second call replaces the first. Across a line of symmetry, or the axis x = 0, acts no weight, and `axis` must lie on the line. METHOD 6."""),
    "c2d_set_rigid": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("load_case", c_int32, False, None),
        ("motion", POINTER(c_double), True, 3),
        ("axis", POINTER(c_double), True, 2),
    ], """c2d_status c2d_set_rigid(c2d_solver* solver, int32_t body, int32_t load_case, const double motion[3], const double axis[2]);

Make the body rigid: it has no equations and moduli, its mesh defines frames and lengths. In a load case it moves by motion[0], motion[1] and rotates by the small angle motion[2] about axis[0], axis[1]; load_case 0 only makes it rigid, and both arrays may be null. Conditions are ignored; c2d_complete refuses tractions and forces on it, and a zone of two rigid bodies. Results: its motion, contact tractions, no stresses; `applied` is the load or reaction on it."""),
    "c2d_set_rigid_load": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("load_case", c_int32, False, None),
        ("is_free", POINTER(c_int32), True, 3),
        ("load", POINTER(c_double), True, 3),
        ("point", POINTER(c_double), True, 2),
    ], """c2d_status c2d_set_rigid_load(c2d_solver* solver, int32_t body, int32_t load_case, const int32_t is_free[3], const double load[3], const double point[2]);

Motions i = 0 to 2 of a rigid body (ux, uy, rotation of `point`) with is_free[i] != 0 are free: equilibrium with the contact and load[0 .. 3) determines them. The load is fx, fy and the moment about `point`; only components of free motions count. load_case 0 sets is_free and point (and makes the body rigid), other cases set the load; the other arguments are ignored."""),
    "c2d_add_platen": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("first_element", c_int32, False, None),
        ("last_element", c_int32, False, None),
        ("elements", c_int32, False, None),
        ("is_free", POINTER(c_int32), True, 3),
        ("point", POINTER(c_double), True, 2),
    ], """c2d_status c2d_add_platen(c2d_solver* solver, int32_t body, int32_t first_element, int32_t last_element, int32_t elements, const int32_t is_free[3], const double point[2]);

A platen: elements first ... last (across the end of a closed region with their number `elements`, else 0) move as one rigid body without a mesh: body c2d_limits.bodies + 1, + 2, ..., "platen 1", ...; its tie is the next zone, the platen its side 1. is_free and point as above; the two calls above move and load it. Its ends have no conditions, no contact. METHOD 10.8."""),
    "c2d_set_interference": (c_int32, [
        ("solver", c_void_p, False, None),
        ("load_case", c_int32, False, None),
    ], """c2d_status c2d_set_interference(c2d_solver* solver, int32_t load_case);

Interference of a press fit: pairs that overlap before any load are legal and begin in contact; the factor of this load case removes their overlap, completely at factor 1. c2d_run raises it from 0 to 1 before the first step of the path and keeps it there; with c2d_advance the caller sets it. A second call replaces the first."""),
    "c2d_add_zone": (c_int32, [
        ("solver", c_void_p, False, None),
        ("zone", POINTER(c2d_zone), True, None),
    ], """c2d_status c2d_add_zone(c2d_solver* solver, const c2d_zone* zone);"""),
    "c2d_tie_zone": (c_int32, [
        ("solver", c_void_p, False, None),
        ("zone", c_int32, False, None),
    ], """c2d_status c2d_tie_zone(c2d_solver* solver, int32_t zone);

Bond zone i (from 1): it carries unlimited tension and shear and never changes its status. Its surfaces must coincide within a tenth of an element; their distance is not a gap. Pairs of such zones are numbered after all others."""),
    "c2d_add_curve": (c_int32, [
        ("solver", c_void_p, False, None),
        ("curve", POINTER(c2d_curve), True, None),
    ], """c2d_status c2d_add_curve(c2d_solver* solver, const c2d_curve* curve);"""),
    "c2d_add_friction": (c_int32, [
        ("solver", c_void_p, False, None),
        ("mu", c_double, False, None),
    ], """c2d_status c2d_add_friction(c2d_solver* solver, double mu);

A coefficient for c2d_run, zero or more, infinity: full adhesion; c2d_set_zone_friction: of one zone, in the i-th run."""),
    "c2d_set_zone_friction": (c_int32, [
        ("solver", c_void_p, False, None),
        ("zone", c_int32, False, None),
        ("i", c_int32, False, None),
        ("mu", c_double, False, None),
    ], """c2d_status c2d_set_zone_friction(c2d_solver* solver, int32_t zone, int32_t i, double mu);"""),
    "c2d_set_symmetry": (c_int32, [
        ("solver", c_void_p, False, None),
        ("axis", c_int32, False, None),
        ("value", c_double, False, None),
    ], """c2d_status c2d_set_symmetry(c2d_solver* solver, int32_t axis, double value);

Symmetry by images (METHOD 5): the model is mirrored across the line x = value (axis 0) or y = value (axis 1), at most one of each. Model one half (one quarter) without elements on the lines: a curve that crosses a line is an open region that ends on the lines; the image of a body that meets no line is another body. Open regions come first in a body (c2d_body.open_regions), and have one boundary point and, except with constant elements, one functional node more. The displacement across a line is 0; other conditions are as usual. Forces and moments are those of the modelled part."""),
    "c2d_add_path": (c_int32, [
        ("solver", c_void_p, False, None),
        ("increments", c_int32, False, None),
        ("load", POINTER(c_double), True, None),
        ("cases", c_int32, False, None),
    ], """c2d_status c2d_add_path(c2d_solver* solver, int32_t increments, const double* load, int32_t cases);

A straight segment of the load path, in `increments` equal steps from the end of the last segment (first: zero) to load[0 .. cases), a factor for every load case. c2d_clear_paths removes all segments."""),
    "c2d_clear_paths": (c_int32, [
        ("solver", c_void_p, False, None),
    ], """c2d_status c2d_clear_paths(c2d_solver* solver);"""),
    "c2d_add_points": (c_int32, [
        ("solver", c_void_p, False, None),
        ("points", POINTER(c2d_points), True, None),
    ], """c2d_status c2d_add_points(c2d_solver* solver, const c2d_points* points);"""),
    "c2d_set_units": (c_int32, [
        ("solver", c_void_p, False, None),
        ("length", c_char_p, True, None),
        ("force", c_char_p, True, None),
    ], """c2d_status c2d_set_units(c2d_solver* solver, const char* length, const char* force);

Names of the units of length and force for axis titles, each at most 15 characters; null: empty. Nothing is converted."""),
    "c2d_set_name": (c_int32, [
        ("solver", c_void_p, False, None),
        ("kind", c_int32, False, None),
        ("i", c_int32, False, None),
        ("name", c_char_p, True, None),
    ], """c2d_status c2d_set_name(c2d_solver* solver, int32_t kind, int32_t i, const char* name);"""),
    "c2d_get_name": (c_int32, [
        ("solver", c_void_p, False, None),
        ("kind", c_int32, False, None),
        ("i", c_int32, False, None),
        ("out", POINTER(c_char), False, 32),
    ], """c2d_status c2d_get_name(c2d_solver* solver, int32_t kind, int32_t i, char out[32]);"""),
    "c2d_set_line": (c_int32, [
        ("solver", c_void_p, False, None),
        ("line", c_int32, False, None),
        ("column", c_int32, False, None),
        ("column_end", c_int32, False, None),
    ], """c2d_status c2d_set_line(c2d_solver* solver, int32_t line, int32_t column, int32_t column_end);

Position in the caller's input that later faults report; 0: none."""),
    "c2d_complete": (c_int32, [
        ("solver", c_void_p, False, None),
    ], """c2d_status c2d_complete(c2d_solver* solver);

Validate the model; c2d_port.log receives every fault. Errors: INPUT."""),
    "c2d_set_options": (c_int32, [
        ("solver", c_void_p, False, None),
        ("options", POINTER(c2d_options), True, None),
    ], """c2d_status c2d_set_options(c2d_solver* solver, const c2d_options* options);

Any time before c2d_prepare; another `symmetry` for a complete model: STATE."""),
    "c2d_tape_need": (c_int32, [
        ("limits", POINTER(c2d_limits), True, None),
        ("options", POINTER(c2d_options), True, None),
        ("workspace_bytes", c_uint64, False, None),
        ("tape", c_int32, False, None),
        ("blocks", POINTER(c_uint64), False, None),
        ("block_bytes", POINTER(c_uint64), False, None),
        ("why", POINTER(c2d_error), False, None),
    ], """c2d_status c2d_tape_need(const c2d_limits* limits, const c2d_options* options, uint64_t workspace_bytes, int32_t tape, uint64_t* blocks, uint64_t* block_bytes, c2d_error* why);

Number of blocks, and bytes of each, for which the store must provide space when a tape (0 ... C2D_TAPES-1) is opened by a solver of these limits and workspace_bytes: upper bounds for any model within the limits, saved states included. `options`, outputs and `why` may be null. Errors: OVERFLOW, MEMORY with why->bytes_needed."""),
    "c2d_prepare": (c_int32, [
        ("solver", c_void_p, False, None),
    ], """c2d_status c2d_prepare(c2d_solver* solver);

---------------------------------------------------------------- 6 prepare ------------------------------------ Assemble (METHOD 2), eliminate the unknowns outside the contact (METHOD 7), reduce to the contact unknowns (METHOD 10), once per model. State afterwards: prepared; after a failure or a cancel: model. A body that contact cannot support is no error here: c2d_advance reports it. Errors: STORE_..., SINGULAR, CANCELLED, MEMORY; INPUT: changed loads; LIMIT: `touching`."""),
    "c2d_change_loads": (c_int32, [
        ("solver", c_void_p, False, None),
    ], """c2d_status c2d_change_loads(c2d_solver* solver);

Change the loads of the same bodies. c2d_change_loads ends the path and returns to state model, where c2d_set_values, c2d_set_body_force, c2d_set_rigid and c2d_set_rigid_load (load_case > 0) and c2d_replace_point_load (place and force of point load i, in the order given; body and load case stay) change the values of load cases. c2d_prepare validates them and, with the option keep_factors, solves only the new right-hand sides with the stored factors: a small part of the work, and the same results to round-off. Without keep_factors, and after other options, a failure or a cancel, c2d_prepare repeats all work. Codes, geometry and contact do not change. A load case needed only later is counted in c2d_limits.load_cases from the beginning; its values do not matter until then. States saved before are stale."""),
    "c2d_replace_point_load": (c_int32, [
        ("solver", c_void_p, False, None),
        ("i", c_int32, False, None),
        ("x", c_double, False, None),
        ("y", c_double, False, None),
        ("fx", c_double, False, None),
        ("fy", c_double, False, None),
    ], """c2d_status c2d_replace_point_load(c2d_solver* solver, int32_t i, double x, double y, double fx, double fy);"""),
    "c2d_begin": (c_int32, [
        ("solver", c_void_p, False, None),
        ("mu", POINTER(c_double), True, None),
        ("zones", c_int32, False, None),
    ], """c2d_status c2d_begin(c2d_solver* solver, const double* mu, int32_t zones);

---------------------------------------------------------------- 7 follow the load ---------------------------- Begin: zero load, no history, coefficients of friction mu[0 .. zones) (zones = 1: one for all), each >= 0, infinity: full adhesion. The first > 0 after a preparation with none repeats its end. State: running. Errors: STORE_..., MEMORY."""),
    "c2d_advance": (c_int32, [
        ("solver", c_void_p, False, None),
        ("load", POINTER(c_double), True, None),
        ("cases", c_int32, False, None),
        ("outcome", POINTER(c_int32), False, None),
    ], """c2d_status c2d_advance(c2d_solver* solver, const double* load, int32_t cases, c2d_outcome* outcome);

Follow a straight line from the load factors reached to load[0 .. cases). If *outcome is not C2D_REACHED the solver remains valid at the last load reached; also after a cancel or MEMORY (`touching`). Errors: STORE_..., CANCELLED, MEMORY."""),
    "c2d_next_event": (c_int32, [
        ("solver", c_void_p, False, None),
        ("direction", POINTER(c_double), True, None),
        ("cases", c_int32, False, None),
        ("step", POINTER(c_double), False, None),
    ], """c2d_status c2d_next_event(c2d_solver* solver, const double* direction, int32_t cases, double* step);

Distance along direction[0 .. cases) at which the next pair changes its status: *step times the direction; infinity if no pair does; 0 if the path cannot continue in this direction. The load does not change; a pair at the limit of its status (zero pressure or incipient slip) may take the status that belongs to the direction. Errors: STORE_..., MEMORY."""),
    "c2d_save": (c_int32, [
        ("solver", c_void_p, False, None),
    ], """c2d_status c2d_save(c2d_solver* solver);

Save the state of the path on tape 0 or, in state prepared, the fact that a factorisation exists. A crash at any moment leaves this state or the one saved before; the tapes are synchronised first. c2d_summary does not count these transfers. In the callback of c2d_run, except at a CHANGE, it also saves the position in the run: after c2d_restore c2d_run continues there, if no other call has changed the load. Errors: STORE_... (c2d_restore returns to the state saved before)."""),
    "c2d_restore": (c_int32, [
        ("solver", c_void_p, False, None),
    ], """c2d_status c2d_restore(c2d_solver* solver);

Return to the newest complete saved state: nothing is eliminated again, and later results have identical bits. In another process: c2d_create with the same limits, the same model and options (state model), the same store, then c2d_restore in place of c2d_prepare; a saved state prepared serves any path. Errors, after which the solver is unchanged: MISMATCH: saved for another model, path, limits or stepping, or by another library or kind of machine (see c2d_last_error); STORE_STALE: a later c2d_prepare has begun; STORE_FORMAT or _READ: nothing was saved; STORE_...: no complete state; MEMORY with bytes_needed: saved in a larger workspace. State broken only if the store fails or data are invalid while they are loaded."""),
    "c2d_run": (c_int32, [
        ("solver", c_void_p, False, None),
        ("step", c2d_step_fn, False, None),
        ("context", c_void_p, False, None),
    ], """c2d_status c2d_run(c2d_solver* solver, c2d_step_fn step, void* context);

Follow the load path of the model for each of its coefficients of friction. A path that ends early is no error of this call: the callback (may be null) and c2d_get_summary report it, and the next coefficient is run. State afterwards: running, at the last load reached, also after CALLBACK, CANCELLED. Errors: ARGUMENT: no path; CALLBACK, CANCELLED, MEMORY, STORE_...."""),
    "c2d_cancel": (c_int32, [
        ("solver", c_void_p, False, None),
    ], """c2d_status c2d_cancel(c2d_solver* solver);

From any callback, another thread or a signal handler: the solver stops as soon as possible and the active call returns C2D_ERR_CANCELLED. If no call is active, or it ends first, the next call that lists CANCELLED does: no cancel is lost."""),
    "c2d_get": (c_int32, [
        ("solver", c_void_p, False, None),
        ("field", c_int32, False, None),
        ("body", c_int32, False, None),
        ("first", c_int32, False, None),
        ("count", c_int32, False, None),
        ("out", POINTER(c_double), False, None),
        ("stride", c_int64, False, None),
    ], """c2d_status c2d_get(c2d_solver* solver, int32_t field, int32_t body, int32_t first, int32_t count, double* out, int64_t stride);

---------------------------------------------------------------- 8 results ------------------------------------ At the load reached, in state running. All except queries of the model may return STORE_... (the first call at a load that needs back substitution performs it). c2d_get copies entries first ... first+count-1 of a field (contact2d_codes.h) to out[0], out[stride], ...; positions also in states model and prepared."""),
    "c2d_interior": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("count", c_int32, False, None),
        ("xy", POINTER(c_double), True, None),
        ("xy_stride", c_int64, False, None),
        ("out", POINTER(c_double), False, None),
        ("out_stride", c_int64, False, None),
    ], """c2d_status c2d_interior(c2d_solver* solver, int32_t body, int32_t count, const double* xy, int64_t xy_stride, double* out, int64_t out_stride);

Displacements and stresses at `count` points (xy[i * xy_stride], xy[i * xy_stride + 1]); column c of point i goes to out[i * out_stride + c]. xy_stride >= 2, out_stride >= C2D_POINT_FIELDS; xy and out must not overlap. body 0: the first body that contains the point. The singular field of a point load is omitted at its own point. Displacements and stresses are 0 before the first contact, and where a rigid-body motion has no support. With lines of symmetry points may lie anywhere in the whole model. Many points in one call cost less than one by one. Errors: STORE_..., CANCELLED: `out` is then undefined."""),
    "c2d_indicators": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("first", c_int32, False, None),
        ("count", c_int32, False, None),
        ("out", POINTER(c_double), False, None),
        ("stride", c_int64, False, None),
    ], """c2d_status c2d_indicators(c2d_solver* solver, int32_t body, int32_t first, int32_t count, double* out, int64_t stride);

Discretisation error indicators of elements: C2D_OFF_... (contact2d_codes.h). Errors: as c2d_interior."""),
    "c2d_get_summary": (c_int32, [
        ("solver", c_void_p, False, None),
        ("out", POINTER(c2d_summary), False, None),
    ], """c2d_status c2d_get_summary(c2d_solver* solver, c2d_summary* out);"""),
    "c2d_get_body_result": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("out", POINTER(c2d_body_result), False, None),
    ], """c2d_status c2d_get_body_result(c2d_solver* solver, int32_t body, c2d_body_result* out);"""),
    "c2d_get_zone_state": (c_int32, [
        ("solver", c_void_p, False, None),
        ("zone", c_int32, False, None),
        ("out", POINTER(c2d_zone_state), False, None),
    ], """c2d_status c2d_get_zone_state(c2d_solver* solver, int32_t zone, c2d_zone_state* out);"""),
    "c2d_get_body_state": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("out", POINTER(c2d_body_state), False, None),
    ], """c2d_status c2d_get_body_state(c2d_solver* solver, int32_t body, c2d_body_state* out);"""),
    "c2d_get_friction": (c_int32, [
        ("solver", c_void_p, False, None),
        ("zone", c_int32, False, None),
        ("i", c_int32, False, None),
        ("mu", POINTER(c_double), False, None),
    ], """c2d_status c2d_get_friction(c2d_solver* solver, int32_t zone, int32_t i, double* mu);

Coefficient of friction of a zone in the i-th run; zone 0: the one of all zones without one of their own."""),
    "c2d_get_path": (c_int32, [
        ("solver", c_void_p, False, None),
        ("i", c_int32, False, None),
        ("increments", POINTER(c_int32), False, None),
        ("load", POINTER(c_double), False, None),
        ("cases", c_int32, False, None),
    ], """c2d_status c2d_get_path(c2d_solver* solver, int32_t i, int32_t* increments, double* load, int32_t cases);"""),
    "c2d_get_zone": (c_int32, [
        ("solver", c_void_p, False, None),
        ("i", c_int32, False, None),
        ("out", POINTER(c2d_zone), False, None),
    ], """c2d_status c2d_get_zone(c2d_solver* solver, int32_t i, c2d_zone* out);

Of a free zone: the elements that can touch, and 0 for the nodes of side 1."""),
    "c2d_get_region": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("i", c_int32, False, None),
        ("first_element", POINTER(c_int32), False, None),
        ("last_element", POINTER(c_int32), False, None),
    ], """c2d_status c2d_get_region(c2d_solver* solver, int32_t body, int32_t i, int32_t* first_element, int32_t* last_element);"""),
    "c2d_get_condition": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("element", c_int32, False, None),
        ("local", c_int32, False, None),
        ("load_case", c_int32, False, None),
        ("codes", POINTER(c_int32), False, 4),
        ("values", POINTER(c_double), False, 4),
    ], """c2d_status c2d_get_condition(c2d_solver* solver, int32_t body, int32_t element, int32_t local, int32_t load_case, int32_t codes[4], double values[4]);"""),
    "c2d_get_point_load": (c_int32, [
        ("solver", c_void_p, False, None),
        ("i", c_int32, False, None),
        ("body", POINTER(c_int32), False, None),
        ("load_case", POINTER(c_int32), False, None),
        ("xy", POINTER(c_double), False, 2),
        ("force", POINTER(c_double), False, 2),
    ], """c2d_status c2d_get_point_load(c2d_solver* solver, int32_t i, int32_t* body, int32_t* load_case, double xy[2], double force[2]);

The point loads of all bodies and cases form one list."""),
    "c2d_get_points": (c_int32, [
        ("solver", c_void_p, False, None),
        ("i", c_int32, False, None),
        ("out", POINTER(c2d_points), False, None),
    ], """c2d_status c2d_get_points(c2d_solver* solver, int32_t i, c2d_points* out);"""),
    "c2d_get_curve": (c_int32, [
        ("solver", c_void_p, False, None),
        ("i", c_int32, False, None),
        ("out", POINTER(c2d_curve), False, None),
    ], """c2d_status c2d_get_curve(c2d_solver* solver, int32_t i, c2d_curve* out);"""),
    "c2d_expand_points": (c_int32, [
        ("points", POINTER(c2d_points), True, None),
        ("first", c_int32, False, None),
        ("count", c_int32, False, None),
        ("xy", POINTER(c_double), False, None),
        ("stride", c_int64, False, None),
        ("total", POINTER(c_int32), False, None),
    ], """c2d_status c2d_expand_points(const c2d_points* points, int32_t first, int32_t count, double* xy, int64_t stride, int32_t* total);

Points first ... first+count-1 of a set: x and y of the k-th to xy[k * stride], xy[k * stride + 1], ready for c2d_interior. *total (may be null): number of points of the set. Needs no solver; `body` is ignored."""),
    "c2d_get_body_force": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("load_case", c_int32, False, None),
        ("force", POINTER(c_double), False, 2),
        ("rho_omega2", POINTER(c_double), False, None),
        ("axis", POINTER(c_double), False, 2),
    ], """c2d_status c2d_get_body_force(c2d_solver* solver, int32_t body, int32_t load_case, double force[2], double* rho_omega2, double axis[2]);

Zeros if there is none. is_rigid: 1 if the body is rigid. The load case that closes initial overlaps, or 0."""),
    "c2d_get_rigid": (c_int32, [
        ("solver", c_void_p, False, None),
        ("body", c_int32, False, None),
        ("load_case", c_int32, False, None),
        ("is_rigid", POINTER(c_int32), False, None),
        ("motion", POINTER(c_double), False, 3),
        ("axis", POINTER(c_double), False, 2),
    ], """c2d_status c2d_get_rigid(c2d_solver* solver, int32_t body, int32_t load_case, int32_t* is_rigid, double motion[3], double axis[2]);"""),
    "c2d_get_interference": (c_int32, [
        ("solver", c_void_p, False, None),
        ("load_case", POINTER(c_int32), False, None),
    ], """c2d_status c2d_get_interference(c2d_solver* solver, int32_t* load_case);"""),
    "c2d_get_state": (c_int32, [
        ("solver", c_void_p, True, None),
    ], """int32_t c2d_get_state(const c2d_solver* solver);"""),
    "c2d_last_error": (c_int32, [
        ("solver", c_void_p, False, None),
        ("out", POINTER(c2d_error), False, None),
    ], """c2d_status c2d_last_error(c2d_solver* solver, c2d_error* out);

Why the last call failed; in state broken: the fault that broke the solver, also after later refusals."""),
    "c2d_message": (c_char_p, [
        ("status", c_int32, False, None),
    ], """const char* c2d_message(int32_t status);

Text of a c2d_status or a warning, and of an outcome, for any integer; never null."""),
    "c2d_outcome_message": (c_char_p, [
        ("outcome", c_int32, False, None),
    ], """const char* c2d_outcome_message(int32_t outcome);"""),
    "c2d_version": (c_char_p, [], """const char* c2d_version(void);"""),
    "c2d_link_holes": (None, [], """void c2d_link_holes(void);

These do nothing at run time. With a library compiled with C2D_PARTS_BY_CALL they link optional parts into the program: bodies with holes; zones of kind C2D_ZONE_FREE; warnings of a preparation or a contact state, also linked by c2d_run and c2d_get_summary; the search, also linked by c2d_run, where changing the violating pairs fails (without it such a path ends with C2D_UNDECIDED); compressed elimination, which small code lacks; and bodies of revolution (C2D_AXISYMMETRIC)."""),
    "c2d_link_free_zones": (None, [], """void c2d_link_free_zones(void);"""),
    "c2d_link_warnings": (None, [], """void c2d_link_warnings(void);"""),
    "c2d_link_search": (None, [], """void c2d_link_search(void);"""),
    "c2d_link_compressed": (None, [], """void c2d_link_compressed(void);"""),
    "c2d_link_axisymmetric": (None, [], """void c2d_link_axisymmetric(void);"""),
    "c2d_walk_deck": (c_int32, [
        ("read", c2d_read_line, False, None),
        ("context", c_void_p, False, None),
        ("body", POINTER(c2d_body_limits), False, None),
        ("bodies", c_int32, False, None),
        ("card", c2d_card_fn, False, None),
        ("card_context", c_void_p, False, None),
        ("report", c2d_report, False, None),
        ("report_context", c_void_p, False, None),
    ], """c2d_status c2d_walk_deck(c2d_read_line read, void* context, c2d_body_limits* body, int32_t bodies, c2d_card_fn card, void* card_context, c2d_report report, void* report_context);

Walks over a deck like c2d_check_deck, without a workspace: `card` receives every field in the order of the deck, `report` every fault; either may be null. Discard the fields of a deck with faults. body[0 .. bodies) is work space; its contents are undefined afterwards. Errors: ARGUMENT, INPUT, READ; LIMIT: the deck has more bodies than `bodies`, reported as soon as their number is read."""),
    "c2d_cycle": (c_int32, [
        ("solver", c_void_p, False, None),
        ("request", POINTER(c2d_cycle_request), True, None),
        ("each", c2d_cycle_fn, False, None),
        ("context", c_void_p, False, None),
        ("out", POINTER(c2d_cycle_state), False, None),
    ], """c2d_status c2d_cycle(c2d_solver* solver, const c2d_cycle_request* request, c2d_cycle_fn each, void* context, c2d_cycle_state* out);

Follow cycles from the load reached, which must be the last corner, until the change over a followed cycle is within the tolerance, and fill *out. `each` may be null. A state saved in the callback is continued by c2d_restore and the same call, with identical bits. With C2D_STEPPING_DECK, free motions at rest and friction without bound nothing is extrapolated. Energies since zero load skip what an extrapolation passes over; their balance stays. Legal in state running. Errors: STORE_..., CALLBACK, CANCELLED (the solver stays at the last load reached), MEMORY."""),
    "c2d_repeat_paths": (c_int32, [
        ("solver", c_void_p, False, None),
        ("pieces", c_int32, False, None),
        ("limit", c_int32, False, None),
        ("digits", c_int32, False, None),
        ("start", c_int32, False, None),
    ], """c2d_status c2d_repeat_paths(c2d_solver* solver, int32_t pieces, int32_t limit, int32_t digits, int32_t start);"""),
    "c2d_get_repeated": (c_int32, [
        ("solver", c_void_p, False, None),
        ("first", POINTER(c_int32), False, None),
        ("pieces", POINTER(c_int32), False, None),
        ("limit", POINTER(c_int32), False, None),
        ("digits", POINTER(c_int32), False, None),
        ("start", POINTER(c_int32), False, None),
    ], """c2d_status c2d_get_repeated(c2d_solver* solver, int32_t* first, int32_t* pieces, int32_t* limit, int32_t* digits, int32_t* start);

Which segments are repeated: the first, from 1 (0: none), how many; limit, digits and start. Legal as the lists of section 8."""),
    "c2d_get_cycle_state": (c_int32, [
        ("solver", c_void_p, False, None),
        ("out", POINTER(c2d_cycle_state), False, None),
    ], """c2d_status c2d_get_cycle_state(c2d_solver* solver, c2d_cycle_state* out);

The cycles followed last, by c2d_cycle or c2d_run, also in its callback."""),
    "c2d_get_cycle": (c_int32, [
        ("solver", c_void_p, False, None),
        ("field", c_int32, False, None),
        ("first", c_int32, False, None),
        ("count", c_int32, False, None),
        ("out", POINTER(c_double), False, None),
        ("stride", c_int64, False, None),
    ], """c2d_status c2d_get_cycle(c2d_solver* solver, int32_t field, int32_t first, int32_t count, double* out, int64_t stride);"""),
    "c2d_get_cycle_zone": (c_int32, [
        ("solver", c_void_p, False, None),
        ("zone", c_int32, False, None),
        ("out", POINTER(c2d_cycle_zone), False, None),
    ], """c2d_status c2d_get_cycle_zone(c2d_solver* solver, int32_t zone, c2d_cycle_zone* out);"""),
    "c2d_image_sum": (c_int32, [
        ("solver", c_void_p, True, None),
        ("sum", POINTER(c_uint64), False, None),
    ], """c2d_status c2d_image_sum(const c2d_solver* solver, uint64_t* sum);

The checksum of the memory of a solver, between any two calls, in any state. It reads all of the memory and changes nothing; the next call on the solver invalidates the sum."""),
    "c2d_attach_image": (c_int32, [
        ("out", POINTER(c_void_p), False, None),
        ("memory", c_void_p, False, None),
        ("bytes", c_size_t, False, None),
        ("port", POINTER(c2d_port), True, None),
        ("sum", c_uint64, False, None),
        ("why", POINTER(c2d_error), False, None),
    ], """c2d_status c2d_attach_image(c2d_solver** out, void* memory, size_t bytes, const c2d_port* port, uint64_t sum, c2d_error* why);

c2d_attach for an image whose c2d_image_sum was `sum` when it was copied. Errors: those of c2d_attach; STORE_CHECKSUM: the sum differs now. On failure the image is unchanged."""),
    "c2d_memory_store_init": (None, [
        ("store", POINTER(c2d_memory_store), False, None),
        ("region", c_void_p, False, None),
        ("bytes", c_uint64, False, None),
    ], """void c2d_memory_store_init(c2d_memory_store* store, void* region, uint64_t bytes);

Empty the store and give it region[0 .. bytes); any alignment."""),
    "c2d_memory_store_need": (c_uint64, [
        ("store", POINTER(c2d_memory_store), True, None),
    ], """uint64_t c2d_memory_store_need(const c2d_memory_store* store);

Bytes that a region needs for all tapes opened so far, including one that failed for lack of room. A tape reopened with another size may need more than this unless _init emptied the region. UINT64_MAX if the number does not fit."""),
    "c2d_memory_store_port": (None, [
        ("store", POINTER(c2d_memory_store), False, None),
        ("out", POINTER(c2d_port), False, None),
    ], """void c2d_memory_store_port(c2d_memory_store* store, c2d_port* out);

Set context, open, read, write, sync and close of *out; other members are unchanged."""),
    "c2d_posix_store_init": (c_int32, [
        ("store", POINTER(c2d_posix_store), False, None),
        ("folder", c_char_p, True, None),
    ], """int32_t c2d_posix_store_init(c2d_posix_store* store, const char* folder);

Create the folder unless it exists (its parent must exist), and in it the folder of the store; lock it until _done or the end of the process. Returns 0, C2D_POSIX_STORE_LOCKED, _FOREIGN or errno; after a failure nothing is locked or open."""),
    "c2d_posix_store_port": (None, [
        ("store", POINTER(c2d_posix_store), False, None),
        ("out", POINTER(c2d_port), False, None),
    ], """void c2d_posix_store_port(c2d_posix_store* store, c2d_port* out);

Set context, open, read, write, sync, close, start_read, start_write and wait of *out; other members are unchanged."""),
    "c2d_posix_store_expect": (None, [
        ("store", POINTER(c2d_posix_store), False, None),
        ("tape", c_int32, False, None),
        ("bytes", c_uint64, False, None),
    ], """void c2d_posix_store_expect(c2d_posix_store* store, int32_t tape, uint64_t bytes);

Reserve at most so many bytes when this tape is opened next (default: all of it; the bounds of compressed elimination are ten times its actual size and more). Does nothing if there is no such tape."""),
    "c2d_posix_store_remove": (c_int32, [
        ("store", POINTER(c2d_posix_store), False, None),
    ], """int32_t c2d_posix_store_remove(c2d_posix_store* store);

Close and delete the tapes; the folder stays locked. Returns 0 or the first errno; a missing file is no failure."""),
    "c2d_posix_store_done": (c_int32, [
        ("store", POINTER(c2d_posix_store), False, None),
    ], """int32_t c2d_posix_store_done(c2d_posix_store* store);

Close all files and unlock the folder. Returns 0 or the first errno. The lock file stays."""),
    "c2d_posix_store_discard": (c_int32, [
        ("store", POINTER(c2d_posix_store), False, None),
        ("folder", c_char_p, True, None),
    ], """int32_t c2d_posix_store_discard(c2d_posix_store* store, const char* folder);

The same after _remove, and delete the lock file and the folder of the store. `folder`, the name given to _init, is removed if it is empty then; null: it stays."""),
    "c2d_stdio_store_init": (c_int32, [
        ("store", POINTER(c2d_stdio_store), False, None),
        ("folder", c_char_p, True, None),
    ], """int32_t c2d_stdio_store_init(c2d_stdio_store* store, const char* folder);

Set the folder (copied; at most 999 bytes). Returns 0 or C2D_STDIO_STORE_NAME. Accesses no file."""),
    "c2d_stdio_store_port": (None, [
        ("store", POINTER(c2d_stdio_store), False, None),
        ("out", POINTER(c2d_port), False, None),
    ], """void c2d_stdio_store_port(c2d_stdio_store* store, c2d_port* out);

Set context, open, read, write, sync and close of *out; other members are unchanged."""),
    "c2d_stdio_store_remove": (c_int32, [
        ("store", POINTER(c2d_stdio_store), False, None),
    ], """int32_t c2d_stdio_store_remove(c2d_stdio_store* store);

Delete the files of the tapes; close them first. Returns 0 or the first failure; a missing file is no failure."""),
    "c2d_threads_start": (c_int32, [
        ("pool", POINTER(c2d_threads), False, None),
        ("threads", c_int32, False, None),
    ], """int32_t c2d_threads_start(c2d_threads* pool, int32_t threads);

Start a pool of `threads` threads, 1 ... C2D_THREADS_MOST, including the one that calls the library. The pool blocks all signals. Returns 0, or errno and no thread runs (EINVAL: number out of range)."""),
    "c2d_threads_port": (None, [
        ("pool", POINTER(c2d_threads), False, None),
        ("out", POINTER(c2d_port), False, None),
    ], """void c2d_threads_port(c2d_threads* pool, c2d_port* out);

Add the pool to a port whose other members are set: the context of the port becomes the pool, and its other functions are called through it with their former context. Alternatively set threads yourself, and parallel_for to a function that calls c2d_threads_run."""),
    "c2d_threads_run": (None, [
        ("pool", POINTER(c2d_threads), False, None),
        ("n", c_int32, False, None),
        ("task", c2d_threads_task, False, None),
        ("argument", c_void_p, False, None),
    ], """void c2d_threads_run(c2d_threads* pool, int32_t n, c2d_threads_task task, void* argument);

Run task(argument, 0) ... task(argument, n - 1), with the caller's rounding mode and traps; all have run when it returns. Call it from one thread at a time, and not from within a task. Threads wait for the next call, and the caller for the last task, first by polling for some ten microseconds, then by sleeping."""),
    "c2d_threads_stop": (None, [
        ("pool", POINTER(c2d_threads), False, None),
    ], """void c2d_threads_stop(c2d_threads* pool);

End the threads. The pool may be started again."""),
}
