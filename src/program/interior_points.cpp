#include "program/interior_points.hpp"

#include "report/text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace app {
namespace {

constexpr size_t kMostPoints = 10000000;
constexpr size_t kTogether = 4096; // in one call of the library
constexpr int64_t kMostTold = 20;  // points outside, one by one
constexpr double kAlongBody = 40;  // spacings of the grid over a body along its longer side

std::string place_text(const InteriorPoint& p) {
  std::string out = "point (";
  append_number(out, p.x);
  out += ", ";
  append_number(out, p.y);
  return out + ")";
}

c2d_error warning(int32_t line, int32_t body, const std::string& text) {
  c2d_error out = C2D_INIT(c2d_error);
  out.severity = C2D_WARNING;
  out.line = line;
  out.body = body;
  std::snprintf(out.text, sizeof out.text, "%s", text.c_str());
  return out;
}

c2d_points mirrored_set(const Summary& s, c2d_points set, int32_t image) {
  for (int c = 0; c < 2; ++c) {
    if ((image >> c & 1) == 0) continue;
    const double from = set.from[c];
    set.from[c] = 2.0 * s.symmetry_at[c] - set.to[c];
    set.to[c] = 2.0 * s.symmetry_at[c] - from;
  }
  return set;
}

} // namespace

bool InteriorPoints::load(const std::string& name) {
  c2d_error fault = C2D_INIT(c2d_error);
  from_file_ = true;
  loaded_ = loaded_ || file_.read_named(name, fault);
  if (!loaded_) file_messages_.fault(fault);
  return loaded_;
}

bool InteriorPoints::read_file(const std::string& name, int32_t bodies) {
  return load(name) && read_points(file_, bodies, file_messages_, wanted_);
}

bool InteriorPoints::take_text(const std::string& text, int32_t bodies) {
  from_file_ = true;
  file_.call("points");
  file_.replace(text);
  return read_points(file_, bodies, file_messages_, wanted_);
}

void InteriorPoints::take_set(const c2d_points& set) {
  const size_t columns = static_cast<size_t>(set.count[0]), rows = static_cast<size_t>(set.count[1]);
  if (set.kind == C2D_POINTS_GRID) grids_.push_back({wanted_.size(), columns, rows});
  std::vector<double> xy(2 * columns * rows);
  c2d_expand_points(&set, 1, static_cast<int32_t>(columns * rows), xy.data(), 2, nullptr);
  for (size_t k = 0; k < xy.size(); k += 2) wanted_.push_back({set.body, xy[k], xy[k + 1], set.line});
}

bool InteriorPoints::take_sets(c2d_solver* solver, std::string& error) {
  c2d_summary summary = C2D_INIT(c2d_summary);
  c2d_status status = c2d_get_summary(solver, &summary);
  for (int32_t i = 1; status == C2D_OK && !from_file_ && i <= summary.point_sets; ++i) {
    c2d_points set = C2D_INIT(c2d_points);
    status = c2d_get_points(solver, i, &set);
    if (status != C2D_OK) break;
    if (static_cast<size_t>(set.count[0]) * static_cast<size_t>(set.count[1]) > kMostPoints - wanted_.size())
      return error = "more than " + std::to_string(kMostPoints) + " points under *POINTS", false;
    take_set(set);
  }
  if (status != C2D_OK) error = c2d_message(status);
  return error.empty();
}

// A body that meets a line of symmetry is looked at whole; of one that does not the image is a body of its own. Of bodies of
// revolution the half section is looked at.
c2d_status InteriorPoints::take_bodies(c2d_solver* solver, const Summary& s) {
  for (int32_t body = 1; body <= s.bodies; ++body) {
    if (s.is_platen(body)) continue;
    c2d_points set = C2D_INIT(c2d_points);
    set.kind = C2D_POINTS_GRID;
    set.body = body;
    double size[2];
    int32_t apart = 0;
    for (int c = 0; c < 2; ++c) {
      std::vector<double> at(static_cast<size_t>(s.body[body - 1].points));
      const c2d_status status =
          c2d_get(solver, c == 0 ? C2D_NODE_X : C2D_NODE_Y, body, 1, s.body[body - 1].points, at.data(), 1);
      if (status != C2D_OK) return status;
      const auto ends = std::minmax_element(at.begin(), at.end());
      const double line = s.symmetry_at[c];
      const bool mirrored = (mirror_lines(s) >> c & 1) != 0, meets = *ends.first <= line && line <= *ends.second;
      set.from[c] = mirrored && meets ? std::min(*ends.first, 2.0 * line - *ends.second) : *ends.first;
      set.to[c] = mirrored && meets ? std::max(*ends.second, 2.0 * line - *ends.first) : *ends.second;
      if (mirrored && !meets) apart |= 1 << c;
      size[c] = set.to[c] - set.from[c];
    }
    const double spacing = std::max(size[0], size[1]) / kAlongBody;
    for (int c = 0; c < 2; ++c) set.count[c] = std::max(2, static_cast<int32_t>(std::lround(size[c] / spacing)) + 1);
    for (int32_t image = 0; image <= apart; ++image)
      if ((image & ~apart) == 0) take_set(mirrored_set(s, set, image));
  }
  return C2D_OK;
}

// C2D_POINT_FIELDS values of each requested point.
c2d_status InteriorPoints::compute(c2d_solver* solver, int32_t bodies, std::vector<double>& values) const {
  std::vector<double> xy, part;
  values.assign(wanted_.size() * C2D_POINT_FIELDS, 0.0);
  for (int32_t body = 1; body <= bodies; ++body)
    for (size_t at = 0; at < wanted_.size();) {
      std::vector<size_t> chosen;
      for (; at < wanted_.size() && chosen.size() < kTogether; ++at)
        if (wanted_[at].body == body) chosen.push_back(at);
      xy.clear();
      for (const size_t i : chosen) xy.insert(xy.end(), {wanted_[i].x, wanted_[i].y});
      part.assign(chosen.size() * C2D_POINT_FIELDS, 0.0);
      const c2d_status status =
          c2d_interior(solver, body, static_cast<int32_t>(chosen.size()), xy.data(), 2, part.data(), C2D_POINT_FIELDS);
      if (status != C2D_OK) return status;
      for (size_t k = 0; k < part.size(); ++k)
        values[chosen[k / C2D_POINT_FIELDS] * C2D_POINT_FIELDS + k % C2D_POINT_FIELDS] = part[k];
    }
  return C2D_OK;
}

c2d_status InteriorPoints::evaluate(c2d_solver* solver, int32_t bodies) {
  std::vector<double> values;
  if (const c2d_status status = compute(solver, bodies, values); status != C2D_OK) return status;
  keep(values);
  return find_others(solver, bodies);
}

c2d_status InteriorPoints::add_stresses(c2d_solver* solver, int32_t bodies, std::vector<double>& out) {
  std::vector<double> values;
  const c2d_status status = compute(solver, bodies, values);
  for (size_t i = 0; i < wanted_.size() && status == C2D_OK; ++i) add_point_stresses(&values[i * C2D_POINT_FIELDS], out);
  return status;
}

void InteriorPoints::add_places(std::vector<StressPlace>& out) const {
  size_t grid = 0;
  for (size_t i = 0; i < wanted_.size(); ++i) {
    const WantedPoint& p = wanted_[i];
    out.push_back({p.body, 0, static_cast<int32_t>(i) + 1, p.x, p.y, is_gridded(i, grid)});
  }
}

// `grid`: 0 at first, as i rises from 0.
bool InteriorPoints::is_gridded(size_t i, size_t& grid) const {
  while (grid < grids_.size() && i >= grids_[grid].first + grids_[grid].columns * grids_[grid].rows) ++grid;
  return grid < grids_.size() && i >= grids_[grid].first;
}

// A wrong body number is the likeliest reason for a point outside: finds the body that contains each point to be
// reported.
c2d_status InteriorPoints::find_others(c2d_solver* solver, int32_t bodies) {
  int64_t reported = 0;
  for (size_t i = 0; i < source_.size(); ++i) {
    const InteriorPoint& p = results_.points[i];
    if (flag_of(p) != C2D_POINT_OUTSIDE || ++reported > kMostTold) continue;
    double row[C2D_POINT_FIELDS];
    const double place[2] = {p.x, p.y};
    for (int32_t body = 1; body <= bodies && source_[i].other == 0; ++body) {
      if (body == p.body) continue;
      const c2d_status status = c2d_interior(solver, body, 1, place, 2, row, C2D_POINT_FIELDS);
      if (status != C2D_OK) return status;
      if (static_cast<int>(row[C2D_POINT_FLAG]) != C2D_POINT_OUTSIDE) source_[i].other = body;
    }
  }
  return C2D_OK;
}

void InteriorPoints::keep(const std::vector<double>& values) {
  std::vector<int64_t> at(wanted_.size(), -1);
  size_t grid = 0;
  for (size_t i = 0; i < wanted_.size(); ++i) {
    InteriorPoint p{wanted_[i].body, wanted_[i].x, wanted_[i].y, {}};
    for (size_t c = 0; c < C2D_POINT_FIELDS; ++c) p.values[c] = values[i * C2D_POINT_FIELDS + c];
    const bool gridded = is_gridded(i, grid);
    const int flag = flag_of(p);
    if (gridded && flag == C2D_POINT_OUTSIDE) {
      ++results_.clipped;
      continue;
    }
    at[i] = static_cast<int64_t>(results_.points.size());
    ++results_.count[flag];
    results_.points.push_back(p);
    source_.push_back({i, gridded, 0});
  }
  for (const GridAt& g : grids_) {
    const auto first = at.begin() + static_cast<ptrdiff_t>(g.first);
    results_.grids.push_back({wanted_[g.first].body, g.columns, g.rows,
                              std::vector<int64_t>(first, first + static_cast<ptrdiff_t>(g.columns * g.rows))});
  }
}

void InteriorPoints::report_places(Messages& deck, const Summary& summary, std::vector<c2d_error>& warnings) {
  Messages& messages = from_file_ ? file_messages_ : deck;
  const auto warn = [&](const c2d_error& entry) {
    Messages::log(&messages, &entry);
    warnings.push_back(entry);
  };
  int64_t outside = 0, on_boundary = 0, near_node = 0;
  for (size_t i = 0; i < results_.points.size(); ++i) {
    const InteriorPoint& p = results_.points[i];
    const int flag = flag_of(p);
    const bool listed = !source_[i].of_grid;
    on_boundary += listed && flag == C2D_POINT_BOUNDARY;
    near_node += listed && flag == C2D_POINT_NEAR_NODE;
    if (flag != C2D_POINT_OUTSIDE || ++outside > kMostTold) continue;
    std::string text = place_text(p) + " lies outside " + body_text(summary, p.body);
    if (source_[i].other > 0) text += ", but inside " + body_text(summary, source_[i].other);
    warn(warning(wanted_[source_[i].wanted].line, p.body, text));
  }
  if (outside > kMostTold) warn(warning(0, 0, std::to_string(outside - kMostTold) + " more points lie outside their body"));
  const auto count = [](int64_t n, const char* one, const char* many) { return std::to_string(n) + (n == 1 ? one : many); };
  if (on_boundary > 0)
    messages.note(count(on_boundary, " point lies", " points lie") +
                  " on the boundary: the stress there is the boundary stress");
  if (near_node > 0)
    messages.note(count(near_node, " point lies", " points lie") +
                  " so close to a node that the mesh limits the accuracy of the stress");
}

} // namespace app
