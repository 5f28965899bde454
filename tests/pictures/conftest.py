"""What tests of the 3D scene share."""

import pytest


@pytest.fixture
def plotter():
    """A plotter of 640 by 400 pixels that draws off screen."""
    import pyvista  # here, as it is slow to load

    made = pyvista.Plotter(off_screen=True, window_size=[640, 400])
    yield made
    made.close()
