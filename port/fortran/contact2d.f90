! contact2d for Fortran: the whole of contact2d.h, contact2d_cards.h and the ports c2d_memory.h, c2d_stdio.h, c2d_posix.h and
! c2d_threads.h, under the same names. The headers are the manual; here stands only how their arguments look from Fortran.
! Made by port/fortran/generate.py from the headers and contact2d.f90.in: do not edit.
!
!   gfortran -c contact2d.f90
!   gfortran program.f90 contact2d.o -lcontact2d
!
! - Functions return the status, as in C. Integers are of kind c_int32_t (int32_t), c_int64_t (int64_t, uint64_t) or
!   c_size_t, reals of kind c_double, whatever the compiler's default kinds are.
! - A solver, a memory and a context are type(c_ptr): c_loc of a variable with the TARGET attribute, or c_null_ptr.
! - Functions of yours are type(c_funptr): c_funloc of a procedure with BIND(C) that looks like the abstract interface of
!   the same name below, or c_null_funptr.
! - Arrays have the shape that the strides say: xy(stride, *), out(stride, *). With a row of results as one vector the
!   stride is 1_c_int64_t.
! - Texts of structs are arrays of characters: c2d_string reads them, c2d_set_string writes them. c2d_message and its like
!   return strings of the right length. A text that goes in ends with c_null_char.
module contact2d
  use, intrinsic :: iso_c_binding
  implicit none
  public
  private :: string_at

  ! ---- numbers of contact2d_codes.h
  integer(c_int32_t), parameter :: C2D_OK = 0, C2D_ERR_ARGUMENT = 1, C2D_ERR_STATE = 2, C2D_ERR_BUSY = 3, &
      C2D_ERR_MEMORY = 4, C2D_ERR_OVERFLOW = 5, C2D_ERR_LIMIT = 6, C2D_ERR_INPUT = 7, C2D_ERR_READ = 8, &
      C2D_ERR_CANCELLED = 9, C2D_ERR_SINGULAR = 10, C2D_ERR_CALLBACK = 11, C2D_ERR_STORE_OPEN = 20, &
      C2D_ERR_STORE_READ = 21, C2D_ERR_STORE_WRITE = 22, C2D_ERR_STORE_SYNC = 23, C2D_ERR_STORE_CLOSE = 24, &
      C2D_ERR_STORE_FORMAT = 30, C2D_ERR_STORE_VERSION = 31, C2D_ERR_STORE_SHORT = 32, C2D_ERR_STORE_CHECKSUM = 33, &
      C2D_ERR_STORE_SWAPPED = 34, C2D_ERR_STORE_STALE = 35, C2D_ERR_MISMATCH = 40, C2D_ERR_INTERNAL = 99
  integer(c_int32_t), parameter :: C2D_REACHED = 0, C2D_FREE_MOTION = 1, C2D_GROSS_SLIDING = 2, &
      C2D_NO_ADMISSIBLE_CHANGE = 3, C2D_NO_PROGRESS = 4, C2D_UNDECIDED = 5, C2D_TIPPING = 6, C2D_BEYOND_LIMITS = 7
  integer(c_int32_t), parameter :: C2D_BREACH_NONE = 0, C2D_BREACH_TABLEAU = 1, C2D_BREACH_EQUATIONS = 2, &
      C2D_BREACH_BALANCE = 3, C2D_BREACH_SIGN = 4, C2D_BREACH_CONE = 5, C2D_BREACH_SLIP = 6, C2D_BREACH_SINGULAR = 7, &
      C2D_BREACHES = 8
  integer(c_int32_t), parameter :: C2D_X = 0, C2D_Y = 1, C2D_STATUS = 2, C2D_TN = 3, C2D_TT = 4, C2D_UN1 = 5, &
      C2D_UT1 = 6, C2D_UN2 = 7, C2D_UT2 = 8, C2D_GAP = 9, C2D_SLIP_SUM = 10, C2D_NX = 11, C2D_NY = 12, &
      C2D_PAIR_NODE1 = 13, C2D_PAIR_NODE2 = 14, C2D_PAIR_ZONE = 15, C2D_PAIR_FIELDS = 16, C2D_END_X = 100, &
      C2D_END_Y = 101, C2D_END_NODE = 102, C2D_END_UX = 103, C2D_END_UY = 104, C2D_END_TX = 105, C2D_END_TY = 106, &
      C2D_END_STATUS = 107, C2D_END_SXX = 108, C2D_END_SYY = 109, C2D_END_SXY = 110, C2D_END_SZZ = 111, &
      C2D_END_HOOP = 112, C2D_END_VON_MISES = 113, C2D_END_MAX_SHEAR = 114, C2D_END_PRINCIPAL1 = 115, &
      C2D_END_PRINCIPAL2 = 116, C2D_NODE_X = 120, C2D_NODE_Y = 121, C2D_PAIR_ELEMENT1 = 130, C2D_PAIR_ETA1 = 131, &
      C2D_SURFACE_X = 140, C2D_SURFACE_Y = 141
  integer(c_int32_t), parameter :: C2D_OFF_LENGTH = 0, C2D_OFF_ZONE = 1, C2D_OFF_SIDE = 2, C2D_OFF_STATUSES = 3, &
      C2D_OFF_EQUATION = 4, C2D_OFF_GAP = 5, C2D_OFF_DRIFT = 6, C2D_OFF_EQUATION_ENERGY = 7, &
      C2D_OFF_CONTACT_ENERGY = 8, C2D_OFF_FIELDS = 9
  integer(c_int32_t), parameter :: C2D_WARN_ZONE_END = 201, C2D_WARN_FEW_PAIRS = 202, C2D_WARN_LARGE_SLIP = 203, &
      C2D_WARN_NORMALS = 204, C2D_WARN_KINK = 205, C2D_WARN_POINT_LOAD = 206, C2D_WARN_TENSION = 207, &
      C2D_WARN_CORNER = 208, C2D_WARN_INCREMENT = 209, C2D_WARN_RESIDUAL = 210, C2D_WARN_CONDITION = 211, &
      C2D_WARN_OFFSET = 212, C2D_WARN_LEFT_OUT = 213, C2D_WARN_OVERLAP = 214, C2D_WARN_NOT_UNIQUE = 215, &
      C2D_WARN_UNDEFINED_PLACE = 216, C2D_WARN_STRAIN = 217, C2D_WARN_FRICTION = 218, C2D_WARN_CONSTANT = 219, &
      C2D_WARN_FAR = 220, C2D_WARN_SIZES = 221, C2D_WARN_SURFACE = 222, C2D_WARN_ENERGY = 223, C2D_WARN_UNHELD = 224, &
      C2D_WARN_TIE_END = 225, C2D_WARN_COMPRESSED = 226, C2D_WARN_BETWEEN = 227, C2D_WARN_SHIFTED = 228, &
      C2D_WARN_OVERLAPPING = 229, C2D_WARN_SIDEWAYS = 230, C2D_WARN_ROTATION = 231, C2D_WARN_SLIT = 232

  ! ---- numbers of contact2d.h
  integer(c_int32_t), parameter :: C2D_OPEN = 0, C2D_STICK = 1, C2D_SLIP = 2, C2D_TIED = 3
  integer(c_int32_t), parameter :: C2D_PLANE_STRAIN = 0, C2D_PLANE_STRESS = 1, C2D_AXISYMMETRIC = 2
  integer(c_int32_t), parameter :: C2D_NOTE = 0, C2D_WARNING = 1, C2D_FAULT = 2
  integer(c_int32_t), parameter :: C2D_PHASE_READ = 0, C2D_PHASE_ASSEMBLE = 1, C2D_PHASE_ELIMINATE = 2, &
      C2D_PHASE_REDUCE = 3, C2D_PHASE_CONTACT = 4, C2D_PHASE_BACK = 5, C2D_PHASE_WRITE = 6, C2D_PHASES = 7
  integer(c_int32_t), parameter :: C2D_TAPE_CONTROL = 0, C2D_TAPE_LOWER = 1, C2D_TAPE_UPPER = 2, &
      C2D_TAPE_CONTACT = 3, C2D_TAPES = 4
  integer(c_int32_t), parameter :: C2D_ANALYSIS_CHECK = -1, C2D_ANALYSIS_STRESS = 0, C2D_ANALYSIS_CONTACT = 1, &
      C2D_ANALYSIS_FULL = 2, C2D_ANALYSIS_ITERATIONS = 3
  integer(c_int32_t), parameter :: C2D_ZONE_MATCHING = 0, C2D_ZONE_FREE = 1, C2D_ZONE_TIED = 2, C2D_ZONE_SELF = 4
  integer(c_int32_t), parameter :: C2D_CURVE_LINE = 0, C2D_CURVE_ARC = 1, C2D_CURVE_SPLINE = 2
  integer(c_int32_t), parameter :: C2D_POINTS_ONE = 0, C2D_POINTS_LINE = 1, C2D_POINTS_GRID = 2
  integer(c_int32_t), parameter :: C2D_NAME_BODY = 0, C2D_NAME_ZONE = 1
  integer(c_int32_t), parameter :: C2D_QUADRATURE_ACCURATE = 0, C2D_QUADRATURE_THESIS = 1
  integer(c_int32_t), parameter :: C2D_STEPPING_EVENTS = 0, C2D_STEPPING_DECK = 1
  integer(c_int32_t), parameter :: C2D_SYMMETRY_DECK = 0, C2D_SYMMETRY_IMAGES = 1
  integer(c_int32_t), parameter :: C2D_ELIMINATION_DENSE = 0, C2D_ELIMINATION_COMPRESSED = 1, &
      C2D_ELIMINATION_BY_SIZE = 2
  integer(c_int32_t), parameter :: C2D_STEP_RECORDED = 0, C2D_STEP_CHANGE = 1, C2D_STEP_STOPPED = 2, &
      C2D_STEP_CYCLE = 3
  integer(c_int32_t), parameter :: C2D_POINT_UX = 0, C2D_POINT_UY = 1, C2D_POINT_SXX = 2, C2D_POINT_SYY = 3, &
      C2D_POINT_SXY = 4, C2D_POINT_SZZ = 5, C2D_POINT_VON_MISES = 6, C2D_POINT_MAX_SHEAR = 7, &
      C2D_POINT_PRINCIPAL1 = 8, C2D_POINT_PRINCIPAL2 = 9, C2D_POINT_FLAG = 10, C2D_POINT_FIELDS = 11
  integer(c_int32_t), parameter :: C2D_POINT_INSIDE = 0, C2D_POINT_NEAR_NODE = 1, C2D_POINT_BOUNDARY = 2, &
      C2D_POINT_OUTSIDE = 3
  integer(c_int32_t), parameter :: C2D_STATE_EMPTY = 0, C2D_STATE_BUILDING = 1, C2D_STATE_MODEL = 2, &
      C2D_STATE_PREPARED = 3, C2D_STATE_RUNNING = 4, C2D_STATE_BROKEN = 5

  ! ---- numbers of contact2d_cards.h
  integer(c_int32_t), parameter :: C2D_CARD_FREE = 0, C2D_CARD_HEADING = 1, C2D_CARD_INTEGER = 2, C2D_CARD_REAL = 3, &
      C2D_CARD_LETTER = 4, C2D_CARD_REMARK = 5, C2D_CARD_COMMENT = 6, C2D_CARD_EXTENSION = 7

  ! ---- numbers of contact2d_cycle.h
  integer(c_int32_t), parameter :: C2D_CYCLES_EXACT = 0, C2D_CYCLES_PLAIN = 1, C2D_CYCLES_FAST = 2
  integer(c_int32_t), parameter :: C2D_CYCLE_NOT_STEADY = 0, C2D_CYCLE_SHAKES_DOWN = 1, C2D_CYCLE_SLIPS = 2, &
      C2D_CYCLE_RATCHETS = 3, C2D_CYCLE_STOPPED = 4
  integer(c_int32_t), parameter :: C2D_START_AS_LOADED = 0, C2D_START_WITHOUT_FRICTION = 1, C2D_START_COMPARED = 2
  integer(c_int32_t), parameter :: C2D_CYCLE_RANGE = 0, C2D_CYCLE_WALK = 1, C2D_CYCLE_STUCK = 2, C2D_CYCLE_TOUCHED = 3

  ! ---- numbers of c2d_memory.h
  integer(c_int32_t), parameter :: C2D_MEMORY_STORE_FULL = 1, C2D_MEMORY_STORE_TAPE = 2, C2D_MEMORY_STORE_RANGE = 3

  ! ---- numbers of c2d_posix.h
  integer(c_int32_t), parameter :: C2D_POSIX_STORE_TAPE = -1, C2D_POSIX_STORE_RANGE = -2, C2D_POSIX_STORE_END = -3, &
      C2D_POSIX_STORE_LOCKED = -4, C2D_POSIX_STORE_STUCK = -5, C2D_POSIX_STORE_TICKET = -6, &
      C2D_POSIX_STORE_FOREIGN = -7

  ! ---- numbers of c2d_stdio.h
  integer(c_int32_t), parameter :: C2D_STDIO_STORE_TAPE = -1, C2D_STDIO_STORE_RANGE = -2, C2D_STDIO_STORE_END = -3, &
      C2D_STDIO_STORE_FAILED = -4, C2D_STDIO_STORE_NAME = -5

  ! ---- numbers of c2d_threads.h
  integer(c_int32_t), parameter :: C2D_THREADS_MOST = 64

  ! ---- structs: each is a first value of itself, `type(c2d_limits) :: limits`, as C2D_INIT makes it
  type, bind(C) :: c2d_error
    integer(c_int32_t) :: struct_size = 400
    integer(c_int32_t) :: status = 0
    integer(c_int32_t) :: severity = 0
    integer(c_int32_t) :: host_code = 0
    integer(c_int32_t) :: line = 0
    integer(c_int32_t) :: column = 0
    integer(c_int32_t) :: column_end = 0
    integer(c_int32_t) :: body = 0
    integer(c_int32_t) :: zone = 0
    integer(c_int32_t) :: pair = 0
    integer(c_int32_t) :: element = 0
    integer(c_int32_t) :: node = 0
    integer(c_int32_t) :: tape = 0
    integer(c_int64_t) :: block = 0
    integer(c_int64_t) :: bytes_needed = 0
    real(c_double) :: load = 0
    character(kind=c_char) :: text(320) = c_null_char
  end type

  type, bind(C) :: c2d_body_limits
    integer(c_int32_t) :: points = 0
    integer(c_int32_t) :: elements = 0
    integer(c_int32_t) :: regions = 0
    integer(c_int32_t) :: reserved = 0
  end type

  type, bind(C) :: c2d_limits
    integer(c_int32_t) :: struct_size = 80
    integer(c_int32_t) :: bodies = 0
    type(c_ptr) :: body = c_null_ptr
    integer(c_int32_t) :: function_nodes = 0
    integer(c_int32_t) :: zones = 0
    integer(c_int32_t) :: pairs = 0
    integer(c_int32_t) :: contact_elements = 0
    integer(c_int32_t) :: point_loads = 0
    integer(c_int32_t) :: coefficients = 0
    integer(c_int32_t) :: paths = 0
    integer(c_int32_t) :: load_cases = 0
    integer(c_int32_t) :: panel_columns = 0
    integer(c_int32_t) :: free_pairs = 0
    integer(c_int32_t) :: point_sets = 0
    integer(c_int32_t) :: curves = 0
    integer(c_int32_t) :: platens = 0
    integer(c_int32_t) :: touching = 0
    integer(c_int32_t) :: cycle_states = 0
    integer(c_int32_t) :: reserved = 0
  end type

  type, bind(C) :: c2d_progress
    integer(c_int32_t) :: struct_size = 48
    integer(c_int32_t) :: phase = 0
    integer(c_int32_t) :: body = 0
    integer(c_int64_t) :: done = 0
    integer(c_int64_t) :: total = 0
    real(c_double) :: load = 0
    real(c_double) :: target = 0
  end type

  type, bind(C) :: c2d_port
    integer(c_int32_t) :: struct_size = 128
    type(c_ptr) :: context = c_null_ptr
    type(c_funptr) :: open = c_null_funptr
    type(c_funptr) :: read = c_null_funptr
    type(c_funptr) :: write = c_null_funptr
    type(c_funptr) :: sync = c_null_funptr
    type(c_funptr) :: close = c_null_funptr
    type(c_funptr) :: start_read = c_null_funptr
    type(c_funptr) :: start_write = c_null_funptr
    type(c_funptr) :: wait = c_null_funptr
    type(c_funptr) :: parallel_for = c_null_funptr
    type(c_funptr) :: progress = c_null_funptr
    type(c_funptr) :: cancel = c_null_funptr
    type(c_funptr) :: log = c_null_funptr
    type(c_funptr) :: clock = c_null_funptr
    integer(c_int32_t) :: threads = 0
  end type

  type, bind(C) :: c2d_problem
    integer(c_int32_t) :: struct_size = 96
    integer(c_int32_t) :: plane = 0
    integer(c_int32_t) :: analysis = 0
    integer(c_int32_t) :: iteration_limit = 0
    character(kind=c_char) :: title(80) = c_null_char
  end type

  type, bind(C) :: c2d_body
    integer(c_int32_t) :: struct_size = 40
    integer(c_int32_t) :: element_nodes = 0
    integer(c_int32_t) :: elements = 0
    integer(c_int32_t) :: regions = 0
    real(c_double) :: youngs_modulus = 0
    real(c_double) :: poisson_ratio = 0
    integer(c_int32_t) :: open_regions = 0
    integer(c_int32_t) :: reserved = 0
  end type

  type, bind(C) :: c2d_side
    integer(c_int32_t) :: body = 0
    integer(c_int32_t) :: first_element = 0
    integer(c_int32_t) :: last_element = 0
    integer(c_int32_t) :: elements = 0
    integer(c_int32_t) :: first_node = 0
    integer(c_int32_t) :: last_node = 0
  end type

  type, bind(C) :: c2d_zone
    integer(c_int32_t) :: struct_size = 60
    integer(c_int32_t) :: kind = 0
    integer(c_int32_t) :: pairs = 0
    type(c2d_side) :: side1
    type(c2d_side) :: side2
  end type

  type, bind(C) :: c2d_curve
    integer(c_int32_t) :: struct_size = 48
    integer(c_int32_t) :: kind = 0
    integer(c_int32_t) :: body = 0
    integer(c_int32_t) :: first_element = 0
    integer(c_int32_t) :: last_element = 0
    integer(c_int32_t) :: line = 0
    real(c_double) :: centre(2) = 0
    real(c_double) :: radius = 0
  end type

  type, bind(C) :: c2d_points
    integer(c_int32_t) :: struct_size = 56
    integer(c_int32_t) :: kind = 0
    integer(c_int32_t) :: body = 0
    integer(c_int32_t) :: count(2) = 0
    integer(c_int32_t) :: line = 0
    real(c_double) :: from(2) = 0
    real(c_double) :: to(2) = 0
  end type

  type, bind(C) :: c2d_options
    integer(c_int32_t) :: struct_size = 28
    integer(c_int32_t) :: quadrature = 0
    integer(c_int32_t) :: stepping = 0
    integer(c_int32_t) :: every_change = 0
    integer(c_int32_t) :: symmetry = 0
    integer(c_int32_t) :: keep_factors = 0
    integer(c_int32_t) :: elimination = 0
  end type

  type, bind(C) :: c2d_step
    integer(c_int32_t) :: struct_size = 120
    integer(c_int32_t) :: kind = 0
    integer(c_int32_t) :: coefficient = 0
    integer(c_int32_t) :: step = 0
    integer(c_int32_t) :: pairs = 0
    integer(c_int32_t) :: changes = 0
    integer(c_int32_t) :: iterations = 0
    integer(c_int32_t) :: outcome = 0
    integer(c_int64_t) :: stride = 0
    real(c_double) :: mu = 0
    real(c_double) :: load = 0
    type(c_ptr) :: table = c_null_ptr
    integer(c_int32_t) :: cases = 0
    integer(c_int32_t) :: reserved = 0
    type(c_ptr) :: loads = c_null_ptr
    type(c_ptr) :: work_by_case = c_null_ptr
    real(c_double) :: work = 0
    real(c_double) :: dissipated = 0
    real(c_double) :: elastic = 0
    real(c_double) :: energy_defect = 0
  end type

  type, bind(C) :: c2d_summary
    integer(c_int32_t) :: struct_size = 680
    integer(c_int32_t) :: state = 0
    integer(c_int32_t) :: outcome = 0
    integer(c_int32_t) :: outcome_body = 0
    integer(c_int32_t) :: outcome_pair = 0
    integer(c_int32_t) :: bodies = 0
    integer(c_int32_t) :: function_nodes = 0
    integer(c_int32_t) :: pairs = 0
    integer(c_int32_t) :: zones = 0
    integer(c_int32_t) :: steps = 0
    integer(c_int32_t) :: coefficients = 0
    integer(c_int32_t) :: contact_unknowns = 0
    integer(c_int32_t) :: analysis = 0
    integer(c_int32_t) :: plane = 0
    integer(c_int32_t) :: stepping = 0
    integer(c_int32_t) :: quadrature = 0
    integer(c_int32_t) :: iteration_limit = 0
    integer(c_int32_t) :: paths = 0
    integer(c_int32_t) :: panel_columns = 0
    integer(c_int32_t) :: warnings = 0
    integer(c_int64_t) :: events = 0
    integer(c_int64_t) :: exchanges = 0
    integer(c_int64_t) :: tableau_rebuilds = 0
    integer(c_int64_t) :: minimum_bytes = 0
    integer(c_int64_t) :: in_core_bytes = 0
    integer(c_int64_t) :: workspace_bytes = 0
    integer(c_int64_t) :: peak_bytes = 0
    integer(c_int64_t) :: tape_blocks(4) = 0
    integer(c_int64_t) :: tape_bytes_written(4) = 0
    integer(c_int64_t) :: tape_bytes_read(4) = 0
    integer(c_int64_t) :: tape_writes(4) = 0
    integer(c_int64_t) :: tape_reads(4) = 0
    real(c_double) :: seconds(7) = 0
    real(c_double) :: load = 0
    real(c_double) :: mu = 0
    real(c_double) :: max_residual = 0
    real(c_double) :: elimination_residual = 0
    real(c_double) :: condition = 0
    real(c_double) :: force_applied = 0
    real(c_double) :: force_contact = 0
    real(c_double) :: force_error = 0
    real(c_double) :: free_motion(3) = 0
    real(c_double) :: tension_ratio = 0
    character(kind=c_char) :: title(80) = c_null_char
    character(kind=c_char) :: unit_length(16) = c_null_char
    character(kind=c_char) :: unit_force(16) = c_null_char
    integer(c_int32_t) :: load_cases = 0
    integer(c_int32_t) :: run_coefficient = 0
    real(c_double) :: work = 0
    real(c_double) :: dissipated = 0
    real(c_double) :: elastic = 0
    real(c_double) :: energy_defect = 0
    real(c_double) :: least_dissipation = 0
    integer(c_int32_t) :: symmetry = 0
    integer(c_int32_t) :: breach = 0
    real(c_double) :: symmetry_at(2) = 0
    real(c_double) :: breach_size = 0
    integer(c_int32_t) :: point_loads = 0
    integer(c_int32_t) :: point_sets = 0
    integer(c_int32_t) :: curves = 0
    integer(c_int32_t) :: run_step = 0
    integer(c_int32_t) :: compressed_bodies = 0
    integer(c_int32_t) :: reserved = 0
    real(c_double) :: compression_residual = 0
    real(c_double) :: compression_error = 0
  end type

  type, bind(C) :: c2d_body_result
    integer(c_int32_t) :: struct_size = 96
    integer(c_int32_t) :: element_nodes = 0
    integer(c_int32_t) :: elements = 0
    integer(c_int32_t) :: regions = 0
    integer(c_int32_t) :: open_regions = 0
    integer(c_int32_t) :: points = 0
    integer(c_int32_t) :: nodes = 0
    integer(c_int32_t) :: unknowns = 0
    real(c_double) :: youngs_modulus = 0
    real(c_double) :: poisson_ratio = 0
    real(c_double) :: applied(3) = 0
    real(c_double) :: contact(3) = 0
  end type

  type, bind(C) :: c2d_zone_state
    integer(c_int32_t) :: struct_size = 96
    integer(c_int32_t) :: open = 0
    integer(c_int32_t) :: stick = 0
    integer(c_int32_t) :: slip = 0
    integer(c_int32_t) :: near_change = 0
    integer(c_int32_t) :: reserved = 0
    real(c_double) :: force(2) = 0
    real(c_double) :: moment = 0
    real(c_double) :: approach = 0
    real(c_double) :: shift = 0
    real(c_double) :: largest_pressure = 0
    real(c_double) :: largest_friction = 0
    real(c_double) :: length = 0
    real(c_double) :: dissipated = 0
  end type

  type, bind(C) :: c2d_body_state
    integer(c_int32_t) :: struct_size = 96
    integer(c_int32_t) :: is_rigid = 0
    real(c_double) :: contact(3) = 0
    real(c_double) :: motion(3) = 0
    real(c_double) :: point(2) = 0
    real(c_double) :: load(3) = 0
  end type

  type, bind(C) :: c2d_card
    integer(c_int32_t) :: struct_size = 40
    integer(c_int32_t) :: kind = 0
    integer(c_int32_t) :: line = 0
    integer(c_int32_t) :: column = 0
    integer(c_int32_t) :: width = 0
    integer(c_int32_t) :: length = 0
    type(c_ptr) :: text = c_null_ptr
    real(c_double) :: value = 0
  end type

  type, bind(C) :: c2d_cycle_request
    integer(c_int32_t) :: struct_size = 40
    integer(c_int32_t) :: corners = 0
    integer(c_int32_t) :: cases = 0
    integer(c_int32_t) :: limit = 0
    integer(c_int32_t) :: mode = 0
    integer(c_int32_t) :: reserved = 0
    real(c_double) :: tolerance = 0
    type(c_ptr) :: load = c_null_ptr
  end type

  type, bind(C) :: c2d_cycle_state
    integer(c_int32_t) :: struct_size = 72
    integer(c_int32_t) :: result = 0
    integer(c_int32_t) :: outcome = 0
    integer(c_int32_t) :: cycles = 0
    integer(c_int32_t) :: extrapolations = 0
    integer(c_int32_t) :: repeated = 0
    integer(c_int32_t) :: stuck = 0
    integer(c_int32_t) :: slipped = 0
    integer(c_int32_t) :: range_pair = 0
    integer(c_int32_t) :: walk_pair = 0
    real(c_double) :: change = 0
    real(c_double) :: dissipated = 0
    real(c_double) :: slip_range = 0
    real(c_double) :: walk = 0
  end type

  type, bind(C) :: c2d_cycle_zone
    integer(c_int32_t) :: struct_size = 32
    integer(c_int32_t) :: touched = 0
    integer(c_int32_t) :: stuck = 0
    integer(c_int32_t) :: slipped = 0
    real(c_double) :: walk = 0
    real(c_double) :: slip_range = 0
  end type

  type, bind(C) :: c2d_memory_store
    type(c_ptr) :: region = c_null_ptr
    integer(c_int64_t) :: bytes = 0
    integer(c_int64_t) :: used = 0
    integer(c_int64_t) :: offset(C2D_TAPES) = 0
    integer(c_int64_t) :: room(C2D_TAPES) = 0
    integer(c_int64_t) :: blocks(C2D_TAPES) = 0
    integer(c_int64_t) :: block_bytes(C2D_TAPES) = 0
    integer(c_int64_t) :: wanted(C2D_TAPES) = 0
    integer(c_int32_t) :: is_open(C2D_TAPES) = 0
  end type

  type, bind(C) :: c2d_posix_store
    integer(c_int32_t) :: parent = 0
    integer(c_int32_t) :: folder = 0
    integer(c_int32_t) :: lock = 0
    integer(c_int32_t) :: file(C2D_TAPES) = 0
    integer(c_int64_t) :: blocks(C2D_TAPES) = 0
    integer(c_int64_t) :: block_bytes(C2D_TAPES) = 0
    type(c_ptr) :: helper = c_null_ptr
    integer(c_int64_t) :: expected(C2D_TAPES) = 0
  end type

  type, bind(C) :: c2d_stdio_store
    character(kind=c_char) :: folder(1000) = c_null_char
    type(c_ptr) :: file(C2D_TAPES) = c_null_ptr
    integer(c_int64_t) :: blocks(C2D_TAPES) = 0
    integer(c_int64_t) :: block_bytes(C2D_TAPES) = 0
  end type

  type, bind(C) :: c2d_threads
    integer(c_int64_t) :: room(192) = 0
  end type

  ! ---- functions of the caller's. None of them may STOP.
  abstract interface
    function c2d_port_open(context, tape, blocks, block_bytes) bind(C) result(status)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: tape
      integer(c_int64_t), value :: blocks
      integer(c_int64_t), value :: block_bytes
      integer(c_int32_t) :: status
    end function
    function c2d_port_transfer(context, tape, block, data, bytes) bind(C) result(status)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: tape
      integer(c_int64_t), value :: block
      type(c_ptr), value :: data
      integer(c_int64_t), value :: bytes
      integer(c_int32_t) :: status
    end function
    function c2d_port_tape(context, tape) bind(C) result(status)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: tape
      integer(c_int32_t) :: status
    end function
    function c2d_port_start(context, tape, block, data, bytes, ticket) bind(C) result(status)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: tape
      integer(c_int64_t), value :: block
      type(c_ptr), value :: data
      integer(c_int64_t), value :: bytes
      integer(c_int32_t), intent(out) :: ticket
      integer(c_int32_t) :: status
    end function
    function c2d_port_wait(context, ticket) bind(C) result(status)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: ticket
      integer(c_int32_t) :: status
    end function
    subroutine c2d_port_task(argument, i) bind(C)
      import
      type(c_ptr), value :: argument
      integer(c_int32_t), value :: i
    end subroutine
    subroutine c2d_port_parallel_for(context, n, task, argument) bind(C)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: n
      type(c_funptr), value :: task
      type(c_ptr), value :: argument
    end subroutine
    subroutine c2d_port_progress(context, now) bind(C)
      import
      type(c_ptr), value :: context
      type(c2d_progress), intent(in) :: now
    end subroutine
    function c2d_port_cancel(context) bind(C) result(status)
      import
      type(c_ptr), value :: context
      integer(c_int32_t) :: status
    end function
    function c2d_port_clock(context) bind(C) result(status)
      import
      type(c_ptr), value :: context
      real(c_double) :: status
    end function
    function c2d_read_line(context, text, size) bind(C) result(status)
      import
      type(c_ptr), value :: context
      integer(c_int32_t), value :: size
      character(kind=c_char), intent(inout) :: text(size)
      integer(c_int32_t) :: status
    end function
    subroutine c2d_report(context, entry) bind(C)
      import
      type(c_ptr), value :: context
      type(c2d_error), intent(in) :: entry
    end subroutine
    function c2d_step_fn(context, step) bind(C) result(status)
      import
      type(c_ptr), value :: context
      type(c2d_step), intent(in) :: step
      integer(c_int32_t) :: status
    end function
    subroutine c2d_card_fn(context, card) bind(C)
      import
      type(c_ptr), value :: context
      type(c2d_card), intent(in) :: card
    end subroutine
    function c2d_cycle_fn(context, now) bind(C) result(status)
      import
      type(c_ptr), value :: context
      type(c2d_cycle_state), intent(in) :: now
      integer(c_int32_t) :: status
    end function
    subroutine c2d_threads_task(argument, i) bind(C)
      import
      type(c_ptr), value :: argument
      integer(c_int32_t), value :: i
    end subroutine
  end interface

  ! ---- functions
  interface
    function c2d_memory_need(limits, minimum, in_core, why) bind(C) result(status)
      import
      type(c2d_limits), intent(in) :: limits
      integer(c_int64_t), intent(out) :: minimum
      integer(c_int64_t), intent(out) :: in_core
      type(c2d_error), intent(inout) :: why
      integer(c_int32_t) :: status
    end function
    function c2d_create(out, memory, bytes, limits, port, why) bind(C) result(status)
      import
      type(c_ptr), intent(out) :: out
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(c2d_limits), intent(in) :: limits
      type(c2d_port), intent(in) :: port
      type(c2d_error), intent(inout) :: why
      integer(c_int32_t) :: status
    end function
    function c2d_attach(out, memory, bytes, port, why) bind(C) result(status)
      import
      type(c_ptr), intent(out) :: out
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(c2d_port), intent(in) :: port
      type(c2d_error), intent(inout) :: why
      integer(c_int32_t) :: status
    end function
    function c2d_close(solver) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t) :: status
    end function
    function c2d_scan_deck(read, context, out, why) bind(C) result(status)
      import
      type(c_funptr), value :: read
      type(c_ptr), value :: context
      type(c2d_limits), intent(inout) :: out
      type(c2d_error), intent(inout) :: why
      integer(c_int32_t) :: status
    end function
    function c2d_check_deck(read, context, out, report, report_context) bind(C) result(status)
      import
      type(c_funptr), value :: read
      type(c_ptr), value :: context
      type(c2d_limits), intent(inout) :: out
      type(c_funptr), value :: report
      type(c_ptr), value :: report_context
      integer(c_int32_t) :: status
    end function
    function c2d_read_deck(solver, read, context) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      type(c_funptr), value :: read
      type(c_ptr), value :: context
      integer(c_int32_t) :: status
    end function
    function c2d_set_problem(solver, problem) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      type(c2d_problem), intent(in) :: problem
      integer(c_int32_t) :: status
    end function
    function c2d_set_body(solver, body, data) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      type(c2d_body), intent(in) :: data
      integer(c_int32_t) :: status
    end function
    function c2d_add_region(solver, body, first_element, last_element) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: first_element
      integer(c_int32_t), value :: last_element
      integer(c_int32_t) :: status
    end function
    function c2d_set_nodes(solver, body, first, count, xy, stride) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      integer(c_int64_t), value :: stride
      real(c_double), intent(in) :: xy(stride,*)
      integer(c_int32_t) :: status
    end function
    function c2d_set_line_nodes(solver, body, first, last, origin, from, to) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: last
      real(c_double), intent(in) :: origin(2)
      real(c_double), intent(in) :: from(2)
      real(c_double), intent(in) :: to(2)
      integer(c_int32_t) :: status
    end function
    function c2d_set_arc_nodes(solver, body, first, last, centre, radius, from_degrees, &
        to_degrees) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: last
      real(c_double), value :: radius
      real(c_double), value :: from_degrees
      real(c_double), value :: to_degrees
      real(c_double), intent(in) :: centre(2)
      integer(c_int32_t) :: status
    end function
    function c2d_set_condition(solver, body, element, local, load_case, codes, values) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: element
      integer(c_int32_t), value :: local
      integer(c_int32_t), value :: load_case
      integer(c_int32_t), intent(in) :: codes(4)
      real(c_double), intent(in) :: values(4)
      integer(c_int32_t) :: status
    end function
    function c2d_set_values(solver, body, element, local, load_case, values) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: element
      integer(c_int32_t), value :: local
      integer(c_int32_t), value :: load_case
      real(c_double), intent(in) :: values(4)
      integer(c_int32_t) :: status
    end function
    function c2d_add_point_load(solver, body, load_case, x, y, fx, fy) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: load_case
      real(c_double), value :: x
      real(c_double), value :: y
      real(c_double), value :: fx
      real(c_double), value :: fy
      integer(c_int32_t) :: status
    end function
    function c2d_set_body_force(solver, body, load_case, force, rho_omega2, axis) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: load_case
      real(c_double), value :: rho_omega2
      real(c_double), intent(in) :: force(2)
      real(c_double), intent(in) :: axis(2)
      integer(c_int32_t) :: status
    end function
    function c2d_set_rigid(solver, body, load_case, motion, axis) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: load_case
      real(c_double), intent(in) :: motion(3)
      real(c_double), intent(in) :: axis(2)
      integer(c_int32_t) :: status
    end function
    function c2d_set_rigid_load(solver, body, load_case, is_free, load, point) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: load_case
      integer(c_int32_t), intent(in) :: is_free(3)
      real(c_double), intent(in) :: load(3)
      real(c_double), intent(in) :: point(2)
      integer(c_int32_t) :: status
    end function
    function c2d_add_platen(solver, body, first_element, last_element, elements, is_free, &
        point) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: first_element
      integer(c_int32_t), value :: last_element
      integer(c_int32_t), value :: elements
      integer(c_int32_t), intent(in) :: is_free(3)
      real(c_double), intent(in) :: point(2)
      integer(c_int32_t) :: status
    end function
    function c2d_set_interference(solver, load_case) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: load_case
      integer(c_int32_t) :: status
    end function
    function c2d_add_zone(solver, zone) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      type(c2d_zone), intent(in) :: zone
      integer(c_int32_t) :: status
    end function
    function c2d_tie_zone(solver, zone) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: zone
      integer(c_int32_t) :: status
    end function
    function c2d_add_curve(solver, curve) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      type(c2d_curve), intent(in) :: curve
      integer(c_int32_t) :: status
    end function
    function c2d_add_friction(solver, mu) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      real(c_double), value :: mu
      integer(c_int32_t) :: status
    end function
    function c2d_set_zone_friction(solver, zone, i, mu) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: zone
      integer(c_int32_t), value :: i
      real(c_double), value :: mu
      integer(c_int32_t) :: status
    end function
    function c2d_set_symmetry(solver, axis, value) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: axis
      real(c_double), value :: value
      integer(c_int32_t) :: status
    end function
    function c2d_add_path(solver, increments, load, cases) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: increments
      integer(c_int32_t), value :: cases
      real(c_double), intent(in) :: load(cases)
      integer(c_int32_t) :: status
    end function
    function c2d_clear_paths(solver) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t) :: status
    end function
    function c2d_add_points(solver, points) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      type(c2d_points), intent(in) :: points
      integer(c_int32_t) :: status
    end function
    function c2d_set_units(solver, length, force) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      character(kind=c_char), intent(in) :: length(*)
      character(kind=c_char), intent(in) :: force(*)
      integer(c_int32_t) :: status
    end function
    function c2d_set_name(solver, kind, i, name) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: kind
      integer(c_int32_t), value :: i
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int32_t) :: status
    end function
    function c2d_get_name(solver, kind, i, out) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: kind
      integer(c_int32_t), value :: i
      character(kind=c_char), intent(out) :: out(32)
      integer(c_int32_t) :: status
    end function
    function c2d_set_line(solver, line, column, column_end) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: line
      integer(c_int32_t), value :: column
      integer(c_int32_t), value :: column_end
      integer(c_int32_t) :: status
    end function
    function c2d_complete(solver) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t) :: status
    end function
    function c2d_set_options(solver, options) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      type(c2d_options), intent(in) :: options
      integer(c_int32_t) :: status
    end function
    function c2d_tape_need(limits, options, workspace_bytes, tape, blocks, block_bytes, why) bind(C) result(status)
      import
      type(c2d_limits), intent(in) :: limits
      type(c2d_options), intent(in) :: options
      integer(c_int64_t), value :: workspace_bytes
      integer(c_int32_t), value :: tape
      integer(c_int64_t), intent(out) :: blocks
      integer(c_int64_t), intent(out) :: block_bytes
      type(c2d_error), intent(inout) :: why
      integer(c_int32_t) :: status
    end function
    function c2d_prepare(solver) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t) :: status
    end function
    function c2d_change_loads(solver) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t) :: status
    end function
    function c2d_replace_point_load(solver, i, x, y, fx, fy) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: i
      real(c_double), value :: x
      real(c_double), value :: y
      real(c_double), value :: fx
      real(c_double), value :: fy
      integer(c_int32_t) :: status
    end function
    function c2d_begin(solver, mu, zones) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: zones
      real(c_double), intent(in) :: mu(zones)
      integer(c_int32_t) :: status
    end function
    function c2d_advance(solver, load, cases, outcome) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: cases
      integer(c_int32_t), intent(out) :: outcome
      real(c_double), intent(in) :: load(cases)
      integer(c_int32_t) :: status
    end function
    function c2d_next_event(solver, direction, cases, step) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: cases
      real(c_double), intent(out) :: step
      real(c_double), intent(in) :: direction(cases)
      integer(c_int32_t) :: status
    end function
    function c2d_save(solver) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t) :: status
    end function
    function c2d_restore(solver) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t) :: status
    end function
    function c2d_run(solver, step, context) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      type(c_funptr), value :: step
      type(c_ptr), value :: context
      integer(c_int32_t) :: status
    end function
    function c2d_cancel(solver) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t) :: status
    end function
    function c2d_get(solver, field, body, first, count, out, stride) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: field
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      integer(c_int64_t), value :: stride
      real(c_double), intent(inout) :: out(stride,*)
      integer(c_int32_t) :: status
    end function
    function c2d_interior(solver, body, count, xy, xy_stride, out, out_stride) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: count
      integer(c_int64_t), value :: xy_stride
      integer(c_int64_t), value :: out_stride
      real(c_double), intent(in) :: xy(xy_stride,*)
      real(c_double), intent(inout) :: out(out_stride,*)
      integer(c_int32_t) :: status
    end function
    function c2d_indicators(solver, body, first, count, out, stride) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      integer(c_int64_t), value :: stride
      real(c_double), intent(inout) :: out(stride,*)
      integer(c_int32_t) :: status
    end function
    function c2d_get_summary(solver, out) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      type(c2d_summary), intent(inout) :: out
      integer(c_int32_t) :: status
    end function
    function c2d_get_body_result(solver, body, out) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      type(c2d_body_result), intent(inout) :: out
      integer(c_int32_t) :: status
    end function
    function c2d_get_zone_state(solver, zone, out) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: zone
      type(c2d_zone_state), intent(inout) :: out
      integer(c_int32_t) :: status
    end function
    function c2d_get_body_state(solver, body, out) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      type(c2d_body_state), intent(inout) :: out
      integer(c_int32_t) :: status
    end function
    function c2d_get_friction(solver, zone, i, mu) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: zone
      integer(c_int32_t), value :: i
      real(c_double), intent(out) :: mu
      integer(c_int32_t) :: status
    end function
    function c2d_get_path(solver, i, increments, load, cases) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: i
      integer(c_int32_t), intent(out) :: increments
      integer(c_int32_t), value :: cases
      real(c_double), intent(out) :: load(cases)
      integer(c_int32_t) :: status
    end function
    function c2d_get_zone(solver, i, out) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: i
      type(c2d_zone), intent(inout) :: out
      integer(c_int32_t) :: status
    end function
    function c2d_get_region(solver, body, i, first_element, last_element) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: i
      integer(c_int32_t), intent(out) :: first_element
      integer(c_int32_t), intent(out) :: last_element
      integer(c_int32_t) :: status
    end function
    function c2d_get_condition(solver, body, element, local, load_case, codes, values) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: element
      integer(c_int32_t), value :: local
      integer(c_int32_t), value :: load_case
      integer(c_int32_t), intent(out) :: codes(4)
      real(c_double), intent(out) :: values(4)
      integer(c_int32_t) :: status
    end function
    function c2d_get_point_load(solver, i, body, load_case, xy, force) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: i
      integer(c_int32_t), intent(out) :: body
      integer(c_int32_t), intent(out) :: load_case
      real(c_double), intent(out) :: xy(2)
      real(c_double), intent(out) :: force(2)
      integer(c_int32_t) :: status
    end function
    function c2d_get_points(solver, i, out) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: i
      type(c2d_points), intent(inout) :: out
      integer(c_int32_t) :: status
    end function
    function c2d_get_curve(solver, i, out) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: i
      type(c2d_curve), intent(inout) :: out
      integer(c_int32_t) :: status
    end function
    function c2d_expand_points(points, first, count, xy, stride, total) bind(C) result(status)
      import
      type(c2d_points), intent(in) :: points
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      integer(c_int64_t), value :: stride
      integer(c_int32_t), intent(out) :: total
      real(c_double), intent(inout) :: xy(stride,*)
      integer(c_int32_t) :: status
    end function
    function c2d_get_body_force(solver, body, load_case, force, rho_omega2, axis) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: load_case
      real(c_double), intent(out) :: rho_omega2
      real(c_double), intent(out) :: force(2)
      real(c_double), intent(out) :: axis(2)
      integer(c_int32_t) :: status
    end function
    function c2d_get_rigid(solver, body, load_case, is_rigid, motion, axis) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: body
      integer(c_int32_t), value :: load_case
      integer(c_int32_t), intent(out) :: is_rigid
      real(c_double), intent(out) :: motion(3)
      real(c_double), intent(out) :: axis(2)
      integer(c_int32_t) :: status
    end function
    function c2d_get_interference(solver, load_case) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), intent(out) :: load_case
      integer(c_int32_t) :: status
    end function
    function c2d_get_state(solver) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t) :: status
    end function
    function c2d_last_error(solver, out) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      type(c2d_error), intent(inout) :: out
      integer(c_int32_t) :: status
    end function
    function c2d_message_address(status) bind(C, name='c2d_message') result(answer)
      import
      integer(c_int32_t), value :: status
      type(c_ptr) :: answer
    end function
    function c2d_outcome_message_address(outcome) bind(C, name='c2d_outcome_message') result(status)
      import
      integer(c_int32_t), value :: outcome
      type(c_ptr) :: status
    end function
    function c2d_version_address() bind(C, name='c2d_version') result(status)
      import
      type(c_ptr) :: status
    end function
    subroutine c2d_link_holes() bind(C)
    end subroutine
    subroutine c2d_link_free_zones() bind(C)
    end subroutine
    subroutine c2d_link_warnings() bind(C)
    end subroutine
    subroutine c2d_link_search() bind(C)
    end subroutine
    subroutine c2d_link_compressed() bind(C)
    end subroutine
    subroutine c2d_link_axisymmetric() bind(C)
    end subroutine
    function c2d_walk_deck(read, context, body, bodies, card, card_context, report, &
        report_context) bind(C) result(status)
      import
      type(c_funptr), value :: read
      type(c_ptr), value :: context
      integer(c_int32_t), value :: bodies
      type(c_funptr), value :: card
      type(c_ptr), value :: card_context
      type(c_funptr), value :: report
      type(c_ptr), value :: report_context
      type(c2d_body_limits), intent(inout) :: body(*)
      integer(c_int32_t) :: status
    end function
    function c2d_cycle(solver, request, each, context, out) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      type(c2d_cycle_request), intent(in) :: request
      type(c_funptr), value :: each
      type(c_ptr), value :: context
      type(c2d_cycle_state), intent(inout) :: out
      integer(c_int32_t) :: status
    end function
    function c2d_repeat_paths(solver, pieces, limit, digits, start) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: pieces
      integer(c_int32_t), value :: limit
      integer(c_int32_t), value :: digits
      integer(c_int32_t), value :: start
      integer(c_int32_t) :: status
    end function
    function c2d_get_repeated(solver, first, pieces, limit, digits, start) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), intent(out) :: first
      integer(c_int32_t), intent(out) :: pieces
      integer(c_int32_t), intent(out) :: limit
      integer(c_int32_t), intent(out) :: digits
      integer(c_int32_t), intent(out) :: start
      integer(c_int32_t) :: status
    end function
    function c2d_get_cycle_state(solver, out) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      type(c2d_cycle_state), intent(inout) :: out
      integer(c_int32_t) :: status
    end function
    function c2d_get_cycle(solver, field, first, count, out, stride) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: field
      integer(c_int32_t), value :: first
      integer(c_int32_t), value :: count
      integer(c_int64_t), value :: stride
      real(c_double), intent(inout) :: out(stride,*)
      integer(c_int32_t) :: status
    end function
    function c2d_get_cycle_zone(solver, zone, out) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int32_t), value :: zone
      type(c2d_cycle_zone), intent(inout) :: out
      integer(c_int32_t) :: status
    end function
    function c2d_image_sum(solver, sum) bind(C) result(status)
      import
      type(c_ptr), value :: solver
      integer(c_int64_t), intent(out) :: sum
      integer(c_int32_t) :: status
    end function
    function c2d_attach_image(out, memory, bytes, port, sum, why) bind(C) result(status)
      import
      type(c_ptr), intent(out) :: out
      type(c_ptr), value :: memory
      integer(c_size_t), value :: bytes
      type(c2d_port), intent(in) :: port
      integer(c_int64_t), value :: sum
      type(c2d_error), intent(inout) :: why
      integer(c_int32_t) :: status
    end function
    subroutine c2d_memory_store_init(store, region, bytes) bind(C)
      import
      type(c2d_memory_store), intent(inout) :: store
      type(c_ptr), value :: region
      integer(c_int64_t), value :: bytes
    end subroutine
    function c2d_memory_store_need(store) bind(C) result(status)
      import
      type(c2d_memory_store), intent(in) :: store
      integer(c_int64_t) :: status
    end function
    subroutine c2d_memory_store_port(store, out) bind(C)
      import
      type(c2d_memory_store), intent(inout) :: store
      type(c2d_port), intent(inout) :: out
    end subroutine
    function c2d_posix_store_init(store, folder) bind(C) result(status)
      import
      type(c2d_posix_store), intent(inout) :: store
      character(kind=c_char), intent(in) :: folder(*)
      integer(c_int32_t) :: status
    end function
    subroutine c2d_posix_store_port(store, out) bind(C)
      import
      type(c2d_posix_store), intent(inout) :: store
      type(c2d_port), intent(inout) :: out
    end subroutine
    subroutine c2d_posix_store_expect(store, tape, bytes) bind(C)
      import
      type(c2d_posix_store), intent(inout) :: store
      integer(c_int32_t), value :: tape
      integer(c_int64_t), value :: bytes
    end subroutine
    function c2d_posix_store_remove(store) bind(C) result(status)
      import
      type(c2d_posix_store), intent(inout) :: store
      integer(c_int32_t) :: status
    end function
    function c2d_posix_store_done(store) bind(C) result(status)
      import
      type(c2d_posix_store), intent(inout) :: store
      integer(c_int32_t) :: status
    end function
    function c2d_posix_store_discard(store, folder) bind(C) result(status)
      import
      type(c2d_posix_store), intent(inout) :: store
      character(kind=c_char), intent(in) :: folder(*)
      integer(c_int32_t) :: status
    end function
    function c2d_stdio_store_init(store, folder) bind(C) result(status)
      import
      type(c2d_stdio_store), intent(inout) :: store
      character(kind=c_char), intent(in) :: folder(*)
      integer(c_int32_t) :: status
    end function
    subroutine c2d_stdio_store_port(store, out) bind(C)
      import
      type(c2d_stdio_store), intent(inout) :: store
      type(c2d_port), intent(inout) :: out
    end subroutine
    function c2d_stdio_store_remove(store) bind(C) result(status)
      import
      type(c2d_stdio_store), intent(inout) :: store
      integer(c_int32_t) :: status
    end function
    function c2d_threads_start(pool, threads) bind(C) result(status)
      import
      type(c2d_threads), intent(inout) :: pool
      integer(c_int32_t), value :: threads
      integer(c_int32_t) :: status
    end function
    subroutine c2d_threads_port(pool, out) bind(C)
      import
      type(c2d_threads), intent(inout) :: pool
      type(c2d_port), intent(inout) :: out
    end subroutine
    subroutine c2d_threads_run(pool, n, task, argument) bind(C)
      import
      type(c2d_threads), intent(inout) :: pool
      integer(c_int32_t), value :: n
      type(c_funptr), value :: task
      type(c_ptr), value :: argument
    end subroutine
    subroutine c2d_threads_stop(pool) bind(C)
      import
      type(c2d_threads), intent(inout) :: pool
    end subroutine
  end interface

contains

  ! A text of C's as a string: of a struct's array of characters, up to its zero byte.
  pure function c2d_string(text) result(string)
    character(kind=c_char), intent(in) :: text(:)
    character(:), allocatable :: string
    integer :: i, length
    length = 0
    do while (length < size(text))
      if (text(length + 1) == c_null_char) exit
      length = length + 1
    end do
    allocate (character(length) :: string)
    do i = 1, length
      string(i:i) = text(i)
    end do
  end function

  ! The other way: what does not fit is cut off.
  pure subroutine c2d_set_string(text, string)
    character(kind=c_char), intent(out) :: text(:)
    character(*), intent(in) :: string
    integer :: i
    text = c_null_char
    do i = 1, min(len(string), size(text) - 1)
      text(i) = string(i:i)
    end do
  end subroutine

  function c2d_message(status) result(string)
    integer(c_int32_t), intent(in) :: status
    character(:), allocatable :: string
    string = string_at(c2d_message_address(status))
  end function

  function c2d_outcome_message(outcome) result(string)
    integer(c_int32_t), intent(in) :: outcome
    character(:), allocatable :: string
    string = string_at(c2d_outcome_message_address(outcome))
  end function

  function c2d_version() result(string)
    character(:), allocatable :: string
    string = string_at(c2d_version_address())
  end function

  function string_at(address) result(string)
    type(c_ptr), intent(in) :: address
    character(:), allocatable :: string
    character(kind=c_char), pointer :: text(:)
    integer :: length
    length = 0
    do
      call c_f_pointer(address, text, [length + 1])
      if (text(length + 1) == c_null_char) exit
      length = length + 1
    end do
    string = c2d_string(text)
  end function

end module contact2d
