"""Light before the lens: one file a kind.

A new kind of source is a file here, its fields in `workbench.scene`, and a row in ``_EMITTERS``.
"""

from collections.abc import Callable, Mapping
from typing import Any

from workbench.optics.samples import Corners, Samples
from workbench.optics.sources.collimated import CollimatedEmitter
from workbench.optics.sources.crowding import where_lit
from workbench.optics.sources.emitter import Emitter
from workbench.optics.sources.extended import AreaEmitter, DirectionEmitter
from workbench.optics.sources.origins import Origins
from workbench.optics.sources.points import PhotometricEmitter, PointEmitter, RayFileEmitter
from workbench.scene import (
    AreaSource,
    CollimatedSource,
    Element,
    LightOfPoints,
    PhotometricSource,
    RayFileSource,
    Source,
)
from workbench.scene.part import row_of

__all__ = [
    "CollimatedEmitter",
    "DirectionEmitter",
    "Emitter",
    "Origins",
    "PointEmitter",
    "emitter_of",
]


def _collimated(source: CollimatedSource, optic: Element, samples: Samples | None) -> Emitter:
    straight = source.along_axis
    return (CollimatedEmitter if straight else DirectionEmitter)(source, optic, samples)


_EMITTERS: Mapping[type, Callable[[Any, Element, Samples | None], Emitter]] = {
    CollimatedSource: _collimated,
    AreaSource: AreaEmitter,
    LightOfPoints: PointEmitter,
    PhotometricSource: PhotometricEmitter,
    RayFileSource: RayFileEmitter,
}


def emitter_of(source: Source, optic: Element, samples: Samples | None = None) -> Emitter:
    """The element that emits the light of a source towards a lens.

    `source`, `lens`: the light and its aperture; `samples`: rays along x and y that are wanted in
    place of the source's own. A source whose rays are drawn at random keeps them.
    """
    if isinstance(samples, Corners):
        samples = where_lit(samples, source, optic)
    return row_of(_EMITTERS, source)(source, optic, samples)
