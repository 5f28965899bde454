"""Inspection of made parts: what each of them, and what all of them deviate from the design."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any, NamedTuple

import numpy as np

from workbench.analysis.cells.image import ACCURACY
from workbench.analysis.inspection.alignment import Alignment, aligned
from workbench.analysis.inspection.placement import DesignedFace
from workbench.analysis.inspection.relief import by_relief
from workbench.analysis.inspection.residual import Residual, residual_of
from workbench.analysis.inspection.starts import mean_plane, relief, thinned
from workbench.analysis.validation import validating
from workbench.analysis.validation_figures import Validation
from workbench.arrays import Array
from workbench.design.lens_state import FurtherLight
from workbench.design.session import Session, result_of
from workbench.errors import Refused
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import nets_of
from workbench.measured.surfaces import UNITS, MeasuredSurface
from workbench.messages import Message
from workbench.progress import Steps, of_equal, within
from workbench.scene import Scene
from workbench.units import WRITTEN

# Sizes of a measurement and of its relief, in those of the face, that need no other unit; sizes
# that speak for another unit. The relief of a part of a face, and of a face with its rim, differs.
_SIZES, _RELIEFS, _FITTING = (0.25, 3.0), (0.02, 20.0), (0.4, 2.5)
_FLAT = 1e-4  # relief in half-widths that says nothing of units
_FEW = 2000  # points that tell a size


class Units(NamedTuple):
    """Units of a measurement; None for that of the file, or else of the scene."""

    length: str | None = None
    heights: str | None = None  # by default as ``length``


AS_DESIGNED = Message("as designed")
"""Name of the lens as designed."""

AS_STATED = Units()
"""Units of the file, or else of the scene."""


@dataclass(frozen=True, eq=False)
class MeasuredPart:
    """A made part: where its measurement stands, and its residual."""

    name: str
    alignment: Alignment
    residual: Residual
    missing: int  # places of the file without a height

    def to_data(self, micrometre: float) -> dict[str, Any]:
        """The figures by name, for JSON; ``micrometre`` in scene units."""
        found, at = self.residual, self.alignment
        placement = at.placement
        return {
            "file": self.name,
            "points": len(found.offsets),
            "missing": self.missing,
            "spikes": found.spikes,
            "covered": found.covered,
            "rms_um": found.rms / micrometre,
            "peak_to_valley_um": found.peak_to_valley / micrometre,
            "slope_rms_mrad": 1e3 * found.slope_rms,
            "resolved_rms_um": found.resolved_rms / micrometre,
            "resolved_by": list(found.net.shape),
            "rest_rms_um": found.noise / micrometre,
            "rotation": placement.rotation.tolist(),
            "shift": placement.shift.tolist(),
            "scale": placement.scale,
            "turn_error_degrees": _listed(at.turn_error),
            "shift_error_um": _listed(at.shift_error / micrometre),
            "scale_error": at.scale_error,
        }


@dataclass(frozen=True, eq=False)
class Inspection:
    """Made parts beside the design of one of their faces."""

    scene: Scene
    heights: Mapping[str, Array]  # as designed, of all faces
    face: DesignedFace
    parts: tuple[MeasuredPart, ...]

    @property
    def micrometre(self) -> float:
        """A micrometre in scene units."""
        return float(WRITTEN["um"] / WRITTEN[self.scene.unit])

    @cached_property
    def repeating(self) -> Array:
        """What repeats: the mean of the resolved residuals, control heights (n_u, n_v)."""
        return np.asarray(np.mean([part.residual.on_design for part in self.parts], axis=0))

    @property
    def repeating_rms(self) -> float:
        """RMS of what repeats, scene units."""
        x, y, _ = self.face.samples.T
        return float(np.sqrt(np.square(self.face.net.at(x, y, self.repeating)[0]).mean()))

    @property
    def spread(self) -> float | None:
        """RMS by which parts differ from their mean, scene units; None for one part."""
        if len(self.parts) < 2:
            return None
        x, y, _ = self.face.samples.T
        each = [self.face.net.at(x, y, part.residual.on_design)[0] for part in self.parts]
        return float(np.sqrt(np.var(each, axis=0, ddof=1).mean()))

    def as_measured(self, part: MeasuredPart) -> FaceArrays[np.float64]:
        """Control heights of all faces, with this one as measured."""
        there = self.face.heights + part.residual.on_design
        return FaceArrays({**self.heights, self.face.name: there})

    @property
    def lenses(self) -> tuple[Mapping[str, Array], ...]:
        """Control heights of all faces as designed, and of each part as measured."""
        return (self.heights, *map(self.as_measured, self.parts))

    def corrected(self, made_from: Mapping[str, Array] | None = None) -> FaceArrays[np.float64]:
        """Control heights of all faces, with this one less what repeats.

        ``made_from`` are the heights that the measured parts were made from, if they are not the
        designed ones.
        """
        base = self.heights if made_from is None else made_from
        return FaceArrays({**base, self.face.name: base[self.face.name] - self.repeating})

    def to_data(self) -> dict[str, Any]:
        """The figures by name, for JSON."""
        return {
            "face": self.face.name,
            "unit": self.scene.unit,
            "parts": [part.to_data(self.micrometre) for part in self.parts],
            "spread_um": None if self.spread is None else self.spread / self.micrometre,
        }


def inspected(
    session: Session,
    surfaces: Iterable[tuple[str, MeasuredSurface]],
    face: str | None = None,
    unit: Units = AS_STATED,
    with_scale: bool = False,
) -> Inspection:
    """Align measured surfaces, by their names, to a face of the lens of a session.

    ``face`` is by default the designed face. Raise Refused if a surface does not fit.
    """
    scene, heights = session.scene, result_of(session).state.heights
    nets = nets_of(scene)
    name = face or scene.optic.designed_face
    if name not in nets:
        raise Refused(
            "face",
            Message("{face!r} is no freeform face; {known}", face=name, known=", ".join(nets)),
        )
    designed = DesignedFace.of(scene, heights[name], name)
    parts = tuple(
        _part(file, surface, scene, designed, unit, with_scale) for file, surface in surfaces
    )
    return Inspection(scene, heights, designed, parts)


def lighting(
    session: Session, lenses: Sequence[Mapping[str, Array]], rays: int = 4_000_000
) -> Steps[tuple[Validation, ...]]:
    """Check the light of lenses by their control heights, in steps."""
    found = []
    for number, heights in enumerate(lenses):
        steps = validating(session.scene, session.target, heights, rays, accuracy=ACCURACY)
        found.append((yield from within(steps, partial(of_equal, len(lenses), number))))
    return tuple(found)


def corrected_session(
    session: Session, heights: FaceArrays[np.float64], light: Validation
) -> Session:
    """Return a session with other control heights of its lens, and with their light."""
    first, *others = (each.by_cells or each for each in light.images)
    state = {
        "heights": heights,
        "irradiance": first.irradiance,
        "loss": first.loss,
        "account": first.account,
        "further": tuple(FurtherLight(one.irradiance, one.loss, one.account) for one in others),
        "shortfall": None,
    }
    return Session(
        session.scene,
        session.target,
        result_of(session).with_state(**state),
        session.locked,
        view=session.view,
        picture=session.picture,
    )


def _part(
    file: str,
    surface: MeasuredSurface,
    scene: Scene,
    face: DesignedFace,
    unit: Units,
    with_scale: bool,
) -> MeasuredPart:
    length = unit.length or surface.unit or scene.unit
    heights = unit.heights or length
    patches = [
        _in_scene(patch, scene, length, heights)
        for patch in surface.patches
        if _fits(patch, face, scene, length, heights, _SIZES, _RELIEFS)
    ]
    if not patches:
        largest = max(surface.patches, key=len)
        raise Refused(file, _other_units(largest, face, scene, length, heights))
    first = aligned(patches, face, file, with_scale)
    rough = residual_of(face, first.placement, first.patch, file)
    alignment = by_relief(first, face, rough.net)
    found = residual_of(face, alignment.placement, alignment.patch, file, rough.net)
    return MeasuredPart(file, alignment, found, surface.missing)


def _in_scene(points: Array, scene: Scene, length: str, heights: str) -> Array:
    along, up = (float(WRITTEN[each] / WRITTEN[scene.unit]) for each in (length, heights))
    return np.asarray(points * [along, along, up])


def _fits(
    points: Array,
    face: DesignedFace,
    scene: Scene,
    length: str,
    heights: str,
    sizes: tuple[float, float],
    reliefs: tuple[float, float],
) -> bool:
    """Whether size and relief of points in these units are about those of the face."""
    there = thinned(_in_scene(points, scene, length, heights), _FEW)
    size, height = (of(there) / max(of(face.samples), 1e-300) for of in (_extent, relief))
    is_flat = relief(face.samples) < _FLAT * max(face.net.half_width)
    return sizes[0] <= size <= sizes[1] and (is_flat or reliefs[0] <= height <= reliefs[1])


def _other_units(
    points: Array, face: DesignedFace, scene: Scene, length: str, heights: str
) -> Message:
    """What is wrong with units in which points do not fit, and which units fit."""
    pairs = [(each, each) for each in UNITS]
    pairs += [(length, each) for each in UNITS] + [(each, heights) for each in UNITS]
    for along, up in pairs:
        if _fits(points, face, scene, along, up, _FITTING, _FITTING):
            if along == up:
                return Message(
                    "it has another size than {face} in {old}; the unit {unit} fits",
                    face=face.name,
                    old=length,
                    unit=along,
                )
            return Message(
                "its heights do not fit {face} in {old}; lengths in {unit} and heights in {up} fit",
                face=face.name,
                old=heights,
                unit=along,
                up=up,
            )
    return Message(
        "it has another size or relief than {face}, and no unit fits; check part and face",
        face=face.name,
    )


def _extent(points: Array) -> float:
    centre, axes = mean_plane(points)
    return float(np.ptp((points - centre) @ axes[:, :2], axis=0).max())


def _listed(errors: Array) -> list[float | None]:
    return [float(error) if np.isfinite(error) else None for error in errors]
