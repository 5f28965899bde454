"""The light of sources that name a file: read once, from what is carried along or from disk."""

import io
import os
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import BinaryIO, Literal, TypeVar

from workbench.errors import Refused
from workbench.measured.photometry import IntensityTable, read_photometry
from workbench.measured.rays import RaySet, read_rays
from workbench.measured.rays.model import RayModel, model_of
from workbench.measured.rays.placed import PlacedRays, placed
from workbench.measured.text import problem_in
from workbench.reading import opened
from workbench.said import Said
from workbench.scene import (
    AreaSource,
    Element,
    MeasuredSource,
    PhotometricSource,
    PointSource,
    RayFileSource,
    Source,
)

T = TypeVar("T")

# Width over height of the emitter that stands for rays of a line, at least.
_SLIMMEST = 1e-6


def intensity_of(source: PhotometricSource) -> IntensityTable:
    """The intensity by direction of a source's file.

    Raises
    ------
    Refused
        If the file cannot be read or used.
    """
    return _read(source, _intensity)


def rays_of(source: RayFileSource) -> RaySet:
    """The rays of a source's file, in the unit of the file.

    Raises
    ------
    Refused
        If the file cannot be read or used, or nothing says the unit of its lengths.
    """
    rays = _read(source, _rays)
    if rays.unit is None and source.file_unit is None:
        raise Refused(
            "source.file_unit", Said("missing; '{file}' does not name its unit", file=source.file)
        )
    return rays


def placed_rays(source: RayFileSource) -> PlacedRays:
    """The rays of a source's file where they are in the scene; raises as `rays_of`."""
    return _placed(source, source.unit, rays_of(source))


def ray_model(source: RayFileSource, optic: Element, points: int) -> RayModel:
    """The light of a source's rays to a lens as that of points; see `RayModel`.

    Raises
    ------
    Refused
        If no ray comes to the lens, and as `rays_of`.
    """
    try:
        face = (optic.half_width, optic.front_z)
        return _model(source, source.unit, rays_of(source), *face, points)
    except ValueError as error:
        raise Refused(
            "source.file",
            Said(
                "'{file}' gives the lens no light: {error}",
                file=source.file,
                error=problem_in(error),
            ),
        ) from None


def of_known_size(source: Source, optic: Element) -> Source:
    """A source that says how large it is.

    Parameters
    ----------
    source : Source
        The source; only files of rays do not say it themselves.
    optic : Element
        What it lights: of rays, those that come there count.

    Returns
    -------
    Source
        The source itself. Of rays of a file, an even emitter whose middle and standard deviation
        are those of the places where they start, or a point where that is one.

    Raises
    ------
    Refused
        As `ray_model`.
    """
    if not isinstance(source, RayFileSource) or not source.continuous:
        return source
    model = ray_model(source, optic, 1)
    place = (*model.size.middle, float(model.places[0, 2]))
    r_x, r_y = model.size.half_width
    least = _SLIMMEST * max(r_x, r_y)
    if least == 0:
        return PointSource(kind="point", position=place)
    half_width = max(r_x, least), max(r_y, least)
    outline: Literal["rectangle", "ellipse"] = "ellipse" if model.size.round else "rectangle"
    return AreaSource(kind="area", position=place, half_width=half_width, outline=outline)


def check_file(source: object) -> None:
    """Refuse a source whose file cannot be used.

    Raises
    ------
    Refused
        See `intensity_of` and `rays_of`.
    """
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
            "source.file", Said("'{file}' {reason}", file=refused.path, reason=refused.reason)
        ) from refused


def _state(file: str) -> tuple[int, ...] | None:
    """What changes when the file does; None where it is not there."""
    try:
        found = os.stat(file)
    except (OSError, ValueError):
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino


# Read again and again: by each run, check and picture.
@lru_cache(maxsize=8)
def _intensity(file: str, data: bytes | None, state: object) -> IntensityTable:
    return _from(file, data, read_photometry)


@lru_cache(maxsize=2)
def _rays(file: str, data: bytes | None, state: object) -> RaySet:
    return _from(file, data, read_rays)


# Their keys are what places rays: sets of rays differ by what they are, not by what they hold.
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
