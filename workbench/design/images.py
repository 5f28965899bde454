"""Images of lenses against their targets: one, and several."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import reduce

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.design.lens_blur import LensBlur, plan_of
from workbench.design.lens_state import FurtherLight, LensState, Step
from workbench.design.loss import AskedLight, Residual, check_finite, measure_of, paper_loss, share
from workbench.extended.blur import Blur
from workbench.extended.blurring import ImageBlur, convolved
from workbench.extended.deblur import wanted_light
from workbench.geometry.as_made import AsMade
from workbench.geometry.surface import nets_of
from workbench.messages import Message
from workbench.optics.light import Light
from workbench.optics.plan import device_of
from workbench.optics.samples import Corners
from workbench.scene import Scene, WantedImage

# Parts of the screen's width that the image reaches beyond it on each side: as far as the light of
# the first design falls, within these.
MARGINS = 0.05, 1.0
# Width of a blur, in pixels, that damps waves of a face as pixels do. Random waves of a lens for a
# photograph change its 256 x 256 pixels by the square of their periods up to some 60 of them, and
# by nearly the same from there on.
_PIXEL = 1.9
# Time of a cell drawn as a box, see `workbench.optics.images.beams`, over that of a beam: of
# trace, image and gradients, with one freeform face and with two, of which the trace takes most;
# and that of a ray.
_OF_A_BOX, _OF_A_RAY = (0.3, 0.75), 0.15


class WideImage:
    """Compares lenses with the target, light beside the screen included.

    `target` (n_y, n_x): the wanted image in any scale, row 0 at +y; `cells`: cells of the light of
    each origin along x and y, and how many origins; see `BeamPlan`; `light_extent`: how far from
    the receiver's middle light falls; `mirrored`: whether all lenses are mirror images of
    themselves in x, in y; see `BeamPlan`; `blur`: what the parts of the lens make of the source, if
    that is nearly the same everywhere: light of its middle is traced then, and blurred;
    `asked_light`: light that the image shall have. By default what arrives, however much that is;
    `blurs`: what a diffuser, and relief of manufacture, make of the light that comes to the
    receiver of ``scene``; `made`: what manufacture makes of control heights; nothing by default.
    `effort`: time of a look at a lens and its gradients, in those of a beam of light: how many
    cells are traced, those of all origins together, of which boxes take less; `blurred`: whether it
    is the light of a source whose size blurs it, or of a diffuser; `rays`: whether it is drawn as
    rays, not beams; `blur_widths`: mean widths of ``blur`` and ``blurs`` along x and y, parts
    of those of the receiver, or that of a pixel;
    0 where the blur differs over the lens.
    """

    def __init__(
        self,
        scene: Scene,
        target: Array,
        cells: tuple[int, int] | Corners,
        light_extent: tuple[float, float],
        mirrored: tuple[bool, bool] = (False, False),
        blur: LensBlur | None = None,
        asked_light: AskedLight | None = None,
        blurs: Sequence[ImageBlur] = (),
        made: AsMade | None = None,
    ) -> None:
        receiver = scene.receiver
        self.rays = blur is not None and blur.suits_rays
        (n_x, n_y), r, most = receiver.pixels, receiver.half_extent, receiver.farthest
        m_x, m_y = (
            _margin(light_extent[k] / r[k], receiver.pixels[k], most[k] / r[k]) for k in (0, 1)
        )
        self._plan = plan_of(scene, cells, mirrored, blur, blurs, self.rays)
        self._margin, self._made = (m_x, m_y), made
        halves = 2 ** sum(mirrored)
        corners = Corners(*cells)
        self.blurred = blur is not None or bool(blurs) or corners.origins > 1
        widths = [each.widths for each in (blur and blur.mean, *blurs) if each]
        pixel = 0.0 if self.blurred and not widths else _PIXEL
        x, y = map(max, zip((pixel, pixel), *widths, strict=True))
        self.blur_widths = x / n_x, y / n_y
        origins = corners.origins * scene.source.point_count
        if corners.of_source is not None:
            origins = math.prod(corners.of_source)
        boxes = blur is None and scene.source.continuous and corners.origins > 1
        each = _OF_A_RAY if self.rays else 1.0
        if boxes and corners.of_source is None:
            each = _OF_A_BOX[min(len(nets_of(scene)), 2) - 1]
        self.effort = each * corners.x * corners.y * origins * len(scene.lines) / halves
        self._pixel_measure = receiver.pixel_measure
        self._on_screen = (slice(m_y, m_y + n_y), slice(m_x, m_x + n_x))
        device = device_of(scene)
        self._share = torch.as_tensor(share(target), dtype=torch.float32, device=device)
        # Where pixels cover different measures, densities are compared, as shares of all light.
        flux = share(target * receiver.relative_measure())
        kernel = _mean_kernel(scene, blurs)
        wanted = wanted_light(flux, kernel, (m_x, m_y))
        # Two faces near an LED are at most 3.0 % off with this, and 4.0 % without.
        if kernel is not None and not blurs:
            wanted /= wanted.sum()
        wanted = wanted / receiver.relative_measure(m_y)
        wide = torch.as_tensor(wanted, dtype=torch.float32, device=device)
        self._residual = Residual(scene, wide, m_y, asked_light)
        self._relative = measure_of(receiver, device)

    def compare(self, heights: Mapping[str, Tensor]) -> tuple[Tensor, Step]:
        """Error relative to the norm of the target, on the wide image, and the step to report.

        Raises `RunFailed` if there is no light on the wide image, or the loss is not finite.
        """
        traced = self._trace(heights)
        return self._residual(traced), self._step(heights, traced)

    def step(self, heights: Mapping[str, Tensor]) -> Step:
        """The step to report of a lens, also of one that sends no light here."""
        with torch.no_grad():
            return self._step(heights, self._trace(heights))

    def light(self, heights: Mapping[str, Tensor]) -> Tensor:
        """Light (n_y + 2 m_y, n_x + 2 m_x) in the pixels of the wide image, without gradients."""
        with torch.no_grad():
            return self._trace(heights).flux

    def error_of(self, light: Tensor) -> float:
        """Relative L2 error of a wide image on the receiver."""
        on_screen = light[self._on_screen]
        loss = paper_loss(on_screen, self._share.to(light), self._relative.to(light)).item()
        return float(loss * on_screen.numel() ** 0.5 / self._share.norm().item())

    def _trace(self, heights: Mapping[str, Tensor]) -> Light:
        made = heights if self._made is None else self._made.tensors(heights)
        return self._plan.trace(made, self._margin)

    def _step(self, heights: Mapping[str, Tensor], traced: Light) -> Step:
        account = traced.account
        flux = traced.flux.detach()[self._on_screen]
        loss = paper_loss(flux, self._share, self._relative)
        check_finite(loss, account)
        merit = None if flux.sum() > 0 else math.inf
        state = LensState.traced(heights, flux, self._pixel_measure, loss, account)
        return Step(state, self._plan.notes, merit)


def _mean_kernel(scene: Scene, blurs: Sequence[ImageBlur]) -> Array | None:
    """What becomes of light in a pixel by source and blurs, on average; None if nothing."""
    source = Blur.of(scene).seen_in(scene.receiver.pixels)
    kernels = [] if source.within_a_pixel else [source.spread()[0]]
    kernels += [blur.of_pixels for blur in blurs]
    return reduce(convolved, kernels) if kernels else None


def _margin(extent: float, pixels: int, farthest: float) -> int:
    """Pixels beyond a receiver that hold light up to ``extent`` half-extents from its middle.

    There is no light beyond ``farthest``.
    """
    least, most = MARGINS
    wanted = math.ceil(min(max((extent - 1) / 2, least), most) * pixels)
    return wanted if math.isinf(farthest) else min(wanted, int((farthest - 1) / 2 * pixels))


class SeveralImages:
    """Compares lenses with several targets at once, as `WideImage` does with one.

    The square of its error is the mean of the squares of theirs, each relative to its own target,
    by the weights of the images.

    `images`: one for each of the scene's images; `wanted`: the same images, as the task asks for
    them. `effort`: of all of them together; see `WideImage`; `blurred`: whether any is the light of
    a source whose size blurs it; `rays`: whether all are drawn as rays; `blur_widths`: the least of
    those of all images; see `WideImage`.
    """

    def __init__(self, images: Sequence["AnyImage"], wanted: Sequence[WantedImage]) -> None:
        self._images = images
        total = sum(image.weight for image in wanted)
        self._weights = [image.weight / total for image in wanted]
        # By these the paper's loss becomes an error relative to the target.
        self._units = [
            float(np.linalg.norm(share(image.target))) / image.target.size**0.5 for image in wanted
        ]
        self.effort: float = sum(image.effort for image in images)
        self.blurred: bool = any(image.blurred for image in images)
        self.rays: bool = all(image.rays for image in images)
        x, y = (min(widths) for widths in zip(*(i.blur_widths for i in images), strict=True))
        self.blur_widths: tuple[float, float] = x, y

    def compare(self, heights: Mapping[str, Tensor]) -> tuple[Tensor, Step]:
        """Errors of all images in a row, and the step to report; see `WideImage.compare`."""
        found = [image.compare(heights) for image in self._images]
        parts = (
            math.sqrt(weight) * error.flatten()
            for weight, (error, _) in zip(self._weights, found, strict=True)
        )
        return torch.cat(list(parts)), self._joined([step for _, step in found])

    def step(self, heights: Mapping[str, Tensor]) -> Step:
        """The step to report of a lens; see `WideImage.step`."""
        return self._joined([image.step(heights) for image in self._images])

    def _joined(self, steps: Sequence[Step]) -> Step:
        first, *others = (step.state for step in steps)
        squares = (
            weight * (step.state.loss / unit) ** 2
            for weight, unit, step in zip(self._weights, self._units, steps, strict=True)
        )
        further = tuple(FurtherLight(s.irradiance, s.loss, s.account) for s in others)
        loss = self._units[0] * math.sqrt(sum(squares))
        # Without light at one of its places, a lens is no good.
        dark = any(step.merit is not None for step in steps)
        return Step(
            replace(first, loss=loss, further=further), steps[0].notes, math.inf if dark else None
        )


class ExpectedImage(SeveralImages):
    """Compares lenses by their errors in several cases of a set-up, of which the first is shown.

    The square of its error is the mean of the squares of theirs.
    """

    def _joined(self, steps: Sequence[Step]) -> Step:
        expected = super()._joined(steps)
        merit = expected.state.loss if expected.merit is None else expected.merit
        note = Message(
            "mean error over {count} set-ups {error:.2f} %",
            count=len(steps),
            error=100 * expected.state.loss / self._units[0],
        )
        return steps[0]._replace(merit=merit, notes=(*steps[0].notes, note))


AnyImage = WideImage | SeveralImages
"""What lenses are compared by."""
