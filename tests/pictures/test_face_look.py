"""How a freeform face is coloured and lit."""

import numpy as np
import pytest

from workbench.pictures import meshes
from workbench.pictures.face_colours import (
    face_colours,
    lit_normals,
    scale_top,
)

X, Y = np.meshgrid(np.linspace(-2, 2, 41), np.linspace(-1, 1, 31), indexing="ij")


def surface(z):
    return np.stack([X, Y, z + 0 * X], axis=-1)


def rgb(z, by):
    top = scale_top([surface(z)], by)
    return face_colours(surface(z), by, "#8fc1e8", top).reshape(41, 31, 3).astype(int)


def test_bowls_are_red_and_humps_blue():
    red, _, blue = np.moveaxis(rgb(0.1 * X**3, "curvature"), -1, 0)  # a hump at -x, a bowl at +x
    assert (red[35] > blue[35]).all()
    assert (red[5] < blue[5]).all()


def test_relief_is_lit_as_if_it_were_higher_and_a_smooth_face_as_it_is():
    smooth = 0.3 * X**2 - 0.1 * X * Y + 0.2 * Y
    fine = smooth + 1e-3 * np.sin(12 * X)
    plain, exaggerated = (lit_normals(surface(fine), high) for high in (False, True))
    assert plain == pytest.approx(meshes.normals(surface(fine)))
    change = np.abs(lit_normals(surface(smooth), True) - meshes.normals(surface(smooth)))
    assert change.max() < 1e-6
    off = [np.abs(each - meshes.normals(surface(smooth))).max() for each in (plain, exaggerated)]
    assert off[1] > 20 * off[0]
    assert np.linalg.norm(exaggerated, axis=1) == pytest.approx(1.0)
