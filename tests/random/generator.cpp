#include "generator.hpp"

#include "../dice.hpp"
#include "scenes.hpp"

#include <cmath>
#include <limits>

namespace random_decks {

namespace {

using problem::Problem;

size_t index(int64_t i) { return static_cast<size_t>(i); }

double random_friction(Dice& dice) {
  const double kind = dice.unit();
  if (kind < 0.12) return 0;
  if (kind < 0.70) return dice.between(0.05, 1);
  if (kind < 0.90) return dice.between(1, 2);
  if (kind < 0.96) return 3;
  return std::numeric_limits<double>::infinity();
}

double random_poisson(Dice& dice, int32_t plane) {
  const double kind = dice.unit();
  if (kind < 0.45) return 0.3;
  if (kind < 0.55) return 0.5;
  if (kind < 0.65) return 0;
  return dice.between(plane == C2D_PLANE_STRESS ? -0.45 : -0.5, 0.5);
}

void set_materials(Problem& p, Dice& dice) {
  p.plane = dice.chance(0.3) ? C2D_PLANE_STRESS : C2D_PLANE_STRAIN;
  const double ratio = dice.chance(0.4) ? 1 : dice.power(-4, 4);
  for (size_t b = 0; b < 2; ++b) {
    p.bodies[b].youngs_modulus = b == 0 ? 1000 : 1000 * ratio;
    p.bodies[b].poisson_ratio = random_poisson(dice, p.plane);
  }
  if (dice.chance(0.5)) p.bodies[1].poisson_ratio = p.bodies[0].poisson_ratio;
}

// ---- how bodies are held ----------------------------------------------------------------------------------------------

void clamp(Side& side) { side.condition.fixed[0] = side.condition.fixed[1] = true; }

// The body that does not move as a whole, held on its base (or its top, if the other one is loaded from below).
void hold(Outlines& body, int32_t base, int32_t other, Dice& dice) {
  std::vector<Side>& outline = body.regions[0];
  const int32_t sides = static_cast<int32_t>(outline.size());
  const double kind = dice.unit();
  if (kind < 0.55) {
    clamp(outline[index(base)]);
  } else if (kind < 0.65) {
    clamp(outline[index(other)]);
  } else if (kind < 0.85) { // a roller and a point
    outline[index(base)].condition.fixed[1] = true;
    body.pins.push_back({0, base, 0});
  } else { // statically determinate: three reactions
    body.pins.push_back({0, base, 0});
    body.pins.push_back({0, base, 1});
    body.pins.push_back({0, (base + 1) % sides, 1});
  }
}

// The other one: free, or held in part. True: its top moves as told.
bool hold_loosely(Outlines& body, int32_t top, int32_t other, bool round, Dice& dice) {
  std::vector<Side>& outline = body.regions[0];
  const double kind = round ? dice.between(0.55, 1) : dice.unit();
  if (kind < 0.60) return false;
  if (kind < 0.72) {
    body.pins.push_back({0, (top + 1) % static_cast<int32_t>(outline.size()), 0});
    return false;
  }
  if (kind < 0.82) { // slides along a wall
    outline[index(other)].condition.fixed[0] = outline[index(other)].zone == 0;
    return false;
  }
  if (kind < 0.88) { // guided: it may not slide
    outline[index(top)].condition.fixed[0] = true;
    return false;
  }
  clamp(outline[index(top)]);
  return true;
}

// Half of a symmetric problem, its line meshed: neither body moves across x = 0.
void hold_at_symmetry(Scene& scene) {
  for (int b = 0; b < 2; ++b)
    for (int32_t i = 0; i < 2; ++i) {
      Condition& wall = scene.body[b].regions[0][index(scene.left_wall[b] + i)].condition;
      wall.fixed[0] = true;
      for (double(&value)[2] : wall.value) value[0] = 0;
    }
  scene.name = "half " + scene.name;
}

// ---- loads ------------------------------------------------------------------------------------------------------------

struct Loading {
  double size;      // of stresses
  double direction; // -1: down
  double mu;
};

void press(Side& side, const Loading& l, bool moves, bool two_cases, double stiffness, Dice& dice) {
  const double unit = moves ? l.size / stiffness : l.size, bound = std::max(0.3, std::min(l.mu, 2.0));
  const double aside = dice.chance(0.4) ? 0 : dice.between(-1, 1) * (dice.chance(0.2) ? 1 : bound);
  side.condition.value[0][1] = l.direction * unit;
  side.condition.value[0][0] = side.condition.fixed[0] && !moves ? 0 : two_cases ? 0 : aside * unit;
  if (!two_cases) return;
  side.condition.value[1][0] = side.condition.fixed[0] && !moves ? 0 : dice.between(-1.1, 1.1) * bound * unit;
  if (side.condition.value[1][0] == 0 || dice.chance(0.3)) side.condition.value[1][1] = dice.between(-1, 1) * unit;
}

std::vector<problem::Path> random_path(bool two_cases, Dice& dice) {
  std::vector<problem::Path> path = {{dice.whole(1, 4), 1.0, 0}};
  const int32_t pieces = dice.whole(0, 3);
  if (two_cases) {
    if (dice.chance(0.2)) path[0].second = dice.between(-0.5, 0.5);
    for (int32_t i = 0; i <= pieces; ++i)
      path.push_back({dice.whole(1, 4), dice.chance(0.6) ? 1.0 : dice.between(-0.3, 1.5), dice.between(-1.2, 1.2)});
    return path;
  }
  for (int32_t i = 0; i < pieces; ++i) {
    const double kind = dice.unit();
    path.push_back({dice.whole(1, 4), kind < 0.25   ? 0.0
                                      : kind < 0.45 ? dice.between(-1, 0)
                                      : kind < 0.7  ? dice.between(0, 1)
                                                    : dice.between(0.5, 2)});
  }
  return path;
}

// ---- lifted and put back ----------------------------------------------------------------------------------------------

// Load case 1 brings the bodies together, and apart where its factor is negative; load case 2 moves or pushes aside.
enum class Drive : int32_t {
  held,      // the upper body is moved as told, both ways
  guided,    // it is moved up and down, and free aside; the lower one moves aside
  dragged,   // it is moved up and down, and pushed aside
  rests,     // it is pressed by a traction alone; the lower body moves aside
  pushed,    // the same, and pushed aside
  pinned_up, // one point of it keeps its height; the lower body is raised and lowered, and moves aside
  pinned_on, // one point of it stays in x; the same
  hangs,     // its top keeps its height; the same
  wall,      // a side of it slides along a wall; pressed by a traction
  count
};

void set_both(Side& side, int component, bool fixed, double first, double second) {
  side.condition.fixed[component] = fixed;
  side.condition.value[0][component] = first;
  side.condition.value[1][component] = second;
}

// `up`: from the held body to the one that is lifted, 1 or -1. Motions of this size; tractions of that.
void drive(Drive how, Outlines& lifted, int32_t top, int32_t other, Side& base, double up, double motion, double traction) {
  std::vector<Side>& outline = lifted.regions[0];
  const int32_t beside = (top + 1) % static_cast<int32_t>(outline.size());
  const bool base_rises = how == Drive::pinned_up || how == Drive::pinned_on || how == Drive::hangs;
  const bool base_moves = base_rises || how == Drive::guided || how == Drive::rests;
  set_both(base, 0, true, 0, base_moves ? motion : 0);
  set_both(base, 1, true, base_rises ? up * motion : 0, 0);
  const bool told = how == Drive::held || how == Drive::guided || how == Drive::dragged;
  if (told || how == Drive::hangs) set_both(outline[index(top)], 1, true, told ? -up * motion : 0, 0);
  if (how == Drive::held) set_both(outline[index(top)], 0, true, 0, motion);
  if (how == Drive::dragged || how == Drive::pushed) set_both(outline[index(top)], 0, false, 0, traction);
  if (how == Drive::rests || how == Drive::pushed || how == Drive::wall)
    set_both(outline[index(top)], 1, false, -up * traction, 0);
  if (how == Drive::pinned_up || how == Drive::pinned_on) lifted.pins.push_back({0, beside, how == Drive::pinned_up});
  if (how == Drive::wall && outline[index(other)].zone == 0 && other != top)
    set_both(outline[index(other)], 0, true, 0, motion);
}

std::vector<problem::Path> lifting_path(Dice& dice) {
  std::vector<problem::Path> path = {{dice.whole(1, 3), 1.0, dice.chance(0.6) ? 0 : dice.between(-1, 1)}};
  for (int32_t i = dice.whole(2, 5); i > 0; --i) {
    const problem::Path last = path.back();
    const double kind = dice.unit();
    const double first = kind < 0.25 ? last.load : kind < 0.40 ? 0.0 : kind < 0.65 ? dice.between(-1, 0) : dice.between(0, 1.5);
    path.push_back({dice.whole(1, 3), first, dice.chance(0.5) ? last.second : dice.between(-1.2, 1.2)});
    if (dice.chance(0.1)) path.back().second = 0;
  }
  return path;
}

// ---- symmetric ------------------------------------------------------------------------------------------------------------

void fix(Side& side, int component) { side.condition.fixed[component] = true; }

// `pins`: there are nodes on the axis.
void hold_symmetric(Outlines& body, int32_t other_half, bool pins, Dice& dice) {
  std::vector<Side>& outline = body.regions[0];
  const double kind = dice.unit();
  const bool walls = kind < 0.15 && outline[2].zone == 0; // they do not end in the contact
  const bool roller = pins && kind > 0.75;
  for (int32_t side : {walls ? 1 : 0, walls ? other_half - 1 : other_half})
    for (int c = roller ? 1 : 0; c < 2; ++c) fix(outline[index(side)], c);
  if (roller) body.pins.push_back({0, 0, 0});
}

// Pressed by the whole top, or by its outer or its inner sides.
void press_symmetric(std::vector<Side>& outline, int32_t top, double stress, double aside, Dice& dice) {
  const int32_t from = dice.whole(0, 2);
  for (int32_t i = 0; i < 4; ++i) {
    Condition& c = outline[index(top + i)].condition;
    const bool inner = i == 1 || i == 2;
    if (from == 0 || inner == (from == 1)) c.value[0][1] = -stress;
    c.value[1][0] = aside * stress;
  }
  if (!dice.chance(0.2)) return;
  const double squeeze = dice.between(-0.5, 0.5) * stress; // of the walls
  outline[index(top - 1)].condition.value[0][0] = -squeeze;
  outline[index(top + 4)].condition.value[0][0] = squeeze;
}

void drive_symmetric(Outlines& body, int32_t top, bool pins, bool round, double strain, double stress, double aside,
                     Dice& dice) {
  std::vector<Side>& outline = body.regions[0];
  const double kind = round ? dice.between(0.65, 1) : dice.unit();
  if (kind < 0.80) press_symmetric(outline, top, stress, aside, dice);
  if (pins && kind > 0.55 && kind < 0.65) body.pins.push_back({0, top + 2, 0});
  for (int32_t i = 0; i < 4; ++i) {
    Side& side = outline[index(top + i)];
    if (kind > 0.65) fix(side, 0);
    if (kind > 0.80) fix(side, 1);
    if (kind > 0.65) side.condition.value[1][0] = aside * strain;
    if (kind > 0.80) side.condition.value[0][1] = -strain;
  }
}

std::vector<problem::Path> symmetric_path(Dice& dice) {
  std::vector<problem::Path> path = {{dice.whole(1, 3), 1, 0}};
  for (int32_t i = dice.whole(0, 2); i > 0; --i)
    path.push_back({dice.whole(1, 3), dice.chance(0.2) ? 0 : dice.between(0.1, 1.5), 0});
  if (dice.chance(0.4)) return path;
  const double end = path.back().load, first = dice.sign();
  for (int32_t i = dice.whole(1, 4), k = 0; k < i; ++k) path.push_back({dice.whole(1, 3), end, k % 2 == 0 ? first : -first});
  if (dice.chance(0.3)) path.push_back({dice.whole(1, 2), dice.between(0, 1.5), dice.chance(0.5) ? 0 : path.back().second});
  return path;
}

// ---- the whole --------------------------------------------------------------------------------------------------------

void add_zones(Problem& p, const Scene& scene) {
  const int32_t f = p.function_nodes, per = f == 1 ? 1 : f - 1;
  for (int zone = 1; zone <= scene.zones; ++zone) {
    const Run one = run_of(scene.body[0], zone), two = run_of(scene.body[1], zone);
    const int32_t first[2] = {one.first_element, two.first_element + two.elements - 1};
    const int32_t last[2] = {one.first_element + one.elements - 1, two.first_element};
    if (scene.free_zones) {
      problem::FreeZone z = problem::FreeZone();
      for (int b = 0; b < 2; ++b) z.first_element[b] = first[b], z.last_element[b] = last[b];
      p.free_zones.push_back(z);
      continue;
    }
    problem::Zone z = problem::Zone();
    z.elements = one.elements;
    z.pairs = f == 1 ? one.elements : one.elements * per + 1;
    for (int b = 0; b < 2; ++b) z.first_element[b] = first[b], z.last_element[b] = last[b];
    z.first_node[0] = (first[0] - 1) * per + 1;
    z.last_node[0] = f == 1 ? last[0] : last[0] * per + 1;
    z.first_node[1] = f == 1 ? first[1] : first[1] * per + 1;
    z.last_node[1] = (last[1] - 1) * per + 1;
    p.zones.push_back(z);
  }
}

bool at_any_angle(const Problem& p) {
  for (const problem::Body& body : p.bodies)
    for (const problem::End& end : body.ends)
      if (end.codes[0] != end.codes[1] || end.codes[2] != end.codes[3]) return false;
  return true;
}

void add_point_loads(Problem& p, const Scene& scene, const Loading& l, Dice& dice) {
  const Point low = scene.room[1][0], high = scene.room[1][1];
  if (high.x - low.x < 0.1 || high.y - low.y < 0.1 || scene.body[1].regions.size() > 1) return;
  p.point_loads.push_back({2, dice.between(low.x, high.x), dice.between(low.y, high.y), l.size * dice.between(-0.5, 0.5),
                           l.size * dice.between(-1, 0.2), 1});
}

double softer(const Problem& p) { return std::min(p.bodies[0].youngs_modulus, p.bodies[1].youngs_modulus); }

// The outlines' points and conditions, with the materials that are there.
void make_bodies(Problem& p, const Scene& scene, int32_t geometry, bool two_cases) {
  for (int b = 0; b < 2; ++b) {
    const problem::Body material = p.bodies[index(b)];
    p.bodies[index(b)] = make_body(scene.body[b], geometry, p.function_nodes, two_cases);
    p.bodies[index(b)].youngs_modulus = material.youngs_modulus;
    p.bodies[index(b)].poisson_ratio = material.poisson_ratio;
  }
}

void finish(Model& model, const Scene& scene) {
  Problem& p = model.problem;
  add_zones(p, scene);
  model.same_surfaces = scene.same_surfaces;
  model.any_angle = at_any_angle(p);
  model.proportional = scene.touching && scene.same_surfaces && p.paths[0].second == 0;
  model.title = scene.name;
}

Model assemble(Scene& scene, Dice& dice, int32_t function_nodes, double mu, bool two_cases, bool half) {
  Model model;
  Problem& p = model.problem;
  p.function_nodes = function_nodes;
  p.friction = {mu};
  p.bodies.resize(2);
  set_materials(p, dice);
  const double soft = softer(p);
  const double strain = dice.power(-4, -2);
  // Mostly body 2 is pressed down onto body 1; sometimes body 1 up against body 2.
  const bool from_below = !scene.free_zones && dice.chance(0.12);
  const Loading loading = {strain * soft, from_below ? 1.0 : -1.0, mu};
  const int held = from_below ? 1 : 0, pressed = 1 - held;
  const int32_t held_side = held == 0 ? scene.base : scene.top, held_other = held == 0 ? scene.base_other : scene.top_other;
  const int32_t side = held == 0 ? scene.top : scene.base, other = held == 0 ? scene.top_other : scene.base_other;
  if (!dice.chance(0.02)) hold(scene.body[held], held_side, held_other, dice);
  const bool moves = hold_loosely(scene.body[pressed], side, other, scene.round, dice);
  Side& loaded = scene.body[pressed].regions[0][index(side)];
  press(loaded, loading, moves, two_cases, soft, dice);
  if (!moves && dice.chance(0.25)) { // a push from the side
    Side& pushed = scene.body[pressed].regions[0][index(other)];
    if (pushed.zone == 0 && !pushed.condition.fixed[0])
      pushed.condition.value[0][0] = loading.size * dice.between(-0.5, 0.5) * std::min(mu, 1.0);
  }
  if (half && scene.flush_left && scene.zones == 1) hold_at_symmetry(scene);
  make_bodies(p, scene, dice.whole(2, 4), two_cases);
  if (!moves && !from_below && dice.chance(0.15)) add_point_loads(p, scene, loading, dice);
  if (scene.overlap) p.interference = 2;
  p.paths = random_path(two_cases, dice);
  finish(model, scene);
  return model;
}

const char* name_of(Drive how) {
  const char* const names[] = {"held", "guided", "dragged", "rests", "pushed", "pinned up", "pinned on", "hangs", "wall"};
  return names[static_cast<int32_t>(how)];
}

} // namespace

Model generate(uint64_t seed) {
  Dice dice(seed);
  const double order = dice.unit();
  const int32_t function_nodes = order < 0.1 ? 1 : order < 0.55 ? 2 : order < 0.85 ? 3 : 4;
  const double mu = random_friction(dice);
  Scene scene = make_scene(dice, function_nodes, false);
  Model model =
      assemble(scene, dice, function_nodes, mu, !scene.overlap && dice.chance(0.3), Dice(seed ^ 0xA1F0000u).chance(0.2));
  model.title += " " + std::to_string(seed);
  return model;
}

Model generate_lifted(uint64_t seed) {
  Dice dice(seed ^ 0x11F7000000u);
  Model model;
  Problem& p = model.problem;
  p.function_nodes = dice.whole(2, 4);
  p.friction = {random_friction(dice)};
  p.bodies.resize(2);
  set_materials(p, dice);
  Scene scene = make_scene(dice, p.function_nodes, false);
  while (scene.overlap) scene = make_scene(dice, p.function_nodes, false);
  const Drive how = static_cast<Drive>(dice.whole(0, static_cast<int32_t>(Drive::count) - 1));
  const double strain = dice.power(-4, -2);
  const int lifted = !scene.free_zones && dice.chance(0.2) ? 0 : 1; // the other one is held
  Side& base = scene.body[1 - lifted].regions[0][index(lifted == 1 ? scene.base : scene.top)];
  drive(how, scene.body[lifted], lifted == 1 ? scene.top : scene.base, lifted == 1 ? scene.top_other : scene.base_other, base,
        lifted == 1 ? 1 : -1, strain, strain * softer(p));
  make_bodies(p, scene, dice.whole(2, 4), true);
  p.paths = lifting_path(dice);
  finish(model, scene);
  model.title += std::string(", ") + name_of(how) + " " + std::to_string(seed);
  return model;
}

Model generate_symmetric(uint64_t seed) {
  Dice dice(seed ^ 0x3172707000u);
  Model model;
  Problem& p = model.problem;
  p.function_nodes = dice.whole(1, 7) / 2 + 1;
  const double mu = dice.chance(0.5) ? dice.between(0.05, 0.5) : dice.between(0.5, 2);
  p.friction = {mu};
  p.bodies.resize(2);
  set_materials(p, dice);
  if (p.bodies[1].youngs_modulus > 1000 && dice.chance(0.7)) std::swap(p.bodies[0].youngs_modulus, p.bodies[1].youngs_modulus);
  Scene scene = make_symmetric_scene(dice, p.function_nodes);
  const double strain = dice.power(-4, -2);
  const bool pins = p.function_nodes > 1;
  hold_symmetric(scene.body[0], scene.base_other, pins, dice);
  drive_symmetric(scene.body[1], scene.top, pins, scene.round, strain, strain * softer(p), dice.between(0.1, 1.1) * mu, dice);
  p.paths = symmetric_path(dice);
  bool pushed = false;
  for (const problem::Path& path : p.paths) pushed = pushed || path.second != 0;
  make_bodies(p, scene, dice.whole(2, 4), pushed);
  finish(model, scene);
  model.symmetric = true;
  model.title += ", mu " + std::to_string(mu) + " " + std::to_string(seed);
  return model;
}

Model generate_few_pairs(uint64_t seed) {
  Dice dice(seed ^ 0x5EED0000u);
  const int32_t function_nodes = dice.whole(2, 4);
  const double mu = dice.chance(0.5) ? dice.between(0.1, 1) : dice.between(1, 3);
  Scene scene = make_scene(dice, function_nodes, true);
  Model model = assemble(scene, dice, function_nodes, mu, false, false);
  model.problem.paths.resize(1);
  model.title = "few pairs, " + model.title + " " + std::to_string(seed);
  return model;
}

} // namespace random_decks
