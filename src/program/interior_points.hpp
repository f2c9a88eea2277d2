// The points inside at which a run gives results: those of a file, or the deck's own under *POINTS.
#pragma once

#include "post/summary.hpp"
#include "program/files/points_file.hpp"
#include "report/interior.hpp"
#include "report/stresses.hpp"

#include <contact2d.h>

#include <string>

namespace app {

class InteriorPoints {
public:
  InteriorPoints() : file_messages_(file_) {}
  InteriorPoints(const InteriorPoints&) = delete;
  InteriorPoints& operator=(const InteriorPoints&) = delete;

  // Reads the CSV `name` unless already read; false if it cannot be read or has faults. All faults are reported.
  bool load(const std::string& name);
  bool read_file(const std::string& name, int32_t bodies);
  // The same of its text.
  bool take_text(const std::string& text, int32_t bodies);
  const std::string& file_text() const { return file_.text(); }
  // The deck's points, unless a file was read. False with `error`: there are too many.
  bool take_sets(c2d_solver* solver, std::string& error);
  // A grid over each body. Returns the status of the first call that failed.
  c2d_status take_bodies(c2d_solver* solver, const Summary& summary);
  bool any() const { return !wanted_.empty(); }

  // Results of all points at the load reached. Returns the status of the first call that failed.
  c2d_status evaluate(c2d_solver* solver, int32_t bodies);
  const Interior& results() const { return results_; }
  // Their stresses at the state of a run's step, and where they are; added to both.
  c2d_status add_stresses(c2d_solver* solver, int32_t bodies, std::vector<double>& out);
  void add_places(std::vector<StressPlace>& out) const;
  // Reports points outside (a warning each, up to a limit), on the boundary and near a node; `deck` gets the
  // messages on points of the deck. Warnings that did not go there are added to `warnings`.
  void report_places(Messages& deck, const Summary& summary, std::vector<c2d_error>& warnings);

private:
  struct GridAt {
    size_t first; // of the points wanted
    size_t columns, rows;
  };
  // Of each result: which of the points wanted; if it is outside its body, the body it lies in, or 0.
  struct Source {
    size_t wanted;
    bool of_grid;
    int32_t other;
  };
  void take_set(const c2d_points& set);
  c2d_status compute(c2d_solver* solver, int32_t bodies, std::vector<double>& values) const;
  c2d_status find_others(c2d_solver* solver, int32_t bodies);
  void keep(const std::vector<double>& values);
  bool is_gridded(size_t i, size_t& grid) const;

  DeckFile file_;
  Messages file_messages_;
  bool from_file_ = false, loaded_ = false;
  std::vector<WantedPoint> wanted_;
  std::vector<GridAt> grids_; // their points stand one after another
  std::vector<Source> source_;
  Interior results_;
};

} // namespace app
