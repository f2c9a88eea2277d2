// A washer with a square hole and a notch.
$fn = 64;
difference() {
  circle(r = 10);
  square(6, center = true);
  translate([9, -1]) square([4, 2]);
}
