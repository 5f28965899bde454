import numpy as np
import pytest

from workbench.geometry.basis import basis_matrix, greville
from workbench.geometry.curvature import local_shape
from workbench.geometry.surface import ControlNet

HALF = (1.0, 0.8)
SIDE = np.linspace(0, 1, 31)
X, Y = np.meshgrid((2 * SIDE - 1) * HALF[0], (2 * SIDE - 1) * HALF[1], indexing="ij")


def shape_of(height, count=(40, 36), degree=(5, 4)):
    """Shape of the face that interpolates a height function."""
    net = ControlNet(count, degree, HALF)
    into_x, into_y = (
        np.linalg.inv(basis_matrix(knots, p, greville(knots, p)))
        for knots, p in zip(net.knots, degree, strict=True)
    )
    x, y = net.positions
    heights = into_x @ height(x[:, None], y[None, :]) @ into_y.T
    return local_shape(net, heights, SIDE, SIDE)


@pytest.mark.parametrize("degree", [(2, 2), (3, 3), (2, 5)])
def test_a_quadric_is_exact(degree):
    """z = a x² + b x y + c y² is in the spline space itself."""
    a, b, c = 0.3, -0.2, 0.1
    found = shape_of(lambda x, y: 0.5 + a * x**2 + b * x * y + c * y**2, (9, 8), degree)
    p, q = 2 * a * X + b * Y, b * X + 2 * c * Y
    stretch = 1 + p**2 + q**2
    mean = ((1 + q**2) * 2 * a - 2 * p * q * b + (1 + p**2) * 2 * c) / (2 * stretch**1.5)
    gaussian = (4 * a * c - b**2) / stretch**2
    np.testing.assert_allclose(found.height, 0.5 + a * X**2 + b * X * Y + c * Y**2, rtol=1e-12)
    np.testing.assert_allclose(found.slope, np.hypot(p, q), atol=1e-11)
    np.testing.assert_allclose(found.mean, mean, rtol=1e-9)
    np.testing.assert_allclose(found.gaussian, gaussian, rtol=1e-9)
    np.testing.assert_allclose(found.smallest + found.largest, 2 * mean, rtol=1e-9)
    np.testing.assert_allclose(found.smallest * found.largest, gaussian, rtol=1e-9)
    assert (found.smallest <= found.largest).all()


def test_a_cylinder_across_the_axes():
    radius, cos, sin = 3.0, np.cos(np.pi / 6), 0.5
    found = shape_of(lambda x, y: 4 - np.sqrt(radius**2 - (cos * x + sin * y) ** 2))
    np.testing.assert_allclose(found.largest, 1 / radius, rtol=1e-5)
    np.testing.assert_allclose(found.smallest, 0, atol=1e-5)
    np.testing.assert_allclose(found.gaussian, 0, atol=1e-5)
    np.testing.assert_allclose(found.mean, 0.5 / radius, rtol=1e-5)
