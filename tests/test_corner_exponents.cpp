// Exponents of sharp corners: closed forms, studies of others, equivalent shapes, and how many there must be.
#include "post/corner_exponent.hpp"
#include "post/corner_fit.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

using app::CornerShape;
using app::FaceKind;

namespace {

const double kPi = std::acos(-1.0);
using Complex = std::complex<double>;

CornerShape wedge(double degrees, FaceKind first, FaceKind last, double nu = 0.3) {
  return {{app::sector_of(degrees * kPi / 180, 1, nu, true)}, {{first, 0}, {last, 0}}};
}
// A block of 90 degrees on a half plane of like material.
CornerShape block(app::Face joint) {
  return {{app::sector_of(kPi, 1, 0.3, true), app::sector_of(kPi / 2, 1, 0.3, true)}, {{}, joint, {}}};
}
std::vector<double> real_parts(const CornerShape& shape, double below = 1) {
  std::vector<double> out;
  for (const Complex& lambda : app::corner_exponents(shape, below)) out.push_back(lambda.real());
  return out;
}
bool alike(const std::vector<Complex>& a, const std::vector<Complex>& b, double tolerance) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i] - b[i]) > tolerance) return false;
  return true;
}

// Zeros of the determinant with left < real part < right and |imaginary part| < high: how often it winds round zero.
int zeros(const CornerShape& shape, double left, double right, double high) {
  const Complex corner[5] = {{left, -high}, {right, -high}, {right, high}, {left, high}, {left, -high}};
  double turned = 0;
  for (int side = 0; side < 4; ++side) {
    const int steps = 3000;
    Complex before = app::corner_determinant(shape, corner[side]);
    for (int i = 1; i <= steps; ++i) {
      const Complex now =
          app::corner_determinant(shape, corner[side] + (corner[side + 1] - corner[side]) * (i / double(steps)));
      turned += std::arg(now / before);
      before = now;
    }
  }
  return static_cast<int>(std::lround(turned / (2 * kPi)));
}

} // namespace

TEST_CASE("corners: exponents of wedges are those of Williams") {
  const std::vector<double> right = real_parts(wedge(270, FaceKind::kFree, FaceKind::kFree));
  REQUIRE(right.size() == 2);
  CHECK(std::fabs(right[0] - 0.5444837368) < 1e-10);
  CHECK(std::fabs(right[1] - 0.9085291898) < 1e-10);
  for (double degrees = 185; degrees < 360; degrees += 12.5) { // sin(lambda w) = -+ lambda sin(w)
    const double w = degrees * kPi / 180;
    for (const double lambda : real_parts(wedge(degrees, FaceKind::kFree, FaceKind::kFree)))
      CHECK(std::fabs(std::fabs(std::sin(lambda * w)) - lambda * std::fabs(std::sin(w))) < 1e-12);
    const app::Sector s = app::sector_of(w, 1, 0.3, true);
    std::vector<Complex> both = app::notch_exponents(s, true), odd = app::notch_exponents(s, false);
    both.insert(both.end(), odd.begin(), odd.end());
    CHECK(alike(both, app::corner_exponents(wedge(degrees, FaceKind::kFree, FaceKind::kFree)), 1e-10));
  }
  for (const double degrees : {70.0, 90.0, 135.0, 170.0, 200.0, 300.0})
    for (const double nu :
         {0.0, 0.3, 0.5}) { // held and free: sin^2(lambda w) = ((kappa + 1)^2 - 4 lambda^2 sin^2 w) / (4 kappa)
      const double w = degrees * kPi / 180, kappa = 3 - 4 * nu;
      for (const Complex& z : app::corner_exponents(wedge(degrees, FaceKind::kBonded, FaceKind::kFree, nu))) {
        const Complex left = std::pow(std::sin(z * w), 2), sine = z * std::sin(w);
        CHECK(std::abs(left - ((kappa + 1) * (kappa + 1) - 4.0 * sine * sine) / (4 * kappa)) < 1e-9);
      }
    }
  CHECK(app::exponent(wedge(90, FaceKind::kFree, FaceKind::kFree)) == 1);
  CHECK(app::exponent(wedge(90, FaceKind::kSmooth, FaceKind::kFree)) == 1); // half of a flat
  CHECK(std::fabs(app::exponent(wedge(180, FaceKind::kSmooth, FaceKind::kFree)) - 0.5) < 1e-10);
}

TEST_CASE("corners: a crack's exponent is double, those between unlike materials are complex") {
  const std::vector<Complex> crack = app::corner_exponents(wedge(360, FaceKind::kFree, FaceKind::kFree), 2.2);
  CHECK(alike(crack, {0.5, 0.5, 1.5, 1.5, 2, 2}, 1e-9));
  for (const double ratio : {1e-3, 0.2, 1.0, 30.0})
    for (const double nu : {0.0, 0.25, 0.45}) {
      const app::Sector a = app::sector_of(kPi, 1, nu, true), b = app::sector_of(kPi, ratio, 0.3, true);
      const double G = b.shear_modulus / a.shear_modulus;
      const double beta = (G * (a.kappa - 1) - (b.kappa - 1)) / (G * (a.kappa + 1) + (b.kappa + 1));
      const double oscillation = std::fabs(std::log((1 - beta) / (1 + beta)) / (2 * kPi));
      const std::vector<Complex> found = app::corner_exponents({{a, b}, {{}, {FaceKind::kBonded, 0}, {}}});
      REQUIRE(!found.empty());
      CHECK(std::abs(found[0] - Complex(0.5, oscillation)) < 1e-8);
    }
}

TEST_CASE("corners: exponents of a block on a half plane, and of a rigid punch with friction") {
  CHECK(alike(app::corner_exponents(block({FaceKind::kBonded, 0})), {0.5444837368, 0.9085291898}, 1e-9));
  const double table[][2] = {{0, 0.774013},   {0.1, 0.724882},  {0.2, 0.679924},  {0.3, 0.637987}, {0.4, 0.598319},
                             {0.5, 0.560389}, {-0.1, 0.829259}, {-0.2, 0.894461}, {-0.3, 0.979878}};
  for (const auto& row : table) {
    const app::Face joint{row[0] == 0 ? FaceKind::kSmooth : FaceKind::kRubbing, row[0]};
    CHECK(std::fabs(app::exponent(block(joint)) - row[1]) < 5.1e-7);
    // Seen from behind: the other way round, with friction of the other sign.
    CornerShape mirrored = block({joint.kind, -joint.friction});
    std::swap(mirrored.sectors[0], mirrored.sectors[1]);
    CHECK(alike(app::corner_exponents(mirrored, 1.9), app::corner_exponents(block(joint), 1.9), 1e-9));
  }
  for (const double f : {-0.8, -0.2, 0.1, 0.6}) { // f > 0: on the punch into the contact
    const double nu = 0.3, beta = (1 - 2 * nu) / (2 * (1 - nu));
    const CornerShape punch{{app::sector_of(kPi, 1, nu, true)}, {{}, {FaceKind::kRubbing, f}}};
    CHECK(std::fabs(app::exponent(punch) - (0.5 + std::atan(f * beta) / kPi)) < 1e-10);
  }
}

TEST_CASE("corners: no exponent is missed, and cutting a wedge in two changes none") {
  std::mt19937 random(7);
  const auto number = [&](double a, double b) { return a + (b - a) * (static_cast<double>(random()) / 4294967296.0); };
  const FaceKind kinds[] = {FaceKind::kFree, FaceKind::kGuided, FaceKind::kBonded, FaceKind::kSmooth, FaceKind::kRubbing};
  for (int i = 0; i < 120; ++i) {
    CAPTURE(i);
    CornerShape shape;
    const size_t n = 1 + static_cast<size_t>(i % 3);
    for (size_t k = 0; k < n; ++k)
      shape.sectors.push_back(
          app::sector_of(number(0.1, 1.9 / double(n)) * kPi, std::pow(10, number(-2, 2)), number(0, 0.5), true));
    for (size_t k = 0; k <= n; ++k) {
      const bool outer = k == 0 || k == n;
      shape.faces.push_back({kinds[outer ? random() % 5 : 2 + random() % 3], number(-1, 1)});
    }
    const std::vector<Complex> found = app::corner_exponents(shape);
    int count = 0;
    for (const Complex& z : found) count += z.real() > 0.999 ? 0 : z.imag() == 0 ? 1 : 2;
    CHECK(count == zeros(shape, 0.002, 0.999, 0.95));
    CornerShape cut = shape;
    cut.sectors[0].angle *= 0.4;
    cut.sectors.insert(cut.sectors.begin(), shape.sectors[0]);
    cut.sectors[0].angle *= 0.6;
    cut.faces.insert(cut.faces.begin() + 1, {FaceKind::kBonded, 0});
    CHECK(alike(app::corner_exponents(cut), found, 1e-7));
  }
}

// The first terms at a crack's tip, opening and shear, and a translation; faces at +-pi from the direction ahead.
TEST_CASE("corners: the intensities of a crack are those that its displacements were made of") {
  const double pi = std::acos(-1.0), E = 1000, nu = 0.3;
  const app::Sector sector = app::sector_of(2 * pi, E, nu, true);
  const double G = sector.shear_modulus, K1 = 3, K2 = -2;
  for (const double turn : {0.0, 0.7}) {
    CAPTURE(turn);
    std::vector<app::NotchSample> samples;
    for (int i = 0; i < 24; ++i)
      for (const bool first : {true, false}) {
        const double d = 0.02 * (i + 1), way = first ? -1 : 1; // the first face is below: theta = -pi
        const double part = way * (sector.kappa + 1) / (2 * G) * std::sqrt(d / (2 * pi));
        const double along = K2 * part + 0.1, across = K1 * part - 0.2;
        samples.push_back(
            {d, first, std::cos(turn) * along - std::sin(turn) * across, std::sin(turn) * along + std::cos(turn) * across});
      }
    app::Notch notch;
    notch.sector = sector, notch.bisector = turn;
    const app::CornerFit fit = app::fit_notch(samples, notch);
    CHECK(std::fabs(fit.K) == doctest::Approx(K1).epsilon(1e-6));
    CHECK(std::fabs(fit.K2) == doctest::Approx(-K2).epsilon(1e-6));
    CHECK(fit.K * fit.K2 < 0);
    CHECK(fit.misfit < 1e-6);
    CHECK(fit.K_error < 1e-6);
    // Nothing moved, or too little is known: nothing is made up.
    std::vector<app::NotchSample> still = samples, few(samples.begin(), samples.begin() + 4);
    for (app::NotchSample& s : still) s.ux = s.uy = 0;
    const app::CornerFit none = app::fit_notch(still, notch), little = app::fit_notch(few, notch);
    CHECK((none.K == 0 && none.K2 == 0 && none.misfit == 0));
    CHECK((little.K == 0 && little.K2 == 0));
  }
  // A wedge whose corner is no notch has no singular mode; samples at one distance tell one term only.
  app::Notch wedge;
  wedge.sector = app::sector_of(2.0, E, nu, true);
  const app::CornerFit flat = app::fit_notch({{1, true, 1, 0}, {1, false, 0, 1}, {2, true, 1, 1}, {2, false, 1, 0}}, wedge);
  CHECK((flat.K == 0 && flat.K2 == 0));
  const app::CornerFit same = app::fit_pressure(
      {{0.5, 2}, {0.5, 2}, {0.5, 2}, {0.5, 2}, {0.5, 2}, {0.5, 2}, {0.5, 2}, {0.5, 2}, {0.5, 2}}, {0.5, 1.0, 1.5});
  CHECK(same.K == doctest::Approx(2 * std::sqrt(0.5)));
  CHECK(same.misfit < 1e-12);
  CHECK(app::fit_pressure({{0.5, 0}, {1, 0}, {2, 0}}, {0.5}).misfit == 0);
}
