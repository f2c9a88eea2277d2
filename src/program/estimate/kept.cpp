#include "program/estimate/kept.hpp"

#include "program/commands/archive.hpp"

namespace app {

template <class Archive> void members(Archive& a, MeshCurve& c) { a(c.body), a(c.closed), a(c.ends); }
template <class Archive> void members(Archive& a, Stated& s) {
  a(s.what), a(s.of), a(s.zone), a(s.body), a(s.item), a(s.value), a(s.error), a(s.scale), a(s.tolerance), a(s.at), a(s.along),
      a(s.images), a(s.endless), a(s.confirmed), a(s.apart), a(s.error_by_before), a(s.doubt), a(s.way), a(s.angle);
}
template <class Archive> void members(Archive& a, MeshRound& r) {
  a(r.elements), a(r.pairs), a(r.equations), a(r.seconds), a(r.pressure), a(r.energy), a(r.adapted), a(r.curves), a(r.stated);
}
template <class Archive> void members(Archive& a, ToleranceOf& t) { a(t.name), a(t.value), a(t.size), a(t.why); }
template <class Archive> void members(Archive& a, Influence& i) { a(i.derivative), a(i.why); }
template <class Archive> void members(Archive& a, Toleranced& t) { a(t.number), a(t.by); }
template <class Archive> void members(Archive& a, ToleranceTable& t) { a(t.parameters), a(t.numbers), a(t.why); }
template <class Archive> void members(Archive& a, FatigueLine& f) { a(f.what), a(f.body), a(f.along), a(f.points); }
template <class Archive> void members(Archive& a, TorsionPart& p) { a(p.name), a(p.body), a(p.is_loaded); }
template <class Archive> void members(Archive& a, TorsionContact& c) {
  a(c.name), a(c.tied), a(c.turns_through), a(c.start), a(c.start_at), a(c.through);
}
template <class Archive> void members(Archive& a, TorsionBorder& b) { a(b.contact), a(b.at); }
template <class Archive> void members(Archive& a, TorsionStep& s) {
  a(s.loads), a(s.angle), a(s.torque), a(s.carried), a(s.slipping);
}
template <class Archive> void members(Archive& a, TorsionTable& t) {
  a(t.cases), a(t.parts), a(t.contacts), a(t.steps), a(t.borders), a(t.residual), a(t.imbalance), a(t.ended), a(t.why);
}
template <class Archive> void members(Archive& a, MeshLoop& l) {
  a(l.rounds), a(l.taken), a(l.stated), a(l.stopped), a(l.fatigue), a(l.tolerances), a(l.torsion);
}

} // namespace app

namespace estimate {

std::string text_of(app::MeshLoop loop) {
  app::ArchiveWriter writer;
  writer(loop);
  return writer.take();
}

bool read_meshes(const std::string& text, app::MeshLoop& out) {
  app::ArchiveReader reader(text);
  reader(out);
  return reader.is_sound_to_the_end() && (out.rounds.empty() || out.taken < out.rounds.size());
}

} // namespace estimate
