"""B-spline basis, knots, surface evaluation and knot insertion."""
