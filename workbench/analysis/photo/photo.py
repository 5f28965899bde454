"""The image on the screen as a camera would see it, in colour.

Each wavelength is traced by the independent check with the indices of the materials there: by
cells, or by random rays for very many points of the source and behind a diffuser. The source has
its size, and faces reflect as much as they do at these indices. What is left out: diffraction,
light that is reflected within the lens, and the optics of the camera itself.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import partial
from itertools import count, pairwise
from typing import BinaryIO

import numpy as np
import numpy.typing as npt
from PIL import Image

from workbench.analysis.cells.image import Levels
from workbench.analysis.photo.light import (
    LONGEST,
    SHORTEST,
    Illuminant,
    encoded,
    light_of,
    luminance,
)
from workbench.analysis.tracing.elements import joined
from workbench.analysis.tracing.pose import Pose
from workbench.analysis.tracing.sources.sampling import BATCHES
from workbench.analysis.tracing.trace import Trace, added
from workbench.analysis.tracing.train import OpticalTrain, Tally
from workbench.arrays import Array, Mask
from workbench.errors import RunFailed
from workbench.geometry.as_made import scatterer_of
from workbench.geometry.body import check_body
from workbench.materials import CATALOGUE, Material
from workbench.messages import Message
from workbench.powers import written
from workbench.progress import Progress, Steps, finished, no_progress, of_equal, within
from workbench.scene import CustomIndex, Lens, Scene
from workbench.scene.image import as_viewed, side_in_words, viewed_from

_ACCURACY = 0.02  # relative change by halved cells, which is invisible in 256 steps
_EACH, _MOST_RAYS = 256, 1 << 24  # random rays for each pixel, and at most for a wavelength
_PROBES, _PART = 1 << 13, 0.99  # rays for the distance of colours, and its quantile
_FEWEST, _MOST = 3, 32


@dataclass(frozen=True, eq=False)
class Photo:
    """A predicted photo."""

    rgb: Array  # (n_y, n_x, 3), linear sRGB for the viewer, flux per area of a source of flux 1
    white: float  # irradiance of white: of the target's brightest pixel at the flux of the image
    aspect: float  # width of a pixel over its height
    light: Illuminant
    wavelengths_um: tuple[float, ...]  # what was traced
    step: float  # distance of the images of neighbouring wavelengths, pixels
    by_cells: bool  # else by random rays
    side: Message  # of the camera

    def picture(self, stops: float = 0.0) -> npt.NDArray[np.uint8]:
        """Return values (n_y, n_x, 3) of an sRGB file; each stop of exposure doubles the light."""
        return encoded(self.rgb * (2.0**stops / self.white))

    @property
    def summary(self) -> Message:
        """Method of the prediction in a line."""
        way = Message("with cells") if self.by_cells else Message("with random rays")
        light = self.light.title
        if len(self.wavelengths_um) == 1:
            return Message(
                "{side}; {light}, no dispersion known, {way}", side=self.side, light=light, way=way
            )
        first, *_, last = self.wavelengths_um
        return Message(
            "{side}; {light}, {count} wavelengths from {first:g} to {last:g} µm, {step} pixels "
            "apart, {way}",
            side=self.side,
            light=light,
            count=len(self.wavelengths_um),
            first=first,
            last=last,
            step=written(self.step, digits=2),
            way=way,
        )


def photograph(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    light: Illuminant | None = None,
    progress: Progress = no_progress,
) -> Photo:
    """Predict the photo of the image of a lens; ``light`` is by default `light_of` the scene.

    Raises `Refused` for several images or a lens that is no solid body; `RunFailed` without light.
    """
    return finished(photographing(scene, target, heights, light), progress)


def photographing(
    scene: Scene,
    target: Array,
    heights: Mapping[str, Array],
    light: Illuminant | None = None,
    threads: int | None = None,
) -> Steps[Photo]:
    """`photograph` in steps."""
    scene.check_one_image("the predicted photo")
    check_body(scene, heights)
    light = light or light_of(scene)
    wavelengths, step = _wavelengths(scene, heights, light)
    weights = light.weights(wavelengths)
    rgb, tracer = np.zeros((*target.shape, 3)), _Tracer(heights, threads)
    for done, (wavelength, weight) in enumerate(zip(wavelengths.tolist(), weights, strict=True)):
        lit = at_wavelength(scene, wavelength)
        if done == 0 or lit is not scene:  # else all wavelengths make the same image
            steps = tracer.trace(lit)
            image = yield from within(steps, partial(of_equal, len(wavelengths), done))
        rgb += (image / scene.receiver.pixel_measure)[..., None] * weight
    if not rgb.any():
        dark = Message("no light of this lens reaches the screen, so there is nothing to see")
        raise RunFailed(dark)
    receiver, wanted = scene.receiver, target / target.max()
    white = receiver.total(luminance(rgb)) / receiver.total(wanted)
    width, height = np.divide(receiver.half_extent, receiver.pixels).tolist()
    made_by = tuple(wavelengths.tolist()), step, tracer.by_cells
    side = side_in_words(scene, viewed_from(scene))
    return Photo(as_viewed(scene, rgb), white, width / height, light, *made_by, side)


def at_wavelength(scene: Scene, wavelength_um: float) -> Scene:
    """Return the scene with the indices at a wavelength, also outside the range of the formula."""
    for number, material in _materials(scene).items():
        index = CustomIndex(index=material.index(wavelength_um))
        element = scene.elements[number].model_copy(update={"material": index})
        scene = scene.with_element(number, element)
    return scene


def _materials(scene: Scene) -> dict[int, Material]:
    """Catalogue materials by the numbers of elements; others have no known dispersion."""
    names = {
        number: element.material
        for number, element in enumerate(scene.elements)
        if isinstance(element, Lens)
    }
    return {number: CATALOGUE[name] for number, name in names.items() if isinstance(name, str)}


def _wavelengths(
    scene: Scene, heights: Mapping[str, Array], light: Illuminant
) -> tuple[Array, float]:
    """Wavelengths at equal steps of the indices' sum, or of lines; distance of their images."""
    if light.lines:
        lines = [wavelength for wavelength, _ in light.lines]
        lit = [at_wavelength(scene, wavelength) for wavelength in lines]
        steps_apart = [_apart(one, other, heights) for one, other in pairwise(lit)]
        return np.array(lines), max(steps_apart, default=0.0)
    materials = _materials(scene).values()
    if not materials:
        return np.array([(SHORTEST + LONGEST) / 2]), 0.0
    first, last = (at_wavelength(scene, end) for end in (SHORTEST, LONGEST))
    apart = _apart(first, last, heights)
    number = min(max(math.ceil(apart) + 1, _FEWEST), _MOST)
    fine = np.linspace(SHORTEST, LONGEST, 301)
    index = np.array([sum(each.index(um) for each in materials) for um in fine.tolist()])
    steps = np.linspace(index[0], index[-1], number)
    return np.interp(-steps, -index, fine), apart / (number - 1)


def _apart(first: Scene, last: Scene, heights: Mapping[str, Array]) -> float:
    """Distance of the light of two scenes on the receiver, in pixels."""
    (a, a_lit), (b, b_lit) = (_hits(scene, heights) for scene in (first, last))
    size = np.array(first.receiver.pixels)
    on_screen = [((places >= 0) & (places < size)).all(axis=1) for places in (a, b)]
    seen = a_lit & b_lit & (on_screen[0] | on_screen[1])
    distances = np.linalg.norm(a[seen] - b[seen], axis=1)
    return float(np.quantile(distances, _PART)) if distances.size else 0.0


def _hits(scene: Scene, heights: Mapping[str, Array]) -> tuple[Array, Mask]:
    """Hits of some rays on the receiver, in pixels (m, 2), and whether they arrive."""
    train = OpticalTrain.of(scene, heights, _PROBES, 0, Pose(), [scene.receiver])
    every = joined([rays for number in range(BATCHES) for rays in train.source.batch(number)])
    places, flux = np.zeros((len(every.flux), 2)), np.empty(len(every.flux))
    train.hits(every, places, flux)
    return places, (flux > 0) & np.isfinite(places).all(axis=1)


class _Tracer:
    """Images at several wavelengths, by the cells of the first image, or by random rays."""

    def __init__(self, heights: Mapping[str, Array], threads: int | None) -> None:
        self._heights, self._threads = heights, threads
        self._level: int | None = None
        self.by_cells, self._traced = True, 0

    def trace(self, scene: Scene) -> Steps[Array]:
        """Part of the emitted flux in each pixel, (n_y, n_x)."""
        levels = None if scatterer_of(scene) is not None else Levels(scene, self._heights)
        self.by_cells = levels is not None and levels.possible
        self._traced += 1
        if levels is None or not levels.possible:
            return (yield from self._by_rays(scene))
        if self._level is not None:
            return (yield from levels.drawing(self._level).tracing(self._threads))
        return (yield from self._refined(levels))

    def _refined(self, levels: Levels) -> Steps[Array]:
        """Halve the cells until the image is accurate."""
        last: Array | None = None
        for level in count():
            drawing = levels.drawing(level)
            image = yield from within(drawing.tracing(self._threads), partial(_of_level, level))
            change = math.inf if last is None else float(np.linalg.norm(image - last))
            too_much = 4 * levels.more(level) * drawing.rays > _MOST_RAYS
            if change <= _ACCURACY * np.linalg.norm(image) or too_much:
                self._level = level
                break
            last = image
        return image

    def _by_rays(self, scene: Scene) -> Steps[Array]:
        n_x, n_y = scene.receiver.pixels
        # Other rays for each wavelength, so that noise is independent.
        trace = Trace(scene, self._heights, min(_EACH * n_x * n_y, _MOST_RAYS), self._traced)
        total: Tally | None = None
        for batch in trace.batches(self._threads):
            total = added(total, batch)
            del batch  # frees memory before the next batch
            yield trace.part
        assert total is not None
        return total.flux.reshape(n_y, n_x) / total.emitted


def _of_level(level: int, fraction: float) -> float:
    """Fraction of the first image that is done after a fraction of a level."""
    return 1 - math.pow(0.5, level + fraction)


def write_png(photo: Photo, stops: float, file: BinaryIO) -> None:
    """Write a photo as PNG with square pixels, scaled where those of the receiver are not."""
    image = Image.fromarray(photo.picture(stops))
    width, height = image.size
    wanted = round(width * max(photo.aspect, 1.0)), round(height * max(1 / photo.aspect, 1.0))
    if wanted != image.size:
        image = image.resize(wanted, Image.Resampling.BILINEAR)
    image.save(file, "PNG")
