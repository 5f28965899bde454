"""The image of a lens on the screen and some way beyond, against the target."""

import math
from collections.abc import Mapping

import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.design.blurred_plan import BlurredPlan
from workbench.design.lens_blur import LensBlur
from workbench.design.lens_state import LensState
from workbench.design.loss import check_finite, check_light, measure_of, paper_loss, share
from workbench.design.scattered_plan import BeamImages, ScatteredPlan
from workbench.design.step import Step
from workbench.extended.blur import Blur
from workbench.extended.scattering import Scattering
from workbench.extended.wanted import wanted_light
from workbench.geometry.surface import nets_of
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.light import Light
from workbench.optics.plan import device_of
from workbench.optics.samples import Corners
from workbench.scene import Scene

# Parts of the screen's width that the image reaches beyond it on each side: as far as the light of
# the first lens falls, within these.
MARGINS = 0.05, 1.0
# Time of a cell that is drawn as a box, see `workbench.optics.boxes`, over that of a beam: of
# trace, image and gradients, with one freeform face and with two, of which the trace takes most.
_OF_A_BOX = 0.3, 0.75


class WideImage:
    """Compares lenses with the target, light beside the screen included.

    `target` (n_y, n_x): the wanted image in any scale, row 0 at +y; `cells`: cells of the light of
    each origin along x and y, and how many origins; see `BeamPlan`; `light_extent`: how far from
    the receiver's middle light falls; `mirrored`: whether all lenses are mirror images of
    themselves in x, in y; see `BeamPlan`; `blur`: what the parts of the lens make of the source, if
    that is nearly the same everywhere: light of its middle is traced then, and blurred;
    `asked_light`: flux that the image shall have. By default what arrives, however much that is;
    `scattering`: what a diffuser makes of the light that comes to the receiver of ``scene``.
    `effort`: time of a look at a lens and its gradients, in those of a beam of light: how many
    cells are traced, those of all origins together, of which boxes take less; `blurred`: whether it
    is the light of a source whose size blurs it, or of a diffuser; `blur_widths`: mean widths of
    ``blur`` and ``scattering`` along x and y, parts of those of the receiver.
    """

    def __init__(
        self,
        scene: Scene,
        target: Array,
        cells: tuple[int, int] | Corners,
        light_extent: tuple[float, float],
        mirrored: tuple[bool, bool] = (False, False),
        blur: LensBlur | None = None,
        asked_light: float | None = None,
        scattering: Scattering | None = None,
    ) -> None:
        self._scene, receiver = scene, scene.receiver
        (n_x, n_y), r, most = receiver.pixels, receiver.half_extent, receiver.farthest
        m_x, m_y = (
            _margin(light_extent[k] / r[k], receiver.pixels[k], most[k] / r[k]) for k in (0, 1)
        )
        parts = scattering.parts if scattering else 1
        fine = receiver.model_copy(update={"pixels": (parts * n_x, parts * n_y)})
        traced = scene.with_receiver(fine)
        plan: BeamPlan | BlurredPlan = (
            BlurredPlan(traced, (cells[0], cells[1]), blur.scaled(parts), mirrored)
            if blur
            else BeamPlan(traced, cells, mirrored=mirrored)
        )
        self._plan: BeamImages = (
            ScatteredPlan(plan, scattering, receiver.pixels) if scattering else plan
        )
        self._margin, self._asked_light = (m_x, m_y), asked_light
        halves = 2 ** sum(mirrored)
        corners = Corners(*cells)
        self.blurred = blur is not None or scattering is not None or corners.origins > 1
        blurs = [each.widths for each in (blur and blur.mean, scattering) if each]
        x, y = map(max, zip((0.0, 0.0), *blurs, strict=True))
        self.blur_widths = x / n_x, y / n_y
        origins = corners.origins * scene.source.point_count
        if corners.of_source is not None:
            origins = math.prod(corners.of_source)
        boxes = isinstance(plan, BeamPlan) and plan.boxes
        each = _OF_A_BOX[min(len(nets_of(scene)), 2) - 1] if boxes else 1.0
        self.effort = each * corners.x * corners.y * origins * len(scene.lines) / halves
        self._pixel_measure = receiver.pixel_measure
        self._on_screen = (slice(m_y, m_y + n_y), slice(m_x, m_x + n_x))
        device = device_of(scene)
        self._share = torch.as_tensor(share(target), dtype=torch.float32, device=device)
        # Where pixels cover different measures, densities are compared, as shares of all light.
        seen = Blur.of(scene).seen_in(receiver.pixels)
        flux = share(target * receiver.relative_measure())
        if scattering is None:
            wanted = wanted_light(flux, seen, (m_x, m_y))
        else:
            source = None if seen.within_a_pixel else seen.spread()[0]
            wanted = scattering.wanted(flux, (m_x, m_y), source)
        wanted = wanted / receiver.relative_measure(m_y)
        self._wanted = torch.as_tensor(wanted, dtype=torch.float32, device=device)
        self._relative = measure_of(receiver, device)
        self._wide_relative = measure_of(receiver, device, m_y)
        self._scale = self._wanted.norm().item()

    def compare(self, heights: Mapping[str, Tensor]) -> tuple[Tensor, Step]:
        """Error relative to the norm of the target, on the wide image, and the step to report.

        Raises `RunFailed` if there is no light on the wide image, or the loss is not finite.
        """
        traced = self._plan.trace(heights, self._margin)
        check_light(traced.flux.detach(), traced.account, self._scene)
        step = self._step(heights, traced)
        light = self._asked_light or traced.account.arrived
        error = traced.flux / light / self._wide_relative - self._wanted
        return error / self._scale, step

    def step(self, heights: Mapping[str, Tensor]) -> Step:
        """The step to report of a lens, also of one that sends no light here."""
        with torch.no_grad():
            return self._step(heights, self._plan.trace(heights, self._margin))

    def _step(self, heights: Mapping[str, Tensor], traced: Light) -> Step:
        account = traced.account
        flux = traced.flux.detach()[self._on_screen]
        loss = paper_loss(flux, self._share, self._relative)
        check_finite(loss, account)
        merit = None if flux.sum() > 0 else math.inf
        state = LensState.traced(heights, flux, self._pixel_measure, loss, account)
        return Step(state, self._plan.notes, merit)


def _margin(extent: float, pixels: int, farthest: float) -> int:
    """Pixels beyond a receiver that hold light up to ``extent`` half-extents from its middle.

    There is no light beyond ``farthest``.
    """
    least, most = MARGINS
    wanted = math.ceil(min(max((extent - 1) / 2, least), most) * pixels)
    return wanted if math.isinf(farthest) else min(wanted, int((farthest - 1) / 2 * pixels))
