#include "program/files/path_record.hpp"

#include "program/commands/archive.hpp"
#include "program/commands/archive_quantity.hpp"

#include <complex>

template <class Archive, size_t size> void characters(Archive& a, char (&text)[size]) {
  std::string words(text, ::strnlen(text, size));
  a(words);
  std::memset(text, 0, size);
  std::memcpy(text, words.data(), words.size() < size ? words.size() : size - 1);
}
template <class Archive> void members(Archive& a, c2d_error& e) {
  a(e.status), a(e.severity), a(e.host_code), a(e.line), a(e.column), a(e.column_end);
  a(e.body), a(e.zone), a(e.pair), a(e.element), a(e.node), a(e.tape), a(e.block), a(e.bytes_needed), a(e.load);
  characters(a, e.text);
  e.struct_size = sizeof e;
}
template <class Archive> void members(Archive& a, c2d_zone_state& z) {
  a(z.open), a(z.stick), a(z.slip), a(z.near_change), a(z.force), a(z.moment), a(z.approach), a(z.shift);
  a(z.largest_pressure), a(z.largest_friction), a(z.length), a(z.dissipated);
  z.struct_size = sizeof z;
}
template <class Archive> void members(Archive& a, c2d_body_state& b) {
  a(b.is_rigid), a(b.contact), a(b.motion), a(b.point), a(b.load);
  b.struct_size = sizeof b;
}

namespace app {

template <class Archive> void members(Archive& a, Complex& c) {
  double parts[2] = {c.real(), c.imag()};
  a(parts);
  c = Complex(parts[0], parts[1]);
}
template <class Archive> void members(Archive& a, StressIntensity& s) { a(s.zone), a(s.at), a(s.K1), a(s.K2), a(s.why); }
template <class Archive> void members(Archive& a, CornerState& c) {
  a(c.kind), a(c.zone), a(c.body), a(c.at);
  std::string joint = c.joint;
  a(joint);
  for (const char* known : {"", "stick", "slip", "tied", "open", "free", "held"})
    if (joint == known) c.joint = known;
  a(c.exponents), a(c.K), a(c.K2), a(c.K_error), a(c.K2_error), a(c.why);
}
template <class Archive> void members(Archive& a, StepRecord& s) {
  a(s.step), a(s.corners), a(s.work), a(s.dissipated), a(s.elastic), a(s.defect), a(s.loads), a(s.work_by_case);
  a(s.zones), a(s.bodies), a(s.cracks), a(s.quantities), a(s.stresses);
}
template <class Archive> void members(Archive& a, ZoneCycle& z) {
  a(z.touched), a(z.stuck), a(z.slipped), a(z.walk), a(z.slip_range);
}
template <class Archive> void members(Archive& a, CycleSeen& c) {
  a(c.result), a(c.cycles), a(c.extrapolations), a(c.stuck), a(c.slipped), a(c.range_pair), a(c.walk_pair);
  a(c.change), a(c.dissipated), a(c.slip_range), a(c.walk), a(c.elastic), a(c.zones);
}
template <class Archive> void members(Archive& a, CoefficientRecord& c) {
  a(c.mu), a(c.load), a(c.loads), a(c.step), a(c.changes), a(c.outcome), a(c.singular), a(c.why), a(c.body), a(c.pair);
  a(c.table), a(c.steps), a(c.cycles), a(c.cycle_start), a(c.slip), a(c.slip_at_turn);
}
template <class Archive> void members(Archive& a, ZonePoint& p) { a(p.shift), a(p.tn), a(p.tt), a(p.mean); }
template <class Archive> void members(Archive& a, FollowedZone& z) { a(z.pair), a(z.touched); }
template <class Archive> void members(Archive& a, PathPoint& p) {
  a(p.step), a(p.kind), a(p.load), a(p.travel), a(p.peak), a(p.count), a(p.events), a(p.status), a(p.zones);
}
template <class Archive> void members(Archive& a, Snapshot& s) {
  a(s.step), a(s.is_quarter), a(s.load), a(s.loads), a(s.table);
}
template <class Archive> void members(Archive& a, EnergyPoint& e) {
  a(e.travel), a(e.load), a(e.work), a(e.dissipated), a(e.elastic), a(e.defect);
}
template <class Archive> void members(Archive& a, CoefficientHistory& h) {
  a(h.mu), a(h.points), a(h.loads), a(h.frames), a(h.reversals), a(h.last), a(h.before), a(h.energy), a(h.cycle), a(h.followed);
}
template <class Archive> void members(Archive& a, History& h) { h.archive(a); }
template <class Archive> void members(Archive& a, Trace::State& s) { a(s.status), a(s.side); }
template <class Archive> void members(Archive& a, Trace& t) { t.archive(a); }
template <class Archive> void members(Archive& a, PathRecord& p) {
  a(p.coefficients), a(p.history), a(p.trace), a(p.coefficient_shown), a(p.warnings), a(p.latest), a(p.outputs);
}

namespace {

// Tables are indexed by the numbers of the model.
struct Sizes {
  size_t pairs, zones, bodies, cases;
  template <class List> static bool is(const List& list, size_t size) { return list.empty() || list.size() == size; }
  bool fit(const StepRecord& s) const {
    return s.loads.size() == cases && s.work_by_case.size() == cases && is(s.zones, zones) && is(s.bodies, bodies);
  }
  bool fit(const CoefficientRecord& c) const {
    bool all = is(c.table, pairs * C2D_PAIR_FIELDS) && is(c.slip, pairs) && is(c.slip_at_turn, pairs) && is(c.loads, cases);
    for (const StepRecord& s : c.steps) all = all && fit(s);
    for (const StepRecord& s : c.cycle_start) all = all && fit(s);
    for (const CycleSeen& one : c.cycles) all = all && one.zones.size() == zones;
    return all;
  }
  bool fit(const CoefficientHistory& h) const {
    bool all = is(h.loads, cases) && is(h.followed, zones) && (h.cycle == 0 || h.cycle < h.points.size());
    for (const FollowedZone& zone : h.followed) {
      all = all && zone.pair < static_cast<int64_t>(pairs);
      for (const int32_t p : zone.touched) all = all && p >= 0 && p < static_cast<int64_t>(pairs);
    }
    for (const PathPoint& p : h.points) all = all && is(p.status, pairs) && is(p.zones, zones);
    const auto fits = [this](const Snapshot& s) { return is(s.table, pairs * C2D_PAIR_FIELDS) && is(s.loads, cases); };
    for (const Snapshot& s : h.frames) all = all && fits(s);
    for (const Snapshot& s : h.reversals) all = all && fits(s);
    return all && fits(h.last) && fits(h.before);
  }
};

} // namespace

std::string text_of(PathRecord& record) {
  ArchiveWriter writer;
  writer(record);
  return writer.take();
}

bool read_path_record(const std::string& text, const Summary& model, PathRecord& out) {
  ArchiveReader reader(text);
  reader(out);
  const auto count = [](int32_t number) { return static_cast<size_t>(number); };
  const Sizes sizes{count(model.pairs), count(model.zones), count(model.bodies), count(model.load_cases)};
  bool all = reader.is_sound_to_the_end();
  for (const CoefficientRecord& c : out.coefficients) all = all && sizes.fit(c);
  for (const CoefficientHistory& h : out.history.coefficients()) all = all && sizes.fit(h);
  return all;
}

} // namespace app
