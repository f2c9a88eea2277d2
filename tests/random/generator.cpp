#include "generator.hpp"

#include "dice.hpp"
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

Model assemble(Scene& scene, Dice& dice, int32_t function_nodes, double mu, bool two_cases, bool half) {
  Model model;
  Problem& p = model.problem;
  p.function_nodes = function_nodes;
  p.friction = {mu};
  p.bodies.resize(2);
  set_materials(p, dice);
  const problem::Body materials[2] = {p.bodies[0], p.bodies[1]};
  const double soft = std::min(materials[0].youngs_modulus, materials[1].youngs_modulus);
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
  const int32_t geometry = dice.whole(2, 4);
  for (int b = 0; b < 2; ++b) {
    p.bodies[index(b)] = make_body(scene.body[b], geometry, function_nodes, two_cases);
    p.bodies[index(b)].youngs_modulus = materials[b].youngs_modulus;
    p.bodies[index(b)].poisson_ratio = materials[b].poisson_ratio;
  }
  if (!moves && !from_below && dice.chance(0.15)) add_point_loads(p, scene, loading, dice);
  if (scene.overlap) p.interference = 2;
  add_zones(p, scene);
  p.paths = random_path(two_cases, dice);
  model.same_surfaces = scene.same_surfaces;
  model.any_angle = at_any_angle(p);
  model.proportional = scene.touching && scene.same_surfaces && p.paths[0].second == 0;
  model.title = scene.name;
  return model;
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
