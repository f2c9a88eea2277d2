#pragma once
// Binary tree of clusters over the nodes of a body, halved until none has more than a given number of nodes (METHOD 7.6).
#include <stdint.h>

namespace c2d {

// All leaves are at the same depth. Depth d has 2^d clusters, numbered from 0; cluster i of depth d consists of clusters 2 i
// and 2 i + 1 of depth d + 1. Clusters of a depth differ by one node at most.
int32_t tree_depth(int32_t nodes, int32_t leaf);
// Where leaf i begins in the order, i = 0 ... 2^depth.
int32_t leaf_begin(int32_t nodes, int32_t depth, int32_t leaf);

// Sorts nodes, which come in the order of the contour, into the order of the leaves. A cluster is halved along the contour or
// across its longer or shorter side, whichever leaves the halves least close to each other: where a contour returns close to
// itself, as in a thin layer, only a cut across both parts leaves blocks of low rank. point[2 node]; room [nodes].
void order_nodes(const double* point, int32_t nodes, int32_t depth, int32_t* order, int32_t* room);

} // namespace c2d
