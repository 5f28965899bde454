"""The best this program knows: quasi-Newton from coarse to fine, from flow of light to detail.

Three things set it apart from the paper's method:

- Early phases measure the image error in a Sobolev norm that weighs long waves most, the
  linearised transport distance. It knows in which direction far-away light has to move, where
  the plain norm sees only pixels that do not overlap.
- Corrections come first from a coarse control net, then from finer ones, so that the surface
  stays smooth while large amounts of light move.
- The image reaches beyond the screen and is compared with all light that passes the lens, so
  that light beside the screen counts as an error and is called back.

The target goes through the expected reconstruction filter, else the optimum is a lens that is too
sharp, to undo a blur that only the simulation has.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import islice

import numpy as np
import numpy.typing as npt
import torch
from scipy.fft import dct
from torch import Tensor

from workbench.design.heights import HeightRange
from workbench.design.lbfgs import Evaluation, Objective, minimise
from workbench.design.loss import check_finite, check_gradient, paper_loss, share
from workbench.design.step import Step
from workbench.geometry.surface import ControlNet
from workbench.optics.filtered import expected_image
from workbench.optics.plan import Plan, device_of
from workbench.scene import BoxFilter, GaussianFilter, Scene, Screen

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Phase:
    """A part of the run; every stage of a scene goes through all of them.

    Attributes
    ----------
    coarsening : int
        How many times fewer control points per axis the corrections have.
    cut : float or None
        Waves with more periods per image width than this lose weight; None weighs all alike.
    part : float
        Part of the iterations.
    """

    coarsening: int
    cut: float | None
    part: float


PHASES = (
    Phase(coarsening=4, cut=0.25, part=0.15),
    Phase(coarsening=2, cut=2.0, part=0.15),
    Phase(coarsening=1, cut=16.0, part=0.25),
    Phase(coarsening=1, cut=None, part=0.45),
)

# Parts of the screen's width that the image reaches beyond it on each side: as far as the light of
# the first lens falls, within these.
_MARGINS = 0.1, 1.0
# The most that a step may change a parameter. Far out tanh is flat: a height that one bold step
# brings there does not find back.
_REACH = 0.3
# The run ends when this many steps together lower the loss by less than this part.
_PATIENCE, _PROGRESS = 30, 1e-3


def auto_steps(scene: Scene, target: Array, start: Array | None) -> Iterator[Step]:
    """Evaluate lens after lens through all phases; see `workbench.design.run.run`.

    Raises
    ------
    RunFailed
        If the loss or its gradient is not finite.
    """
    net = ControlNet.of(scene.lens)
    free = HeightRange.of(scene.lens, net, device_of(scene))
    parameters = free.rest if start is None else free.parameters(start)
    image = _WideImage(scene, target, free.heights(parameters))
    phases = PHASES if start is None else PHASES[-1:]
    for number, phase in enumerate(phases):
        correction = _Correction(net, parameters, phase.coarsening)
        objective = _objective(image, free, correction, phase.cut)
        descent = minimise(objective, correction.nothing, _REACH)
        if phase is not phases[-1]:
            descent = islice(descent, 1 + round(scene.run.iterations * phase.part))
        best: list[float] = []
        for x, found in descent:
            parameters = correction.apply(x)
            if number > 0 and not best:  # this lens ended the phase before
                best.append(found.seen.loss)
                continue
            yield found.seen
            best.append(min([found.seen.loss, *best[-1:]]))
            if len(best) > _PATIENCE and best[-1] > (1 - _PROGRESS) * best[-1 - _PATIENCE]:
                break


class _Correction:
    """Changes of the parameters that live on a coarser control net."""

    def __init__(self, net: ControlNet, parameters: Tensor, coarsening: int) -> None:
        shape = tuple(
            max(n // coarsening, p + 1) for n, p in zip(net.shape, net.degree, strict=True)
        )
        coarse = ControlNet((shape[0], shape[1]), net.degree, net.half_width)
        self._base = parameters
        into_x, into_y = net.embedding(coarse)
        self._into_x = torch.as_tensor(into_x).to(parameters)
        self._into_y = torch.as_tensor(into_y).to(parameters)
        self.nothing = parameters.new_zeros(coarse.shape).flatten()
        self._shape = coarse.shape

    def apply(self, x: Tensor) -> Tensor:
        """Parameters of the finished net, shape (n_u, n_v)."""
        return self._base + self._into_x @ x.view(self._shape) @ self._into_y.T


def _objective(
    image: "_WideImage", free: HeightRange, correction: _Correction, cut: float | None
) -> Objective[Step]:
    waves = None if cut is None else image.waves(cut)

    def objective(x: Tensor) -> Evaluation[Step]:
        x = x.detach().requires_grad_()
        heights = free.heights(correction.apply(x))
        error, step = image.compare(heights)
        if waves is not None:
            error = waves.weigh(error)
        value = error.square().sum()
        (gradient,) = torch.autograd.grad(value, [x])
        check_gradient(gradient)
        return Evaluation(value.item(), gradient, step)

    return objective


class _WideImage:
    """The image of a lens on the screen and some way beyond, against the wish.

    It holds the light of the first lens, as far as that is possible with few pixels more.
    """

    def __init__(self, scene: Scene, target: Array, first: Tensor) -> None:
        # A box filter gives no gradient; the design then looks through the usual Gaussian.
        filter = GaussianFilter() if isinstance(scene.filter, BoxFilter) else scene.filter
        screen = scene.screen
        (n_x, n_y), (r_x, r_y) = screen.pixels, screen.half_width
        plan = Plan(scene, filter=filter)
        reach_x, reach_y = plan.reach(first)
        m_x, m_y = _margin(reach_x / r_x, n_x), _margin(reach_y / r_y, n_y)
        wide = Screen(
            z=screen.z,
            half_width=(r_x * (1 + 2 * m_x / n_x), r_y * (1 + 2 * m_y / n_y)),
            pixels=(n_x + 2 * m_x, n_y + 2 * m_y),
        )
        device = device_of(scene)
        self._plan = plan.on(wide)
        self._on_screen = (slice(m_y, m_y + n_y), slice(m_x, m_x + n_x))
        around = ((m_y, m_y), (m_x, m_x))
        wanted = expected_image(np.pad(share(target), around), filter)
        self._wanted = torch.as_tensor(wanted, dtype=torch.float32, device=device)
        self._scale = self._wanted.norm().item()

    def compare(self, heights: Tensor) -> tuple[Tensor, Step]:
        """Error relative to the norm of the wish, on the wide image, and the step to report."""
        traced = self._plan.trace(heights)
        ledger = traced.ledger
        flux = traced.flux[self._on_screen]
        visible = flux.detach().sum(dtype=torch.float64).item()
        beside = ledger.off_screen + ledger.on_screen - visible
        ledger = replace(ledger, on_screen=visible, off_screen=beside)
        loss = paper_loss(flux.detach(), self._wanted[self._on_screen])
        check_finite(loss, ledger)
        step = Step(loss.item(), heights.detach(), flux.detach(), ledger)
        error = traced.flux / (ledger.on_screen + ledger.off_screen) - self._wanted
        return error / self._scale, step

    def waves(self, cut: float) -> "_Waves":
        """The norm of a phase."""
        return _Waves(self._wanted, cut)


def _margin(reach: float, pixels: int) -> int:
    """Pixels beyond the screen that hold light up to ``reach`` screen half-widths from the axis."""
    least, most = _MARGINS
    return math.ceil(min(max((reach - 1) / 2, least), most) * pixels)


class _Waves:
    """Splits an image into cosine waves and weighs the long ones most: the H⁻¹ norm beyond a cut.

    Cosines have no slope at the edge of the image: in this norm no light can improve matters by
    leaving the image, as it could with waves that wrap around.
    """

    def __init__(self, like: Tensor, cut: float) -> None:
        rows, columns = like.shape
        self._down = torch.as_tensor(dct(np.eye(rows), axis=0, norm="ortho")).to(like)
        self._across = torch.as_tensor(dct(np.eye(columns), axis=1, norm="ortho")).to(like)
        periods_y, periods_x = torch.arange(rows) / 2, torch.arange(columns) / 2
        periods2 = periods_y[:, None].square() + periods_x[None, :].square()
        self._weight = (1 + periods2 / cut**2).rsqrt().to(like)

    def weigh(self, image: Tensor) -> Tensor:
        """Weighted amplitudes of the waves in an image, both of shape (rows, columns)."""
        return self._weight * (self._down @ image @ self._across)
