#include "program/estimate/trial_keeper.hpp"

#include "program/commands/archive.hpp"
#include "program/commands/archive_quantity.hpp"
#include "program/files/sealed_file.hpp"

namespace estimate {

template <class Archive> void members(Archive& a, Side& s) { a(s.body), a(s.first), a(s.last); }
template <class Archive> void members(Archive& a, Rubbing& r) {
  a(r.x), a(r.y), a(r.pressure), a(r.friction), a(r.slip), a(r.zone);
}
template <class Archive> void members(Archive& a, State& s) {
  a(s.turn), a(s.loads), a(s.ends), a(s.quantities), a(s.inside), a(s.rubbing), a(s.work), a(s.dissipated), a(s.elastic);
}
template <class Archive> void members(Archive& a, Trial& t) {
  a(t.nodes), a(t.lengths), a(t.stiffness), a(t.across), a(t.zones), a(t.tied), a(t.touched), a(t.states), a(t.cycle),
      a(t.outcome), a(t.why);
  a(t.elements), a(t.pairs), a(t.equations), a(t.seconds), a(t.work);
}

namespace {

const char kKind[] = "contact2d mesh 4";

} // namespace

void TrialKeeper::begin(const std::string& store_folder, const std::string& job, double seconds) {
  folder_ = store_folder;
  job_ = job;
  seconds_ = seconds;
}

bool TrialKeeper::recall(const std::string& deck, Trial& out) {
  ++number_;
  std::string text, ignored; // damaged files are ignored: the mesh is solved again, with the same result
  if (app::read_sealed(path(), kKind, text, ignored) != app::Sealed::kWhole) return false;
  app::ArchiveReader reader(text);
  std::string job, its_deck;
  reader(job), reader(its_deck), reader(out);
  if (reader.is_sound_to_the_end() && job == job_ && its_deck == deck) return true;
  out = Trial();
  return false;
}

bool TrialKeeper::keep(const std::string& deck, Trial& trial) {
  if (trial.seconds < seconds_) return true;
  app::ArchiveWriter writer;
  std::string of_deck = deck;
  writer(job_), writer(of_deck), writer(trial);
  return app::write_sealed(path(), kKind, writer.take(), error_);
}

} // namespace estimate
