"""The spectrum of a source: lines of light, each traced with its own refractive indices."""

from collections.abc import Iterable
from typing import TYPE_CHECKING, Annotated, NamedTuple

from pydantic import Field

from workbench.errors import Refused
from workbench.messages import Message

if TYPE_CHECKING:
    from workbench.scene.task import Scene

MOST_LINES = 16
"""Of a spectrum: each takes a trace of its own."""

Lines = tuple[tuple[Annotated[float, Field(gt=0)], Annotated[float, Field(ge=0)]], ...]


class Line(NamedTuple):
    """One line of the light of a scene."""

    scene: "Scene"  # the scene in light of one wavelength
    part: float  # the part of the flux that has it; the parts of all lines add up to 1


def lines_of(scene: "Scene") -> tuple[Line, ...]:
    """Return the lines of a scene; those of equal indices in all elements count as one."""
    spectrum = scene.source.spectrum
    if spectrum is None:
        return (Line(scene, 1.0),)
    alike: dict[tuple[float, ...], list[tuple[float, float]]] = {}
    for wavelength, part in spectrum:
        if part:
            indices = tuple(element.lit(wavelength).index for element in scene.elements)
            alike.setdefault(indices, []).append((wavelength, part))
    total = sum(part for _, part in spectrum)
    lines = []
    for found in alike.values():
        source = scene.source.model_copy(
            update={"wavelength_um": mean_wavelength(found), "spectrum": None}
        )
        part = sum(part for _, part in found) / total if len(alike) > 1 else 1.0
        lines.append(Line(scene.model_copy(update={"source": source}), part))
    return tuple(lines)


def mean_wavelength(spectrum: Iterable[tuple[float, float]]) -> float:
    """Return the mean wavelength of some lines, weighted by their flux."""
    lines = list(spectrum)
    if len(lines) == 1:
        return lines[0][0]
    return sum(each * part for each, part in lines) / sum(part for _, part in lines)


def check_spectrum(scene: "Scene") -> None:
    """Refuse a spectrum that makes no light, or for which a material has no data.

    Raises `Refused` with the path of the field in the scene, the value and what is allowed.
    """
    source, spectrum = scene.source, scene.source.spectrum
    if spectrum is None:
        return
    path = "source.spectrum"
    if source.wavelength_um is not None:
        both = Message(
            "given together with a wavelength of {wavelength:g} µm; one of both",
            wavelength=source.wavelength_um,
        )
        raise Refused(path, both)
    if not 1 <= len(spectrum) <= MOST_LINES:
        count = Message(
            "{count} lines are given; 1 to {most}", count=len(spectrum), most=MOST_LINES
        )
        raise Refused(path, count)
    if not any(part for _, part in spectrum):
        raise Refused(path, Message("all parts of the flux are 0; one above 0"))
    for number, (wavelength, _) in enumerate(spectrum):
        for element in scene.elements:
            try:
                _ = element.lit(wavelength).index
            except Refused as refused:
                if refused.path == "source.wavelength_um":  # else the material is refused later
                    raise Refused(f"{path}[{number}][0]", refused.reason) from None
