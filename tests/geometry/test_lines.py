import numpy as np
import pytest

from workbench.pictures.projection import nearest_to_line


def test_distances_are_square_to_the_line(rng):
    points = rng.normal(size=(4, 5, 3))
    start, end = rng.normal(size=(2, 3))
    along = (end - start) / np.linalg.norm(end - start)
    distances = np.linalg.norm(np.cross(points - start, along), axis=-1)
    index, distance = nearest_to_line(points, start, end)
    assert index == np.unravel_index(distances.argmin(), distances.shape)
    assert distance == pytest.approx(distances.min(), rel=1e-12)
