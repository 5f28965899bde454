"""How far an image is from the wish, and what to say when that cannot be computed."""

import numpy as np
import numpy.typing as npt
import torch
from torch import Tensor

from workbench.errors import RunFailed
from workbench.optics.ledger import Ledger


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
    difference = flux / flux.sum() - target_share
    loss: Tensor = torch.linalg.vector_norm(difference) / difference.numel() ** 0.5
    return loss


def check_finite(loss: Tensor, ledger: Ledger) -> None:
    """Stop a run whose loss is not a number.

    Raises
    ------
    RunFailed
        With where the non-finite loss comes from.
    """
    if torch.isfinite(loss):
        return
    if ledger.on_screen == 0:
        raise RunFailed(
            f"no light reaches the screen: of the emitted light {ledger.off_screen:.0%} passes "
            f"beside it, {ledger.total_reflection:.0%} is totally reflected, "
            f"{ledger.left_side:.0%} leaves by the side and {ledger.missed_lens:.0%} misses the "
            "lens; a larger screen or another base would catch some"
        )
    raise RunFailed(
        f"the loss is {loss.item()} although {ledger.on_screen:.0%} of the light is on the screen"
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
