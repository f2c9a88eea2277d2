/* A mesh refined by the host program: a rigid cylinder on a flat block, smooth. Every round solves on a mesh and on the same
   mesh with every element halved, and states the error from the difference. It then halves the elements that c2d_indicators
   marks, until the error is small enough. Static memory, no files. C99, and valid C++.

     cc -std=c99 -Iinclude -Iport/memory examples/adapt.c build/libcontact2d.a -lm -o build/adapt && build/adapt          */
#include "c2d_memory.h"
#include "contact2d.h"

#include <math.h>
#include <stdio.h>

#define MOST 256  /* elements of the zone */
#define SIDE 6    /* elements of the bottom and of the right side of the block */
#define OUTER 32  /* most elements of its top outside the zone */
static const double kRadius = 100, kZone = 2, kSize = 300, kModulus = 1000, kNu = 0.3, kLoad = 8.630447; /* half width 1 */
static unsigned char memory[8 << 20], tapes[16 << 20];

typedef struct Mesh {
  int n;              /* elements */
  double x[MOST + 1]; /* their ends, beginning at the axis of symmetry */
} Mesh;
typedef struct Result {
  double pressure[MOST + 1], density[MOST]; /* energy of the mesh error per length */
} Result;

static void report(void* context, const c2d_error* entry) {
  (void)context;
  if (entry->severity == C2D_FAULT) fprintf(stderr, "%s\n", entry->text);
}

/* The right half of the block, counter-clockwise from the axis to the axis; its last n elements are the zone. */
static int block_points(const Mesh* mesh, double xy[][2]) {
  int i, count = 0, outer = 0;
  double at[OUTER], step = mesh->x[mesh->n] - mesh->x[mesh->n - 1], x = kZone;
  while (outer < OUTER - 1 && x + (step *= 1.4) < 0.8 * kSize) at[outer++] = x += step;
  for (i = 0; i < SIDE; ++i, ++count) xy[count][0] = kSize * i / SIDE, xy[count][1] = -kSize;
  for (i = 0; i < SIDE; ++i, ++count) xy[count][0] = kSize, xy[count][1] = -kSize * (SIDE - i) / SIDE;
  xy[count][0] = kSize, xy[count++][1] = 0;
  for (i = outer; i-- > 0; ++count) xy[count][0] = at[i], xy[count][1] = 0;
  for (i = mesh->n; i >= 0; --i, ++count) xy[count][0] = mesh->x[i], xy[count][1] = 0;
  return count;
}

/* The arc, and back to the axis. */
static int cylinder_points(const Mesh* mesh, double xy[][2]) {
  int i;
  for (i = 0; i <= mesh->n; ++i) {
    xy[i][0] = mesh->x[i];
    xy[i][1] = kRadius - sqrt(kRadius * kRadius - mesh->x[i] * mesh->x[i]);
  }
  xy[i][0] = 0, xy[i][1] = kRadius;
  return i + 1;
}

static int add_body(c2d_solver* s, int number, int points, double xy[][2]) {
  c2d_body body = C2D_INIT(c2d_body);
  body.element_nodes = 2, body.elements = points - 1, body.regions = body.open_regions = 1;
  body.youngs_modulus = kModulus, body.poisson_ratio = kNu;
  return c2d_set_body(s, number, &body) || c2d_add_region(s, number, 1, points - 1) ||
         c2d_set_nodes(s, number, 1, points, xy[0], 2);
}

static int build(c2d_solver* s, const Mesh* mesh, int points, double block[][2], double cylinder[][2]) {
  static const int32_t fixed[4] = {0, 1, 1, 0}, falls[3] = {0, 1, 0};
  const double zero[4] = {0, 0, 0, 0}, force[3] = {0, -0.5 * kLoad, 0}, centre[2] = {0, kRadius};
  const int n = mesh->n;
  int e, bad;
  c2d_problem problem = C2D_INIT(c2d_problem);
  c2d_zone zone = C2D_INIT(c2d_zone);
  c2d_curve arc = C2D_INIT(c2d_curve);
  problem.analysis = C2D_ANALYSIS_FULL;
  bad = c2d_set_problem(s, &problem) || c2d_set_symmetry(s, 0, 0.0) || add_body(s, 1, points, block) ||
        add_body(s, 2, n + 2, cylinder);
  for (e = 1; e <= SIDE && !bad; ++e)
    bad = c2d_set_condition(s, 1, e, 1, 1, fixed, zero) || c2d_set_condition(s, 1, e, 2, 1, fixed, zero);
  arc.kind = C2D_CURVE_ARC, arc.body = 2, arc.first_element = 1, arc.last_element = n;
  arc.centre[1] = arc.radius = kRadius;
  zone.pairs = n + 1;
  zone.side1.body = 1, zone.side1.first_element = points - n, zone.side1.last_element = points - 1;
  zone.side1.first_node = points - n, zone.side1.last_node = points;
  zone.side2.body = 2, zone.side2.first_element = n, zone.side2.last_element = 1;
  zone.side2.first_node = n + 1, zone.side2.last_node = 1;
  return bad || c2d_add_curve(s, &arc) || c2d_set_rigid_load(s, 2, 0, falls, NULL, centre) ||
         c2d_set_rigid_load(s, 2, 1, falls, force, centre) || c2d_add_zone(s, &zone) || c2d_complete(s);
}

static int solve(const Mesh* mesh, Result* out) {
  static double block[2 * SIDE + OUTER + MOST + 2][2], cylinder[MOST + 2][2], rows[MOST][C2D_OFF_FIELDS], p[MOST + 1];
  const double smooth = 0, full = 1;
  const int n = mesh->n, points = block_points(mesh, block);
  int i, bad;
  c2d_body_limits bodies[2] = {{0, 0, 0, 0}, {0, 0, 0, 0}};
  c2d_limits sizes = C2D_INIT(c2d_limits);
  c2d_error why = C2D_INIT(c2d_error);
  c2d_port port = C2D_INIT(c2d_port);
  c2d_outcome outcome = C2D_REACHED;
  c2d_memory_store store;
  c2d_solver* s = NULL;
  bodies[0].points = points, bodies[1].points = cylinder_points(mesh, cylinder);
  for (i = 0; i < 2; ++i) bodies[i].elements = bodies[i].points - 1, bodies[i].regions = 1;
  sizes.bodies = 2, sizes.body = bodies, sizes.function_nodes = 2;
  sizes.zones = 1, sizes.pairs = n + 1, sizes.contact_elements = n, sizes.curves = 1;
  c2d_memory_store_init(&store, tapes, sizeof tapes);
  c2d_memory_store_port(&store, &port);
  port.log = report;
  if (c2d_create(&s, memory, sizeof memory, &sizes, &port, &why) != C2D_OK) return puts(why.text), 1;
  bad = build(s, mesh, points, block, cylinder) || c2d_prepare(s) || c2d_begin(s, &smooth, 1) ||
        c2d_advance(s, &full, 1, &outcome) || outcome != C2D_REACHED || c2d_get(s, C2D_TN, 0, 1, n + 1, p, 1) ||
        c2d_indicators(s, 1, points - n, n, rows[0], C2D_OFF_FIELDS);
  for (i = 0; i <= n && !bad; ++i) out->pressure[n - i] = p[i]; /* the zone begins at its far end */
  for (i = 0; i < n && !bad; ++i) out->density[n - 1 - i] = rows[i][C2D_OFF_CONTACT_ENERGY] / rows[i][C2D_OFF_LENGTH];
  return c2d_close(s) != C2D_OK || bad;
}

/* Halves every element, or only those with a density above `least`. */
static Mesh bisected(const Mesh* mesh, const Result* by, double least) {
  Mesh out;
  int i;
  out.n = 0;
  for (i = 0; i < mesh->n; ++i) {
    out.x[out.n++] = mesh->x[i];
    if (by == NULL || by->density[i] > least) out.x[out.n++] = 0.5 * (mesh->x[i] + mesh->x[i + 1]);
  }
  out.x[out.n] = mesh->x[mesh->n];
  return out;
}

/* Twice the difference between the pressures on a mesh and on the halved mesh, relative to the latter, both as root of the
   integral of squares. */
static double stated_error(const Mesh* mesh, const Result* coarse, const Result* fine) {
  double off = 0, all = 0;
  int i;
  for (i = 0; i < 2 * mesh->n; ++i) {
    const double h = 0.5 * (mesh->x[i / 2 + 1] - mesh->x[i / 2]), a = fine->pressure[i], b = fine->pressure[i + 1];
    const double middle = 0.5 * (coarse->pressure[i / 2] + coarse->pressure[i / 2 + 1]);
    const double c = a - (i % 2 == 0 ? coarse->pressure[i / 2] : middle);
    const double d = b - (i % 2 == 0 ? middle : coarse->pressure[i / 2 + 1]);
    off += h * (c * c + c * d + d * d), all += h * (a * a + a * b + b * b);
  }
  return 2 * sqrt(off / all);
}

int main(void) {
  static Result coarse, fine;
  Mesh mesh = {4, {0, 0.5, 1, 1.5, 2}};
  int round;
  for (round = 1; 2 * mesh.n <= MOST; ++round) {
    const Mesh halves = bisected(&mesh, NULL, 0);
    double error, most = 0;
    int i;
    if (solve(&mesh, &coarse) || solve(&halves, &fine)) return 1;
    error = stated_error(&mesh, &coarse, &fine);
    printf("round %2d: %3d elements, pressure %.5f, stated error of the pressures %.2g %%\n", round, halves.n,
           fine.pressure[0], 100 * error);
    if (error < 1e-3) return 0;
    for (i = 0; i < mesh.n; ++i) most = fmax(most, coarse.density[i]);
    mesh = bisected(&mesh, &coarse, 0.2 * most);
  }
  puts("the required error was not reached");
  return 1;
}
