"""How far an image is from the target, and what to say when that cannot be computed."""

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
import torch
from torch import Tensor

from workbench.arrays import Array
from workbench.design.lens_state import LensState
from workbench.errors import RunFailed
from workbench.messages import Message
from workbench.optics.account import Account, loss_of
from workbench.optics.beam_plan import BeamPlan
from workbench.optics.light import Light
from workbench.scene import AnyReceiver, Lens, Scene
from workbench.scene.losses import kind_and_element

# Cells that show where light goes.
_CELLS = (128, 128)
# Losses of a smaller part of the light are not named.
_NAMED = 5e-4
# Two faces close to a source are asked for so much more light than the first design sends: 67.1 %
# of an LED 10 mm before a lens of 120 mm arrive with an error of 4.3 %, not 61.9 % with 3.3 %.
_MORE_LIGHT = 1.05
# From this part of the light on that an exit face reflects, it deflects near the critical angle; at
# normal incidence it is 0.04. Light that is lost then counts by this factor in the error, or total
# reflection would be the easiest cure for places that are too bright: an LED 10 mm before a lens of
# 24 mm for a rectangle of 136° is 70 % off with 9 % of its light without it, and 65 % with 36 %.
# With a factor of 5 it is 62 % off with 40 %, but a lens of 60 mm is 40 % off in place of 39 %.
_STEEP, _LOST = 0.15, 2.0


def share(target: Array) -> Array:
    """The target as the part of the light that each pixel should get; sums to 1."""
    # Divided by its largest value first, so that neither tiny nor huge images lose their sum.
    scaled = target / target.max()
    return np.asarray(scaled / scaled.sum())


def measure_of(receiver: AnyReceiver, device: torch.device, margin: int = 0) -> Tensor:
    """What pixels cover, relative to each other; see `AnyReceiver.relative_measure`."""
    measure = receiver.relative_measure(margin)
    return torch.as_tensor(measure, dtype=torch.float32, device=device)


def paper_loss(flux: Tensor, target_share: Tensor, measure: Tensor | float = 1.0) -> Tensor:
    """Loss of de Koning et al. (2023), eq. 30.

    `flux` (n_y, n_x): light in each pixel; `target_share` (n_y, n_x): wanted image, sums to 1;
    `measure`: what pixels cover, relative to each other: the image is the light over that. Returns
    frobenius norm of the difference of the sum-normalised images over √(n_x n_y).
    """
    density = flux / measure
    total = density.sum()
    # An image without light differs by all of the target.
    difference = density / torch.where(total > 0, total, 1.0) - target_share
    loss: Tensor = torch.linalg.vector_norm(difference) / difference.numel() ** 0.5
    return loss


class AskedLight(NamedTuple):
    """Light that an image shall have."""

    flux: float
    # By which the part of it that is missing counts in the error, beside that of the image.
    weight: float = 0.0


def asked_light_of(scene: Scene, heights: Mapping[str, Tensor]) -> AskedLight | None:
    """What a lens shall send to the receiver; None where what arrives is as good as any.

    An image that is compared with as much light as arrives gets better by losing what is hard to
    place. Two faces close to a source decide how much light comes through, and each face does that
    deflects light by nearly as much as it can.
    """
    optic = scene.optic
    near = optic.front_z - scene.alone.source.nearest_z < max(optic.half_width)
    weight = _LOST if _reflects_much(scene, heights) else 0.0
    if not weight and not (near and len(heights) > 1):
        return None
    arrived = _account_of(scene, heights).arrived
    return AskedLight(_MORE_LIGHT * arrived, weight) if arrived else None


def _reflects_much(scene: Scene, heights: Mapping[str, Tensor]) -> bool:
    """Whether the last face of a lens would reflect much of the light if it were bare."""
    optic = scene.optic
    if not isinstance(optic, Lens):
        return False
    bare = optic.model_copy(update={"coating": None, "reflection": "fresnel"})
    account = _account_of(scene.with_optic(bare), heights)
    reflected = sum(
        flux
        for key, flux in account.lost.items()
        if kind_and_element(key)[0] in ("fresnel_exit", "total_reflection")
    )
    return reflected > _STEEP * (reflected + account.arrived)


def _account_of(scene: Scene, heights: Mapping[str, Tensor]) -> Account:
    with torch.no_grad():
        return BeamPlan(scene, _CELLS).trace(heights).account


class Residual:
    """Errors of all pixels of an image, relative to the norm of the target.

    `wanted` (n_y, n_x): the wanted density as part of all light, on the scene's receiver with
    ``rows`` more rows on each side; `asked`: light that the image shall have; by default what
    arrives, however much that is.
    """

    def __init__(self, scene: Scene, wanted: Tensor, rows: int, asked: AskedLight | None) -> None:
        self._scene, self._wanted, self._asked = scene, wanted, asked
        self._relative = measure_of(scene.receiver, wanted.device, rows)
        self._scale = wanted.norm().item()

    def __call__(self, light: Light) -> Tensor:
        """Return the errors of an image; and the missing light, where that counts.

        Raises `RunFailed` if there is no light on it.
        """
        flux, account = light
        check_light(flux.detach(), account, self._scene)
        asked = self._asked or AskedLight(account.arrived)
        error: Tensor = (flux / asked.flux / self._relative - self._wanted) / self._scale
        if asked.weight:
            missing = 1 - flux.sum() / asked.flux
            error = torch.cat([error.flatten(), asked.weight * missing[None]])
        return error


def relative_error(state: LensState, target: Array) -> float:
    """Relative L2 error of a lens's image as the design sees it: ‖I − T‖ / ‖T‖."""
    return float(state.loss * target.size**0.5 / np.linalg.norm(share(target)))


def check_light(flux: Tensor, account: Account, scene: Scene) -> None:
    """Stop a run whose image has no light that it could move.

    `flux`: light in each pixel of the image that the run looks at; `account`: where the light went.
    Raises `RunFailed` with where it went, and what would help.
    """
    if flux.sum() > 0:
        return
    parts = {loss_of(key): flux / account.emitted for key, flux in account.lost.items()}
    most = max(parts, key=lambda loss: parts[loss])
    named = {
        f"loss_{number}": Message("{part:.1%} {where}", part=part, where=loss.goes)
        for number, (loss, part) in enumerate(parts.items())
        if part > _NAMED
    }
    went = Message(", ".join(f"{{{name}}}" for name in named), **named)
    raise RunFailed(
        Message(
            "no light reaches the {receiver}: of the emitted light {went}; {cure}",
            receiver=scene.receiver.called,
            went=went,
            cure=most.cure_in(scene),
        )
    )


def check_finite(loss: Tensor, account: Account) -> None:
    """Stop a run whose loss is not a number.

    Raises `RunFailed` with how much light is on the screen.
    """
    if not torch.isfinite(loss):
        part = account.efficiency
        raise RunFailed(
            Message(
                "the loss is {loss} although {part:.0%} of the light is on the screen",
                loss=loss.item(),
                part=part,
            )
        )


def check_gradient(gradient: Tensor) -> None:
    """Stop a run whose gradient is not finite.

    Raises `RunFailed` with how many control points are concerned.
    """
    bad = int((~torch.isfinite(gradient)).sum())
    if bad:
        raise RunFailed(
            Message(
                "the gradient of the loss is not finite for {bad} of {count} parameters",
                bad=bad,
                count=gradient.numel(),
            )
        )
