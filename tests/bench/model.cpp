#include "model.hpp"

#include "bench.hpp"

#include <algorithm>
#include <cmath>
#include <sys/mman.h>

namespace bench {

namespace {

constexpr double kFullLoad = 1;
constexpr double kPi = 3.14159265358979323846;

double processor_clock(void*) { return processor_seconds(); }
double clock_of(void*) { return seconds_now(); }

// Points from the last one of `xy` (not repeated) to (x, y), (x, y) itself left out: steps grow from h0 to
// h1.
void line_to(std::vector<double>& xy, double x0, double y0, double x1, double y1, double h0, double h1) {
  const double length = std::hypot(x1 - x0, y1 - y0);
  const bool even = std::fabs(h1 - h0) < 1e-9 * h0;
  const double growth = even ? 1 : 1 + (h1 - h0) / length;
  const int n = std::max(1, static_cast<int>(std::lround(even ? length / h0 : std::log(h1 / h0) / std::log(growth))));
  const double ratio = even ? 1 : std::pow(h1 / h0, 1.0 / n);
  double sum = 0, step = 1, total = 0;
  for (int i = 0; i < n; ++i, step *= ratio) total += step;
  step = 1;
  for (int i = 0; i < n; ++i, step *= ratio) {
    xy.push_back(x0 + (x1 - x0) * sum / total);
    xy.push_back(y0 + (y1 - y0) * sum / total);
    sum += step;
  }
}

// The same on a circle about (0, radius), by angles in degrees; h in degrees.
void arc_to(std::vector<double>& xy, double radius, double from, double to, double h0, double h1) {
  std::vector<double> angle;
  line_to(angle, from, 0, to, 0, h0, h1);
  for (size_t i = 0; i < angle.size(); i += 2) {
    xy.push_back(radius * std::cos(angle[i] * kPi / 180));
    xy.push_back(radius + radius * std::sin(angle[i] * kPi / 180));
  }
}

int32_t points(const std::vector<double>& xy) { return static_cast<int32_t>(xy.size() / 2); }

// Codes tx ty ux uy at both ends, or at more functional nodes, of the elements first ... last.
void condition(const Solver& s, int body, int32_t first, int32_t last, const char* codes, double ty = 0, int ends = 2) {
  const int32_t code[4] = {codes[0] - '0', codes[1] - '0', codes[2] - '0', codes[3] - '0'};
  const double value[4] = {0, ty, 0, 0};
  for (int32_t e = first; e <= last; ++e)
    for (int32_t l = 1; l <= ends; ++l) s.must(c2d_set_condition(s, body, e, l, 1, code, value));
}
void condition_at(const Solver& s, int body, int32_t element, int local, const char* codes, double ty = 0) {
  const int32_t code[4] = {codes[0] - '0', codes[1] - '0', codes[2] - '0', codes[3] - '0'};
  const double value[4] = {0, ty, 0, 0};
  s.must(c2d_set_condition(s, body, element, local, 1, code, value));
}

void add_body(const Solver& s, int body, const std::vector<double>& xy, double modulus) {
  c2d_body data = C2D_INIT(c2d_body);
  data.element_nodes = 2;
  data.elements = points(xy);
  data.regions = 1;
  data.youngs_modulus = modulus;
  data.poisson_ratio = 0.3;
  s.must(c2d_set_body(s, body, &data));
  s.must(c2d_add_region(s, body, 1, data.elements));
  s.must(c2d_set_nodes(s, body, 1, points(xy), xy.data(), 2));
}

} // namespace

void ask_for_huge_pages(void* memory, uint64_t bytes) {
  const uint64_t page = uint64_t{2} << 20, skipped = (page - reinterpret_cast<uintptr_t>(memory) % page) % page;
  if (bytes >= skipped + page) madvise(static_cast<char*>(memory) + skipped, (bytes - skipped) / page * page, MADV_HUGEPAGE);
}

Solver::Solver(const c2d_limits& limits, int32_t threads) : store_() {
  uint64_t bytes = 0;
  if (c2d_memory_need(&limits, nullptr, &bytes, nullptr) != C2D_OK) give_up("limits refused");
  memory_.reserve(bytes); // on large pages, as the program's
  ask_for_huge_pages(memory_.data(), bytes);
  memory_.resize(bytes);
  tapes_.resize(6 * bytes + (1 << 20)); // more than enough for every tape; pages not used cost nothing
  c2d_memory_store_init(&store_, tapes_.data(), tapes_.size());
  c2d_port port = C2D_INIT(c2d_port);
  c2d_memory_store_port(&store_, &port);
  if (threads > 1) {
    pool_ = std::make_unique<c2d_threads>();
    if (c2d_threads_start(pool_.get(), threads) != 0) give_up("no threads");
    c2d_threads_port(pool_.get(), &port);
  }
  port.clock = threads > 0 ? clock_of : processor_clock;
  c2d_error why = C2D_INIT(c2d_error);
  if (c2d_create(&solver_, memory_.data(), memory_.size(), &limits, &port, &why) != C2D_OK) give_up(why.text);
}

Solver::~Solver() {
  c2d_close(solver_);
  if (pool_) c2d_threads_stop(pool_.get());
}

void Solver::must(c2d_status status) const {
  if (status == C2D_OK) return;
  c2d_error why = C2D_INIT(c2d_error);
  c2d_last_error(solver_, &why);
  give_up(std::string(c2d_message(status)) + ": " + why.text);
}

host::Summary Solver::summary() const {
  host::Summary summary;
  must(host::get_summary(solver_, summary));
  return summary;
}

Cylinder::Cylinder(int32_t n) : pairs(n) {
  const double width = 2.8, radius = 8, h = width / (n - 1);
  floor = 1;
  line_to(foundation, 0, -4, 8, -4, 1, 1);
  side = points(foundation) + 1;
  line_to(foundation, 8, -4, 8, 0, 1, 1);
  top = points(foundation) + 1;
  line_to(foundation, 8, 0, width, 0, 1, h);
  zone1 = points(foundation) + 1;
  line_to(foundation, width, 0, 0, 0, h, h);
  axis1 = points(foundation) + 1;
  line_to(foundation, 0, 0, 0, -4, h, 1);
  foundation_elements = points(foundation);

  arc_to(disc, radius, 0, 80, 10, 10);
  arc_to(disc, radius, 80, 88.2092153, 2, 2);
  loaded = points(disc) + 1;
  arc_to(disc, radius, 88.2092153, 90, 2, 2);
  axis2 = points(disc) + 1;
  line_to(disc, 0, 16, 0, 8, 0.25, 1);
  line_to(disc, 0, 8, 0, 0, 1, h);
  zone2 = points(disc) + 1;
  for (int32_t i = 0; i + 1 < n; ++i) { // nodes right above those of the foundation
    const double x = h * i;
    disc.push_back(x);
    disc.push_back(x * x / (radius + std::sqrt(radius * radius - x * x)));
  }
  arc_to(disc, radius, std::asin(width / radius) * 180 / kPi - 90, 0, h / radius * 180 / kPi, 10);
  disc_elements = points(disc);
}

host::Limits Cylinder::limits() const {
  host::Limits out;
  out.bodies = 2;
  out.function_nodes = 2;
  out.body[0].points = out.body[0].elements = foundation_elements;
  out.body[1].points = out.body[1].elements = disc_elements;
  out.body[0].regions = out.body[1].regions = 1;
  out.zones = 1;
  out.pairs = pairs;
  out.contact_elements = pairs - 1;
  out.coefficients = out.paths = 1;
  return out;
}

void Cylinder::build(const Solver& s) const {
  c2d_problem problem = C2D_INIT(c2d_problem);
  problem.analysis = C2D_ANALYSIS_CONTACT;
  s.must(c2d_set_problem(s, &problem));
  add_body(s, 1, foundation, 1e7);
  add_body(s, 2, disc, 1e3);
  const int32_t e1 = foundation_elements;
  condition_at(s, 1, floor, 1, "0100");
  condition_at(s, 1, floor, 2, "0110");
  condition(s, 1, floor + 1, side - 1, "0110");
  condition_at(s, 1, side - 1, 2, "0100");
  condition_at(s, 1, side, 1, "1000");
  condition_at(s, 1, side, 2, "1001");
  condition(s, 1, side + 1, top - 1, "1001");
  condition_at(s, 1, top, 1, "0001");
  condition_at(s, 1, axis1 - 1, 2, "0101");
  condition(s, 1, axis1, e1, "1001");
  condition_at(s, 1, e1, 2, "1000");
  condition(s, 2, loaded, loaded, "0011", -1820);
  condition_at(s, 2, loaded, 2, "0001", -1820);
  condition(s, 2, axis2, zone2 - 1, "1001");
  condition_at(s, 2, zone2, 1, "0101");
  c2d_zone zone = C2D_INIT(c2d_zone);
  zone.pairs = pairs;
  zone.side1 = {1, zone1, zone1 + pairs - 2, 0, zone1, zone1 + pairs - 1};
  zone.side2 = {2, zone2 + pairs - 2, zone2, 0, zone2 + pairs - 1, zone2};
  s.must(c2d_add_zone(s, &zone));
  s.must(c2d_add_friction(s, 0.4));
  s.must(c2d_add_path(s, 1, &kFullLoad, 1));
  s.must(c2d_complete(s));
}

host::Limits Ring::limits() const {
  host::Limits out;
  out.bodies = 1;
  out.function_nodes = function_nodes;
  out.body[0].elements = 2 * elements;
  out.body[0].points = 2 * elements * (element_nodes - 1);
  out.body[0].regions = 2;
  out.coefficients = out.paths = 1;
  return out;
}

void Ring::build(const Solver& s) const {
  c2d_problem problem = C2D_INIT(c2d_problem);
  problem.analysis = C2D_ANALYSIS_STRESS;
  s.must(c2d_set_problem(s, &problem));
  c2d_body data = C2D_INIT(c2d_body);
  data.element_nodes = element_nodes;
  data.elements = 2 * elements;
  data.regions = 2;
  data.youngs_modulus = 1000;
  data.poisson_ratio = 0.3;
  s.must(c2d_set_body(s, 1, &data));
  s.must(c2d_add_region(s, 1, 1, elements));
  s.must(c2d_add_region(s, 1, elements + 1, 2 * elements));
  const int32_t per = element_nodes - 1, n = elements * per;
  std::vector<double> xy;
  for (int32_t i = 0; i < 2 * n; ++i) {
    const double radius = i < n ? 2 : 1, turn = i < n ? 1 : -1; // outside counter-clockwise, bore clockwise
    const auto at = [&](int32_t k, double out[2]) {
      const double angle = turn * 2 * kPi * k / n;
      out[0] = radius * std::cos(angle), out[1] = radius * std::sin(angle);
    };
    double point[2], next[2];
    const int32_t k = i % n, part = k % per;
    at(round ? k : k - part, point);
    at(k - part + per, next);
    for (int j = 0; j < 2; ++j) xy.push_back(round ? point[j] : point[j] + (next[j] - point[j]) * part / per);
  }
  s.must(c2d_set_nodes(s, 1, 1, 2 * n, xy.data(), 2));
  const int32_t held[4] = {1, 1, 0, 0}, roller[4] = {0, 1, 1, 0};
  const double zero[4] = {0, 0, 0, 0};
  s.must(c2d_set_condition(s, 1, 1, 1, 1, held, zero));
  s.must(c2d_set_condition(s, 1, elements, function_nodes, 1, held, zero));
  s.must(c2d_set_condition(s, 1, elements / 2, 1, 1, roller, zero));
  s.must(c2d_set_condition(s, 1, elements / 2 - 1, function_nodes, 1, roller, zero));
  const int32_t free[4] = {0, 0, 1, 1};
  const double pull[4] = {1, 0, 0, 0};
  s.must(c2d_set_condition(s, 1, elements + 1, 1, 1, free, pull));
  s.must(c2d_add_path(s, 1, &kFullLoad, 1));
  s.must(c2d_complete(s));
}

host::Limits Disc::limits() const {
  host::Limits out;
  out.bodies = 1;
  out.function_nodes = function_nodes;
  out.body[0].elements = out.body[0].points = elements;
  out.body[0].regions = out.coefficients = out.paths = 1;
  return out;
}

void Disc::build(const Solver& s) const {
  c2d_problem problem = C2D_INIT(c2d_problem);
  problem.analysis = C2D_ANALYSIS_STRESS;
  problem.plane = radius > 0 ? C2D_AXISYMMETRIC : C2D_PLANE_STRAIN;
  s.must(c2d_set_problem(s, &problem));
  std::vector<double> xy;
  for (int32_t i = 0; i < elements; ++i) {
    const double angle = 2 * kPi * i / elements;
    xy.push_back(radius + std::cos(angle)), xy.push_back(std::sin(angle));
  }
  add_body(s, 1, xy, 1000);
  condition(s, 1, 1, elements / 4, "1100", 0, function_nodes);
  condition_at(s, 1, elements / 4 + 1, 1, "0000");
  condition_at(s, 1, elements, function_nodes, "0000");
  condition(s, 1, elements / 2, 3 * elements / 4, "0011", -1, function_nodes);
  s.must(c2d_add_path(s, 1, &kFullLoad, 1));
  s.must(c2d_complete(s));
}

} // namespace bench
