#pragma once
// Bodies that overlap outside any zone between them: contact is checked in zones only.
#include "memory/text.hpp"
#include "model/model.hpp"
#include "model/validate/validate.hpp"

namespace c2d {

struct BodyOverlap {
  int body[2];
  double depth; // of a boundary point of the first inside the second; 0: there is none
  double x, y;  // that point
};
// Position of the start of an element, undeformed or deformed.
using ElementStart = void (*)(const void* context, const Model& m, int b, int32_t element, double p[2]);
void start_as_made(const void* context, const Model& m, int b, int32_t element, double p[2]);

// The deepest overlap, at points outside zones between the two bodies and deeper than `part` of their element and `of_body` of
// the smaller body; of pairs of bodies without a common zone only, or of all.
BodyOverlap deepest_overlap(const Model& m, ElementStart start, const void* context, double part, double of_body,
                            bool without_zone_alone);

// Message: "bodies 1 and 2 overlap by 0.5 at (1, 2) outside any zone between them: ..."
Text& put_overlap(Text& text, const Model& m, const BodyOverlap& overlap);
// Warning: C2D_WARN_OVERLAPPING, for the undeformed bodies.
void warn_overlapping_bodies(const Model& m, Reporter& reporter);

} // namespace c2d
