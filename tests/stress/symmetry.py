"""What mirrors and units must not change."""

import numpy as np
import torch

from tests.optics.rays import with_rays
from tests.stress.checks import Make, Seen, as_near_as_rounding, on_creases, see, ways
from tests.stress.scenes import Case
from workbench.geometry.surface import ControlNet
from workbench.optics.path import Path
from workbench.optics.rays import Vector
from workbench.optics.reference import Reference
from workbench.optics.sources import emitter_of
from workbench.scene import CollimatedSource, ExactMethod, Scene


def check_mirrored(case: Case, dtype: torch.dtype) -> None:
    """The mirror image of a scene has the mirror image of its light and of its gradient."""
    scene = case.scene
    for axis in (0, 1):
        image = _mirrored(scene, axis)
        pairs = [
            (make, make)
            for way, makes in ways(case, dtype).items()
            if way not in ("exact", "mesh")  # rays drawn by chance; diagonals of triangles
            and not on_creases(case)
            for make in makes
        ]
        if not isinstance(scene.source, CollimatedSource):
            pairs.append(tuple(_searching(scene, dtype, of) for of in (None, axis)))
        for make, make_image in pairs:
            one = see(make(scene), scene, case.heights(), case.cotangent())
            heights = {face: each.flip(axis) for face, each in case.heights().items()}
            cotangent = case.cotangent().flip(1 - axis)
            other = see(make_image(image), image, heights, cotangent)
            gradient = {face: np.flip(each, axis) for face, each in other.gradient.items()}
            back = Seen(np.flip(other.flux, 1 - axis), gradient, other.lost, other.sum)
            as_near_as_rounding(case, make, one, back, dtype)


def _mirrored(scene: Scene, axis: int) -> Scene:
    """The scene with its source on the other side."""
    source = scene.source
    if isinstance(source, CollimatedSource):
        return scene
    x, y, z = source.place
    place = (-x, y, z) if axis == 0 else (x, -y, z)
    return scene.model_copy(update={"source": source.placed(place)})


def _searching(scene: Scene, dtype: torch.dtype, axis: int | None) -> Make:
    """Rays as drawn for a scene, or their mirror images."""
    assert not isinstance(scene.source, CollimatedSource)
    source = scene.source.model_copy(update={"intersection": ExactMethod()})

    def make(there: Scene) -> Reference:
        there = there.model_copy(update={"source": source})
        path = Path.of(there, ControlNet.of(there.optic), dtype)
        rays = emitter_of(source, there.optic).rays(there.run.seed)
        if axis is not None:
            rays = rays._replace(
                position=_flipped(rays.position, axis), direction=_flipped(rays.direction, axis)
            )
        return Reference(with_rays(path, rays))

    return make


def _flipped(vector: Vector, axis: int) -> Vector:
    x, y, z = vector
    return (-x, y, z) if axis == 0 else (x, -y, z)


def check_units(case: Case, dtype: torch.dtype) -> None:
    """Lengths in other units, a power of two apart, change the gradient's unit and no more."""
    for power in (-case.unit,) if case.unit else (-19, 19):
        other = case._replace(unit=case.unit + power)
        there = ways(other, dtype)
        for way, makes in ways(case, dtype).items():
            for make, make_other in zip(makes, there[way], strict=True):
                heights, cotangent = case.heights(), case.cotangent()
                one = see(make(case.scene), case.scene, heights, cotangent)
                moved = {face: each * 2.0**power for face, each in heights.items()}
                same = see(make_other(other.scene), other.scene, moved, cotangent)
                gradient = {face: each * 2.0**power for face, each in same.gradient.items()}
                same = same._replace(gradient=gradient)
                as_near_as_rounding(case, make, one, same, dtype)
