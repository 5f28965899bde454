"""Light accounts and results of given figures."""

from typing import Any

import numpy as np

from workbench.arrays import Array
from workbench.design.lens_state import LensState
from workbench.design.snapshot import Result
from workbench.geometry.faces import FaceArrays
from workbench.optics.account import Account


def account_of(
    emitted: float,
    on_screen: float,
    off_screen: float,
    missed_lens: float,
    left_side: float,
    total_reflection: float,
    fresnel_entrance: float,
    fresnel_exit: float,
) -> Account:
    """The account of a lens."""
    lost = {
        "off_screen": off_screen,
        "missed_lens": missed_lens,
        "left_side": left_side,
        "total_reflection": total_reflection,
        "fresnel_entrance": fresnel_entrance,
        "fresnel_exit": fresnel_exit,
    }
    return Account(on_screen, lost, emitted)


def result_of(
    heights: Array,
    irradiance: Array | None = None,
    losses: Any = (0.1,),
    seconds: float = 1.0,
    loss: float = 0.1,
    account: Account | None = None,
    **others: Any,
) -> Result:
    """A result with these control heights of a lens's exit face, which no run has found."""
    state = LensState(
        heights=FaceArrays({"lens.back": heights}),
        irradiance=np.ones((32, 32)) if irradiance is None else irradiance,
        loss=loss,
        account=account or account_of(1.0, 0.7, 0.1, 0.0, 0.0, 0.06, 0.04, 0.1),
    )
    return Result(state, losses=np.asarray(losses, float), seconds=seconds, **others)
