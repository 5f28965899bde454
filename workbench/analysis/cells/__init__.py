"""The deterministic check: an image of a lens without random rays, with a bound of its error.

A lattice of rays covers the entrance face. Between its nodes the map from the face to the screen is
linear on triangles, and each triangle spreads its flux evenly over the area that it covers on the
screen. `triangles` does that exactly, `lattice` makes the nodes, and `image` refines the lattice
until two levels agree.
"""
