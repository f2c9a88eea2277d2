#pragma once
// Bodies that lie inside each other where no zone is between them: contact is looked for in zones alone.
#include "memory/text.hpp"
#include "model/model.hpp"
#include "model/validate/validate.hpp"

namespace c2d {

struct BodyOverlap {
  int body[2];
  double depth; // of a boundary point of the first inside the second; 0: there is none
  double x, y;  // that point
};
// Where an element begins: as it was made, or moved.
using ElementStart = void (*)(const void* context, const Model& m, int b, int32_t element, double p[2]);
void start_as_made(const void* context, const Model& m, int b, int32_t element, double p[2]);

// The deepest, of points that are in no zone between the two bodies and deeper than `part` of their element and `of_body` of
// the smaller body; of bodies without such a zone alone, or of all.
BodyOverlap deepest_overlap(const Model& m, ElementStart start, const void* context, double part, double of_body,
                            bool without_zone_alone);

// "bodies 1 and 2 overlap by 0.5 at (1, 2), where no zone is between them: ..."
Text& put_overlap(Text& text, const Model& m, const BodyOverlap& overlap);
// Warning: C2D_WARN_OVERLAPPING, of the bodies as they are made.
void warn_overlapping_bodies(const Model& m, Reporter& reporter);

} // namespace c2d
