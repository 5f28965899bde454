"""The faces of a train in numbers, for its compiled loops."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt
import torch

from workbench.arrays import AnyArray
from workbench.geometry.frames import Frame
from workbench.geometry.outlines import Outline
from workbench.optics.fixed_faces import beyond_rim
from workbench.optics.interfaces import Reflection, Refraction, TransmittanceLaw
from workbench.optics.kernels import kind_of
from workbench.optics.kernels.spline import Face, heights_cotangent, make_table
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface, Conic, Plane, Surface
from workbench.optics.surfaces.intersection import RIM
from workbench.optics.train.first_face import REFLECTS, REFRACTS, REFRACTS_STRAIGHT
from workbench.optics.train.numbers import ASPHERE, BSPLINE, CONIC, Elements, FirstFace

# No slope of light between two faces is larger.
_STEEPEST = 1e9
_ANY_LAW = TransmittanceLaw.constant(1.0, 0.0)


def first_face(
    step: FaceStep | None, lift: float, straight: bool, kind: type[np.floating[Any]]
) -> FirstFace:
    """The first face of a train, if it is sampled.

    `lift`: level that its heights are counted from, above a plane entrance face; `straight`:
    whether its light goes along the axis; `kind`: float type of the loops.
    """
    does = REFRACTS_STRAIGHT if straight else REFRACTS
    law, absorption, reflectance = _ANY_LAW, 0.0, 1.0
    if step is not None:
        law, absorption, reflectance = _interface(step)
        does = REFLECTS if isinstance(step.interface, Reflection) else does
    n = law.ratio
    numbers = kind(n), kind(n * n - 1), kind(lift), kind(_critical(kind)), kind(absorption)
    return FirstFace(does, *numbers, law.cast(kind), kind(reflectance))


class FurtherFaces:
    """The faces that rays search for, with the B-splines among them as one table of patches.

    `steps`: the faces; `changes`: changes of coordinates before each of them, and behind the last
    one; `z`: where positions before the first of them are counted from; `samples`: what cuts parts
    that samples stand for, if the first of them is the next face behind them; `dtype`: float type
    of the trace. `splines`: those that are B-splines; `to_receiver`: change from the coordinates of
    the last face to those of the receiver; `steepest` (faces, 2): the most that slopes of the rays
    before them were for the last train.
    """

    def __init__(
        self,
        steps: Sequence[FaceStep],
        changes: Sequence[Frame],
        z: float,
        samples: Outline | None,
        dtype: torch.dtype,
    ) -> None:
        self._kind = kind_of(dtype)
        surfaces = [step.surface for step in steps]
        self.splines = [each for each in surfaces if isinstance(each, BSplineSurface)]
        self._faces = {
            number: Face(surface.net, dtype)
            for number, surface in enumerate(surfaces)
            if isinstance(surface, BSplineSurface)
        }
        levels = [z, *(_level(step) for step in steps), 0.0]
        self._changes = [
            change.counting_from(*ends)
            for change, ends in zip(changes, pairwise(levels), strict=True)
        ]
        self.to_receiver = self._changes[-1]
        self.steepest = np.full((len(steps), 2), _STEEPEST)  # as long as they are not known
        degrees = [(len(x), len(y)) for x, y in (face.powers for face in self._faces.values())]
        self._terms = tuple(max((each[axis] for each in degrees), default=1) for axis in (0, 1))
        self._first, patches = {}, 0
        for number, face in self._faces.items():
            self._first[number] = patches
            patches += face.net.spans[0] * face.net.spans[1]
        self._patches = patches
        self._elements = self._in_numbers(steps, samples, dtype)

    def prepare(self, heights: Sequence[AnyArray]) -> tuple[Elements, AnyArray]:
        """The faces in numbers, and patches of all B-splines, for heights above their levels."""
        bounds = self._elements.bounds.copy()
        table = np.zeros((self._patches, *self._terms), self._kind)
        for (number, face), each in zip(self._faces.items(), heights, strict=True):
            steepest = self.steepest[number].astype(self._kind)
            bounds[number] = face.bounds(each, steepest)
            found, begin = make_table(each, face.powers), self._first[number]
            _, p, q = found.shape
            table[begin : begin + len(found), :p, :q] = found
        return self._elements._replace(bounds=bounds), table

    def no_cotangents(self, parts: int) -> tuple[AnyArray, npt.NDArray[np.int64]]:
        """Cotangents of patches by parts, all 0, and which patches of each face have others."""
        touched = np.tile([self._patches, -1], (parts, self._elements.kind.size, 1))
        return np.zeros((parts, self._patches, *self._terms)), touched

    def cotangents(
        self,
        d_tables: AnyArray,
        touched: npt.NDArray[np.int64],
        heights: Sequence[AnyArray],
    ) -> list[AnyArray]:
        """Those of the heights of the B-splines from those of the patches, by parts."""
        found: list[AnyArray] = []
        for (number, face), each in zip(self._faces.items(), heights, strict=True):
            p, q = (len(powers) for powers in face.powers)
            begin, count = self._first[number], face.net.spans[0] * face.net.spans[1]
            some = np.ascontiguousarray(d_tables[:, begin : begin + count, :p, :q])
            by_part = touched[:, number] - begin
            found.append(heights_cotangent(some, by_part, each.shape, face.powers))
        return found

    def _in_numbers(
        self, steps: Sequence[FaceStep], samples: Outline | None, dtype: torch.dtype
    ) -> Elements:
        count, kind = len(steps), self._kind
        flags, numbers = np.zeros((count, 5), bool), np.zeros((count, 25), kind)
        changes, spans = np.zeros((count, 12), kind), np.zeros((count, 3), np.int64)
        kinds = np.full(count, CONIC, np.int32)
        terms = [_coefficients(step.surface) for step in steps]
        coefficients = np.zeros((count, max(map(len, terms), default=0)), kind)
        for number, step in enumerate(steps):
            law, absorption, reflectance = _interface(step)
            outline, change, n = step.surface.outline, self._changes[number], law.ratio
            behind_samples = number == 0 and samples is not None and not samples.whole
            first = samples or outline
            mirror, curved = isinstance(step.interface, Reflection), not outline.whole
            flags[number] = mirror, curved, behind_samples, law.exact, not change.is_along_axis
            net: Sequence[Any] = 1.0, 1.0, 1.0, 1.0, 1.0, 1.0
            if number in self._faces:
                kinds[number] = BSPLINE
                *net, (spans_x, spans_y), _ = self._faces[number].net
                spans[number] = spans_x, spans_y, self._first[number]
            if terms[number]:
                kinds[number] = ASPHERE
                coefficients[number, : len(terms[number])] = terms[number]
            numbers[number] = (
                n * n - 1, _critical(kind), absorption, reflectance,
                *(1 / r**2 for r in outline.half_width), RIM,
                beyond_rim(first, outline), *(1 / r**2 for r in first.half_width),
                *_conic(step.surface, dtype),
                law.ratio, law.passing, law.grazing, *net,
            )  # fmt: skip
            changes[number] = *change.rotation.flat, *change.position
        bounds = np.zeros((count, 9), kind)
        return Elements(kinds, flags, numbers, changes, coefficients, bounds, spans)


def _critical(kind: type[np.floating[Any]]) -> float:
    """Squared cosine below which light counts as totally reflected."""
    return 16 * float(np.finfo(kind).eps)


def _interface(step: FaceStep) -> tuple[TransmittanceLaw, float, float]:
    """Transmittance, absorption of the medium before it, and reflectance of a mirror."""
    match step.interface:
        case Refraction(law=TransmittanceLaw() as law, absorption=absorption):
            return law, absorption, 1.0
        case Reflection(reflectance=reflectance):
            return _ANY_LAW, 0.0, reflectance
    raise TypeError(f"the compiled train has no {type(step.interface).__name__}")


def _conic(surface: Surface, dtype: torch.dtype) -> tuple[float, ...]:
    """Curvature, conic constant and the search for an asphere; of other surfaces 0."""
    match surface:
        case Conic(curvature=curvature, conic=conic, reach2=reach2, low=low, high=high):
            return curvature, conic, reach2, low, high, surface.tolerance(dtype)
    return 0.0, 0.0, 0.0, 0.0, 0.0, 0.0


def _coefficients(surface: Surface) -> tuple[float, ...]:
    return surface.coefficients if isinstance(surface, Conic) else ()


def _level(step: FaceStep) -> float:
    """Where heights of the face are counted from, in its frame."""
    match step.surface:
        case BSplineSurface(z=z) | Plane(z=z) | Conic(z=z):
            return z
    raise TypeError(f"the compiled train has no {step.surface.kind}")
