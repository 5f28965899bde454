import numpy as np
import pytest
from scipy.interpolate import NdBSpline

from workbench.errors import Refused
from workbench.files.export.tessellation import Tessellation


def height(design, places):
    """The exit face by scipy."""
    knots = [(2 * k - 1) * r for k, r in zip(design.net.knots, design.net.half_width, strict=True)]
    return NdBSpline(tuple(knots), design.heights, design.net.degree)(places)


def farthest(design, face, rng):
    """Largest distance along z at random places of the triangles of the exit face."""
    m_x, m_y = face.z.shape
    body = face.body()
    triangles = body.vertices[body.triangles[: 2 * (m_x - 1) * (m_y - 1)]]
    weights = rng.dirichlet([1, 1, 1], size=(len(triangles), 20))
    places = np.einsum("tkc,tcd->tkd", weights, triangles).reshape(-1, 3)
    return np.abs(places[:, 2] - height(design, places[:, :2])).max()


class TestChordError:
    @pytest.mark.parametrize("degree", [(1, 1), (1, 3), (3, 3), (2, 5)])
    @pytest.mark.parametrize("chord_error", [1e-2, 1e-3])
    def test_the_chord_error_is_kept_and_measured(self, make_design, rng, degree, chord_error):
        design = make_design({"lens.degree": list(degree)}, chord_error=chord_error)
        face = Tessellation.of(design)
        measured = face.chord_error(design)
        found = farthest(design, face, rng)
        assert found <= measured * 1.05 <= 1.05 * chord_error
        if degree != (1, 1):
            assert measured > 0.15 * chord_error  # not wasteful


class TestRefused:
    def test_the_chord_error_that_a_refusal_suggests_is_possible(self, make_design):
        heights = make_design().heights
        with pytest.raises(Refused) as caught:
            Tessellation.of(make_design(heights=heights, chord_error=1e-7))
        possible = float(str(caught.value).split("about ")[1].split(" ")[0])
        Tessellation.of(make_design(heights=heights, chord_error=possible))


@pytest.mark.parametrize("shape", [(12, 10), (4, 4)])
def test_every_edge_has_two_triangles_that_run_along_it_in_turn(make_design, shape):
    design = make_design({"lens.control_points": list(shape)}, chord_error=1e-2)
    triangles = Tessellation.of(design).body().triangles
    edges = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    there = {tuple(edge) for edge in edges.tolist()}
    assert len(there) == len(edges)
    assert {(b, a) for a, b in there} == there
