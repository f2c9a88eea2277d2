// A plate with a round hole and a wavy top, without physical groups; `gmsh -1` writes its curves alone.
SetFactory("OpenCASCADE");
Point(1) = {0, 0, 0, 2}; Point(2) = {10, 0, 0, 2}; Point(3) = {10, 6, 0, 1}; Point(4) = {7, 7, 0, 1};
Point(5) = {3, 5, 0, 1}; Point(6) = {0, 6, 0, 1};
Line(1) = {1, 2}; Line(2) = {2, 3}; Spline(3) = {3, 4, 5, 6}; Line(4) = {6, 1};
Circle(5) = {5, 3, 0, 1.5, 0, 2 * Pi};
Characteristic Length {:} = 1.2;
Curve Loop(1) = {1, 2, 3, 4}; Curve Loop(2) = {5}; Plane Surface(1) = {1, 2};
