"""B-spline faces: basis, evaluation, knot insertion, curvature, bounds, ball cutters."""
