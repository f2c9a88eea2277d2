// The columns of a body's equations against integrals done the slow way, from the kernels as the thesis
// prints them.
#include "bie/integrals/batch.hpp"
#include "bie/panel.hpp"
#include "model_fixture.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <vector>

using namespace fixture;

namespace {

constexpr double kPi = 3.14159265358979323846;

const c2d::BatchKernel* best_batch() { return c2d::batch_for(c2d::best_instructions()); }

// The whole matrix of a body, column by column.
struct Columns {
  c2d::Model model;
  int b;
  int32_t rows, columns;
  std::vector<double> diagonal, point;
  std::vector<int32_t> twin;
  c2d::ColumnSystem system;
  std::unique_ptr<c2d::AssemblyScratch> scratch = std::make_unique<c2d::AssemblyScratch>();
  std::vector<c2d::Real> data;

  Columns(ModelData& d, int body, int32_t width = 0, const c2d::BatchKernel* batch = best_batch()) : model(d.view()), b(body) {
    c2d::number_unknowns(model, b);
    const size_t nodes = static_cast<size_t>(model.body[b].nodes);
    diagonal.resize(4 * nodes), point.resize(2 * nodes), twin.resize(nodes);
    system = {model, b, c2d::Quadrature::accurate, diagonal.data(), point.data(), twin.data(), scratch.get(), batch};
    system.some_passed_over = c2d::place_sources(system);
    c2d::fill_diagonal(system, 0, static_cast<int32_t>(nodes));
    rows = c2d::system_rows(model, b);
    columns = c2d::outer_columns(model, b) + c2d::trailing_columns(model, b);
    const int64_t ld = rows + 3; // more than the rows, as in a panel
    std::vector<c2d::Real> panel;
    if (width == 0) width = columns;
    for (int32_t first = 0; first < columns; first += width) {
      const int32_t count = std::min(width, columns - first);
      panel.assign(static_cast<size_t>(ld * count), -77);
      c2d::fill_columns(system, first, count, panel.data(), ld);
      for (int32_t j = 0; j < count; ++j) {
        data.insert(data.end(), panel.begin() + j * ld, panel.begin() + j * ld + rows);
        for (int64_t i = rows; i < ld; ++i) CHECK(panel[static_cast<size_t>(j * ld + i)] == c2d::Real(-77));
      }
    }
  }
  double at(int32_t row, int32_t column) const {
    return data[static_cast<size_t>(column) * static_cast<size_t>(rows) + static_cast<size_t>(row)];
  }
};

struct Block {
  double h[2][2], g[2][2];
};

// Kernels (3.23), (3.24): i is the direction of the force at the source, j the component at the field point.
void add_kernels(double nu, double rx, double ry, double nx, double ny, double weight, Block& sum) {
  const double r = std::hypot(rx, ry), d[2] = {rx / r, ry / r}, n[2] = {nx, ny}, k = 1 / (4 * kPi * (1 - nu));
  const double dn = d[0] * nx + d[1] * ny;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j) {
      const double delta = i == j;
      sum.g[i][j] += weight * k * (-(3 - 4 * nu) * std::log(r) * delta + d[i] * d[j]);
      sum.h[i][j] -=
          weight * k / r * (dn * ((1 - 2 * nu) * delta + 2 * d[i] * d[j]) - (1 - 2 * nu) * (d[i] * n[j] - d[j] * n[i]));
    }
}

// Ten-point Gauss-Legendre over pieces that shrink towards `near` (eta of the point nearest to the source).
template <class Integrand> void integrate_slowly(double near, Integrand integrand) {
  const double x[5] = {0.1488743389816312, 0.4333953941292472, 0.6794095682990244, 0.8650633666889845, 0.9739065285171717};
  const double w[5] = {0.2955242247147529, 0.2692667193099963, 0.2190863625159820, 0.1494513491505806, 0.0666713443086881};
  for (int side = -1; side <= 1; side += 2) {
    const double length = side < 0 ? near + 1 : 1 - near;
    if (length <= 0) continue;
    double far = length;
    for (int piece = 0; piece < 60; ++piece) {
      const double close = piece == 59 ? 0 : far / 2, middle = (far + close) / 2, half = (far - close) / 2;
      for (int k = 0; k < 5; ++k)
        for (int sign = -1; sign <= 1; sign += 2) integrand(near + side * (middle + sign * half * x[k]), half * w[k]);
      far = close;
    }
  }
}

double shape_value(int functions, int l, double eta) {
  double value = 1;
  for (int k = 0; k < functions; ++k)
    if (k != l) value *= (eta - c2d::node_eta(functions, k)) / (c2d::node_eta(functions, l) - c2d::node_eta(functions, k));
  return value;
}

// A body with straight and curved sides: the quadratic element 3 bulges.
ModelData bulged(int32_t functions, int32_t element_nodes) {
  ModelData d(functions);
  Points corners = {0, 0, 2, -0.3, 2.2, 1.1, 0.9, 1.6, -0.2, 0.8}, p;
  for (size_t e = 0; e < 5; ++e) {
    const double x0 = corners[2 * e], y0 = corners[2 * e + 1], x1 = corners[(2 * e + 2) % 10], y1 = corners[(2 * e + 3) % 10];
    for (int k = 0; k < element_nodes - 1; ++k) {
      const double s = k / (element_nodes - 1.0), bulge = e == 2 ? 0.6 * s * (1 - s) : 0;
      p.push_back(x0 + (x1 - x0) * s + bulge);
      p.push_back(y0 + (y1 - y0) * s + bulge);
    }
  }
  d.body(element_nodes, {p}, 2600, 0.3); // 2 G = 2000
  return d;
}

// H and G of the body in its own units by slow integration: [source][node or end] blocks, the diagonal of H
// left out.
void slow_matrices(const c2d::Model& m, std::vector<std::vector<Block>>& h, std::vector<std::vector<Block>>& g) {
  const c2d::Body& body = m.body[0];
  const int f = m.head->function_nodes;
  h.assign(static_cast<size_t>(body.nodes), std::vector<Block>(static_cast<size_t>(body.nodes), Block()));
  g.assign(static_cast<size_t>(body.nodes), std::vector<Block>(static_cast<size_t>(body.elements * f), Block()));
  for (int32_t source = 0; source < body.nodes; ++source) {
    double sx, sy;
    c2d::node_position(m, 0, source, &sx, &sy);
    for (int32_t e = 0; e < body.elements; ++e) {
      double near = -1, distance = 1e300;
      for (int k = 0; k <= 200; ++k) {
        const c2d::CurvePoint p = c2d::curve_point(m, 0, e, -1 + 0.01 * k);
        if (std::hypot(p.x - sx, p.y - sy) >= distance) continue;
        distance = std::hypot(p.x - sx, p.y - sy);
        near = -1 + 0.01 * k;
      }
      for (int l = 0; l < f; ++l)
        if (c2d::functional_node(m, 0, e, l) == source) near = c2d::node_eta(f, l);
      for (int l = 0; l < f; ++l) {
        Block sum = {};
        const int32_t node = c2d::functional_node(m, 0, e, l);
        integrate_slowly(near, [&](double eta, double weight) {
          const c2d::CurvePoint p = c2d::curve_point(m, 0, e, eta);
          const double jacobian = std::hypot(p.dx, p.dy), unit = m.head->length_unit;
          const double rx = p.x - sx, ry = p.y - sy;
          if (rx == 0 && ry == 0) return;
          add_kernels(c2d::strain_poisson_ratio(m, 0), rx / unit, ry / unit, p.dy / jacobian, -p.dx / jacobian,
                      weight * jacobian / unit * shape_value(f, l, eta), sum);
        });
        Block& to_h = h[static_cast<size_t>(source)][static_cast<size_t>(node)];
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j) to_h.h[i][j] += sum.h[i][j];
        g[static_cast<size_t>(source)][static_cast<size_t>(e * f + l)] = sum;
      }
    }
  }
}

} // namespace

TEST_CASE("assembly: displacement columns are the integrals of the traction kernel") {
  for (int32_t functions : {1, 2, 3, 4})
    for (int element_nodes : {2, 3}) {
      CAPTURE(functions);
      CAPTURE(element_nodes);
      ModelData d = bulged(functions, element_nodes);
      REQUIRE_MESSAGE(d.complete(), d.all());
      const Columns a(d, 0);
      const int32_t nodes = a.model.body[0].nodes;
      REQUIRE(a.columns == 2 * nodes + 3 + 1);
      std::vector<std::vector<Block>> h, g;
      slow_matrices(a.model, h, g);
      double worst = 0;
      for (int32_t p = 0; p < nodes; ++p)
        for (int32_t q = 0; q < nodes; ++q)
          for (int i = 0; i < 2 && p != q; ++i)
            for (int j = 0; j < 2; ++j)
              worst = std::max(
                  worst, std::fabs(a.at(2 * p + i, 2 * q + j) - h[static_cast<size_t>(p)][static_cast<size_t>(q)].h[i][j]));
      CHECK(worst < 1e-11);               // entries are of order one; both sides are good to some 1e-13
      for (int32_t p = 0; p < nodes; ++p) // a translation moves nothing
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j) {
            double sum = 0;
            for (int32_t q = 0; q < nodes; ++q) sum += a.at(2 * p + i, 2 * q + j);
            CHECK(std::fabs(sum) < 1e-12);
          }
      if (functions < element_nodes) continue;            // the functions then do not hold a rotation
      if (functions == 4 && element_nodes == 3) continue; // cubic nodes hold a quadratic curve, checked by 3 and 3
      for (int32_t row = 0; row < 2 * nodes; ++row) {
        double sum = 0;
        for (int32_t q = 0; q < nodes; ++q) {
          double x, y;
          c2d::node_position(a.model, 0, q, &x, &y);
          sum += -y * a.at(row, 2 * q) + x * a.at(row, 2 * q + 1);
        }
        CHECK(std::fabs(sum) < 1e-12 * 2.2 * 10);
      }
    }
}

TEST_CASE("assembly: traction columns, the right-hand side and the three balances") {
  for (int32_t functions : {1, 2, 3, 4})
    for (int element_nodes : {2, 3}) {
      CAPTURE(functions);
      CAPTURE(element_nodes);
      ModelData d = bulged(functions, element_nodes);
      // Element 1 is held: its tractions are unknown. Element 3, the bulged one, carries a load.
      for (int l = 1; l <= functions; ++l) d.condition(1, 1, l, "1100");
      for (int l = 1; l <= functions; ++l) {
        const size_t end = static_cast<size_t>(2 * functions + l - 1);
        d.condition(1, 3, l, "0011");
        d.end_traction[0][2 * end] = 3.0 + l;
        d.end_traction[0][2 * end + 1] = -2.0 * l;
      }
      REQUIRE_MESSAGE(d.complete(), d.all());
      const Columns a(d, 0);
      const c2d::Model& m = a.model;
      const int32_t nodes = m.body[0].nodes, right = a.columns - 1;
      const double two_g = 2000, unit = m.head->length_unit;
      std::vector<std::vector<Block>> h, g;
      slow_matrices(m, h, g);
      double worst = 0;
      for (int32_t p = 0; p < nodes; ++p)
        for (int i = 0; i < 2; ++i) {
          for (int l = 0; l < functions; ++l)
            for (int j = 0; j < 2; ++j) {
              const int32_t column = c2d::outer_column(m, 0, c2d::functional_node(m, 0, 0, l), j);
              worst = std::max(worst,
                               std::fabs(a.at(2 * p + i, column) + g[static_cast<size_t>(p)][static_cast<size_t>(l)].g[i][j]));
            }
          double sum = 0;
          for (int l = 0; l < functions; ++l) {
            const Block& block = g[static_cast<size_t>(p)][static_cast<size_t>(2 * functions + l)];
            sum += (block.g[i][0] * (4.0 + l) + block.g[i][1] * -2.0 * (l + 1)) / two_g;
          }
          CHECK(std::fabs(a.at(2 * p + i, right) - sum) < 1e-13); // values / 2G are some 1e-3
        }
      CHECK(worst < 1e-11);

      // Balance rows of the loads: forces and their moment about the body's centre.
      double force[3] = {0, 0, 0}, weights = 0;
      integrate_slowly(0, [&](double eta, double weight) {
        const c2d::CurvePoint p = c2d::curve_point(m, 0, 2, eta);
        const double length = weight * std::hypot(p.dx, p.dy) / unit;
        const double x = (p.x - m.body[0].centre[0]) / unit, y = (p.y - m.body[0].centre[1]) / unit;
        weights += length;
        for (int l = 0; l < functions; ++l) {
          const double tx = shape_value(functions, l, eta) * (4.0 + l) / two_g,
                       ty = shape_value(functions, l, eta) * -2.0 * (l + 1) / two_g;
          force[0] += length * tx, force[1] += length * ty;
          force[2] += length * (x * ty - y * tx);
        }
      });
      for (int i = 0; i < 3; ++i) CHECK(std::fabs(a.at(2 * nodes + i, right) - force[i]) < 1e-14);
      // The held element is straight: its shape functions add up to its length.
      double held[2] = {0, 0};
      for (int l = 0; l < functions; ++l) {
        const int32_t node = c2d::functional_node(m, 0, 0, l);
        held[0] -= a.at(2 * nodes, c2d::outer_column(m, 0, node, 0));
        held[1] -= a.at(2 * nodes + 1, c2d::outer_column(m, 0, node, 1));
        CHECK(a.at(2 * nodes + 1, c2d::outer_column(m, 0, node, 0)) == 0.0);
      }
      CHECK(held[0] == doctest::Approx(std::hypot(2, 0.3) / unit).epsilon(1e-13));
      CHECK(held[1] == doctest::Approx(std::hypot(2, 0.3) / unit).epsilon(1e-13));
    }
}

TEST_CASE("assembly: columns of the multipliers are rigid motions") {
  ModelData d = bulged(2, 2);
  REQUIRE(d.complete());
  const Columns a(d, 0);
  const c2d::Body& body = a.model.body[0];
  const double unit = a.model.head->length_unit;
  for (int32_t p = 0; p < body.nodes; ++p) {
    double x, y;
    c2d::node_position(a.model, 0, p, &x, &y);
    const double wanted[2][3] = {{-1, 0, (y - body.centre[1]) / unit}, {0, -1, -(x - body.centre[0]) / unit}};
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 3; ++k)
        CHECK(a.at(2 * p + i, body.columns + k) == doctest::Approx(wanted[i][k]).epsilon(1e-13).scale(1));
  }
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) CHECK(a.at(2 * body.nodes + i, body.columns + k) == 0.0);
}

TEST_CASE("assembly: any panels give the same columns") {
  ModelData d = hertz();
  REQUIRE_MESSAGE(d.complete(), d.all());
  for (int b = 0; b < 2; ++b) {
    const Columns whole(d, b);
    for (int32_t width : {1, 3, 20}) {
      CAPTURE(width);
      const Columns pieces(d, b, width);
      CHECK(pieces.data == whole.data);
    }
  }
}

TEST_CASE("assembly: any range of columns gives the same bits: all orders, slanted contacts, several holes, uneven nodes") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int32_t trial = 0; trial < 24; ++trial) {
    const int32_t functions = 1 + trial % 4, nodes = 2 + trial / 4 % 3;
    CAPTURE(trial);
    ModelData d(functions);
    const double turn = any(random), c = std::cos(turn), s = std::sin(turn);
    for (int b = 0; b < 2; ++b) { // two squares, one on the other, with holes
      std::vector<Points> curves;
      const auto add = [&](const Points& corners) {
        Points p;
        const size_t n = corners.size() / 2;
        for (size_t e = 0; e < n; ++e)
          for (int k = 0; k < nodes - 1; ++k) {
            // Inner nodes stand off the middle on some straight sides.
            const double at = k / (nodes - 1.0) + (k > 0 && e % 3 == 1 ? 0.05 : 0.0);
            const size_t next = (e + 1) % n * 2;
            const double x = corners[2 * e] + at * (corners[next] - corners[2 * e]);
            const double y = corners[2 * e + 1] + at * (corners[next + 1] - corners[2 * e + 1]);
            p.push_back(c * x - s * y);
            p.push_back(s * x + c * y);
          }
        curves.push_back(p);
      };
      add(rectangle(0, b == 0 ? -2 : 0, 3, 2, 3, 2));
      const int holes = 1 + trial % 3;
      for (int h = 0; h < holes; ++h) {
        const double x = 0.5 + h, y = b == 0 ? -1 : 1, r = 0.3 + 0.1 * any(random), a = any(random);
        Points hole;
        for (int k = 0; k < 3 + (h + trial) % 3; ++k) arc_to(hole, x, y, r, 57 * a - 360.0 * k / (3 + (h + trial) % 3), 0, 1);
        add(hole);
      }
      d.body(nodes, curves, 1000, b == 0 ? 0.3 : 0.45);
    }
    d.conditions(1, 1, 1, 3, functions, "1100");
    if (functions == 1) {
      d.zone(3, 3, 6, 1, 6, 3, -1, 3);
    } else {
      const int32_t per = functions - 1, without = trial % 3 == 0 ? 1 : 0; // the last node makes no pair, and may be loaded
      d.zone(3 * per + 1 - without, 3, 6, 1, 5 * per + 1, 3, -1, 3 * per + 1);
      if (without != 0) d.end_traction[1][0] = 0.4, d.end_traction[1][1] = -0.2;
    }
    d.point_load(2, c * 0.2 - s * 1.8, s * 0.2 + c * 1.8, 0.3, -1);
    REQUIRE_MESSAGE(d.complete(), d.all());
    for (int b = 0; b < 2; ++b) {
      const Columns whole(d, b);
      for (int32_t width : {1, 2, 7, 16}) {
        CAPTURE(width);
        const Columns pieces(d, b, width);
        CHECK(pieces.data == whole.data);
      }
    }
  }
}

TEST_CASE("assembly: sources in batches, by every instruction set, give what they give one by one") {
  std::vector<ModelData> models = {hertz()};
  for (int32_t functions : {1, 2, 3, 4}) models.push_back(bulged(functions, functions == 1 ? 2 : 3));
  for (ModelData& d : models) {
    REQUIRE_MESSAGE(d.complete(), d.all());
    for (int b = 0; b < d.view().head->bodies; ++b) {
      const Columns single(d, b, 0, nullptr);
      double most = 0;
      for (const c2d::Real value : single.data) most = std::max(most, std::fabs(static_cast<double>(value)));
      for (int32_t set = 1; set <= static_cast<int32_t>(c2d::best_instructions()); ++set) {
        const c2d::BatchKernel* batch = c2d::batch_for(static_cast<c2d::Instructions>(set));
        if (!batch) continue;
        CAPTURE(set);
        const Columns batched(d, b, 0, batch);
        double worst = 0;
        for (size_t i = 0; i < single.data.size(); ++i)
          worst = std::max(worst, std::fabs(static_cast<double>(batched.data[i] - single.data[i])));
        CHECK(worst < 40 * static_cast<double>(std::numeric_limits<c2d::Real>::epsilon()) * most);
        double diagonal = 0;
        for (size_t i = 0; i < single.diagonal.size(); ++i)
          diagonal = std::max(diagonal, std::fabs(batched.diagonal[i] - single.diagonal[i]));
        CHECK(diagonal < 1e-14 * static_cast<double>(single.diagonal.size())); // a sum over all elements
      }
    }
  }
}

TEST_CASE("assembly: every unknown outside the contact has a column of its own") {
  ModelData d = hertz();
  REQUIRE_MESSAGE(d.complete(), d.all());
  const c2d::Model m = d.view();
  CHECK(m.head->contact == 29); // 15 pairs, the one on the axis without tangential freedom
  for (int b = 0; b < 2; ++b) {
    c2d::number_unknowns(m, b);
    std::set<int32_t> seen;
    int32_t contact = 0;
    for (int32_t node = 0; node < m.body[b].nodes; ++node)
      for (int c = 0; c < 2; ++c) {
        const int32_t column = c2d::outer_column(m, b, node, c);
        if (column < 0) {
          CHECK(c2d::pair_of_node(m, b, node).pair >= 0);
          ++contact;
        } else {
          CHECK(seen.insert(column).second);
        }
      }
    CHECK(contact == 29);
    CHECK(static_cast<int32_t>(seen.size()) == m.body[b].columns);
    CHECK(*seen.begin() == 0);
    CHECK(*seen.rbegin() == m.body[b].columns - 1);
    CHECK(c2d::outer_columns(m, b) == 2 * m.body[b].nodes + 3 - 29);
  }
}

TEST_CASE("assembly: both bodies feel the same contact force") {
  // tau is measured on body 1's length: the balance rows of the two bodies, times 2G, hold the same forces
  // although the surfaces differ in length and direction; on the sample by up to 6 %.
  ModelData d = hertz();
  REQUIRE_MESSAGE(d.complete(), d.all());
  const Columns one(d, 0), two(d, 1);
  const c2d::Model& m = one.model;
  for (int32_t k = 0; k < m.head->contact; ++k)
    for (int i = 0; i < 2; ++i) {
      const int32_t c1 = c2d::outer_columns(m, 0) + m.head->contact + k, c2 = c2d::outer_columns(m, 1) + m.head->contact + k;
      const double f1 = one.at(2 * m.body[0].nodes + i, c1) * 2 * c2d::shear_modulus(m, 0),
                   f2 = two.at(2 * m.body[1].nodes + i, c2) * 2 * c2d::shear_modulus(m, 1);
      CHECK(std::fabs(f1 - f2) < 1e-12 * m.head->stress_unit);
    }
  // An inner pair between elements of length 0.2: unit pressure along its normal carries 0.2.
  const c2d::Pair& pair = m.pair[7];
  const int32_t column = c2d::outer_columns(m, 0) + m.head->contact + pair.dof;
  const double fx = one.at(2 * m.body[0].nodes, column), fy = one.at(2 * m.body[0].nodes + 1, column);
  const double scale = m.head->stress_unit / (2 * c2d::shear_modulus(m, 0)) / m.head->length_unit;
  CHECK(fx == doctest::Approx(0.2 * pair.nx * scale).epsilon(1e-12));
  CHECK(fy == doctest::Approx(0.2 * pair.ny * scale).epsilon(1e-12));
}

TEST_CASE("assembly: the diagonal in closed form is the sum over the elements: corners of all kinds, holes, double nodes") {
  for (int32_t functions = 1; functions <= 4; ++functions)
    for (const bool twins : {false, true}) {
      if (twins && functions != 2) continue;
      CAPTURE(functions);
      ModelData d(functions);
      Points outer = {0, 0, 3, 0, 4.5, 0.9, 1.4, 1.1, 1.2, 2.9, 0.7, 3, -0.1, 1.5}; // a wedge; a corner turns inwards
      if (twins) outer.insert(outer.begin() + 4, {3, 0});
      Points hole = {0.4, 0.3, 0.35, 0.8, 0.6, 0.6, 0.9, 0.5}, other = {2, 0.4, 2.2, 0.7, 2.6, 0.3};
      if (twins) hole.insert(hole.end(), {0.9, 0.5});
      d.body(2, {outer, hole, other}, 2600, 0.3);
      REQUIRE_MESSAGE(d.complete(), d.all());
      const Columns closed(d, 0), summed(d, 0, 0, nullptr);
      for (size_t i = 0; i < closed.diagonal.size(); ++i)
        CHECK(std::fabs(closed.diagonal[i] - summed.diagonal[i]) < 2e-15 * 8); // entries below 1, a dozen elements
    }
}

namespace {

// Elements between these corners, `per` on each side, bulged by this share of their length: straight ones with 0.
Points sides(const Points& corners, int element_nodes, int per, double bulge) {
  Points out;
  const size_t n = corners.size() / 2;
  for (size_t e = 0; e < n; ++e) {
    const double *p = &corners[2 * e], *q = &corners[(2 * e + 2) % (2 * n)];
    const double dx = (q[0] - p[0]) / per, dy = (q[1] - p[1]) / per;
    for (int k = 0; k < per * (element_nodes - 1); ++k) {
      const double at = k / (element_nodes - 1.0), t = at - std::floor(at), out_by = 4 * bulge * t * (1 - t);
      out.insert(out.end(), {p[0] + at * dx + out_by * dy, p[1] + at * dy - out_by * dx});
    }
  }
  return out;
}

// A ring whose section has corners of all kinds and a hole; with functions 2 double nodes at a corner.
ModelData ring_body(int32_t functions, double bulge) {
  ModelData d(functions);
  d.head.plane = C2D_AXISYMMETRIC;
  const int nodes = bulge == 0 ? 2 : 3 + functions % 2;
  Points outer = sides({0.3, 0, 3, 0, 4.5, 0.9, 1.4, 1.1, 1.2, 2.9, 0.7, 3, 0.2, 1.5}, nodes, 2, bulge);
  if (functions == 2 && bulge == 0) outer.insert(outer.begin() + 4, {3, 0});
  d.body(nodes, {outer, sides({0.4, 0.3, 0.35, 0.8, 0.6, 0.6, 0.9, 0.5}, nodes, 1, 0)}, 2600, 0.3);
  return d;
}

} // namespace

TEST_CASE("assembly: rings in batches, their diagonal by paths, give what sums one by one give" * doctest::skip(!c2d::kRings)) {
  for (int32_t functions = 2; functions <= 4; ++functions)
    for (const double bulge : {0.0, 0.08, -0.05}) {
      CAPTURE(functions);
      CAPTURE(bulge);
      ModelData d = ring_body(functions, bulge);
      REQUIRE_MESSAGE(d.complete(), d.all());
      const Columns single(d, 0, 0, nullptr);
      const size_t rows = static_cast<size_t>(single.rows);
      for (int32_t set = 1; set <= static_cast<int32_t>(c2d::best_instructions()); ++set) {
        const c2d::BatchKernel* batch = c2d::batch_for(static_cast<c2d::Instructions>(set));
        if (!batch) continue;
        CAPTURE(set);
        const Columns whole(d, 0, 0, batch), pieces(d, 0, 7, batch);
        CHECK(pieces.data == whole.data);
        double worst = 0, diagonal = 0;
        for (size_t first = 0; first < single.data.size(); first += rows) {
          double most = 1e-300, off = 0; // of the column
          for (size_t i = first; i < first + rows; ++i) {
            most = std::max(most, std::fabs(double{single.data[i]}));
            off = std::max(off, std::fabs(double{whole.data[i]} - double{single.data[i]}));
          }
          worst = std::max(worst, off / most);
        }
        CHECK(worst < 1000 * static_cast<double>(std::numeric_limits<c2d::Real>::epsilon()));
        for (size_t i = 0; i < single.diagonal.size(); ++i)
          diagonal = std::max(diagonal, std::fabs(whole.diagonal[i] - single.diagonal[i]));
        CHECK(diagonal < 5e-14);
      }
    }
}

TEST_CASE("assembly: the diagonal of half a solid of revolution, from the axis to its line of symmetry" *
          doctest::skip(!c2d::kRings)) {
  for (int32_t functions = 2; functions <= 4; ++functions) {
    CAPTURE(functions);
    ModelData d(functions);
    d.head.plane = C2D_AXISYMMETRIC;
    d.head.symmetry_asked = 2; // y = 0
    d.body(2, {{2, 0, 1.9, 0.3, 2.1, 0.9, 1.2, 1, 0.7, 1.8, 0.01, 1.9, 0, 1.9}});
    c2d::Body& body = d.bodies[0];
    body.elements -= 1, body.nodes -= functions - 2, d.regions[0][0].last -= 1, d.regions[0][0].open = 1, body.open_regions = 1;
    REQUIRE_MESSAGE(d.complete(), d.all());
    REQUIRE(d.bodies[0].lines == 3); // axis and line
    const Columns path(d, 0), summed(d, 0, 0, nullptr);
    const size_t on_axis = summed.diagonal.size() - 4; // its block along r has no meaning
    double worst = 0;
    for (size_t i = 0; i < summed.diagonal.size(); ++i)
      if (i < on_axis || i == on_axis + 3) worst = std::max(worst, std::fabs(path.diagonal[i] - summed.diagonal[i]));
    CHECK(worst < 3e-13); // entries of nodes near the axis are sums of larger numbers
  }
}
