// Makes tests/mesh/plate_with_hole.msh: gmsh -2 -format msh41 plate_with_hole.geo  (Gmsh 4.8.4). Millimetres.
Point(1) = {-60, -40, 0, 12};
Point(2) = {60, -40, 0, 12};
Point(3) = {60, 40, 0, 12};
Point(4) = {-60, 40, 0, 12};
Point(5) = {0, 0, 0, 12}; // the middle of the hole: a node of no element
Point(6) = {20, 0, 0, 5};
Point(7) = {0, 20, 0, 5};
Point(8) = {-20, 0, 0, 5};
Point(9) = {0, -20, 0, 5};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Circle(5) = {6, 5, 7};
Circle(6) = {7, 5, 8};
Circle(7) = {8, 5, 9};
Circle(8) = {9, 5, 6};
Transfinite Curve {5, 6, 7, 8} = 9; // eight edges a quarter
Curve Loop(1) = {1, 2, 3, 4};
Curve Loop(2) = {5, 6, 7, 8};
Plane Surface(1) = {1, 2};
Recombine Surface {1};
Mesh.RecombinationAlgorithm = 0; // leaves triangles where they are better
Mesh.RecombineOptimizeTopology = 0;
