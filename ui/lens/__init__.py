"""Tools of the 3D scene that change lens and source."""
