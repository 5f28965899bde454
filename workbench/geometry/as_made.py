"""The designed elements as manufacture leaves them: smoothed, reduced and smaller faces.

Smoothing is linear in the control heights, so that a run can shape a face for it. What is too fine
for a control net is relief, see `workbench.scene.making.relief`.
"""

from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from workbench.arrays import Array
from workbench.geometry.basis import basis_matrix, clamped_knots, greville, sparse_basis
from workbench.geometry.surface import ControlNet, nets_of
from workbench.messages import Message
from workbench.scene import Element, Scene
from workbench.scene.making.process import Making
from workbench.scene.making.relief import Relief

if TYPE_CHECKING:
    from scipy.sparse import csr_array
    from torch import Tensor

# Nodes of the integral over a Gaussian: in a knot span and in its rms width; and how far it goes.
_IN_SPAN, _IN_WIDTH, _FAR = 2, 3, 4.5
_NEGLIGIBLE = 1e-12  # entries of a smoothing matrix
_DENOMINATOR = 10**9
_LONG = 1.0  # radians from control point to control point of the shortest waves that a net holds


class MadeFace(NamedTuple):
    """What manufacture does to the control heights of a face: z' = f (A_u z A_vᵀ − z₀) + z₁."""

    along_u: "csr_array"
    along_v: "csr_array"
    factor: float
    vertex: float  # z₀, of the element
    after: Array | float  # z₁, with known errors and less what is removed

    def forward(self, heights: Array) -> Array:
        """Control heights (n_u, n_v) as made."""
        smooth = (self.along_v @ (self.along_u @ heights).T).T
        return np.asarray(self.factor * (smooth - self.vertex) + self.after)

    def adjoint(self, cotangent: Array) -> Array:
        """Cotangent of the designed heights from that of the heights as made."""
        return np.asarray(self.factor * (self.along_u.T @ (self.along_v.T @ cotangent.T).T))


class AsMade(NamedTuple):
    """A scene whose elements are as their processes leave them, relief apart."""

    scene: Scene  # without processes
    reliefs: tuple[tuple[Relief, float], ...]  # as in `Making`
    faces: Mapping[str, MadeFace]  # by id; none where the processes change no control height

    @classmethod
    def of(cls, scene: Scene, errors: bool = True) -> "AsMade":
        """Apply the processes of a scene; its nets have to be known if there are any.

        `errors`: whether random errors are those of a part that has been made. A run cannot know
        them. Waves of an error that the net does not hold are relief.
        """
        making, ideal = Making.of(scene.processes), scene.ideal
        nets = nets_of(scene) if scene.processes else {}
        if not nets:
            return cls(ideal, (), {})
        faces = {}
        shortest = _LONG / max(max(net.spacing) for net in nets.values())
        parts = [(error.split(shortest), width) for error, width in making.errors]
        reliefs = (*making.reliefs, *((short, width) for (_, short), width in parts))
        known = [(long, width) for (long, _), width in parts] if errors else []
        for number in scene.designed_numbers:
            element = scene.elements[number]
            for face in (placed.name for placed in element.placed_faces if placed.name in nets):
                net, z = nets[face], element.position[2]
                along_u, along_v = (_smoothing(net, axis, making.smoothing) for axis in (0, 1))
                waves = (error.heights(*net.positions, width) for error, width in known)
                after = z + element.outwards(face) * (sum(waves, 0.0) - making.removed)
                faces[face] = MadeFace(along_u, along_v, making.factor, z, after)
            ideal = ideal.with_element(number, _smaller(element, making.factor))
        return cls(ideal, tuple(each for each in reliefs if each[0].seen), faces)

    def heights(self, heights: Mapping[str, Array]) -> dict[str, Array]:
        """Control heights as made of all faces."""
        return {
            face: self.faces[face].forward(each) if face in self.faces else each
            for face, each in heights.items()
        }

    def tensors(self, heights: "Mapping[str, Tensor]") -> "dict[str, Tensor]":
        """The same of tensors; differentiable."""
        if not self.faces:
            return dict(heights)
        from workbench.geometry.linear_step import linear_step  # loads torch

        return {
            face: each
            if (made := self.faces.get(face)) is None
            else linear_step(made.forward, made.adjoint, each)
            for face, each in heights.items()
        }

    def for_result(self, wanted: Mapping[str, Array], rounds: int = 12) -> dict[str, Array]:
        """Control heights that are nearly as wanted after manufacture.

        Repeated correction by what smoothing takes away (van Cittert 1931); waves that it removes
        stay as they are, and are not amplified by more than ``rounds`` times.
        """
        found = dict(wanted)
        for _ in range(rounds if self.faces else 0):
            made = self.heights(found)
            found = {face: found[face] + wanted[face] - made[face] for face in found}
        return found


def scatterer_of(scene: Scene) -> Message | None:
    """What scatters light on its way, so that only random rays show it; None if nothing."""
    if scene.diffuser is not None:
        return Message("a diffuser")
    fine = AsMade.of(scene).reliefs
    return Message("the relief that manufacture leaves") if fine else None


def _smaller(element: Element, factor: float) -> Element:
    """An element at its place whose lengths are reduced by a factor."""
    if factor == 1:
        return element
    ratio = Fraction(factor).limit_denominator(_DENOMINATOR)
    kept = {
        field.name: getattr(element, field.name)
        for field in element.fields()
        if field.name == "position" or field.measure.power < 0
    }
    return element.scaled(ratio).model_copy(update=kept)


def _smoothing(net: ControlNet, axis: int, width: float) -> "csr_array":
    return _smoothing_matrix(net.shape[axis], net.degree[axis], width / (2 * net.half_width[axis]))


@lru_cache(maxsize=16)
def _smoothing_matrix(count: int, degree: int, width: float) -> "csr_array":
    """Matrix of the control heights of a spline that a Gaussian averages, on [0, 1].

    The spline is interpolated at the Greville abscissae. Beyond an end it goes on by point
    reflection, so that planes stay planes.
    """
    from scipy.sparse import csr_array, eye_array  # slow import

    if width == 0:
        return csr_array(eye_array(count))
    knots = clamped_knots(count, degree)
    sites = greville(knots, degree)
    step = min(1 / ((count - degree) * _IN_SPAN), width / _IN_WIDTH)
    reach = int(np.ceil(_FAR * width / step))
    offsets = step * np.arange(-reach, reach + 1)
    weights = np.exp(-((offsets / width) ** 2) / 2)
    weights /= weights.sum()
    ends = sparse_basis(knots, degree, np.array([0.0, 1.0]))
    total = csr_array((len(sites), count))
    for offset, weight in zip(offsets, weights, strict=True):
        place = sites + offset
        below, above = place < 0, place > 1
        inner = np.where(below, -place, np.where(above, 2 - place, place))
        sign = csr_array(np.where(below | above, -1.0, 1.0)[:, None])
        at_end = csr_array(2.0 * np.stack([below, above], axis=1))
        total = total + weight * (sign * sparse_basis(knots, degree, inner) + at_end @ ends)
    found = np.linalg.solve(basis_matrix(knots, degree, sites), total.toarray())
    return csr_array(np.where(np.abs(found) > _NEGLIGIBLE, found, 0.0))
