"""The faces of a train in numbers, for its compiled loops."""

from collections.abc import Sequence
from typing import Any

import numpy as np
import torch

from workbench.arrays import AnyArray
from workbench.optics.interfaces import Reflection, Refraction
from workbench.optics.intersection import RIM
from workbench.optics.kernels.function import kind_of
from workbench.optics.kernels.point_face import Face, heights_cotangent, make_table
from workbench.optics.sampled import SampledTrain
from workbench.optics.steps import FaceStep
from workbench.optics.surfaces import BSplineSurface, Conic, Plane
from workbench.optics.train.first_face import REFLECTS, REFRACTS, REFRACTS_STRAIGHT
from workbench.optics.train.numbers import BSPLINE, CONIC, Elements, FirstFace
from workbench.optics.transmittance import TransmittanceLaw

# No slope of light between two faces is larger.
_STEEPEST = 1e9
_ANY_LAW = TransmittanceLaw.constant(1.0, 0.0)


def first_face(train: SampledTrain, straight: bool, kind: type[np.floating[Any]]) -> FirstFace:
    """The first face of a train; whether its light goes along the axis."""
    does = REFRACTS_STRAIGHT if straight else REFRACTS
    if isinstance(train.first.interface, Reflection):
        does = REFLECTS
    lift = 0.0 if train.glass is None else train.level - train.glass.z
    law, absorption, reflectance = _interface(train.first)
    n = law.ratio
    numbers = kind(n), kind(n * n - 1), kind(lift), kind(_critical(kind)), kind(absorption)
    return FirstFace(does, *numbers, law.cast(kind), kind(reflectance))


class FurtherFaces:
    """The faces behind the first one, with the B-splines among them as one table of patches.

    Parameters
    ----------
    train : SampledTrain
        The train.
    dtype : torch.dtype
        Float type of the trace.

    Attributes
    ----------
    splines : list of BSplineSurface
        Those that are B-splines.
    levels : list of float
        z of the scene from which positions on the first face, and on each further one, are counted.
    steepest : ndarray, shape (faces, 2)
        The most that slopes of the rays before them were for the last train.
    """

    def __init__(self, train: SampledTrain, dtype: torch.dtype) -> None:
        self._kind = kind_of(dtype)
        surfaces = [step.surface for step in train.rest]
        self.splines = [each for each in surfaces if isinstance(each, BSplineSurface)]
        self._faces = {
            number: Face(surface.net, dtype)
            for number, surface in enumerate(surfaces)
            if isinstance(surface, BSplineSurface)
        }
        self.levels = [train.level, *(_level(step, train) for step in train.rest)]
        self.steepest = np.full((len(train.rest), 2), _STEEPEST)  # as long as they are not known
        degrees = [(len(x), len(y)) for x, y in (face.powers for face in self._faces.values())]
        self._terms = tuple(max((each[axis] for each in degrees), default=1) for axis in (0, 1))
        self._first, patches = {}, 0
        for number, face in self._faces.items():
            self._first[number] = patches
            patches += face.net.spans[0] * face.net.spans[1]
        self._patches = patches
        self._elements = self._in_numbers(train)

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

    def cotangents(self, d_tables: AnyArray, heights: Sequence[AnyArray]) -> list[AnyArray]:
        """Those of the heights of the B-splines from those of the patches, by parts."""
        found: list[AnyArray] = []
        for (number, face), each in zip(self._faces.items(), heights, strict=True):
            p, q = (len(powers) for powers in face.powers)
            begin, count = self._first[number], face.net.spans[0] * face.net.spans[1]
            some = np.ascontiguousarray(d_tables[:, begin : begin + count, :p, :q])
            found.append(heights_cotangent(some, each.shape, face.powers))
        return found

    def _in_numbers(self, train: SampledTrain) -> Elements:
        count, kind = len(train.rest), self._kind
        flags, numbers = np.zeros((count, 5), bool), np.zeros((count, 19), kind)
        spans = np.zeros((count, 3), np.int64)
        kinds = np.full(count, CONIC, np.int32)
        (r_x, r_y), curved = train.half_width, not train.outline.whole
        for number, step in enumerate(train.rest):
            spline = number in self._faces
            law, absorption, reflectance = _interface(step)
            n, lift = law.ratio, self.levels[number] - self.levels[number + 1]
            mirror, cuts = isinstance(step.interface, Reflection), curved or not spline
            flags[number] = mirror, curved, number == 0, cuts, law.exact
            net: Sequence[Any] = 1.0, 1.0, 1.0, 1.0, 1.0, 1.0
            if spline:
                kinds[number] = BSPLINE
                *net, (spans_x, spans_y), _ = self._faces[number].net
                spans[number] = spans_x, spans_y, self._first[number]
            numbers[number] = (
                lift, n * n - 1, _critical(kind), absorption, reflectance,
                1 / r_x**2, 1 / r_y**2, RIM, *_conic(step),
                law.ratio, law.passing, law.grazing, *net,
            )  # fmt: skip
        return Elements(kinds, flags, numbers, np.zeros((count, 9), kind), spans)


def _critical(kind: type[np.floating[Any]]) -> float:
    """Squared cosine below which light counts as totally reflected."""
    return 16 * float(np.finfo(kind).eps)


def _interface(step: FaceStep) -> tuple[TransmittanceLaw, float, float]:
    """Transmittance, absorption of the medium before it, and reflectance of a mirror."""
    match step.interface:
        case Refraction(law=law, absorption=absorption):
            return law, absorption, 1.0
        case Reflection(reflectance=reflectance):
            return _ANY_LAW, 0.0, reflectance
    raise TypeError(f"the compiled train has no {type(step.interface).__name__}")


def _conic(step: FaceStep) -> tuple[float, float]:
    """Curvature and conic constant; of a plane, and of a B-spline, 0."""
    match step.surface:
        case Conic(curvature=curvature, conic=conic):
            return curvature, conic
    return 0.0, 0.0


def _level(step: FaceStep, train: SampledTrain) -> float:
    match step.surface:
        case BSplineSurface(level=level):
            return level
        case Plane(z=z) | Conic(z=z):
            return z + train.datum
    raise TypeError(f"the compiled train has no {step.surface.kind}")
