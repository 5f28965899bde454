"""What float64 can hold and what optics can mean: lengths against each other, refractive indices.

All lengths are judged by the lens. Within these limits no square overflows, not even in float32, no
height loses the digits that make its shape, and light of a point arrives.
"""

import math
from collections.abc import Callable, Iterable
from typing import Any

from workbench.errors import Refused
from workbench.messages import Message, Stated

LARGEST_INDEX = 10.0
"""No transparent material has a larger refractive index."""
HEIGHT = 1e6
"""Heights of the faces, at most, in half-widths of the lens."""
FAR = 1e9
"""Radii, and lengths on the screen's side, at most, in half-widths of the lens."""
DARKEST = 1e-6
"""Part of the light that the glass lets through, at least."""
FARTHEST, NEAREST = 1e12, 1e-10
"""Ways from a source, at most and at least, in half-widths of the lens."""

# Half-widths of the lens, scene units, and the smaller one over the larger one, at least.
_SMALLEST, _LARGEST, _SLIMMEST = 1e-6, 1e6, 1e-3


def check_width(half_width: tuple[float, float]) -> None:
    """Refuse an element that is too large, too small or too slim to compute with.

    Raises `Refused` with the half-width, and what is possible.
    """
    large = max(half_width)
    axis = half_width.index(large)
    if not _SMALLEST <= large <= _LARGEST:
        raise Refused(
            f"half_width[{axis}]",
            Message(
                "{large:g} cannot be computed with; from {least:g} to {most:g}, in another unit if "
                "need be",
                large=Stated(large),
                least=Stated(_SMALLEST),
                most=Stated(_LARGEST),
            ),
        )
    if half_width[1 - axis] < _SLIMMEST * large:
        raise Refused(
            f"half_width[{1 - axis}]",
            Message(
                "{half:g} makes the element slimmer than {most:g} to 1; at least {least:g}",
                half=Stated(half_width[1 - axis]),
                most=1 / _SLIMMEST,
                least=Stated(_SLIMMEST * large),
            ),
        )


def check_index(index: float) -> None:
    """Refuse a refractive index that no material has.

    Raises `Refused` with the index, and the largest.
    """
    if index > LARGEST_INDEX:
        raise Refused(
            "material",
            Message(
                "{index:g} is more than any material has; at most {most:g}",
                index=index,
                most=LARGEST_INDEX,
            ),
        )


def check_absorption(absorption: float, thickness: float) -> None:
    """Refuse glass that is as good as black in a lens of some thickness.

    Raises `Refused` with the absorption, and the largest.
    """
    if absorption * thickness > -math.log(DARKEST):
        raise Refused(
            "absorption",
            Message(
                "{absorption:g} leaves less than {least:g} of the light behind {thickness:g} of "
                "glass; at most {most:g}",
                absorption=absorption,
                least=DARKEST,
                thickness=thickness,
                most=-math.log(DARKEST) / thickness,
            ),
        )


def check_lengths(
    lengths: Iterable[tuple[str, float]], half_width: tuple[float, float], most: float
) -> None:
    """Refuse lengths that are too long for a lens.

    `lengths`: paths and values; `half_width`: half-widths of the lens; `most`: the longest, of
    either sign, in units of the larger half-width. Raises `Refused` with the first that is too
    long.
    """
    longest = most * max(half_width)
    for path, length in lengths:
        if abs(length) > longest:
            raise Refused(
                path,
                Message(
                    "{length:g} is too long beside a width of {width:g}; at most {most:g}",
                    length=Stated(length),
                    width=2 * max(half_width),
                    most=Stated(longest),
                ),
            )


def relative(factor: float) -> Callable[[dict[str, Any]], float]:
    """Default length: a multiple of the larger half-width (0 where that was refused)."""
    return lambda data: factor * max(data.get("half_width", (0.0,)))
