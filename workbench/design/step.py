"""What a method hands to the run after each evaluation of a lens."""

from typing import NamedTuple

from torch import Tensor

from workbench.optics.account import Account


class Step(NamedTuple):
    """One evaluated lens.

    Attributes
    ----------
    loss : float
        Paper's loss, comparable over the whole run.
    heights : Tensor, shape (n_u, n_v)
        Control heights of the finished net, no gradient.
    flux : Tensor, shape (n_y, n_x)
        Light in each pixel, no gradient.
    account : Account
        Where the light went.
    notes : tuple of str
        What was chosen for this lens's trace, and what was left out.
    merit : float, optional
        What tells the best lens, where that is not the loss alone; infinite where no light is on
        the screen.
    """

    loss: float
    heights: Tensor
    flux: Tensor
    account: Account
    notes: tuple[str, ...] = ()
    merit: float | None = None
