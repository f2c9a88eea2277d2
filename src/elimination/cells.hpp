#pragma once
// A binary tree over the nodes of a body: cells that are halved until none has more than so many nodes (METHOD 7.6).
#include <stdint.h>

namespace c2d {

// All leaves are at the same depth; at depth d there are 2^d cells, numbered from 0, cell i of depth d holding 2 i and 2 i + 1
// of depth d + 1. Cells of a depth differ by one node at most.
int32_t tree_depth(int32_t nodes, int32_t leaf);
// Where leaf i begins in the order, i = 0 ... 2^depth.
int32_t leaf_begin(int32_t nodes, int32_t depth, int32_t leaf);

// Brings nodes, which come as the contour runs, into the order of the leaves. A cell is halved along the contour or across its
// longer side or its shorter one, whichever leaves the halves least near to each other: where a contour comes back close to
// itself, as in a thin layer, only a cut across both parts leaves blocks of low rank. point[2 node]; room [nodes].
void order_nodes(const double* point, int32_t nodes, int32_t depth, int32_t* order, int32_t* room);

} // namespace c2d
