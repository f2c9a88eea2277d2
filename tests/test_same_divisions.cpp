// The divisions of a mesh on a changed sketch: what has to correspond, and ends that face again what they faced.
#include "program/sketch/same_divisions.hpp"
#include "sketches.hpp"

#include <cmath>

using namespace sketch;
using namespace sketches;

namespace {

// Why the divisions of one sketch are none of another; empty if they are.
std::string refusal(const std::string& text, const std::string& other) {
  const Sketch s = sound(text), changed = sound(other);
  try {
    same_divisions(s, given_mesh(s), changed);
  } catch (const Fault& f) {
    return f.text;
  }
  return "";
}

const std::string kOpen = "body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline w close\n";
const std::string kBase = kOpen + "fix b.s\n", kLoaded = kBase + "pressure b.n 1\n";

std::string top(double x0, double x1, const std::string& material = "E 1 nu 0") {
  const std::string a = show(x0), b = show(x1);
  return "body c " + material + "\nfrom " + a + " 1\nline s to " + b + " 1\nline e to " + b + " 2\nline n to " + a +
         " 2\nline w close\n";
}

std::string ring(double outside, const std::string& contact) {
  return "body h E 1 nu 0\ncircle o centre 0 0 radius 3\nhole\ncircle i centre 0 0 radius 1\n" +
         std::string("body r E 1 nu 0\ncircle o centre 0 0 radius ") + show(outside) + "\nfix h.o\n" + contact;
}

} // namespace

TEST_CASE("same divisions: sketches that do not correspond are refused, with what differs") {
  const std::string curves = "the curves or the parts of body b that face another body differ",
                    loads = "the load cases, the conditions or the requested results differ",
                    outlines = "the outlines of body ", facing = "the facing parts differ";
  const std::string given = kBase + top(0, 1) + "contact b.n c.s\ntolerance off\n";
  const std::string two = kBase + top(0, 1), cases = kBase + "case p\npressure b.n 1\ncase q\npressure b.e 1\n";
  const std::string in_half = "symmetry x 0\nbody b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\n";
  const auto parted = [](double last) {
    return "body b E 1 nu 0\nfrom 0 0\nline s to 2 0\nline e to 2 1\nline n to " +
           std::string(last == 2 ? "1 1\nline n to " : "") + "0 1\nline w close\n" + top(1, 2) + "fix b.s\ncontact b.n c.s\n";
  };
  const std::string shim = kOpen +
                           "body m E 1 nu 0\nfrom 0 1\nline s to 1 1\nline e to 1 1.01\nline n to 0 1.01\nline w close\n"
                           "body c E 1 nu 0\nfrom 0 1.01\nline s to 1 1.01\nline e to 1 2\nline n to 0 2\nline w close\n"
                           "fix b.s\nfix c.n\n";
  const struct {
    std::string one, other, told;
  } all[] = {
      {kLoaded, kBase + top(2, 3) + "fix c.s\npressure b.n 1\n", "the number of bodies differs"},
      {"body a E 1 nu 0\n" + kLoaded.substr(16, kLoaded.find("fix") - 16) + "fix a.s\n", kLoaded, outlines + "a differ"},
      {kBase + top(2, 3) + "fix c.s\n", kBase + top(2, 3, "rigid"), outlines + "c differ"},
      {kLoaded, kOpen + "hole\ncircle h centre 0.5 0.5 radius 0.2\nfix b.s\npressure b.n 1\n", outlines + "b differ"},
      {in_half + "fix b.s\n", "symmetry x -1\n" + kBase, "an outline of body b opens or closes"},
      {kLoaded,
       "body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0.5 1.5\nline w close\nfix b.s\npressure b.n 1\n",
       "none"},
      {kLoaded,
       "body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline r to 1 1\nline n to 0 1\nline w close\nfix b.s\npressure b.n 1\n",
       curves},
      {kLoaded,
       "body b E 1 nu 0\nfrom 0 0\nline s to 1 0\nline e to 1 1\nline n to 0 1\nline m to 0 0.5\nline w close\nfix b.s\n"
       "pressure b.n 1\n",
       curves},
      {two + "contact b.n c.s\n", kBase + top(0.2, 1) + "contact b.n c.s\n", curves}, // the top of b has a part that faces none
      {kBase + top(0.3, 1) + "contact b.n c.s\n", kBase + top(0, 0.7) + "contact b.n c.s\n", curves},
      {given + "elements b.n 7\nelements c.s 5\n", given + "elements b.n 7\nelements c.s 5\n", "none"},
      {parted(1.5), parted(2), curves}, // one curve, and two that have its name
      {shim + "contact b.n c.s\ncontact b.n m.s\n", shim + "contact b.n m.s\n", facing},
      {kBase + top(0, 1, "rigid") + "contact b.n c.s\n", kBase + top(0, 1, "rigid") + "contact c.s b.n\n", facing},
      {two + "tie b.n c.s\n", kBase + top(2, 3) + "fix c.s\n", curves},
      {two + "contact b.n c.s\nfix c.n\n", two + "contact c.s b.n\nfix c.n\n", curves}, // the sides exchange their places
      {cases + "history p 1; q 1\n", kLoaded, loads},
      {cases + "history p 1; q 1\n", cases + "history p 1; q 1, 2\n", loads},
      {kLoaded + "want stress b 0.5 0.5\n", kLoaded, loads},
      {kLoaded + "want approach at b 0.5 0.5 b 0.5 0.6\n", kLoaded + "want stress b 0.5 0.5\n", loads},
      {kLoaded, kLoaded + "pressure b.e 1\n", loads},
      {kBase + "pressure b.e 1\nplaten b.n fy -1\n", kBase + "pressure b.e 1\n", loads},
      {ring(0.9999, "contact h.i r.o\n"), ring(0.8, "contact h.i r.o\n"), "none"},
  };
  for (const auto& c : all) {
    CAPTURE(c.one);
    CAPTURE(c.other);
    CHECK(refusal(c.one, c.other) == (c.told == "none" ? "" : c.told + ", expected a change of numbers only"));
  }
}
