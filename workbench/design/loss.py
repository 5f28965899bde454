"""How far an image is from the wish, and what to say when that cannot be computed."""

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.errors import RunFailed
from workbench.optics.ledger import Ledger

# Where light can go instead of to the screen, in words, and what brings it there.
_WHERE = {
    "off_screen": ("passes beside it", "a larger or a nearer screen catches it"),
    "missed_lens": ("misses the lens", "a larger lens catches it"),
    "left_side": ("leaves by the side", "a thinner lens or a source nearer to the axis keeps it"),
    "total_reflection": ("is totally reflected", "a lower index or a flatter base lets it out"),
    "fresnel_entrance": ("is reflected at the entrance", "a source nearer to the axis lets it in"),
    "fresnel_exit": ("is reflected at the exit", "a lower index or a flatter base lets it out"),
}


def share(target: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """The target as the part of the light that each pixel should get; sums to 1."""
    # Divided by its largest value first, so that neither tiny nor huge images lose their sum.
    scaled = target / target.max()
    return np.asarray(scaled / scaled.sum())


def paper_loss(flux: Tensor, target_share: Tensor) -> Tensor:
    """Loss of de Koning et al. (2023), eq. 30.

    Parameters
    ----------
    flux : Tensor, shape (n_y, n_x)
        Light in each pixel.
    target_share : Tensor, shape (n_y, n_x)
        Wanted part of the light in each pixel, sums to 1.

    Returns
    -------
    Tensor, scalar
        Frobenius norm of the difference of the sum-normalised images over √(n_x n_y).
    """
    total = flux.sum()
    # An image without light differs by all of the target.
    difference = flux / torch.where(total > 0, total, 1.0) - target_share
    loss: Tensor = torch.linalg.vector_norm(difference) / difference.numel() ** 0.5
    return loss


def check_light(flux: Tensor, ledger: Ledger) -> None:
    """Stop a run whose image has no light that it could move.

    Parameters
    ----------
    flux : Tensor
        Light in each pixel of the image that the run looks at.
    ledger : Ledger
        Where the light went.

    Raises
    ------
    RunFailed
        With where it went, and what would help.
    """
    if flux.sum() > 0:
        return
    emitted = ledger.emitted
    parts = {name: value / emitted for name, value in ledger.to_data().items() if name in _WHERE}
    most = max(parts, key=lambda name: parts[name])
    went = ", ".join(f"{part:.1%} {_WHERE[name][0]}" for name, part in parts.items() if part > 5e-4)
    raise RunFailed(f"no light reaches the screen: of the emitted light {went}; {_WHERE[most][1]}")


def check_finite(loss: Tensor, ledger: Ledger) -> None:
    """Stop a run whose loss is not a number.

    Raises
    ------
    RunFailed
        With how much light is on the screen.
    """
    if not torch.isfinite(loss):
        part = ledger.efficiency
        raise RunFailed(
            f"the loss is {loss.item()} although {part:.0%} of the light is on the screen"
        )


def check_gradient(gradient: Tensor) -> None:
    """Stop a run whose gradient is not finite.

    Raises
    ------
    RunFailed
        With how many control points are concerned.
    """
    bad = int((~torch.isfinite(gradient)).sum())
    if bad:
        raise RunFailed(
            f"the gradient of the loss is not finite for {bad} of {gradient.numel()} parameters"
        )
