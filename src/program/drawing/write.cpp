#include "program/drawing/write.hpp"

#include "program/drawing/examples.hpp"
#include "program/drawing/formats/names.hpp"
#include "report/text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

namespace drawing {
namespace {

std::string fixed(double value, int decimals) {
  char text[400];
  std::string out(text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr);
  if (out.find('.') != std::string::npos) out.erase(out.find_last_not_of('0') + 1);
  if (out.back() == '.') out.pop_back();
  return out == "-0" ? "0" : out;
}

std::string angle(double degrees) { return fixed(degrees, 12); }

class Writer {
public:
  Writer(Drawing& drawing, const Conditions& conditions) : d_(drawing), conditions_(conditions) {}
  std::string write(const std::string& name);

private:
  void line(const std::string& text) { out_ += text + "\n"; }
  void comment(const std::string& text);
  std::string number(double value) const;
  std::string at(Point p) const { return " " + number(p.x) + " " + number(p.y); }
  void give_names();
  void heading(const std::string& name);
  std::string material_of(const Body& body) const;
  void check_materials() const;
  void loop(const Loop& loop);
  void outline(const std::vector<Curve>& curves);
  void press_fits();
  void whole(const Curve& c);
  void curve(const Curve& c, bool last);
  std::string path_of(const Curve& c) const;
  void examples();

  Drawing& d_;
  const Conditions& conditions_;
  std::string out_;
  int decimals_ = 0;
  double doubt_ = 0; // of the splines
};

// Breaks long lines at blanks.
void Writer::comment(const std::string& text) {
  constexpr size_t kWidth = 110;
  std::string rest = text;
  while (rest.size() > kWidth) {
    const size_t blank = rest.rfind(' ', kWidth);
    if (blank == std::string::npos || blank < 2) break; // a word as long as that
    line("! " + rest.substr(0, blank));
    rest = "  " + rest.substr(blank + 1);
  }
  line("! " + rest);
}

// To 1e-13 of the drawing's size.
std::string Writer::number(double value) const { return decimals_ < 0 ? app::shortest(value) : fixed(value, decimals_); }

void Writer::give_names() {
  Names bodies, curves;
  for (const Body& body : d_.bodies) // names that are there go before numbers
    for (const Loop& loop : body.loops)
      for (const std::vector<Curve>* list : {&loop.curves, &loop.press_fit})
        for (const Curve& c : *list)
          if (!c.name.empty()) curves.name(c.name);
  for (Body& body : d_.bodies)
    if (!body.name.empty()) body.name = bodies.name(body.name);
  for (Body& body : d_.bodies) {
    if (body.name.empty()) body.name = bodies.numbered("body");
    Names own = curves; // numbers begin anew in every body
    for (Loop& loop : body.loops)
      for (Curve& c : loop.curves) c.name = c.name.empty() ? own.numbered("c") : curves.name(c.name);
    for (Loop& loop : body.loops)
      for (Curve& c : loop.press_fit) c.name = c.name.empty() ? own.numbered("c") : curves.name(c.name);
  }
  for (const Names* names : {&bodies, &curves})
    for (const std::string& change : names->changes()) d_.notes.push_back(change);
}

void Writer::heading(const std::string& name) {
  std::string title = name.substr(0, 60);
  for (char& c : title)
    if (std::string("(){}\"!;").find(c) != std::string::npos || static_cast<unsigned char>(c) < 0x20 ||
        static_cast<unsigned char>(c) >= 0x7f)
      c = '_';
  comment("Made from the drawing " + title + " (" + d_.kind + ").");
  for (const std::string& note : d_.notes) comment(note);
  if (!conditions_.given) {
    comment("To be filled in: the materials after 'body'; contacts, supports and loads at the end.");
  }
  if (!conditions_.has_title) line("title " + title);
  if (!conditions_.has_units)
    line(d_.unit.empty() ? "! units mm N  ! the drawing gives no unit of length"
                         : "units " + d_.unit + (d_.unit == "in" ? " lbf" : " N"));
  out_ += conditions_.head;
}

// Steel, until it is filled in.
std::string Writer::material_of(const Body& body) const {
  for (const Material& material : conditions_.materials)
    if (material.body == body.name) return material.text;
  const char* modulus = d_.unit == "m" ? "210e9" : d_.unit == "in" ? "30e6" : d_.unit == "um" ? "0.21" : "210e3";
  return std::string("E ") + modulus + " nu 0.3  ! fill in the material";
}

void Writer::check_materials() const {
  for (const Material& material : conditions_.materials) {
    std::string known;
    for (const Body& body : d_.bodies) known += (known.empty() ? "" : ", ") + body.name;
    if (std::none_of(d_.bodies.begin(), d_.bodies.end(), [&](const Body& b) { return b.name == material.body; }))
      throw Fault{material.line, "the drawing has no body '" + material.body + "', expected " + known};
  }
}

void Writer::whole(const Curve& c) {
  if (c.kind == Curve::kArc) return line("  circle " + c.name + " centre" + at(c.centre) + "  radius " + number(c.a));
  if (c.kind == Curve::kEllipse)
    return line("  ellipse " + c.name + " centre" + at(c.centre) + "  axes " + number(c.a) + " " + number(c.b) + "  tilt " +
                angle(c.tilt));
  line("  spline " + c.name + path_of(c) + "  closed");
}

std::string Writer::path_of(const Curve& c) const {
  std::string text = " through";
  for (size_t i = c.whole ? 0 : 1; i < c.points.size(); ++i) text += " " + at(c.points[i]);
  return text;
}

void Writer::curve(const Curve& c, bool last) {
  const std::string to = last ? " close" : " to" + at(c.end);
  if (c.kind == Curve::kLine) return line("  line " + c.name + to);
  if (c.kind == Curve::kSpline) return line("  spline " + c.name + path_of(c));
  if (c.kind == Curve::kEllipse)
    return line("  ellipse " + c.name + " centre" + at(c.centre) + "  axes " + number(c.a) + " " + number(c.b) + "  tilt " +
                angle(c.tilt) + "  from " + angle(c.from) + "  turn " + angle(c.sweep));
  // Ends that were moved to a joint may lie beside the circle: then the arc is given by its midpoint.
  const double off =
      std::max(std::fabs(sketch::length(c.begin - c.centre) - c.a), std::fabs(sketch::length(c.end - c.centre) - c.a));
  if (off > 1e-7 * c.a) return line("  arc " + c.name + to + "  through" + at(shape_of(c)->at(0.5)));
  line("  arc " + c.name + to + "  centre" + at(c.centre) + (c.sweep < 0 ? "  right" : ""));
}

void Writer::outline(const std::vector<Curve>& c) {
  if (c.size() == 1 && c[0].whole) return whole(c[0]);
  line("  from" + at(c[0].begin));
  for (size_t i = 0; i < c.size(); ++i) curve(c[i], i + 1 == c.size());
}

void Writer::loop(const Loop& loop) {
  if (loop.hole) line("  hole");
  outline(loop.curves);
  if (loop.press_fit.empty()) return;
  comment("In a press fit, instead of the outline above:");
  std::string before;
  before.swap(out_);
  outline(loop.press_fit);
  before.swap(out_);
  for (size_t at = 0; at < before.size(); at = before.find('\n', at) + 1)
    line("! " + before.substr(at, before.find('\n', at) - at));
}

// A side of a contact: the names of an outline, each once.
std::string side_of(const Body& body, const std::vector<Curve>& curves) {
  std::string out = body.name;
  std::set<std::string> names;
  for (const Curve& c : curves)
    if (names.insert(c.name).second) out += (names.size() == 1 ? "." : "+") + c.name;
  return out;
}

// What makes press fits of outlines that are one in the other.
void Writer::press_fits() {
  std::map<size_t, std::string> contacts;
  for (const bool hole : {true, false})
    for (const Body& body : d_.bodies)
      for (const Loop& l : body.loops)
        if (!l.press_fit.empty() && l.hole == hole) contacts[l.fit] += " " + side_of(body, l.press_fit);
  if (contacts.empty()) return;
  comment("In a press fit also:");
  line("! interference");
  for (const auto& contact : contacts) line("! contact" + contact.second + "  mu 0.3");
}

void Writer::examples() {
  if (conditions_.given) {
    out_ += conditions_.tail;
    return;
  }
  comment("Examples; remove the ! to use them:");
  for (const std::string& text : examples_for(d_.bodies)) comment(text);
}

std::string Writer::write(const std::string& name) {
  std::vector<Curve> all;
  for (const Body& body : d_.bodies)
    for (const Loop& loop : body.loops)
      for (const Curve& c : loop.curves) {
        all.push_back(c);
        doubt_ = std::max(doubt_, c.doubt);
      }
  const double size = size_of(all);
  decimals_ = size > 1e-6 && size < 1e12 ? std::max(0, 13 - static_cast<int>(std::ceil(std::log10(size)))) : -1;
  give_names();
  check_materials();
  if (std::any_of(all.begin(), all.end(), [](const Curve& c) { return c.kind == Curve::kSpline; }))
    d_.notes.push_back("splines interpolate points of the curves of the drawing" +
                       (doubt_ > 0 ? "; largest distance " + text_of(doubt_) : std::string()));
  std::string guessed;
  for (const Body& body : d_.bodies)
    for (const Loop& l : body.loops)
      for (const Curve& c : l.curves)
        if (c.guessed) guessed += (guessed.empty() ? "" : ", ") + body.name + "." + c.name;
  if (!guessed.empty())
    d_.notes.push_back("arcs through only three or four points, which may stand for other curves: " + guessed);
  heading(name);
  for (const Body& body : d_.bodies) {
    line("body " + body.name + " " + material_of(body));
    for (const Loop& l : body.loops) loop(l);
  }
  press_fits();
  examples();
  return out_;
}

} // namespace

std::string sketch_of(Drawing drawing, const std::string& name, const Conditions& conditions, std::vector<std::string>* notes) {
  std::string text = Writer(drawing, conditions).write(name);
  if (notes != nullptr) *notes = drawing.notes;
  return text;
}

} // namespace drawing
