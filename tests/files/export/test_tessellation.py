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

    def test_a_bilinear_patch(self, make_design):
        """z = c x y is off by c h k / 4 at the middle of the diagonal."""
        net = {"lens.degree": [1, 1], "lens.control_points": [2, 2]}
        x, y = np.array([[-1.0, 1.0], [-0.7, 0.7]])
        design = make_design(net, heights=0.5 + 0.1 * x[:, None] * y, chord_error=1.0)
        face = Tessellation.of(design)
        assert face.z.shape == (2, 2)
        assert face.chord_error(design) == pytest.approx(0.1 * 2.0 * 1.4 / 4)

    def test_a_plane_needs_no_more_than_its_spans(self, make_design):
        design = make_design(heights=np.full((12, 10), 0.5), chord_error=1e-9)
        face = Tessellation.of(design)
        assert face.z.shape == (10, 8)
        assert face.chord_error(design) < 1e-15

    def test_single_precision_counts(self, make_design, rng):
        heights = 0.5 + 5e-4 * rng.random((12, 10))
        design = make_design(heights=heights, chord_error=1e-6)
        face = Tessellation.of(design, precision=2.0**-24).rounded()
        assert face.chord_error(design) <= 1e-6


class TestRefused:
    def test_finer_than_single_precision(self, make_design):
        with pytest.raises(Refused, match=r"--chord-error: 1e-09 cm is finer than the numbers"):
            Tessellation.of(make_design(chord_error=1e-9), precision=2.0**-24)

    def test_too_many_triangles(self, make_design):
        with pytest.raises(Refused, match=r"takes \d+ triangles, .*; about .* is possible"):
            Tessellation.of(make_design(chord_error=1e-9))

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
