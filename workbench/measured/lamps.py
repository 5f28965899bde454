"""Sources that name a file: their intensity or rays, cached, and the unit of their light."""

import io
import math
import os
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import BinaryIO, Literal, NamedTuple, TypeVar

import numpy as np

from workbench import units
from workbench.errors import Refused
from workbench.measured.photometry import IntensityTable, read_photometry
from workbench.measured.rays import RaySet, read_rays
from workbench.measured.rays.model import RayModel, model_of
from workbench.measured.rays.rayset import PlacedRays, placed
from workbench.measured.text import problem_in
from workbench.messages import Message
from workbench.powers import written
from workbench.reading import opened
from workbench.scene import (
    AreaSource,
    Element,
    MeasuredSource,
    PhotometricSource,
    PointSource,
    RayFileSource,
    Scene,
    Source,
)

T = TypeVar("T")
# Least aspect ratio of the emitter that replaces rays of a line.
_LEAST_ASPECT = 1e-6


def intensity_of(source: PhotometricSource) -> IntensityTable:
    """Return the intensity by direction of a source's file; raise Refused if unusable."""
    return _read(source, _intensity)


def rays_of(source: RayFileSource) -> RaySet:
    """Return the rays of a source's file, in the file's unit; raise Refused if unusable."""
    rays = _read(source, _rays)
    if rays.unit is None and source.file_unit is None:
        raise Refused(
            "source.file_unit",
            Message("missing; '{file}' does not name its unit", file=source.file),
        )
    return rays


def placed_rays(source: RayFileSource) -> PlacedRays:
    """Return the rays of a source's file in scene coordinates; raise as `rays_of`."""
    return _placed(source, source.unit, rays_of(source))


def ray_model(source: RayFileSource, optic: Element, points: int) -> RayModel:
    """Return the `RayModel` of a source's rays at an element; raise Refused if none arrives."""
    try:
        face = (optic.half_width, optic.front_z)
        return _model(source, source.unit, rays_of(source), *face, points)
    except ValueError as error:
        raise Refused(
            "source.file",
            Message(
                "'{file}' gives the lens no light: {error}",
                file=source.file,
                error=problem_in(error),
            ),
        ) from None


def of_known_size(source: Source, optic: Element) -> Source:
    """Return a source with a size: a ray file is replaced by a uniform emitter.

    Only rays that reach the element count. The emitter has the mean and the standard deviation of
    their starting points; it is a point source if that deviation is zero. Raise as `ray_model`.
    """
    if not isinstance(source, RayFileSource) or not source.continuous:
        return source
    model = ray_model(source, optic, 1)
    place = (*model.size.middle, float(model.places[0, 2]))
    r_x, r_y = model.size.half_width
    least = _LEAST_ASPECT * max(r_x, r_y)
    if least == 0:
        return PointSource(kind="point", position=place)
    half_width = max(r_x, least), max(r_y, least)
    outline: Literal["rectangle", "ellipse"] = "ellipse" if model.size.round else "rectangle"
    return AreaSource(kind="area", position=place, half_width=half_width, outline=outline)


def check_file(source: object) -> None:
    """Raise Refused if the file of a source is unusable."""
    match source:
        case PhotometricSource():
            intensity_of(source)
        case RayFileSource():
            rays_of(source)


def _read(
    source: MeasuredSource, read: Callable[[str, bytes | None, tuple[int, ...] | None], T]
) -> T:
    try:
        if source.content is not None:
            return read(source.file, source.content, None)
        return read(source.file, None, _state(source.file))
    except Refused as refused:
        raise Refused(
            "source.file", Message("'{file}' {reason}", file=refused.path, reason=refused.reason)
        ) from refused


def _state(file: str) -> tuple[int, ...] | None:
    try:
        found = os.stat(file)
    except (OSError, ValueError):
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino


# Each run, check and picture reads the file.
@lru_cache(maxsize=8)
def _intensity(file: str, data: bytes | None, state: object) -> IntensityTable:
    return _from(file, data, read_photometry)


@lru_cache(maxsize=2)
def _rays(file: str, data: bytes | None, state: object) -> RaySet:
    return _from(file, data, read_rays)


# `RaySet` hashes by identity: the cache key does not compare arrays.
@lru_cache(maxsize=2)
def _placed(source: RayFileSource, unit: str, rays: RaySet) -> PlacedRays:
    file_unit = source.file_unit or rays.unit or unit
    return placed(rays, file_unit, unit, source.matrix, source.position)


@lru_cache(maxsize=4)
def _model(
    source: RayFileSource,
    unit: str,
    rays: RaySet,
    half_width: tuple[float, float],
    z: float,
    points: int,
) -> RayModel:
    return model_of(_placed(source, unit, rays), half_width, z, points)


def _from(file: str, data: bytes | None, read: Callable[[Path, BinaryIO], T]) -> T:
    if data is not None:
        return read(Path(file), io.BytesIO(data))
    with opened(Path(file)) as content:
        return read(Path(file), content)


class LightUnit(NamedTuple):
    """Unit in which light is shown, for a source whose flux is 1 in the computation."""

    words: str = "flux"  # unit of a density: "lx", "cd" or "× mean"
    # Factor for a density: flux per area in the scene's unit, or per solid angle.
    density: float = 1.0
    lumens: float | None = None  # flux of the source, lm; None if unknown

    def flux_in_words(self, share: float) -> str:
        """A part of the flux in lumen, as in "12.3 lm"; empty if unknown."""
        return "" if self.lumens is None else written(share * self.lumens, "lm")

    def density_in_words(self, density: float) -> str:
        """A density with its unit."""
        value = density * self.density
        if self.lumens is None:
            return Message("{value} {unit}", value=written(value), unit=self.words)
        return written(value, self.words)


IN_PARTS = LightUnit()
"""Unit for light of unknown flux."""


def light_unit(scene: Scene) -> LightUnit:
    """Return the unit for the light of a scene.

    Where the flux of the source is unknown, or its file unusable, light is stated in multiples of
    the mean: what the whole flux gives when it is spread evenly over the receiver.

    Examples
    --------
    >>> from workbench.scene import Scene
    >>> scene = Scene.from_data({
    ...     "version": 3, "unit": "cm",
    ...     "source": {
    ...         "kind": "area", "position": [0, 0, -3], "half_width": [0.1, 0.1], "flux": 200,
    ...     },
    ...     "elements": [{
    ...         "kind": "lens", "name": "lens", "half_width": [1, 1], "material": "PMMA",
    ...         "thickness": 0.5, "faces": [{"shape": "plane"}, {"shape": "bspline"}],
    ...     }],
    ...     "images": [{
    ...         "receiver": {
    ...             "kind": "plane", "position": [0, 0, 50], "half_width": [10, 10],
    ...             "pixels": [64, 64],
    ...         },
    ...         "target": {"builtin": "rectangle"},
    ...     }],
    ... })
    >>> light_unit(scene)
    LightUnit(words='lx', density=2000000.0, lumens=200.0)
    """
    receiver, lumens = scene.receiver, _lumens(scene)
    if lumens is None:
        whole = float(np.mean(receiver.pixel_measure)) * math.prod(receiver.pixels)
        return LightUnit(Message("× mean"), whole)
    if not receiver.measure.power:
        return LightUnit("cd", lumens, lumens)
    return LightUnit("lx", lumens / float(units.METRES[scene.unit]) ** 2, lumens)


def _lumens(scene: Scene) -> float | None:
    source = scene.source
    if not isinstance(source, PhotometricSource):
        return source.lumens
    try:
        return intensity_of(source).lumens
    except Refused:  # reported where the file is needed
        return None
