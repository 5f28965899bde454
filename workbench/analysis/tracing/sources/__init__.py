"""Light before the lens: a file for each kind.

A new kind of source is a file here, its fields in `workbench.scene`, and a row in ``_SOURCES``.
"""

import math
from collections.abc import Callable, Mapping
from typing import Any

from workbench.analysis.tracing.elements import LightSource
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.area import AreaLight
from workbench.analysis.tracing.sources.collimated import BeamLight, CollimatedLight
from workbench.analysis.tracing.sources.measured import PhotometricLight, RayFileLight
from workbench.analysis.tracing.sources.points import PointLight
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


def _collimated(
    source: CollimatedSource, optic: Element, pose: Pose, rays: int, seed: int
) -> LightSource:
    """Parallel light that is even, or a beam."""
    even = math.isinf(source.profile.radius) and not source.continuous
    return (CollimatedLight if even else BeamLight)(source, optic, pose, rays, seed)


_SOURCES: Mapping[type, Callable[[Any, Element, Pose, int, int], LightSource]] = {
    CollimatedSource: _collimated,
    AreaSource: AreaLight,
    LightOfPoints: PointLight,
    PhotometricSource: PhotometricLight,
    RayFileSource: RayFileLight,
}


def light_source(source: Source, optic: Element, pose: Pose, rays: int, seed: int) -> LightSource:
    """The element that a source is.

    `optic`: gives the entrance face; `pose`: how the lens stands; `rays`, `seed`: how many rays are
    drawn at least, and which.
    """
    return row_of(_SOURCES, source)(source, optic, pose, rays, seed)
