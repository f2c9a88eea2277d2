// A pad with rounded edges on a block: two bodies that touch along the pad's flat.
h = 12;
Point(1) = {-20, -15, 0, h}; Point(2) = {20, -15, 0, h}; Point(3) = {20, 0, 0, h}; Point(4) = {-20, 0, 0, h};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Point(11) = {-5, 0, 0, 1.5}; Point(12) = {5, 0, 0, 1.5}; Point(13) = {7, 2, 0, 1.5}; Point(14) = {7, 10, 0, h};
Point(15) = {-7, 10, 0, h}; Point(16) = {-7, 2, 0, 1.5}; Point(17) = {5, 2, 0, 1}; Point(18) = {-5, 2, 0, 1};
Line(11) = {11, 12}; Circle(12) = {12, 17, 13}; Line(13) = {13, 14}; Line(14) = {14, 15}; Line(15) = {15, 16};
Circle(16) = {16, 18, 11};
Curve Loop(2) = {11, 12, 13, 14, 15, 16}; Plane Surface(2) = {2};
Physical Curve("bottom") = {1}; Physical Curve("top") = {3}; Physical Curve("sides") = {2, 4};
Physical Curve("face") = {16, 11, 12}; Physical Curve("flanks") = {13, 15}; Physical Curve("loaded") = {14};
Physical Surface("block") = {1}; Physical Surface("pad") = {2};
