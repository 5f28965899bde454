"""How much light the stored colours of a picture are: by the file itself, or by a scene's tone.

A colour profile (ICC), or in a PNG the chunks sRGB or gAMA with cHRM, say what stored values mean.
Light is the luminance that a monitor with the white D65 shows: the weights of an sRGB profile are
those of Rec. 709.
"""

import struct
from collections.abc import Sequence
from functools import cache
from io import BytesIO
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import numpy.typing as npt
from PIL import Image

from workbench.arrays import Array
from workbench.said import Said
from workbench.targets.tone import SRGB, Tone

if TYPE_CHECKING:
    from PIL.ImageCms import ImageCmsProfile, ImageCmsTransform

REC_709 = np.array([0.2126, 0.7152, 0.0722])
"""Luminance weights of red, green and blue."""

# Luminance for a monitor of white D65, of X, Y and Z in the white D50 of profiles: a row of the
# Bradford transform (Lindbloom, Chromatic Adaptation).
_TO_D65 = np.array([-0.0282895, 1.0099416, 0.0210077])
_D50 = (0.9642, 1.0, 0.8249)
_ALIKE = 0.01  # of the largest value: nobody sees less
_DEEP = 65535.0
_HDR_VIDEO = 16, 18  # PQ and HLG, by ITU-T H.273
_LAB_LIGHT, _LAB_STRAIGHT = 8.0, 903.3  # below that lightness, CIE 1976 is straight


class Colour(NamedTuple):
    """Relation of stored colours and light.

    Attributes
    ----------
    tone : Tone
        Of greys.
    tones : sequence of Tone
        Of red, green and blue.
    weights : ndarray, shape (3,)
        Luminance of red, green and blue.
    transform : ImageCmsTransform, optional
        In place of these where a profile is more than that.
    mode : str
        In which a transform takes an image.
    remarks : tuple of Said
        What a person should know of it.
    """

    tone: Tone
    tones: Sequence[Tone]
    weights: Array
    transform: "ImageCmsTransform | None" = None
    mode: str = "RGB"
    remarks: tuple[Said, ...] = ()

    @classmethod
    def plain(cls, tone: Tone, weights: Array = REC_709) -> "Colour":
        """Colours of one tone."""
        return cls(tone, (tone,) * 3, weights)

    @classmethod
    def of(cls, image: Image.Image, tone: Tone) -> "Colour":
        """Colours of an image: as it says itself, else of a tone."""
        plain = cls.plain(tone)
        try:
            found, statement = _stated(image)
        except Exception as error:  # whatever a damaged profile makes its readers stumble over
            broken = Said(
                "has a colour profile that cannot be used ({why}); "
                "“Brightness” (target.tone) counts",
                why=" ".join(str(error).split()),
            )
            return plain._replace(remarks=(broken,))
        if found is None or found.is_like(plain):
            return plain
        stated = Said(
            "has {statement}, which counts in place of “Brightness” (target.tone)",
            statement=statement,
        )
        return found._replace(remarks=(stated,))

    def is_like(self, other: "Colour") -> bool:
        """Whether nobody would see a difference."""
        values = np.linspace(0.0, 1.0, 33)
        pairs = zip((self.tone, *self.tones), (other.tone, *other.tones), strict=True)
        apart = [np.abs(one.light(values) - two.light(values)).max() for one, two in pairs]
        apart.append(np.abs(self.weights - other.weights).max())
        return self.transform is None and max(apart) < _ALIKE

    def light(self, image: Image.Image) -> Array:
        """Light of an image without transparency, shape (rows, columns)."""
        if self.transform is not None:
            return _deep(self.transform, image.convert(self.mode))
        if image.mode in ("1", "L"):
            return _light_of(np.asarray(image.convert("L")), self.tone)
        # Channel by channel: three of them as floats take eight times the memory of the picture.
        grey = np.zeros((image.height, image.width))
        channels = image.convert("RGB").split()
        for channel, tone, weight in zip(channels, self.tones, self.weights, strict=True):
            grey += weight * _light_of(np.asarray(channel), tone)
        return grey


def luminance_weights(primaries: Sequence[Sequence[float]], white: Sequence[float]) -> Array:
    """Luminance of red, green and blue, together 1, from their chromaticities x, y.

    Raises
    ------
    ValueError
        If these are the primaries of no light.
    """
    columns = np.array([(x / y, 1.0, (1 - x - y) / y) for x, y in (*primaries, white)]).T
    weights: Array = np.linalg.solve(columns[:, :3], columns[:, 3])
    if not (np.isfinite(weights).all() and weights.min() > 0):
        raise ValueError("its primaries are no colours of light")
    return weights


def grey_of_lab(lightness: npt.NDArray[np.uint8]) -> Array:
    """Light of a lightness L* of CIE 1976, in 255ths of its largest value."""
    full = 100 * (np.arange(256) / 255.0)
    light = np.where(full > _LAB_LIGHT, ((full + 16) / 116) ** 3, full / _LAB_STRAIGHT)
    found: Array = light[lightness]
    return found


def _light_of(stored: npt.NDArray[np.uint8], tone: Tone) -> Array:
    return tone.light(np.arange(256) / 255.0)[stored]


def _stated(image: Image.Image) -> tuple[Colour | None, str]:
    """What an image says of its colours, and by what; None where it says nothing."""
    info = image.info
    if content := info.get("icc_profile"):
        return _of_profile(image, content)
    if info.get("nclx_profile", {}).get("transfer_characteristics") in _HDR_VIDEO:
        raise ValueError("its values are those of HDR video")
    if image.format != "PNG":
        return None, ""
    if "srgb" in info:
        return Colour.plain(SRGB), Said("a chunk sRGB")
    if (gamma := info.get("gamma")) is None:
        return None, ""
    if not 0 < gamma < 100:
        raise ValueError(f"gAMA {gamma:g}")
    weights = REC_709
    if "chromaticity" in info:
        x_white, y_white, *rest = info["chromaticity"]
        primaries = list(zip(rest[::2], rest[1::2], strict=True))
        weights = luminance_weights(primaries, (x_white, y_white))
    return Colour.plain(Tone.power(1 / gamma), weights), Said(
        "a chunk gAMA of {gamma:.4g}", gamma=gamma
    )


def _of_profile(image: Image.Image, content: bytes) -> tuple[Colour, str]:
    from PIL import ImageCms  # late: few pictures have a profile

    profile = ImageCms.getOpenProfile(BytesIO(content))
    name = " ".join((profile.profile.profile_description or "").split()) or "ICC"
    statement = Said("the colour profile “{name}”", name=name)
    space = profile.profile.xcolor_space.strip()
    is_grey = image.mode in ("1", "L", "LA", "La") or image.mode.startswith("I;16")
    fits = {
        "GRAY": is_grey,
        "RGB": image.mode != "CMYK",
        "CMYK": image.mode == "CMYK",
    }
    if not fits.get(space, False):
        raise ValueError(f"it is for {space}, and the picture has {image.mode}")
    if space == "GRAY":
        ramp = Image.fromarray(np.arange(65536, dtype=np.uint16).reshape(256, 256))
        light = _deep(_to_light(profile, "I;16"), ramp).ravel()
        return Colour.plain(_rising(light)), statement
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
    tones = [_rising(light) for light in _deep(transform, Image.fromarray(ramps))]
    values = np.linspace(0.0, 1.0, 256)
    greys = Tone.measured(weights @ np.array([tone.light(values) for tone in tones]))
    return Colour(greys, tones, weights), statement


def _transformed(transform: "ImageCmsTransform", mode: str) -> Colour:
    """Colours of a profile that is more than tones and weights."""
    if mode == "CMYK":
        greys = np.zeros((1, 256, 4), dtype=np.uint8)
        greys[0, :, 3] = np.arange(256)[::-1]
        ramp = Image.frombytes("CMYK", (256, 1), greys.tobytes())
    else:
        ramp = Image.fromarray(np.repeat(np.arange(256, dtype=np.uint8)[None, :, None], 3, axis=2))
    tone = _rising(_deep(transform, ramp)[0])
    return Colour.plain(tone)._replace(transform=transform, mode=mode)


def _rising(light: Array) -> Tone:
    """Tone of a ramp of light, relative to its end."""
    light = np.maximum.accumulate(light)
    if not light[-1] > 0:
        raise ValueError("its white is black")
    return Tone.measured(light / light[-1])


def _to_light(profile: "ImageCmsProfile", mode: str) -> "ImageCmsTransform":
    from PIL import ImageCms

    linear = ImageCms.getOpenProfile(BytesIO(_linear_grey_profile()))
    intent = ImageCms.Intent.RELATIVE_COLORIMETRIC
    # The darkest ink is black, as on a monitor: a black ground gets no light.
    flags = ImageCms.Flags.BLACKPOINTCOMPENSATION
    return ImageCms.buildTransform(profile, linear, mode, "I;16", intent, flags)


def _deep(transform: "ImageCmsTransform", image: Image.Image) -> Array:
    """Light of an image by a transform, in 65535ths."""
    return np.asarray(transform.apply(image)) / _DEEP


@cache
def _linear_grey_profile() -> bytes:
    """A profile whose grey values are luminance, to which a colour engine transforms; ICC.1:2001.

    Pillow has none whose result has more than 8 bits.
    """

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
