"""Conversion of stored picture values to light, by the picture file or by the scene's tone.

A colour profile (ICC), or in a PNG the chunks sRGB or gAMA with cHRM, defines stored values. Light
is the luminance on a monitor with the white point D65: the weights of an sRGB profile are those of
Rec. 709.
"""

import struct
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from io import BytesIO
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import numpy.typing as npt
from PIL import Image

from workbench.arrays import Array
from workbench.messages import Message

if TYPE_CHECKING:
    from PIL.ImageCms import ImageCmsProfile, ImageCmsTransform

# sRGB: linear below these stored and light values.
_STRAIGHT_SHADE, _STRAIGHT_LIGHT, _STEEPNESS = 0.04045, 0.0031308, 12.92
_OFFSET, _POWER = 0.055, 2.4
REC_709 = np.array([0.2126, 0.7152, 0.0722])
"""Luminance weights of red, green and blue."""
# Luminance for white point D65 of X, Y and Z for white point D50 (of profiles): a row of the
# Bradford transform (Lindbloom, Chromatic Adaptation).
_TO_D65 = np.array([-0.0282895, 1.0099416, 0.0210077])
_D50 = (0.9642, 1.0, 0.8249)
_INVISIBLE = 0.01  # difference relative to the largest value
_DEEP = 65535.0
_HDR_VIDEO = 16, 18  # PQ and HLG, by ITU-T H.273
_LAB_LIGHT, _LAB_STRAIGHT = 8.0, 903.3  # CIE 1976 is linear below this lightness


@dataclass(frozen=True)
class Tone:
    """Monotonic relation of stored values and light, both in [0, 1].

    ``name`` is that of ``target.tone`` or of a file's statement; ``stored`` is the inverse of
    ``light``.
    """

    name: str
    light: Callable[[Array], Array]
    stored: Callable[[Array], Array]

    @classmethod
    def power(cls, exponent: float) -> "Tone":
        """Light is a power of the stored value."""
        return cls(
            f"power {exponent:g}",
            lambda stored: stored**exponent,
            lambda light: light ** (1 / exponent),
        )

    @classmethod
    def measured(cls, light: Array) -> "Tone":
        """Tone that interpolates light (values,) at equally spaced stored values; monotonic."""
        stored = np.linspace(0.0, 1.0, len(light))
        return cls(
            "measured",
            lambda values: np.interp(values, stored, light),
            lambda values: np.interp(values, light, stored),
        )


def _identity(values: Array) -> Array:
    return values


def _light_of_srgb(stored: Array) -> Array:
    power = ((stored + _OFFSET) / (1 + _OFFSET)) ** _POWER
    return np.where(stored <= _STRAIGHT_SHADE, stored / _STEEPNESS, power)


def _srgb_of_light(light: Array) -> Array:
    power = (1 + _OFFSET) * light ** (1 / _POWER) - _OFFSET
    return np.where(light <= _STRAIGHT_LIGHT, light * _STEEPNESS, power)


LINEAR = Tone("linear", _identity, _identity)
"""The stored value is the light."""

NUMBERS = Tone("linear", _identity, _identity)
"""The stored value is the light, without an upper limit: tones of monitors do not apply."""

SRGB = Tone("srgb", _light_of_srgb, _srgb_of_light)
"""Light of a monitor for the stored value; IEC 61966-2-1."""

TONES = {tone.name: tone for tone in (LINEAR, SRGB)}


class Colour(NamedTuple):
    """Conversion of stored colours to light.

    ``tone`` holds for greys, ``tones`` for red, green and blue, with their luminance ``weights``
    (3,). A ``transform``, which expects images of ``mode``, replaces these for a complex profile.
    """

    tone: Tone
    tones: Sequence[Tone]
    weights: Array
    transform: "ImageCmsTransform | None" = None
    mode: str = "RGB"
    remarks: tuple[Message, ...] = ()

    @classmethod
    def plain(cls, tone: Tone, weights: Array = REC_709) -> "Colour":
        """Conversion with one tone for all channels."""
        return cls(tone, (tone,) * 3, weights)

    @classmethod
    def of(cls, image: Image.Image, tone: Tone) -> "Colour":
        """Conversion by the image itself, else by a tone."""
        plain = cls.plain(tone)
        try:
            found, statement = _declared(image)
        except Exception as error:  # damaged profiles raise any exception
            broken = Message(
                "has a colour profile that cannot be used ({why}); "
                "“Brightness” (target.tone) counts",
                why=" ".join(str(error).split()),
            )
            return plain._replace(remarks=(broken,))
        if found is None or found.is_like(plain):
            return plain
        stated = Message(
            "has {statement}, which counts in place of “Brightness” (target.tone)",
            statement=statement,
        )
        return found._replace(remarks=(stated,))

    def is_like(self, other: "Colour") -> bool:
        """Whether the difference of two conversions is invisible."""
        values = np.linspace(0.0, 1.0, 33)
        pairs = zip((self.tone, *self.tones), (other.tone, *other.tones), strict=True)
        apart = [np.abs(one.light(values) - two.light(values)).max() for one, two in pairs]
        apart.append(np.abs(self.weights - other.weights).max())
        return self.transform is None and max(apart) < _INVISIBLE

    def light(self, image: Image.Image) -> Array:
        """Return the light (rows, columns) of an opaque image."""
        if self.transform is not None:
            return _deep(self.transform, image.convert(self.mode))
        if image.mode in ("1", "L"):
            return _light_of(np.asarray(image.convert("L")), self.tone)
        # Channel by channel: all three as floats take eight times the memory of the picture.
        grey = np.zeros((image.height, image.width))
        channels = image.convert("RGB").split()
        for channel, tone, weight in zip(channels, self.tones, self.weights, strict=True):
            grey += weight * _light_of(np.asarray(channel), tone)
        return grey


def luminance_weights(primaries: Sequence[Sequence[float]], white: Sequence[float]) -> Array:
    """Return luminance weights of primaries, with a sum of 1, from chromaticities x, y.

    Raise ValueError if no light has such primaries.
    """
    columns = np.array([(x / y, 1.0, (1 - x - y) / y) for x, y in (*primaries, white)]).T
    weights: Array = np.linalg.solve(columns[:, :3], columns[:, 3])
    if not (np.isfinite(weights).all() and weights.min() > 0):
        raise ValueError("its primaries are no colours of light")
    return weights


def grey_of_lab(lightness: npt.NDArray[np.uint8]) -> Array:
    """Return the light of a lightness L* of CIE 1976, stored in 255ths of its maximum."""
    full = 100 * (np.arange(256) / 255.0)
    light = np.where(full > _LAB_LIGHT, ((full + 16) / 116) ** 3, full / _LAB_STRAIGHT)
    found: Array = light[lightness]
    return found


def _light_of(stored: npt.NDArray[np.uint8], tone: Tone) -> Array:
    return tone.light(np.arange(256) / 255.0)[stored]


def _declared(image: Image.Image) -> tuple[Colour | None, str]:
    info = image.info
    if content := info.get("icc_profile"):
        return _of_profile(image, content)
    if info.get("nclx_profile", {}).get("transfer_characteristics") in _HDR_VIDEO:
        raise ValueError("its values are those of HDR video")
    if image.format != "PNG":
        return None, ""
    if "srgb" in info:
        return Colour.plain(SRGB), Message("a chunk sRGB")
    if (gamma := info.get("gamma")) is None:
        return None, ""
    if not 0 < gamma < 100:
        raise ValueError(f"gAMA {gamma:g}")
    weights = REC_709
    if "chromaticity" in info:
        x_white, y_white, *rest = info["chromaticity"]
        primaries = list(zip(rest[::2], rest[1::2], strict=True))
        weights = luminance_weights(primaries, (x_white, y_white))
    return Colour.plain(Tone.power(1 / gamma), weights), Message(
        "a chunk gAMA of {gamma:.4g}", gamma=gamma
    )


def _of_profile(image: Image.Image, content: bytes) -> tuple[Colour, str]:
    from PIL import ImageCms  # few pictures have a profile

    profile = ImageCms.getOpenProfile(BytesIO(content))
    name = " ".join((profile.profile.profile_description or "").split()) or "ICC"
    statement = Message("the colour profile “{name}”", name=name)
    space = profile.profile.xcolor_space.strip()
    is_grey = image.mode in ("1", "L", "LA", "La") or image.mode.startswith("I;16")
    fits = {"GRAY": is_grey, "RGB": image.mode != "CMYK", "CMYK": image.mode == "CMYK"}
    if not fits.get(space, False):
        raise ValueError(f"it is for {space}, and the picture has {image.mode}")
    if space == "GRAY":
        ramp = Image.fromarray(np.arange(65536, dtype=np.uint16).reshape(256, 256))
        light = _deep(_to_light(profile, "I;16"), ramp).ravel()
        return Colour.plain(_measured_tone(light)), statement
    if space == "CMYK":
        return _transformed(_to_light(profile, "CMYK"), "CMYK"), statement
    transform = _to_light(profile, "RGB")
    core = profile.profile
    intent = ImageCms.Intent.RELATIVE_COLORIMETRIC
    if not core.is_matrix_shaper or any((core.clut or {}).get(intent, ())[:1]):
        return _transformed(transform, "RGB"), statement
    colorants = core.red_colorant, core.green_colorant, core.blue_colorant
    weights = np.array([_TO_D65 @ np.array(each[0]) for each in colorants if each is not None])
    if weights.shape != (3,):
        raise ValueError("it has no colorants")
    ramps = np.zeros((3, 256, 3), dtype=np.uint8)
    for channel in range(3):
        ramps[channel, :, channel] = np.arange(256)
    tones = [_measured_tone(light) for light in _deep(transform, Image.fromarray(ramps))]
    values = np.linspace(0.0, 1.0, 256)
    greys = Tone.measured(weights @ np.array([tone.light(values) for tone in tones]))
    return Colour(greys, tones, weights), statement


def _transformed(transform: "ImageCmsTransform", mode: str) -> Colour:
    if mode == "CMYK":
        greys = np.zeros((1, 256, 4), dtype=np.uint8)
        greys[0, :, 3] = np.arange(256)[::-1]
        ramp = Image.frombytes("CMYK", (256, 1), greys.tobytes())
    else:
        ramp = Image.fromarray(np.repeat(np.arange(256, dtype=np.uint8)[None, :, None], 3, axis=2))
    tone = _measured_tone(_deep(transform, ramp)[0])
    return Colour.plain(tone)._replace(transform=transform, mode=mode)


def _measured_tone(light: Array) -> Tone:
    light = np.maximum.accumulate(light)
    if not light[-1] > 0:
        raise ValueError("its white is black")
    return Tone.measured(light / light[-1])


def _to_light(profile: "ImageCmsProfile", mode: str) -> "ImageCmsTransform":
    from PIL import ImageCms

    linear = ImageCms.getOpenProfile(BytesIO(_linear_grey_profile()))
    intent = ImageCms.Intent.RELATIVE_COLORIMETRIC
    # The darkest ink maps to zero light, as on a monitor.
    flags = ImageCms.Flags.BLACKPOINTCOMPENSATION
    return ImageCms.buildTransform(profile, linear, mode, "I;16", intent, flags)


def _deep(transform: "ImageCmsTransform", image: Image.Image) -> Array:
    return np.asarray(transform.apply(image)) / _DEEP


@cache
def _linear_grey_profile() -> bytes:
    # Grey values of this profile (ICC.1:2001) are luminance; pillow has no profile whose result has
    # more than 8 bits.

    def place(*xyz: float) -> bytes:
        return struct.pack(">4s4x3i", b"XYZ ", *(round(value * 65536) for value in xyz))

    name = b"Linear grey\0"
    parts = {
        b"desc": struct.pack(">4s4xI", b"desc", len(name)) + name + bytes(78),
        b"cprt": b"text\0\0\0\0none\0",
        b"wtpt": place(*_D50),
        b"kTRC": struct.pack(">4s4xI", b"curv", 0),  # no value: the identity
    }
    table, content, begin = b"", b"", 128 + 4 + 12 * len(parts)
    for tag, part in parts.items():
        table += struct.pack(">4s2I", tag, begin + len(content), len(part))
        content += part + bytes(-len(part) % 4)
    header = struct.pack(
        ">I4xI4s4s4s12x4s28x12s48x",
        begin + len(content),
        0x02400000,
        b"mntr",
        b"GRAY",
        b"XYZ ",
        b"acsp",
        place(*_D50)[8:],
    )
    return header + struct.pack(">I", len(parts)) + table + content
