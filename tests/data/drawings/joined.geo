// Two rectangles that share a side, and a hole, in quadrangles; surfaces alone have names.
SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 4, 2}; Rectangle(2) = {0, 2, 0, 4, 1}; Disk(3) = {2, 1, 0, 0.5};
BooleanDifference{ Surface{1}; Delete; }{ Surface{3}; Delete; }
Coherence;
Characteristic Length {:} = 1.5;
Physical Surface("lower") = {1}; Physical Surface("upper") = {2};
Mesh.RecombineAll = 1;
