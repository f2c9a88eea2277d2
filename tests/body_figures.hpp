// What families of several bodies are compared with, for their tests and for make convergence.
#pragma once

#include "family_runs.hpp"

namespace families_test {

// Largest difference of a contact's tractions from p and, in size, q; over p. Pairs that do not stick count as 1.
inline double uniform_error(const Solution& s, double p, double q) {
  double worst = s.last().empty() ? 1 : 0;
  for (const Row& row : s.last())
    worst =
        std::max({worst, std::fabs(row.tn / p - 1), std::fabs(std::fabs(row.tt) - q) / p, row.status == C2D_STICK ? 0.0 : 1.0});
  return worst;
}

// A contact about x = middle against Hertz's, of half width a and largest pressure p0.
struct HertzFigures {
  double peak, edge, curve; // relative; in length; over p0 where |x| < 0.9 a
};
inline HertzFigures hertz_figures(const std::vector<Row>& zone, double middle, double a, double p0) {
  HertzFigures out{largest_pressure(zone) / p0 - 1, 0, 0};
  for (const Row& row : zone) {
    const double x = std::fabs(row.x - middle) / a;
    if (row.status != C2D_OPEN) out.edge = std::max(out.edge, x * a);
    if (x < 0.9) out.curve = std::max(out.curve, std::fabs(row.tn / p0 - std::sqrt(1 - x * x)));
  }
  out.edge -= a;
  return out;
}
// The worst over zones first ... last, whose middles are in `middles`, one per two zones.
inline HertzFigures worst_of_rollers(const Solution& s, const std::vector<double>& middles, double p0) {
  HertzFigures worst{0, 0, 0};
  for (size_t i = 0; i < 2 * middles.size(); ++i) {
    const HertzFigures f = hertz_figures(s.zone(static_cast<int>(i) + 1), middles[i / 2], 1, p0);
    worst.peak = std::max(worst.peak, std::fabs(f.peak));
    worst.edge = std::max(worst.edge, std::fabs(f.edge));
    worst.curve = std::max(worst.curve, f.curve);
  }
  return worst;
}

// Forces on the rollers of a bearing without clearance, between rigid rings: a roller at psi from the load P gives way by
// D cos(psi), which Hertz's line contacts and the roller between them give by its force (Johnson, eq. 5.57).
class RigidRings {
public:
  RigidRings(int rollers, double shaft, double load, bool between, double modulus = 1000 / 0.91)
      : modulus_(modulus), shaft_(shaft), load_(load) {
    for (int i = 0; i < rollers; ++i) {
      const double cosine = std::cos((i + (between ? 0.5 : 0)) * 2 * kPi / rollers);
      if (cosine > 1e-9) cosines_.push_back(cosine);
    }
    const auto carried = [this](double approach) {
      double sum = 0;
      for (const double c : cosines_) sum += c * force(approach * c);
      return sum;
    };
    approach_ = inverse(carried, load, compression(load));
  }
  double at(double degrees) const { return force(approach_ * std::cos(degrees * kPi / 180)); }
  double compression(double force) const { // of a roller of radius 1, by both contacts
    const auto term = [&](double curvature) {
      return 2 * std::log(4 / std::sqrt(4 * force / (kPi * modulus_ * curvature))) - 1;
    };
    return force / (kPi * modulus_) * (term(1 + 1 / shaft_) + term(1 - 1 / (shaft_ + 2)));
  }

private:
  // x from 0 to `most` at which a rising function has a value.
  template <class F> static double inverse(F f, double value, double most) {
    double low = 0;
    for (int i = 0; i < 200; ++i) (f((low + most) / 2) < value ? low : most) = (low + most) / 2;
    return low;
  }
  double force(double approach) const {
    return inverse([this](double q) { return compression(q); }, approach, load_);
  }
  double modulus_, shaft_, load_, approach_ = 0;
  std::vector<double> cosines_;
};

// make bearing with rollers of radius 1 between rings of radius `shaft` and more.
struct BearingFigures {
  double share; // largest difference of a force on a roller, at either contact, from that between rigid rings, over the largest
  double factor; // largest force, over P / Z
};
inline BearingFigures bearing_figures(const Solution& s, int rollers, bool between = false, double shaft = 5) {
  const double load = 2 * std::fabs(s.resultants[0].contact[1]);
  const RigidRings rigid(rollers, shaft, load, between);
  BearingFigures out{0, 0};
  for (size_t zone = 0; zone < s.zones.size(); ++zone) {
    const double place = (static_cast<double>(zone / 2) + (between ? 0.5 : 0)) * 360 / rollers;
    const double* f = s.zones[zone].force;
    const double force = place == 0 ? 2 * std::fabs(f[1]) : std::hypot(f[0], f[1]); // one half under the load
    out.share = std::max(out.share, std::fabs(force - rigid.at(place)) / rigid.at(0));
    out.factor = std::max(out.factor, force * rollers / load);
  }
  return out;
}

// Pressures of make shrink at the bond and at the fit: rings under pressure, in plane strain; E and nu are its defaults.
struct ShrinkFigures {
  double bond, fit;
};
inline ShrinkFigures shrink_exact() {
  const double a = 1, b = 1.5, c = 2, d = 3, delta = 2e-4, inner = c - delta;
  struct Ring {
    double r1, r2, E, nu;
    // ur at r for unit pressure inside, and outside.
    double at(double r, bool inside) const {
      const double square = r2 * r2 - r1 * r1, A = (inside ? r1 * r1 : -r2 * r2) / square;
      const double B = (inside ? 1 : -1) * r1 * r1 * r2 * r2 / square;
      return (1 + nu) / E * ((1 - 2 * nu) * A * r + B / r);
    }
  } const core{a, b, 1000, 0.3}, bush{b, c, 500, 0.35}, ring{inner, d, 2000, 0.25};
  // The bond: u of the core is that of the bush; the fit: the ring moves delta more. The bush carries the ring's force,
  // and the pressure is told per length of side 1, the bush.
  const double part = inner / c;
  const double m11 = core.at(b, false) - bush.at(b, true), m12 = -part * bush.at(b, false);
  const double m21 = -bush.at(c, true), m22 = ring.at(inner, true) - part * bush.at(c, false);
  const double det = m11 * m22 - m12 * m21;
  return {-m12 * delta / det, part * m11 * delta / det};
}
// Largest relative differences.
inline ShrinkFigures shrink_errors(const Solution& s) {
  const ShrinkFigures exact = shrink_exact();
  ShrinkFigures worst{0, 0};
  for (const Row& row : s.zone(1)) worst.fit = std::max(worst.fit, std::fabs(row.tn / exact.fit - 1));
  for (const Row& row : s.zone(2)) worst.bond = std::max(worst.bond, std::fabs(row.tn / exact.bond - 1));
  return worst;
}

// make bimaterial against the beam of two materials, up to half its length; relative to the largest.
struct BendingFigures {
  double deflection, stress;
};
inline BendingFigures bending_errors(const Solution& s) {
  const double E1 = 1000 / 0.91, E2 = 3000 / 0.96, h1 = 1, h2 = 0.5, h = h1 + h2;
  const double y0 = (E1 * h1 * h1 / 2 + E2 * h2 * (h1 + h2 / 2)) / (E1 * h1 + E2 * h2);
  const auto cube = [](double x) { return x * x * x; };
  const double k = 3 / (E1 * (cube(h1 - y0) - cube(-y0)) + E2 * (cube(h - y0) - cube(h1 - y0)));
  BendingFigures worst{0, 0};
  const double largest = E2 * k * (h - y0), reach = 3 * h, sag = k * reach * reach / 2;
  for (size_t b = 0; b < 2; ++b)
    for (const EndRow& end : s.bodies[b]) {
      const bool outside = end.y == 0 || end.y == h;
      if (end.x > reach) continue;
      if (end.y == 0) worst.deflection = std::max(worst.deflection, std::fabs(end.uy + k * end.x * end.x / 2) / sag);
      const double stress = (b == 0 ? E1 : E2) * k * (end.y - y0);
      if (outside) worst.stress = std::max(worst.stress, std::fabs(end.hoop - stress) / largest);
    }
  for (const Row& row : s.zone(1))
    if (row.x <= reach) worst.stress = std::max(worst.stress, std::hypot(row.tn, row.tt) / largest);
  return worst;
}

// The dovetail: a flank's normal force where it slips, against F / (2 (cos + mu sin)), and the balance of both flanks.
struct FlankFigures {
  double normal, balance; // relative
};
inline FlankFigures flank_errors(const Solution& s, double degrees, double mu, double pull) {
  const double c = std::cos(degrees * kPi / 180), d = std::sin(degrees * kPi / 180);
  const double* const force = s.zones[0].force; // on the blade, half of which is modelled
  return {(-force[0] * d - force[1] * c) / (pull / 2 / (c + mu * d)) - 1, -force[1] / (pull / 2) - 1};
}

// Gears: the moments that act on what carries the teeth about their axes, the ratio over zB / zA, less 1.
inline double gear_error(const Solution& s, int zA, int zB) {
  const double centres = (zA + zB) / 2.0;
  const c2d_body_result &A = s.resultants[2], &B = s.resultants[3];
  const double driving = A.applied[2], held = B.applied[2] - centres * B.applied[1];
  return std::fabs(held / driving) * zA / zB - 1;
}

// The largest pressure between these teeth, of module 1 and the family's pressure angle, against Hertz's for that force.
inline double gear_peak(const Solution& s, int zA) {
  const double a = 1e-3, base = zA / 2.0 * std::cos(20 * kPi / 180), force = s.resultants[2].applied[2] / base;
  return largest_pressure(s.zone(1)) / (2 * force / (kPi * a)) - 1;
}

// The lap joint: what the upper plate is pulled by, and what the contact between the plates and the stud's walls carry of it.
struct LapFigures {
  double pull, friction, bearing;
};
inline LapFigures lap_figures(const Solution& s) {
  return {s.resultants[1].applied[0], -s.zones[0].force[0] - s.zones[1].force[0], s.zones[2].force[0] + s.zones[3].force[0]};
}

// K1 over stress times sqrt(pi a) of make crack, a over the (half) width x. H. Tada, P. C. Paris, G. R. Irwin, The Stress
// Analysis of Cracks Handbook: the crack in the middle by Tada after Isida and Feddersen (it says 0.1 %), the edge crack in
// tension by Tada (0.5 %), in bending by Gross and Srawley (0.2 % up to x = 0.6; another formula there is 1.5 % off).
struct CrackFactors {
  double centre, edge, bending;
};
inline CrackFactors crack_factors(double x) {
  const double t = kPi * x / 2, edge = std::sqrt(std::tan(t) / t) * (0.752 + 2.02 * x + 0.37 * std::pow(1 - std::sin(t), 3));
  return {(1 - 0.025 * x * x + 0.06 * std::pow(x, 4)) / std::sqrt(std::cos(t)), edge / std::cos(t),
          1.122 - 1.4 * x + 7.33 * x * x - 13.08 * x * x * x + 14 * std::pow(x, 4)};
}

// Where faces begin to open that are closed on the left: their pressure falls to zero there as a root does. NaN: they do not.
inline double opens_at(const std::vector<Row>& faces) {
  size_t open = 0;
  while (open < faces.size() && faces[open].status != C2D_OPEN) ++open;
  for (size_t i = open; i < faces.size(); ++i)
    if (faces[i].status != C2D_OPEN) return NAN;
  if (open < 3 || open == faces.size()) return NAN;
  const Row &a = faces[open - 3], &b = faces[open - 1];
  const double pa = a.tn * a.tn, pb = b.tn * b.tn;
  return std::min(b.x + (b.x - a.x) * pb / (pa - pb), faces[open].x);
}

} // namespace families_test
