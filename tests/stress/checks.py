"""What has to hold for every trace, however extreme its scene."""

from collections.abc import Callable, Mapping
from itertools import product
from typing import NamedTuple

import numpy as np
import pytest
import torch

from tests.stress.scenes import Case, Heights
from workbench.arrays import Array
from workbench.geometry.surface import ControlNet, freeform_nets
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.light import Light, Tracer
from workbench.optics.path import Path
from workbench.optics.plan import Plan, nearly_touches
from workbench.optics.reference import Reference
from workbench.optics.samples import Corners, places_of_points
from workbench.optics.train.compiled import CompiledTrain
from workbench.scene import (
    AnyReceiver,
    CollimatedSource,
    CustomIndex,
    ExactMethod,
    FarField,
    Filter,
    Lens,
    Scene,
    Screen,
    Source,
)

Make = Callable[[Scene], Tracer]
Ways = Callable[[Case, torch.dtype], dict[str, list[Make]]]

LEDGER = {torch.float64: 1e-9, torch.float32: 1e-5}
# Image (L1), lost light, gradient (relative).
CLOSE = {
    torch.float64: np.array([1e-11, 1e-11, 1e-9]),
    torch.float32: np.array([1e-5, 1e-5, 1e-3]),
}


class Seen(NamedTuple):
    """What a tracer makes of a case, in float64."""

    flux: Array
    gradient: dict[str, Array]
    lost: Array
    sum: float


def ways(case: Case, dtype: torch.dtype) -> dict[str, list[Make]]:
    """Ways to trace a case, the reference first and then others of the same rays."""
    scene = case.scene
    net, source = ControlNet.of(scene.optic), scene.source

    def path(scene: Scene) -> Path:
        return Path.of(scene, net, dtype)

    made: list[Make] = [
        lambda scene: Reference(path(scene)),
        lambda scene: CompiledTrain(path(scene)),
    ]
    if isinstance(source, CollimatedSource):
        return {"collimated": made}
    if not isinstance(source.intersection, ExactMethod):
        made.pop()
    return {source.intersection.method: made}


class _Beams:
    """Beams of light as a tracer; they need no filter."""

    def __init__(self, plan: BeamPlan) -> None:
        self._plan, self.notes = plan, list(plan.notes)

    def image(self, heights: Mapping[str, torch.Tensor], filter: Filter) -> Light:
        return self._plan.trace(heights)


class _Rays(_Beams):
    """Rays of the source as a tracer."""

    def __init__(self, plan: Plan) -> None:
        self._plan, self.notes = plan, list(plan.notes)


def any_light(case: Case, dtype: torch.dtype) -> dict[str, list[Make]]:
    """Ways that serve any source, receiver and outline: reference and kernel, if there is one."""
    corners = Corners(*case.samples, case.origins)
    beams: list[Make] = [
        lambda scene, fused=fused: _Beams(BeamPlan(scene, corners, dtype=dtype, fused=fused))
        for fused in (False, True)
    ]
    rays: list[Make] = [
        lambda scene, fused=fused: _Rays(Plan(scene, dtype=dtype, fused=fused))
        for fused in (False, True)
    ]
    if _sampled_otherwise(case.scene.source):
        return {"beams": beams[:1], "fused beams": beams[1:], "rays": rays}
    return {"beams": beams, "rays": rays}


def _sampled_otherwise(source: Source) -> bool:
    """Whether the kernel has other beams than the reference.

    It knows the light of each cell of a straight beam.
    """
    straight_beam = isinstance(source, CollimatedSource) and source.along_axis
    return straight_beam and source.profile.kind == "gaussian"


def see(tracer: Tracer, scene: Scene, heights: Heights, cotangent: torch.Tensor) -> Seen:
    """Trace a lens, and its gradient for a cotangent of the image."""
    leaves = {face: each.clone().requires_grad_() for face, each in heights.items()}
    light = tracer.image(leaves, scene.filter)
    weighed = (light.flux * cotangent.to(light.flux.dtype)).sum()
    gradient = {face: np.zeros(each.shape) for face, each in heights.items()}
    if weighed.requires_grad:
        found = torch.autograd.grad(weighed, list(leaves.values()), allow_unused=True)
        parts = zip(leaves, found, strict=True)
        gradient |= {face: each.numpy() for face, each in parts if each is not None}
    flux = light.flux.detach().double().numpy()
    _, *lost = light.account.to_data().values()
    return Seen(flux, gradient, np.array(lost), sum(lost))


def sane(seen: Seen, dtype: torch.dtype) -> None:
    """Finite, not negative, and no light gained or lost."""
    assert np.isfinite(seen.flux).all()
    assert seen.flux.min() >= 0
    assert np.isfinite(_joined(seen)).all()
    assert np.isfinite(seen.lost).all()
    # Few samples close to a point make far too much light, and the side takes it back.
    largest = max(1, np.abs(seen.lost).max())
    assert seen.sum == pytest.approx(1, abs=LEDGER[dtype] * largest)


def as_near_as_rounding(case: Case, make: Make, one: Seen, other: Seen, dtype: torch.dtype) -> None:
    """Two traces agree within rounding, or as well as scenes do that differ by rounding.

    Rays on the edge of a pixel, or at the critical angle, make up the second case.
    """
    rounding = noise(case, dtype)
    apart = _distances(one, other, rounding)
    if (apart <= CLOSE[dtype]).all():
        return
    # All that neighbours differ by counts, be it below the noise: of several rays on edges each has
    # some moved, and a mirror moves all.
    near = [_distances(one, seen, 0) for seen in _neighbours(case, make, dtype)]
    allowed = CLOSE[dtype] + 8 * np.max(near, axis=0)
    assert (apart <= allowed).all(), f"apart by {apart}, rounding does {allowed}"


def noise(case: Case, dtype: torch.dtype) -> float:
    """Gradients below this are made of rounding: of great numbers that cancel.

    A height moves hits by the distance of the screen over that of control points.
    """
    optic, receiver, info = case.scene.optic, case.scene.receiver, torch.finfo(dtype)
    steepest = max(
        n / r
        for net in freeform_nets(optic).values()
        for n, r in zip(net.shape, net.half_width, strict=True)
    )
    pixels = max(n / r for n, r in zip(receiver.pixels, receiver.half_extent, strict=True))
    lever = (1 + max(receiver.per_radian(optic.front_z)) * steepest) * pixels
    largest = float(case.cotangent().abs().max())
    return lever * (100 * info.eps * largest + info.smallest_normal)


def _distances(one: Seen, other: Seen, noise: float) -> Array:
    """L1 of the images, the most of the lost light, and the relative L2 of the gradients."""
    first, second = _joined(one), _joined(other)
    size = max(np.linalg.norm(first), np.linalg.norm(second), 1e-300)
    return np.array(
        [
            np.abs(one.flux - other.flux).sum(),
            np.abs(one.lost - other.lost).max(),
            max(np.linalg.norm(first - second) - noise, 0) / size,
        ]
    )


def _joined(seen: Seen) -> Array:
    """The gradients of all faces in one row."""
    return np.concatenate([each.ravel() for each in seen.gradient.values()])


def _nudged(
    receiver: Screen | FarField, wide: tuple[float, float], nudge: tuple[float, float]
) -> AnyReceiver:
    """A receiver of other half-extents whose pixels are moved a little."""
    (r_x, r_y), (n_x, n_y), (x, y) = wide, receiver.pixels, receiver.center
    center = x - nudge[0] * 2 * r_x / n_x, y + nudge[1] * 2 * r_y / n_y
    if isinstance(receiver, Screen):
        receiver = receiver.model_copy(update={"position": (*center, receiver.z)})
    else:
        receiver = receiver.model_copy(update={"center": center})
    return receiver.model_copy(update={receiver.extent: wide})


def _moved(scene: Scene, signs: list[int]) -> Source:
    """The source a few roundings of the aperture aside, which matters to one right before it."""
    source, hair = scene.source, 4 * torch.finfo(torch.float64).eps
    if isinstance(source, CollimatedSource):
        if source.along_axis:
            return source
        about_x, about_y = source.direction
        tilted = about_x + 90 * hair * signs[0], about_y + 90 * hair * signs[1]
        return source.model_copy(update={"direction": tilted})
    x, y, z = source.place
    r_x, r_y = scene.optic.half_width
    return source.placed((x + signs[0] * hair * r_x, y + signs[1] * hair * r_y, z))


def _neighbours(case: Case, make: Make, dtype: torch.dtype) -> list[Seen]:
    """The same lens in scenes that differ from its own by some rounding."""
    scene, heights = case.scene, case.heights()
    rng = np.random.default_rng(case.seed)
    hair = 32 * torch.finfo(dtype).eps
    level, front = scene.optic.base.height, scene.optic.front_z
    deep = max((each - level).abs().max().item() for each in heights.values())
    thick = deep + abs(level - front)
    size = hair * thick
    size += 4 * torch.finfo(torch.float64).eps * abs(level)  # of the heights themselves
    found = []
    # Pixels move to each side, or apart and together.
    for *signs, growth in [*product((-1, 1), (-1, 1), (0,)), (0, 0, -1), (0, 0, 1)]:
        receiver = scene.receiver
        if receiver.at_distance:  # the way there is rounded, too, which counts where it leans
            receiver = receiver.moved_to(receiver.plane_z * (1 + hair * (signs[0] + growth)))
        wide = tuple(r * (1 + hair * growth) for r in receiver.half_extent)
        nudge = tuple(hair * m * sign for m, sign in zip(receiver.pixels, signs, strict=True))
        other = scene.with_receiver(_nudged(receiver, wide, nudge)).model_copy(
            update={"source": _moved(scene, signs)}
        )
        if isinstance(scene.optic, Lens):
            lens, wide = scene.optic, max(scene.optic.half_width)
            index = lens.index * (1 + hair * rng.uniform(0, 1))
            # A way through the glass is the difference of places, which are rounded.
            part = torch.finfo(dtype).eps * (1 + wide / thick)
            fading = lens.absorption * (1 + part * (signs[0] + growth))
            glass = {"material": CustomIndex(index=index), "absorption": fading}
            other = other.with_optic(lens.model_copy(update=glass))
        moved = {
            face: each + size * torch.as_tensor(rng.uniform(-1, 1, each.shape))
            for face, each in heights.items()
        }
        found.append(see(make(other), other, moved, case.cotangent()))
    return found


def on_creases(case: Case) -> bool:
    """Whether even rays meet a face of degree 1 where its slope jumps.

    They take that of one side or of the other, by the rounding of their place.
    """
    optic, source = case.scene.optic, case.scene.source
    samples = source.rays if isinstance(source, CollimatedSource) else case.samples
    on_spans = [
        places_of_points(samples, axis, source.point_count).part * (points - 1)
        for axis, points in enumerate(optic.control_points)
        if optic.degree[axis] == 1
    ]
    return any(np.isclose(place, place.round(), rtol=0, atol=1e-6).any() for place in on_spans)


def check_traces(case: Case, dtype: torch.dtype, by: Ways = ways) -> None:
    """Every way to trace a case is sane, and kernels agree with their reference."""
    scene = case.scene
    for way, makes in by(case, dtype).items():
        seen = [see(make(scene), scene, case.heights(), case.cotangent()) for make in makes]
        for one in seen:
            sane(one, dtype)
        if dtype is torch.float32 and nearly_touches(scene):
            continue  # no digits of it are left to agree in, and runs take float64
        if way in ("collimated", "samples", "rays") and on_creases(case):
            continue
        for other in seen[1:]:
            as_near_as_rounding(case, makes[0], seen[0], other, dtype)
