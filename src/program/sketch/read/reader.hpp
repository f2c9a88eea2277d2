// The reader of statements; its functions are in several files, by topic.
#pragma once

#include "program/sketch/read/read.hpp"
#include "program/sketch/read/statement.hpp"

#include <set>

namespace sketch {

class Reader {
public:
  using File = std::function<bool(const std::string& name, std::string& text)>;
  Reader(const Parameters& given, const File& file, const Parameters& tolerances)
      : given_(given), given_tolerances_(tolerances), file_(file) {}
  void read(const std::string& text);
  static std::vector<std::string> words(); // first words of statements
  Reading take() { return {std::move(s_), std::move(faults_), std::move(used_)}; }

private:
  struct Keyword {
    const char* name;
    void (Reader::*read)(Statement&);
  };
  static const Keyword kKeywords[];
  bool applies(std::vector<Word>& words);
  void statement(Statement& s);
  void finish();

  // read.cpp
  void once(Statement& s, const std::string& what);
  void title(Statement& s);
  void units(Statement& s);
  void plane(Statement& s);
  void axisymmetric(Statement& s);
  void functions(Statement& s);
  void parameter(Statement& s);
  void tolerance_of_parameter(Statement& s, const std::string& name);
  void symmetry(Statement& s);

  // read_bodies.cpp
  void body(Statement& s);
  void outline(Statement& s);
  void hole(Statement& s);
  void from(Statement& s);
  void straight(Statement& s);
  void arc(Statement& s);
  void circle(Statement& s);
  void ellipse(Statement& s);
  void curve(Statement& s);
  void spline(Statement& s);
  void fillet(Statement& s) { ask_corner(s, true); }
  void chamfer(Statement& s) { ask_corner(s, false); }
  void mirror(Statement& s);
  void copy(Statement& s);
  void fatigue_constants(Statement& s, FatigueConstants& out);
  std::string new_body_name(Statement& s, const std::string& expected);
  void ask_corner(Statement& s, bool round);
  Body& current_body(Statement& s);
  Outline& current_outline(Statement& s);
  std::string curve_name(Statement& s);
  Point target(Statement& s);
  void draw(Statement& s, const std::string& name, ShapePtr shape);
  void draw_whole(Statement& s, const std::string& name, ShapePtr shape);
  void end_outline();
  void end_body();
  Motion motion(Statement& s);
  std::vector<Point> listed_points(Statement& s);
  std::vector<Point> points_of_file(Statement& s);

  // read_part.cpp
  void part_of(Statement& s);
  std::vector<Curve*> pieces_named(Statement& s, const std::string& name);
  void cut(Statement& s, const std::string& name, const std::string& of, double first, double last);

  // read_actions.cpp
  void contact(Statement& s) { interface(s, false); }
  void tie(Statement& s) { interface(s, true); }
  void interface(Statement& s, bool tied);
  void load_case(Statement& s);
  void fix(Statement& s);
  void move(Statement& s) { given(s, Condition::kDisplacement); }
  void traction(Statement& s) { given(s, Condition::kTraction); }
  void pressure(Statement& s);
  void force(Statement& s);
  void weight(Statement& s);
  void spin(Statement& s);
  void platen(Statement& s);
  void drive(Statement& s);
  void history(Statement& s);
  void pieces_of_history(Statement& s);
  void cycle(Statement& s);
  bool is_at(size_t piece, size_t other) const;
  void drop_piece(size_t piece);
  void interference(Statement& s);
  void turn(Statement& s, const std::optional<Side>& side, int body, bool is_traction, int load_case);
  int body_named(const Word& word) const;
  Side side(Statement& s, Condition::Part* part = nullptr);
  int curves_named(int body, const std::string& name) const;
  std::string names_of(int body) const;
  std::string names_of_cases() const;
  void given(Statement& s, Condition::Kind kind);
  BodyForce& body_force(Statement& s);
  void drive_of(Statement& s, Drive drive);
  bool components(Statement& s, Condition& c);
  std::vector<const char*> axes_of(const Statement& s) const;
  size_t force_axis(Statement& s, const std::optional<double> value[2]);
  Point force_vector(Statement& s);
  void field(Statement& s, Condition& c, size_t axis, const std::string& what);

  // read_moving.cpp
  void course(Statement& s, LoadCase& moving);
  void loads_of_course(Statement& s, Course& course);
  ShapePtr single_curve(Statement& s);
  static void check_place(Statement& s, const Course& course, double periods);

  // read_wants.cpp
  void steps(Statement& s);
  void stress(Statement& s);
  void want(Statement& s);
  void want_one(Statement& s);
  bool may_be_number(const Statement& s, size_t ahead = 0) const;
  void want_stress(Statement& s, Want want);
  void want_pair(Statement& s, Want want);
  void want_pressure_at(Statement& s, Want want);
  void want_points(Statement& s, Want want);
  void want_fatigue(Statement& s, Want want);
  void check_fatigue_constants(Statement& s, const Want& want);
  void tolerance(Statement& s);
  void limit(Statement& s);

  // elements.cpp
  void elements(Statement& s);
  void require(Statement& s);

  static constexpr const char* kTolerance = "+-";
  const Parameters& given_;
  const Parameters& given_tolerances_;
  std::set<std::string> once_; // statements allowed once that have been read
  std::set<std::string> used_; // names of parameters defined by statements
  const File& file_;
  Sketch s_;
  std::vector<Fault> faults_;

  // The outline that is being drawn.
  struct Corner { // a fillet or a chamfer before its second curve is read
    bool round;
    std::string name;
    double size;
    Place at;
  };
  bool in_body_ = false, in_outline_ = false, has_start_ = false;
  std::set<int> broken_bodies_; // bodies with missing curves
  bool is_lost_ = false;        // an unknown statement was read, perhaps one that begins a body
  bool broken_ = false;         // a curve of the outline could not be read: errors that follow from this are not reported
  Point start_, here_;
  std::optional<Corner> corner_;
  int case_ = 0;
};

} // namespace sketch
