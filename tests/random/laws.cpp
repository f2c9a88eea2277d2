#include "laws.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace random_decks {

namespace {

using namespace problem;

size_t index(int64_t i) { return static_cast<size_t>(i); }

__attribute__((format(printf, 1, 2))) std::string formatted(const char* format, ...) {
  char text[300];
  va_list list;
  va_start(list, format);
  std::vsnprintf(text, sizeof text, format, list);
  va_end(list);
  return text;
}

constexpr double kPassedOver = 0.05;

// ---- integrals along a body ------------------------------------------------------------------------------------------

struct ElementAt {
  double x, y, ds, shape[4]; // ds: length per unit of eta
};

// Lagrange's polynomials of n points, their slopes times `of`.
double lagrange(int n, int k, double eta, bool slope) {
  double value = 1, rise = 0;
  const auto place = [n](int j) { return n == 1 ? 0.0 : -1 + 2.0 * j / (n - 1); };
  for (int j = 0; j < n; ++j) {
    if (j == k) continue;
    const double step = place(k) - place(j);
    rise = rise * (eta - place(j)) / step + value / step;
    value *= (eta - place(j)) / step;
  }
  return slope ? rise : value;
}

ElementAt element_at(const Problem& p, const Body& body, int32_t element, double eta) {
  const int n = body.element_nodes;
  ElementAt out = {0, 0, 0, {0, 0, 0, 0}};
  double dx = 0, dy = 0;
  for (const Range& r : body.regions) {
    if (element < r.first || element > r.last) continue;
    for (int k = 0; k < n; ++k) {
      int32_t node = (element - 1) * (n - 1) + k;
      if (k == n - 1 && element == r.last) node = (r.first - 1) * (n - 1);
      const double x = body.xy[index(2 * node)], y = body.xy[index(2 * node + 1)];
      out.x += lagrange(n, k, eta, false) * x, out.y += lagrange(n, k, eta, false) * y;
      dx += lagrange(n, k, eta, true) * x, dy += lagrange(n, k, eta, true) * y;
    }
  }
  out.ds = std::hypot(dx, dy);
  for (int l = 0; l < p.function_nodes; ++l) out.shape[l] = lagrange(p.function_nodes, l, eta, false);
  return out;
}

constexpr int kPoints = 7; // of Gauss and Legendre
constexpr double kPlace[kPoints] = {0,
                                    0.4058451513773972,
                                    -0.4058451513773972,
                                    0.7415311855993945,
                                    -0.7415311855993945,
                                    0.9491079123427585,
                                    -0.9491079123427585};
constexpr double kWeight[kPoints] = {0.4179591836734694, 0.3818300505051189, 0.3818300505051189, 0.2797053914892766,
                                     0.2797053914892766, 0.1294849661688697, 0.1294849661688697};

struct Sum {
  double fx = 0, fy = 0, moment = 0, size = 0; // size: of magnitudes
};

// Tractions of a body, of its contact ends alone if `contact`, and its point loads.
Sum sum_of(const Problem& p, const Step& s, int b, bool contact) {
  constexpr int kParts = 4; // the length of a curved element is no polynomial
  Sum sum;
  const auto add = [&sum](double x, double y, double fx, double fy) {
    sum.fx += fx, sum.fy += fy, sum.moment += x * fy - y * fx, sum.size += std::hypot(fx, fy);
  };
  for (int32_t e = 1; e <= p.elements(b + 1); ++e)
    for (int g = 0; g < kPoints * kParts; ++g) {
      const ElementAt at = element_at(p, p.bodies[index(b)], e, (kPlace[g % kPoints] + 2 * (g / kPoints) + 1) / kParts - 1);
      double t[2] = {0, 0};
      for (int l = 0; l < p.function_nodes; ++l) {
        const EndResult& end = s.boundary[b][index((e - 1) * p.function_nodes + l)];
        if (contact && end.status < 0) continue;
        t[0] += at.shape[l] * end.tx, t[1] += at.shape[l] * end.ty;
      }
      const double w = kWeight[g % kPoints] * at.ds / kParts;
      add(at.x, at.y, w * t[0], w * t[1]);
    }
  for (const PointLoad& l : p.point_loads)
    if (l.body == b + 1 && !contact) add(l.x, l.y, s.load * l.fx, s.load * l.fy);
  return sum;
}

class Laws {
public:
  Laws(const Model& model, const Runs& runs)
      : model_(model), p_(model.problem), runs_(runs), size_(sizes_of(p_, runs)), near_(tolerance_of(runs.changes)) {}
  std::vector<std::string> all();

private:
  void tell(const char* law, double size, const Step* step, int pair);
  bool more(double value, double bound, const char* law, const Step* step = nullptr, int pair = -1) {
    if (value <= bound) return false; // also what is no number is told
    tell(law, bound > 0 ? value / bound : value, step, pair);
    return true;
  }
  void contact(const Step& s, int pair);
  void open_pair(const Step& s, int pair);
  void closed_pair(const Step& s, int pair);
  void since_change(const Step& before, const Step& s, int pair);
  void balance(const Step& s);
  void conditions(const Step& s, int body);
  void nodes(const Step& s);
  void energies();
  std::vector<double> pair_lengths() const;

  const Model& model_;
  const Problem& p_;
  const Runs& runs_;
  const Sizes size_;
  const double near_;
  std::vector<std::string> found_;
};

void Laws::tell(const char* law, double size, const Step* step, int pair) {
  for (const std::string& other : found_)
    if (other.compare(0, std::string(law).size(), law) == 0) return; // once is enough
  std::string text = formatted("%s: %.2g times what is allowed", law, size);
  const char* const kinds[] = {"row", "change", "stop"};
  if (step) text += formatted(", %s at load %.9g %.9g", kinds[step->kind], step->load, step->second);
  if (pair >= 0) text += formatted(", pair %d", pair + 1);
  found_.push_back(text);
}

// ---- contact ----------------------------------------------------------------------------------------------------------

void Laws::open_pair(const Step& s, int pair) {
  more(std::fabs(s.at(pair, C2D_TN)) + std::fabs(s.at(pair, C2D_TT)), 0, "an open pair carries a force", &s, pair);
  more(-s.at(pair, C2D_GAP), near_ * size_.displacement, "an open pair overlaps", &s, pair);
}

void Laws::closed_pair(const Step& s, int pair) {
  const double tn = s.at(pair, C2D_TN), tt = std::fabs(s.at(pair, C2D_TT)), close = near_ * size_.traction;
  more(-tn, close, "a closed pair pulls", &s, pair);
  if (p_.interference == 0) more(std::fabs(s.at(pair, C2D_GAP)), near_ * size_.displacement, "a closed pair gapes", &s, pair);
  if (!std::isfinite(s.mu)) return;
  more(tt - s.mu * tn, close * (1 + s.mu), "friction beyond the cone", &s, pair);
  if (static_cast<int>(s.at(pair, C2D_STATUS)) == C2D_SLIP)
    more(s.mu * tn - tt, close * (1 + s.mu), "a slipping pair is inside the cone", &s, pair);
}

// A pair of the same status at a change and at the next entry kept it in between.
void Laws::since_change(const Step& before, const Step& s, int pair) {
  const int status = static_cast<int>(s.at(pair, C2D_STATUS));
  if (before.kind != C2D_STEP_CHANGE || static_cast<int>(before.at(pair, C2D_STATUS)) != status) return;
  const double slip = s.at(pair, C2D_SLIP_SUM) - before.at(pair, C2D_SLIP_SUM), close = near_ * size_.displacement;
  if (status == C2D_STICK) more(std::fabs(slip), close, "a sticking pair slips", &s, pair);
  if (status != C2D_SLIP || s.mu == 0) return;
  const double way = s.at(pair, C2D_UT2) - s.at(pair, C2D_UT1) - before.at(pair, C2D_UT2) + before.at(pair, C2D_UT1);
  more(std::fabs(way - slip), close, "slip is not the motion", &s, pair);
  const double friction = s.at(pair, C2D_TT) + before.at(pair, C2D_TT);
  if (std::fabs(friction) > 4 * near_ * size_.traction && friction * slip > 0)
    more(std::fabs(slip), close, "friction pushes along the slip", &s, pair);
}

void Laws::contact(const Step& s, int pair) {
  const double gap = s.at(pair, C2D_GAP) - (s.at(pair, C2D_UN2) - s.at(pair, C2D_UN1));
  if (model_.same_surfaces && p_.interference == 0)
    more(std::fabs(gap), 1e-9 * size_.length + near_ * size_.displacement, "a gap between surfaces of the same points", &s,
         pair);
  for (int field = C2D_TN; field <= C2D_SLIP_SUM; ++field)
    if (!std::isfinite(s.at(pair, field))) tell("a result is no number", 1, &s, pair);
  if (static_cast<int>(s.at(pair, C2D_STATUS)) == C2D_OPEN)
    open_pair(s, pair);
  else
    closed_pair(s, pair);
}

// ---- bodies -----------------------------------------------------------------------------------------------------------

void Laws::balance(const Step& s) {
  // Where the surfaces differ, what passes over is no polynomial on the other body: its ends tell only about what it is.
  const int passed = p_.free_zones.empty() ? 1 : 0;
  Sum contact[2];
  for (int b = 0; b < 2; ++b) {
    const Sum all = sum_of(p_, s, b, false);
    contact[b] = sum_of(p_, s, b, true);
    if (b == 0 && passed == 0) continue;
    const double close = (b == passed && !model_.same_surfaces ? kPassedOver : near_) * size_.force;
    more(std::hypot(all.fx, all.fy), close, b == 0 ? "forces on body 1" : "forces on body 2", &s);
    more(std::fabs(all.moment), close * size_.length, b == 0 ? "moments on body 1" : "moments on body 2", &s);
  }
  if (!p_.free_zones.empty()) return; // the contact's share of an end is not told there
  more(std::hypot(contact[0].fx + contact[1].fx, contact[0].fy + contact[1].fy),
       (model_.same_surfaces ? near_ : kPassedOver) * size_.force, "action and reaction", &s);
  if (model_.same_surfaces)
    more(std::fabs(contact[0].moment + contact[1].moment), near_ * size_.force * size_.length, "moments of action and reaction",
         &s);
}

// What was prescribed is there.
void Laws::conditions(const Step& s, int b) {
  const Body& body = p_.bodies[index(b)];
  for (size_t i = 0; i < body.ends.size(); ++i) {
    const EndResult& e = s.boundary[b][i];
    if (e.status >= 0) continue;
    bool in_free_zone = false;
    for (const problem::FreeZone& z : p_.free_zones)
      in_free_zone = in_free_zone || (e.element - z.first_element[b]) * (e.element - z.last_element[b]) <= 0;
    if (in_free_zone) continue;
    const double is[4] = {e.tx, e.ty, e.ux, e.uy};
    for (int k = 0; k < 4; ++k) {
      if (body.ends[i].codes[k] != 0) continue;
      double given = s.load * body.ends[i].values[k];
      if (!body.second_case.empty()) given += s.second * body.second_case[i].values[k];
      more(std::fabs(is[k] - given), near_ * (k < 2 ? size_.traction : size_.displacement),
           k < 2 ? "a prescribed traction is missed" : "a prescribed displacement is missed", &s);
    }
  }
}

// The pairs' displacements are those of their nodes.
void Laws::nodes(const Step& s) {
  if (!p_.free_zones.empty()) return;
  for (int b = 0; b < 2; ++b)
    for (const EndResult& e : s.boundary[b])
      for (int i = 0; i < s.pairs(); ++i) {
        if (e.node != static_cast<int32_t>(s.at(i, b == 0 ? C2D_PAIR_NODE1 : C2D_PAIR_NODE2))) continue;
        const double nx = s.at(i, C2D_NX), ny = s.at(i, C2D_NY), un = s.at(i, b == 0 ? C2D_UN1 : C2D_UN2),
                     ut = s.at(i, b == 0 ? C2D_UT1 : C2D_UT2);
        more(std::hypot(un * nx + ut * ny - e.ux, un * ny - ut * nx - e.uy), near_ * size_.displacement,
             "a pair's displacement is not its node's", &s, i);
      }
}

// ---- energies ---------------------------------------------------------------------------------------------------------

// Integrals of the pairs' shape functions along body 1.
std::vector<double> Laws::pair_lengths() const {
  std::vector<double> length;
  const int f = p_.function_nodes;
  for (const problem::Zone& z : p_.zones) {
    const size_t first = length.size();
    length.resize(first + index(z.pairs));
    for (int32_t i = 0; i < z.elements; ++i)
      for (int g = 0; g < kPoints; ++g) {
        const ElementAt at = element_at(p_, p_.bodies[0], z.first_element[0] + i, kPlace[g]);
        for (int l = 0; l < f; ++l) length[first + index(f == 1 ? i : i * (f - 1) + l)] += kWeight[g] * at.ds * at.shape[l];
      }
  }
  return length;
}

// What friction takes, summed over the straight pieces between changes, is what is reported, and is not given back.
void Laws::energies() {
  const std::vector<Step>& steps = runs_.changes.steps;
  const std::vector<double> length = p_.free_zones.empty() ? pair_lengths() : std::vector<double>();
  const double close = 1e-6 * size_.energy;
  double sum = 0, before = 0;
  for (size_t k = 0; k < steps.size(); ++k) {
    const Step& s = steps[k];
    more(before - s.dissipated, close, "friction gives energy back", &s);
    before = s.dissipated;
    for (int i = 0; i < s.pairs() && !length.empty() && std::isfinite(s.mu); ++i) {
      const double tt = s.at(i, C2D_TT) + (k > 0 ? steps[k - 1].at(i, C2D_TT) : 0);
      const double slip = s.at(i, C2D_SLIP_SUM) - (k > 0 ? steps[k - 1].at(i, C2D_SLIP_SUM) : 0);
      sum -= 0.5 * length[index(i)] * tt * slip;
    }
    if (!length.empty() && p_.interference == 0 && std::isfinite(s.mu)) // else jumps set energy free as well
      more(std::fabs(sum - s.dissipated), close, "dissipation is not friction times slip", &s);
  }
}

std::vector<std::string> Laws::all() {
  const std::vector<Step>& steps = runs_.changes.steps;
  for (size_t k = 0; k < steps.size(); ++k)
    for (int i = 0; i < steps[k].pairs(); ++i) {
      contact(steps[k], i);
      if (k > 0 && steps[k].kind != C2D_STEP_STOPPED) since_change(steps[k - 1], steps[k], i);
    }
  for (const Step& s : runs_.rows.steps) {
    if (s.boundary[0].empty()) continue;
    balance(s);
    for (int b = 0; b < 2; ++b) conditions(s, b);
    nodes(s);
  }
  energies();
  return found_;
}

} // namespace

Sizes sizes_of(const Problem& p, const Runs& runs) {
  Sizes size;
  for (const Step& s : runs.changes.steps) {
    for (int i = 0; i < s.pairs(); ++i) {
      for (int field : {C2D_TN, C2D_TT}) size.traction = std::max(size.traction, std::fabs(s.at(i, field)));
      for (int field : {C2D_UN1, C2D_UT1, C2D_UN2, C2D_UT2})
        size.displacement = std::max(size.displacement, std::fabs(s.at(i, field)));
    }
    size.energy = std::max({size.energy, std::fabs(s.work), std::fabs(s.elastic), std::fabs(s.dissipated)});
  }
  for (const Body& body : p.bodies)
    for (double x : body.xy) size.length = std::max(size.length, std::fabs(x));
  for (const Step& s : runs.rows.steps)
    for (int b = 0; b < 2; ++b) {
      if (s.boundary[b].empty()) continue;
      size.force = std::max(size.force, sum_of(p, s, b, false).size);
      for (const EndResult& e : s.boundary[b]) {
        size.traction = std::max(size.traction, std::hypot(e.tx, e.ty));
        size.displacement = std::max(size.displacement, std::hypot(e.ux, e.uy));
      }
    }
  // A motion without load leaves round-off of its own.
  const double stiff = std::max(p.bodies[0].youngs_modulus, p.bodies[1].youngs_modulus);
  const double stress = 1e-4 * stiff * size.displacement / size.length;
  size.traction = std::max(size.traction, stress);
  size.force = std::max(size.force, stress * size.length);
  size.energy = std::max(size.energy, stress * size.displacement * size.length);
  return size;
}

double tolerance_of(const Result& result) { return std::max(1e-8, 1e-14 * result.summary.condition); }

std::vector<std::string> broken_laws(const Model& model, const Runs& runs) { return Laws(model, runs).all(); }

} // namespace random_decks
