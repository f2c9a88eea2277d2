/* A model by calls, all its results, and a saved and restored state. A steel block stands on an aluminium block. It is pressed
   down by 50 N/mm2 and pushed back and forth on its upper face; only the contact supports it. C99, and valid C++.

     cc -std=c99 -Iinclude examples/model_by_calls.c build/libcontact2d.a -lm -o build/model_by_calls
     build/model_by_calls

   or, with an installed library, `cc -std=c99 model_by_calls.c -lcontact2d -lm`. N and mm.                             */
#include "contact2d.h"

#include <stdio.h>
#include <string.h>

/* ---- the blocks: 8 elements along, 4 up, counter-clockwise from the lower left corner ---- */
enum { ALONG = 8, UP = 4, ELEMENTS = 2 * (ALONG + UP), PAIRS = ALONG + 1, ENDS = 2 * ELEMENTS, CASES = 2 };
enum { RIGHT = ALONG + 1, TOP = RIGHT + UP, LEFT = TOP + ALONG }; /* first elements of the sides, and their first nodes */
static const double width = 16.0, height[2] = {8.0, 6.0}, bottom[2] = {-8.0, 0.0};

/* ---- a block store of this program: the blocks of a tape lie one after another in an array ---- */
typedef struct Tape {
  unsigned char* bytes;
  uint64_t blocks, block_bytes, room;
} Tape;
typedef struct Store {
  Tape tape[C2D_TAPES];
} Store;

/* Keeps the blocks of an earlier run: they contain its saved state. */
static int32_t open_tape(void* context, int32_t tape, uint64_t blocks, uint64_t block_bytes) {
  Tape* t = &((Store*)context)->tape[tape];
  if (block_bytes != 0 && blocks > t->room / block_bytes) return 1;
  t->blocks = blocks, t->block_bytes = block_bytes;
  return 0;
}
static int32_t read_block(void* context, int32_t tape, uint64_t block, void* data, uint64_t bytes) {
  const Tape* t = &((Store*)context)->tape[tape];
  if (block >= t->blocks || bytes > t->block_bytes) return 2;
  memcpy(data, t->bytes + block * t->block_bytes, (size_t)bytes);
  return 0;
}
static int32_t write_block(void* context, int32_t tape, uint64_t block, const void* data, uint64_t bytes) {
  Tape* t = &((Store*)context)->tape[tape];
  if (block >= t->blocks || bytes > t->block_bytes) return 3;
  memcpy(t->bytes + block * t->block_bytes, data, (size_t)bytes);
  return 0;
}
static int32_t sync_or_close(void* context, int32_t tape) {
  (void)context;
  (void)tape;
  return 0; /* nothing to do for memory */
}
static void report(void* context, const c2d_error* entry) {
  (void)context;
  fprintf(stderr, "%s: %s\n", entry->severity == C2D_FAULT ? "error" : "note", entry->text);
}
static c2d_port port_of(Store* store) {
  c2d_port port = C2D_INIT(c2d_port);
  port.context = store;
  port.open = open_tape, port.read = read_block, port.write = write_block;
  port.sync = sync_or_close, port.close = sync_or_close;
  port.log = report;
  return port;
}

/* ---- the model ---- */
static int add_block(c2d_solver* solver, int32_t b, const char* name, double modulus, double ratio) {
  const double y = bottom[b - 1], h = height[b - 1];
  const double corner[5][2] = {{0, y}, {width, y}, {width, y + h}, {0, y + h}, {0, y}};
  const int32_t first[5] = {1, RIGHT, TOP, LEFT, ELEMENTS + 1};
  double xy[ELEMENTS][2];
  c2d_body body = C2D_INIT(c2d_body);
  int bad, side, i;
  body.element_nodes = 2, body.elements = ELEMENTS, body.regions = 1;
  body.youngs_modulus = modulus, body.poisson_ratio = ratio;
  for (side = 0; side < 4; ++side) {
    const int n = first[side + 1] - first[side];
    for (i = 0; i < n; ++i) {
      xy[first[side] - 1 + i][0] = corner[side][0] + (corner[side + 1][0] - corner[side][0]) * i / n;
      xy[first[side] - 1 + i][1] = corner[side][1] + (corner[side + 1][1] - corner[side][1]) * i / n;
    }
  }
  bad = c2d_set_body(solver, b, &body) != C2D_OK;
  bad |= c2d_add_region(solver, b, 1, ELEMENTS) != C2D_OK;
  bad |= c2d_set_nodes(solver, b, 1, ELEMENTS, xy[0], 2) != C2D_OK;
  return bad | (c2d_set_name(solver, C2D_NAME_BODY, b, name) != C2D_OK);
}

static int build(c2d_solver* solver) {
  static const int32_t fixed[4] = {1, 1, 0, 0}, loaded[4] = {0, 0, 1, 1};                       /* tx ty ux uy */
  static const double zero[4] = {0, 0, 0, 0}, load[CASES][4] = {{0, -50, 0, 0}, {10, 0, 0, 0}}; /* per load case */
  c2d_problem problem = C2D_INIT(c2d_problem);
  c2d_zone zone = C2D_INIT(c2d_zone);
  int32_t e, end, k;
  int bad;
  problem.plane = C2D_PLANE_STRAIN, problem.analysis = C2D_ANALYSIS_FULL;
  strcpy(problem.title, "steel on aluminium, back and forth");
  bad = c2d_set_problem(solver, &problem) != C2D_OK;
  bad |= add_block(solver, 1, "aluminium", 70000.0, 0.33) | add_block(solver, 2, "steel", 210000.0, 0.30);
  for (k = 1; k <= CASES; ++k) {
    for (end = 1; end <= 2; ++end) {
      for (e = 1; e < RIGHT; ++e) bad |= c2d_set_condition(solver, 1, e, end, k, fixed, zero) != C2D_OK;
      for (e = TOP; e < LEFT; ++e) bad |= c2d_set_condition(solver, 2, e, end, k, loaded, load[k - 1]) != C2D_OK;
    }
  }
  zone.pairs = PAIRS; /* the upper side of body 1, from right to left, against the lower side of body 2 */
  zone.side1.body = 1, zone.side1.first_element = TOP, zone.side1.last_element = LEFT - 1;
  zone.side1.first_node = TOP, zone.side1.last_node = LEFT;
  zone.side2.body = 2, zone.side2.first_element = ALONG, zone.side2.last_element = 1;
  zone.side2.first_node = RIGHT, zone.side2.last_node = 1;
  bad |= c2d_add_zone(solver, &zone) != C2D_OK;
  bad |= c2d_set_units(solver, "mm", "N") != C2D_OK;
  return bad | (c2d_complete(solver) != C2D_OK);
}

/* ---- every result, at the load reached ---- */
static int show_pairs(c2d_solver* solver) {
  static const char* const word[] = {"open", "stick", "slip", "tied"};
  double field[C2D_PAIR_FIELDS][PAIRS];
  int bad = 0, f, p;
  for (f = 0; f < C2D_PAIR_FIELDS; ++f) bad |= c2d_get(solver, f, 0, 1, PAIRS, field[f], 1) != C2D_OK;
  for (p = 0; p < PAIRS && !bad; ++p)
    printf("  pair %d at x %6.2f  %-5s  pressure %8.3f  friction %8.3f  gap %9.2e  slip %9.2e\n", p + 1, field[C2D_X][p],
           word[(int)field[C2D_STATUS][p]], field[C2D_TN][p], field[C2D_TT][p], field[C2D_GAP][p], field[C2D_SLIP_SUM][p]);
  return bad;
}

/* The largest magnitude of the entries of a field. */
static double largest(c2d_solver* solver, int32_t field, int32_t body, int32_t count, int* bad) {
  double values[ENDS], most = 0.0;
  int i;
  *bad |= c2d_get(solver, field, body, 1, count, values, 1) != C2D_OK;
  for (i = 0; i < count && !*bad; ++i) {
    const double size = values[i] < 0 ? -values[i] : values[i];
    if (size > most) most = size;
  }
  return most;
}

static int show_bodies(c2d_solver* solver) {
  double off[ELEMENTS][C2D_OFF_FIELDS], point[2], inside[C2D_POINT_FIELDS], hoop;
  char name[32];
  int bad = 0, b, e;
  for (b = 1; b <= 2; ++b) {
    c2d_body_result sums = C2D_INIT(c2d_body_result);
    c2d_body_state state = C2D_INIT(c2d_body_state);
    double error_energy = 0.0;
    bad |= c2d_get_name(solver, C2D_NAME_BODY, b, name) != C2D_OK;
    bad |= c2d_get_body_state(solver, b, &state) != C2D_OK;
    bad |= c2d_indicators(solver, b, 1, ELEMENTS, off[0], C2D_OFF_FIELDS) != C2D_OK;
    for (e = 0; e < ELEMENTS; ++e) error_energy += off[e][C2D_OFF_EQUATION_ENERGY] + off[e][C2D_OFF_CONTACT_ENERGY];
    point[0] = 0.5 * width, point[1] = bottom[b - 1] + 0.5 * height[b - 1];
    bad |= c2d_interior(solver, b, 1, point, 2, inside, C2D_POINT_FIELDS) != C2D_OK;
    hoop = largest(solver, C2D_END_HOOP, b, ENDS, &bad);
    bad |= c2d_get_body_result(solver, b, &sums) != C2D_OK; /* after the results of the boundary, which give the reactions */
    printf("  %s: contact force (%.4f, %.4f), moment %.3f; applied (%.4f, %.4f)\n", name, state.contact[0], state.contact[1],
           state.contact[2], sums.applied[0], sums.applied[1]);
    printf("    largest displacement %.4e, traction %.3f, hoop stress %.3f, von Mises on the boundary %.3f\n",
           largest(solver, C2D_END_UX, b, ENDS, &bad), largest(solver, C2D_END_TY, b, ENDS, &bad), hoop,
           largest(solver, C2D_END_VON_MISES, b, ENDS, &bad));
    printf("    in the middle: sxx %.3f, syy %.3f, sxy %.3f, von Mises %.3f; energy of the mesh error: %.2e\n",
           inside[C2D_POINT_SXX], inside[C2D_POINT_SYY], inside[C2D_POINT_SXY], inside[C2D_POINT_VON_MISES], error_energy);
  }
  return bad;
}

static int show(c2d_solver* solver) {
  c2d_zone_state zone = C2D_INIT(c2d_zone_state);
  c2d_summary summary = C2D_INIT(c2d_summary);
  int bad = c2d_get_zone_state(solver, 1, &zone) != C2D_OK;
  bad |= c2d_get_summary(solver, &summary) != C2D_OK;
  printf("  zone: %d stick, %d slip, %d open; force (%.4f, %.4f), moment %.3f; shift %.4e, approach %.4e\n", (int)zone.stick,
         (int)zone.slip, (int)zone.open, zone.force[0], zone.force[1], zone.moment, zone.shift, zone.approach);
  printf("  %s: %s; work %.5f, elastic %.5f, dissipated %.5f; %d events, residual %.0e\n", summary.title,
         c2d_outcome_message(summary.outcome), summary.work, summary.elastic, summary.dissipated, (int)summary.events,
         summary.max_residual);
  return bad | show_pairs(solver) | show_bodies(solver);
}

/* ---- the load: pressed, then pushed back and forth; a point of the loop after each quarter ---- */
static int follow(c2d_solver* solver, int first, int last, double shifts[]) {
  static const double push[] = {0.0, 1.0, 0.0, -1.0, 0.0, 1.0, 0.0, -1.0, 0.0};
  int i;
  for (i = first; i <= last; ++i) {
    const double load[CASES] = {1.0, push[i]};
    c2d_outcome outcome = C2D_REACHED;
    c2d_zone_state zone = C2D_INIT(c2d_zone_state);
    if (c2d_advance(solver, load, CASES, &outcome) != C2D_OK || c2d_get_zone_state(solver, 1, &zone) != C2D_OK) return 1;
    if (outcome != C2D_REACHED) {
      printf("the path ended: %s\n", c2d_outcome_message(outcome));
      return 1;
    }
    shifts[i] = zone.shift;
  }
  return 0;
}

static c2d_limits sizes_of_model(c2d_body_limits bodies[2]) {
  c2d_limits sizes = C2D_INIT(c2d_limits);
  int b;
  for (b = 0; b < 2; ++b) bodies[b].points = ELEMENTS, bodies[b].elements = ELEMENTS, bodies[b].regions = 1;
  sizes.bodies = 2, sizes.body = bodies, sizes.function_nodes = 2;
  sizes.zones = 1, sizes.pairs = PAIRS, sizes.contact_elements = ALONG, sizes.load_cases = CASES;
  return sizes;
}

static int fail(const char* what, c2d_solver* solver) {
  c2d_error why = C2D_INIT(c2d_error);
  if (solver != NULL) c2d_last_error(solver, &why);
  fprintf(stderr, "%s: %s\n", what, why.text);
  return 1;
}

/* Repeats the second cycle: in the solver that saved, and in another one on the same store, as after a crash. */
static int repeat_cycle(c2d_solver* solver, c2d_solver* other, double shifts[]) {
  double again[9], once_more[9];
  if (follow(solver, 5, 8, shifts) != 0) return fail("second cycle", solver);
  if (c2d_restore(solver) != C2D_OK || follow(solver, 5, 8, again) != 0) return fail("restore", solver);
  if (build(other) != 0 || c2d_restore(other) != C2D_OK || follow(other, 5, 8, once_more) != 0) return fail("other", other);
  if (memcmp(again + 5, shifts + 5, 4 * sizeof(double)) != 0 || memcmp(once_more + 5, shifts + 5, 4 * sizeof(double)) != 0) {
    puts("restored states differ");
    return 1;
  }
  puts("restored twice, the same bits");
  return 0;
}

int main(void) {
  static unsigned char memory[2][1 << 18], tapes[C2D_TAPES][1 << 18];
  const double mu = 0.3;
  double shifts[9];
  c2d_body_limits bodies[2];
  const c2d_limits sizes = sizes_of_model(bodies);
  Store store;
  c2d_port port;
  c2d_solver *solver = NULL, *other = NULL;
  int bad, i;
  memset(&store, 0, sizeof store);
  for (i = 0; i < C2D_TAPES; ++i) store.tape[i].bytes = tapes[i], store.tape[i].room = sizeof tapes[i];
  port = port_of(&store);
  if (c2d_create(&solver, memory[0], sizeof memory[0], &sizes, &port, NULL) != C2D_OK) return fail("create", NULL);
  if (c2d_create(&other, memory[1], sizeof memory[1], &sizes, &port, NULL) != C2D_OK) return fail("create", NULL);
  if (build(solver) != 0) return fail("model", solver);
  if (c2d_prepare(solver) != C2D_OK || c2d_begin(solver, &mu, 1) != C2D_OK) return fail("prepare", solver);
  if (follow(solver, 0, 4, shifts) != 0) return fail("path", solver);
  puts("after a cycle:");
  if (show(solver) != 0 || c2d_save(solver) != C2D_OK) return fail("results", solver);
  bad = repeat_cycle(solver, other, shifts);
  puts("push and mean slip, the second cycle closed:");
  for (i = 0; i < 9; ++i) printf("  %d %12.5e\n", i, shifts[i]);
  bad |= c2d_close(solver) != C2D_OK;
  return bad | (c2d_close(other) != C2D_OK);
}
