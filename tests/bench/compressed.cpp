// Compressed elimination: against the dense one, its growth, and what it leaves of equations of awkward bodies. Every run is a
// process of its own, whose processor time and memory count.
#include "../host_structs.hpp"
#include "../many_bodies.hpp"
#include "bench.hpp"
#include "children.hpp"

#include "../callable.hpp"
#include "c2d_memory.h"
#include "c2d_posix.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace bench {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kNumbers = 4;                       // of a run, before those of its pairs
constexpr uint64_t kBeside = uint64_t{128} << 20; // workspace beyond twice the minimum, as the program takes it

struct Outcome {
  double seconds, megabytes, residual, error, inside; // inside: seconds for a grid of points
  std::vector<double> pressure, status;
};

// Pages that are not touched cost nothing; so much may be asked for that the system would not promise it all.
class Memory {
public:
  explicit Memory(uint64_t bytes) : bytes_(bytes) {
    memory_ = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory_ == MAP_FAILED) give_up("no memory");
  }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  ~Memory() { munmap(memory_, bytes_); }
  void* get() const { return memory_; }

private:
  void* memory_;
  uint64_t bytes_;
};

[[noreturn]] void fail(c2d_solver* solver, c2d_status status) {
  c2d_error why = C2D_INIT(c2d_error);
  c2d_last_error(solver, &why);
  give_up(std::string(c2d_message(status)) + ": " + why.text);
}

// What a run writes to whoever waits for it.
void write_numbers(int file, const std::vector<double>& numbers) {
  const char* from = reinterpret_cast<const char*>(numbers.data());
  for (size_t left = numbers.size() * sizeof(double); left > 0;) {
    const ssize_t done = write(file, from, left);
    if (done <= 0) std::_Exit(1);
    from += done, left -= static_cast<size_t>(done);
  }
}

// Of so many points each way in the lower block.
double seconds_inside(c2d_solver* solver, int32_t points) {
  const int32_t count = points * points;
  std::vector<double> xy(2 * static_cast<size_t>(count)), out(C2D_POINT_FIELDS * static_cast<size_t>(count));
  c2d_points grid = C2D_INIT(c2d_points);
  grid.kind = C2D_POINTS_GRID, grid.body = 1, grid.count[0] = grid.count[1] = points;
  grid.from[0] = -0.4, grid.to[0] = 0.4, grid.from[1] = -0.5, grid.to[1] = -0.001;
  const double start = processor_seconds();
  if (points > 0 && (c2d_expand_points(&grid, 1, count, xy.data(), 2, nullptr) != C2D_OK ||
                     c2d_interior(solver, 1, count, xy.data(), 2, out.data(), C2D_POINT_FIELDS) != C2D_OK))
    give_up("no interior points");
  return processor_seconds() - start;
}

constexpr uint64_t kStreamed = uint64_t{256} << 20;

// With a folder in so much memory and files, else in memory alone.
void solve(const many::Model& m, int32_t elimination, int32_t points, const std::string& folder, int file) {
  std::vector<c2d_body_limits> list;
  const c2d_limits limits = many::limits_of(m, list);
  uint64_t minimum = 0, in_core = 0, tapes = 0;
  if (c2d_memory_need(&limits, &minimum, &in_core, nullptr) != C2D_OK) give_up("limits refused");
  const bool compressed = elimination == C2D_ELIMINATION_COMPRESSED;
  const bool streams = !folder.empty();
  const uint64_t bytes = streams ? kStreamed : compressed ? 2 * minimum + kBeside : in_core;
  c2d_options options = C2D_INIT(c2d_options);
  options.elimination = elimination;
  for (int32_t tape = 0; tape < C2D_TAPES; ++tape) {
    uint64_t blocks = 0, each = 0;
    if (c2d_tape_need(&limits, &options, bytes, tape, &blocks, &each, nullptr) != C2D_OK) give_up("no tapes");
    tapes += blocks * each + 64;
  }
  const Memory workspace(bytes), region(streams ? 64 : tapes);
  c2d_memory_store store;
  c2d_posix_store files;
  c2d_port port = C2D_INIT(c2d_port);
  if (streams) {
    if (c2d_posix_store_init(&files, folder.c_str()) != 0) give_up("no folder");
    for (int32_t tape = 0; tape < C2D_TAPES; ++tape) c2d_posix_store_expect(&files, tape, 0);
    c2d_posix_store_port(&files, &port);
  } else {
    c2d_memory_store_init(&store, region.get(), tapes);
    c2d_memory_store_port(&store, &port);
  }
  c2d_solver* solver = nullptr;
  if (c2d_create(&solver, workspace.get(), bytes, &limits, &port, nullptr) != C2D_OK) give_up("not created");
  c2d_status status = many::feed(solver, m);
  if (status == C2D_OK) status = c2d_set_options(solver, &options);
  if (status == C2D_OK) status = c2d_prepare(solver);
  if (status == C2D_OK) status = c2d_run(solver, nullptr, nullptr);
  if (status != C2D_OK) fail(solver, status);
  host::Summary summary;
  host::get_summary(solver, summary);
  if (summary.outcome != C2D_REACHED) give_up(c2d_outcome_message(summary.outcome));
  std::vector<double> all = {processor_seconds(), summary.compression_residual, summary.compression_error,
                             seconds_inside(solver, points)};
  const size_t pairs = static_cast<size_t>(summary.pairs);
  all.resize(kNumbers + 2 * pairs);
  if (pairs > 0) {
    c2d_get(solver, C2D_TN, 0, 1, summary.pairs, all.data() + kNumbers, 1);
    c2d_get(solver, C2D_STATUS, 0, 1, summary.pairs, all.data() + kNumbers + pairs, 1);
  }
  c2d_close(solver);
  if (streams) c2d_posix_store_discard(&files, folder.c_str());
  write_numbers(file, all);
}

Outcome run(const many::Model& m, int32_t elimination, int32_t points, const std::string& folder = "") {
  int ends[2];
  if (pipe(ends) != 0) give_up("no pipe");
  std::fflush(stdout);
  const pid_t child = fork();
  if (child < 0) give_up("no process");
  if (child == 0) {
    close(ends[0]);
    solve(m, elimination, points, folder, ends[1]);
    std::_Exit(0);
  }
  close(ends[1]);
  std::vector<double> all;
  double numbers[512];
  size_t held = 0;
  for (;;) {
    const ssize_t got = read(ends[0], reinterpret_cast<char*>(numbers) + held, sizeof numbers - held);
    if (got <= 0) break;
    held += static_cast<size_t>(got);
    all.insert(all.end(), numbers, numbers + held / sizeof(double));
    std::copy(reinterpret_cast<char*>(numbers) + held / sizeof(double) * sizeof(double),
              reinterpret_cast<char*>(numbers) + held, reinterpret_cast<char*>(numbers));
    held %= sizeof(double);
  }
  close(ends[0]);
  int ended = 0;
  rusage used = {};
  if (wait4(child, &ended, 0, &used) != child || ended != 0 || all.size() < kNumbers) give_up("a run has failed");
  const int64_t pairs = static_cast<int64_t>(all.size() - kNumbers) / 2;
  return {all[0],
          static_cast<double>(used.ru_maxrss) / 1024,
          all[1],
          all[2],
          all[3],
          {all.begin() + kNumbers, all.begin() + kNumbers + pairs},
          {all.begin() + kNumbers + pairs, all.end()}};
}

Outcome compressed(const many::Model& m, int32_t points = 0) { return run(m, C2D_ELIMINATION_COMPRESSED, points); }

using Curve = std::vector<double>; // x y x y ...

// Closed curves of straight elements.
many::Body body_of(const std::vector<Curve>& curves) {
  many::Body body;
  for (const Curve& curve : curves) {
    const int32_t before = body.elements(), count = static_cast<int32_t>(curve.size() / 2);
    body.xy.insert(body.xy.end(), curve.begin(), curve.end());
    body.regions.push_back({before + 1, before + count});
  }
  body.ends.resize(2 * static_cast<size_t>(body.elements()));
  return body;
}

// ---- a pair of bodies -------------------------------------------------------------------------------------------------

// Two blocks of so many nodes each, the upper one rounded below, that may touch in their middle, in 200 pairs if there are as
// many.
many::Model pressed(int32_t nodes) {
  const int32_t face = nodes / 8 * 3, rest = (nodes - 2 * face) / 2, pairs = std::min(200, face / 2);
  const double half_width = 0.5 * pairs / face; // of the zone, of faces from -1/2 to 1/2
  const auto flat = [](double) { return 0.0; };
  const auto round = [&](double x) { return 0.02 * half_width * (x / half_width) * (x / half_width) / 2; };
  many::Model m;
  for (int upper = 0; upper < 2; ++upper) {
    const test::Callable<double(double)> gap = upper == 1 ? test::Callable<double(double)>(round) : flat;
    const double far = upper == 1 ? 1 : -1;
    std::vector<double> xy;
    const auto side = [&](double x0, double y0, double x1, double y1, int32_t count, bool contact) {
      for (int32_t i = 0; i < count; ++i) {
        const double s = static_cast<double>(i) / count, x = x0 + (x1 - x0) * s;
        xy.insert(xy.end(), {x, contact ? gap(x) : y0 + (y1 - y0) * s});
      }
    };
    // Counter-clockwise; the face that may touch is the first side of the upper block, the third of the lower one.
    const double low = upper == 1 ? gap(0.5) : far, high = upper == 1 ? far : gap(0.5);
    side(-0.5, low, 0.5, low, face, upper == 1);
    side(0.5, low, 0.5, high, rest, false);
    side(0.5, high, -0.5, high, face, upper == 0);
    side(-0.5, high, -0.5, low, rest, false);
    many::Body body = body_of({xy});
    body.sides = {
        {1, face}, {face + 1, face + rest}, {face + rest + 1, 2 * face + rest}, {2 * face + rest + 1, 2 * (face + rest)}};
    m.add(body);
  }
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(2, 3, many::end_of(many::kPulled, 0.15 * half_width * half_width, -3 * half_width));
  const int32_t first = (face - pairs) / 2 + 1, last = first + pairs - 2;
  const many::Range lower = m.side(1, 3), top = m.side(2, 1);
  m.zones.push_back(
      {C2D_ZONE_MATCHING,
       {{1, lower.first + face - last, lower.first + face - first}, {2, top.first + last - 1, top.first + first - 1}}});
  m.friction = 0.3;
  return m;
}

double farthest(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0, size = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::fabs(a[i] - b[i])), size = std::max(size, std::fabs(a[i]));
  return size > 0 ? most / size : 0;
}

void against_dense(bool large) {
  for (int32_t nodes : {500, 1000, 2000, 4000}) {
    if (nodes > 2000 && !large) continue;
    const many::Model m = pressed(nodes);
    const Outcome dense = run(m, C2D_ELIMINATION_DENSE, 0), own = compressed(m);
    const std::string key = "compressed." + std::to_string(nodes);
    const double ratio = own.seconds / dense.seconds, apart = farthest(dense.pressure, own.pressure);
    row(key + ".time", own.seconds, "s", "dense " + std::to_string(dense.seconds));
    row(key + ".over_dense", ratio, "", nodes == 2000 ? judged(key + ".ratio", ratio, "<=", 1.5, "") : "");
    row(key + ".pressures", apart, "",
        std::string(dense.status == own.status ? "same statuses" : "OTHER STATUSES") + ", " +
            judged(key + ".apart", apart, "<=", 1e-9, ""));
  }
}

// By the clock, as it waits for the files.
void streamed(const many::Model& m, const std::string& key, const Outcome& in_memory, const std::string& folder) {
  const auto start = std::chrono::steady_clock::now();
  const Outcome own = run(m, C2D_ELIMINATION_COMPRESSED, 0, folder + "/streamed");
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const double ratio = seconds / in_memory.seconds;
  row(key + ".streamed", seconds, "s", "in 256 MiB and files");
  row(key + ".streamed_memory", own.megabytes, "MB");
  row(key + ".over_in_memory", ratio, "", judged(key + ".streamed_ratio", ratio, "<=", 2, ""));
}

void growth(bool large, const std::string& folder) {
  std::vector<double> sizes, times;
  for (int32_t nodes : {10000, 30000, 100000}) {
    if (nodes > 10000 && !large) continue;
    const many::Model m = pressed(nodes);
    const Outcome own = compressed(m, 400);
    const std::string key = "compressed." + std::to_string(nodes);
    const double seconds = nodes == 10000    ? 10
                           : nodes == 100000 ? 150
                                             : 0,
                 memory = nodes == 10000    ? 300
                          : nodes == 100000 ? 2500
                                            : 0;
    row(key + ".time", own.seconds, "s", judged(key + ".seconds", own.seconds, "<=", seconds, ""));
    row(key + ".memory", own.megabytes, "MB", judged(key + ".megabytes", own.megabytes, "<=", memory, ""));
    row(key + ".inside", own.inside, "s", "400 x 400 points in the lower block");
    row(key + ".residual", own.residual, "", "a step of refinement would change " + std::to_string(own.error * 1e12) + "e-12");
    streamed(m, key, own, folder);
    sizes.push_back(nodes), times.push_back(own.seconds);
  }
  if (sizes.size() > 1) {
    const double power = exponent(sizes, times);
    row("compressed.growth", power, "", judged("compressed.exponent", power, "<=", 1.15, ""));
  }
}

// ---- a rough face -----------------------------------------------------------------------------------------------------

// With all of the contact system, and on demand.
void rough_faces(bool large) {
  for (int32_t pairs : {1000, 2000, 4000, 10000}) {
    if (pairs > 2000 && !large) continue;
    const std::string key = "rough." + std::to_string(pairs);
    const bool asked = pairs == 10000;
    many::Model m = many::rough(pairs);
    const Outcome whole = asked ? Outcome{} : run(m, C2D_ELIMINATION_DENSE, 0);
    m.touching = pairs / 5;
    const Outcome own = run(m, C2D_ELIMINATION_COMPRESSED, 0);
    const auto touch = std::count_if(own.status.begin(), own.status.end(), [](double s) { return s != C2D_OPEN; });
    row(key + ".time", own.seconds, "s",
        std::to_string(touch) + " touch" + (asked ? ", " + judged(key + ".seconds", own.seconds, "<=", 60, "") : ""));
    row(key + ".memory", own.megabytes, "MB", asked ? judged(key + ".megabytes", own.megabytes, "<=", 1500, "") : "");
    if (asked) continue;
    row(key + ".whole.time", whole.seconds, "s");
    row(key + ".whole.memory", whole.megabytes, "MB");
    const double apart = farthest(whole.pressure, own.pressure);
    row(key + ".pressures", apart, "",
        std::string(whole.status == own.status ? "same statuses" : "OTHER STATUSES") + ", " +
            judged(key + ".apart", apart, "<=", 1e-9, ""));
  }
}

// ---- one body ---------------------------------------------------------------------------------------------------------

// From (x0, y0), left out (x1, y1): equal elements, or elements that grow from both ends, the first so long.
void straight(Curve& c, double x0, double y0, double x1, double y1, int count, double smallest = 0) {
  std::vector<double> s;
  if (smallest > 0) {
    std::vector<double> half;
    for (double at = smallest; at < 0.5; at *= 1.3) half.push_back(at);
    s.push_back(0);
    s.insert(s.end(), half.begin(), half.end());
    for (size_t k = half.size(); k-- > 0;) s.push_back(1 - half[k]);
  } else {
    for (int i = 0; i < count; ++i) s.push_back(static_cast<double>(i) / count);
  }
  for (double at : s) c.insert(c.end(), {x0 + (x1 - x0) * at, y0 + (y1 - y0) * at});
}
Curve box(double width, double height, int along, int across, double smallest = 0) {
  Curve c;
  straight(c, 0, 0, width, 0, along, smallest), straight(c, width, 0, width, height, across, smallest);
  straight(c, width, height, 0, height, along, smallest), straight(c, 0, height, 0, 0, across, smallest);
  return c;
}
Curve circle(double x, double y, double radius, int count, double turn) {
  Curve c;
  for (int i = 0; i < count; ++i) {
    const double angle = turn * 2 * kPi * i / count;
    c.insert(c.end(), {x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  return c;
}

// Held at its first elements, pulled at others on the far side of its first curve.
many::Model held(const std::vector<Curve>& curves) {
  many::Model m;
  many::Body body = body_of(curves);
  const int32_t count = static_cast<int32_t>(curves[0].size() / 2), some = std::max(1, count / 12);
  body.sides = {{1, some}, {count / 2 + 1, count / 2 + some}};
  m.add(body);
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(1, 2, many::end_of(many::kPulled, 0.3, 1));
  return m;
}

void awkward(bool large) {
  const int n = large ? 4 : 1;
  std::vector<Curve> plate = {box(5, 4, 500 * n, 400 * n)};
  for (int h = 0; h < 20; ++h) plate.push_back(circle(0.5 + h % 5, 0.5 + h / 5, 0.3, 100 * n, -1));
  const std::pair<const char*, many::Model> bodies[] = {
      {"graded", held({box(1, 1, 0, 0, 1e-6)})},
      {"square", held({box(1, 1, 1000 * n, 1000 * n)})},
      {"layer", held({box(1, 0.001, 1000 * n, 1)})},
      {"ring", held({circle(0, 0, 1, 2000 * n, 1), circle(0, 0, 0.7, 1500 * n, -1)})},
      {"holes", held(plate)},
  };
  for (const auto& [name, m] : bodies) {
    const Outcome own = compressed(m);
    const std::string key = std::string("compressed.") + name;
    row(key + ".time", own.seconds, "s");
    row(key + ".residual", own.residual, "", judged(key + ".left", own.residual, "<=", 1e-10, ""));
  }
}

// ---- beside others ----------------------------------------------------------------------------------------------------

// A disc, half of it held, the other half pulled: the problem of write_boundary_matrix.
many::Model half_held(int32_t nodes) {
  many::Model m;
  many::Body body = body_of({circle(0, 0, 1, nodes, 1)});
  body.sides = {{1, nodes / 2}, {nodes / 2 + 1, nodes}};
  m.add(body);
  m.set(1, 1, many::end_of(many::kHeld));
  m.set(1, 2, many::end_of(many::kPulled, 0.3, 1));
  return m;
}

struct Other {
  std::string name, absent;
  std::vector<std::string> words;
};

// Whole runs, in which every entry is integrated, beside the algebra alone of others on that matrix.
void beside_others(const Options& options) {
  const std::string hmat = options.folder + "/rival_hmat", lapack = options.folder + "/rival_lapack";
  const Other others[] = {
      {"openblas", options.openblas.empty() ? "OpenBLAS is not installed" : "", {lapack, options.openblas}},
      {"hmat", is_program(hmat) ? "" : "HMAT-OSS was not installed when this was built", {hmat, "1e-10"}},
  };
  const std::string file = "/tmp/contact2d-bench-disc-" + std::to_string(getpid());
  for (int32_t nodes : {1000, 2000, 4000}) {
    if (nodes > 2000 && !options.large) continue;
    const std::string key = "beside." + std::to_string(nodes) + ".";
    const Outcome own = compressed(half_held(nodes));
    row(key + "own", own.seconds, "s", "all of the run, " + std::to_string(static_cast<int>(own.megabytes)) + " MB");
    write_boundary_matrix(file, nodes);
    for (const Other& other : others) {
      if (!other.absent.empty()) {
        note(key + other.name, other.absent);
        continue;
      }
      Child child(other.words, {"OPENBLAS_NUM_THREADS=1", "OMP_NUM_THREADS=1"});
      const Answer time = ask(child, "time", "file:" + file, 2 * nodes),
                   left = ask(child, "residual", "file:" + file, 2 * nodes);
      if (!time.ok || !left.ok) {
        note(key + other.name, "has failed");
        continue;
      }
      char residual[48];
      std::snprintf(residual, sizeof residual, "scaled residual %.1e", left.residual);
      row(key + other.name, time.processor, "s", times(time.processor / own.seconds) + " of ours, " + residual);
    }
    unlink(file.c_str());
  }
}

} // namespace

void compressed_elimination(const Options& options) {
  heading("Compressed elimination: two blocks that touch in at most 200 pairs, whole runs");
  against_dense(options.large);
  growth(options.large, options.folder);
  heading("Compressed elimination of a disc, whole runs, beside the algebra of others on its matrix: a dense elimination, and "
          "hierarchical matrices to 1e-10");
  beside_others(options);
  heading("Compressed elimination: what is left of the equations of awkward bodies");
  awkward(options.large);
  heading("A rough face on a flat one: candidate pairs of which few touch, whole runs");
  rough_faces(options.large);
}

} // namespace bench
