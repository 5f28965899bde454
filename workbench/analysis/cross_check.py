"""Two tracers that share nothing, on one lens: the independent check and Mitsuba 3."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from workbench.analysis.focus import through_focus
from workbench.analysis.metrics import product, relative_l2, root
from workbench.analysis.mitsuba import MitsubaScene
from workbench.analysis.scatter import CorrectedDistance
from workbench.arrays import Array
from workbench.errors import RunFailed
from workbench.geometry.as_made import AsMade
from workbench.geometry.body import check_body
from workbench.messages import Message
from workbench.progress import Progress, fraction_of, no_progress
from workbench.scene import Lens, Scene
from workbench.scene.losses import TakesLight

# Standard deviations that hold 95 %.
_95 = 1.96


@dataclass(frozen=True)
class TracerResult:
    """What one tracer says of a lens."""

    # Error against the target, with and without the scatter of the rays, as in `Validation`.
    relative_l2: float
    relative_l2_corrected: float
    efficiency: float  # part of the emitted flux that lands on the screen
    # (n_y, n_x), flux per area on the screen, row 0 at +y, of all emitted flux together 1.
    irradiance: Array

    def to_data(self) -> dict[str, float]:
        """The figures by name, for JSON."""
        return {
            "relative_l2": self.relative_l2,
            "relative_l2_corrected": self.relative_l2_corrected,
            "efficiency": self.efficiency,
        }


@dataclass(frozen=True)
class CrossCheck:
    """How far apart the images of two tracers are; both are divided by their sums."""

    difference: float  # ‖M − O‖ / ‖O‖ of Mitsuba's image M and our image O
    noise: float  # what it would be on the scatter of the rays alone, from two halves of each image
    # The same difference without the scatter: the root of ⟨M₁ − O₁, M₂ − O₂⟩ / ‖O‖², where 1 and 2
    # are the halves. Their scatter is independent and falls out; a negative one counts as 0.
    difference_corrected: float
    # Where that lies with 95 % confidence, pixels scattering independently.
    difference_corrected_interval: tuple[float, float]
    # What each of them says of the lens.
    ours: TracerResult
    mitsuba: TracerResult
    rays: int  # rays of each
    # What of the lens both are without, since Mitsuba does not have it; see `bare_and_clear`.
    left_out: tuple[str, ...] = ()

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON."""
        return {
            "difference": self.difference,
            "noise": self.noise,
            "difference_without_noise": self.difference_corrected,
            "difference_corrected": self.difference_corrected,  # its name in files of before
            "difference_corrected_interval": list(self.difference_corrected_interval),
            "ours": self.ours.to_data(),
            "mitsuba": self.mitsuba.to_data(),
            "rays": self.rays,
            "left_out": list(self.left_out),
        }


def cross_check(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    rays: int = 4_000_000,
    seed: int = 1,
    progress: Progress = no_progress,
) -> CrossCheck:
    """Trace a lens by our independent tracer and by Mitsuba, and compare.

    Mitsuba takes Fresnel's equations for unpolarised light; where the scene takes Schlick's
    approximation, the difference is in the result. In both what is reflected is lost. Coatings,
    other laws of reflection, fields of a lens that take light, and relief of manufacture are left
    out of both.

    `rays`: rays for each of the two, at least. Raises `Refused` if Mitsuba is not installed, pixels
    are not square, or the lens is no body; `RunFailed` if no light reaches the screen.
    """
    scene.check_one_image("the comparison with Mitsuba")
    check_body(scene, heights)
    scene, left_out = bare_and_clear(scene)
    made = AsMade.of(scene)
    scene, heights = made.scene, made.heights(heights)
    left_out += ("relief of manufacture",) if made.reliefs else ()
    theirs = [(line.part, MitsubaScene(line.scene, heights)) for line in scene.lines]
    half, measure = -(-rays // 2), scene.receiver.pixel_measure
    light = {
        "mitsuba": [
            _by_mitsuba(theirs, half, seed + k, fraction_of(progress, k, 1, 4)) for k in (0, 1)
        ],
        "ours": [
            through_focus(
                scene,
                heights,
                None,
                half,
                seed + k,
                progress=fraction_of(progress, 2 + k, 1, 4),
            )[0]
            * measure
            for k in (0, 1)
        ],
    }
    if not all(image.sum() > 0 for images in light.values() for image in images):
        dark = Message("no light of this lens reaches the screen, so there is nothing to compare")
        raise RunFailed(dark)
    (m_1, m_2), (o_1, o_2) = ([i / i.sum() for i in images] for images in light.values())
    size = _norm((o_1 + o_2) / 2)
    products = (m_1 - o_1) * (m_2 - o_2) / size**2
    square, error = float(products.sum()), _norm(products - products.mean())
    corrected = CorrectedDistance.of_square(square, error, _95)
    return CrossCheck(
        difference=_norm(m_1 + m_2 - o_1 - o_2) / (2 * size),
        noise=math.hypot(_norm(m_1 - m_2), _norm(o_1 - o_2)) / (2 * size),
        difference_corrected=corrected.distance,
        difference_corrected_interval=corrected.interval,
        ours=_seen(light["ours"], target, measure),
        mitsuba=_seen(light["mitsuba"], target, measure),
        rays=2 * half,
        left_out=left_out,
    )


def _by_mitsuba(
    lines: Sequence[tuple[float, MitsubaScene]], rays: int, seed: int, progress: Progress
) -> Array:
    """The image of all lines of the light, each with its part of the flux and as many rays."""
    count, images = len(lines), []
    for number, (part, scene) in enumerate(lines):
        each = scene.flux(
            -(-rays // count), seed + 2 * number, fraction_of(progress, number, 1, count)
        )
        images.append(part * each)
    return np.asarray(sum(images[1:], images[0]))


def bare_and_clear(scene: Scene) -> tuple[Scene, tuple[str, ...]]:
    """The scene without what Mitsuba's glass cannot have, and what that was.

    Faces are bare and reflect by Fresnel's equations, and its light tracer knows no media.
    """
    elements, left_out = [], []
    for element in scene.elements:
        if isinstance(element, Lens):
            element, without = _bare_and_clear(element)
            left_out += [name for name in without if name not in left_out]
        elements.append(element)
    return scene.model_copy(update={"elements": tuple(elements)}), tuple(left_out)


def _bare_and_clear(lens: Lens) -> tuple[Lens, list[str]]:
    lossy = [field.name for field in lens.fields() if field.mark(TakesLight)]
    without = {name: Lens.model_fields[name].default for name in lossy}
    left_out = [name for name in lossy if getattr(lens, name) != without[name]]
    if lens.coating is not None or lens.reflection not in ("fresnel", "schlick"):
        without |= {"coating": None, "reflection": "fresnel"}
        left_out.insert(0, "reflectance of the faces" if lens.coating is None else "coating")
    return lens.model_copy(update=without), left_out


def _seen(halves: list[Array], target: Array, measure: float | Array) -> TracerResult:
    image = (halves[0] + halves[1]) / 2
    return TracerResult(
        relative_l2=relative_l2(image, target),
        relative_l2_corrected=root(product(halves[0], halves[1], target)),
        efficiency=float(image.sum()),
        irradiance=image / measure,
    )


def _norm(image: Array) -> float:
    return math.sqrt(float(np.square(image).sum()))
