"""Files of lamps, held in memory: what the scenes of the stress suite take their light from."""

import numpy as np

from tests.measured.photometry.files import GAMMA, candela, ies, ldt
from tests.measured.rays.files import dat, rays, text, tm25

_C = np.linspace(0.0, 345.0, 24)
_AROUND = np.linspace(0.0, 360.0, 25)
_NARROW = np.linspace(0.0, 90.0, 181)


def _two_rays() -> np.ndarray:
    """One straight on, and one that goes back."""
    table = np.zeros((2, 7), np.float32)
    table[:, 5] = 1, -1
    table[:, 6] = 2, 3
    return table


LAMPS: dict[str, bytes] = {
    "crooked.ies": ies(_AROUND, GAMMA, candela(_AROUND, GAMMA)).encode(),
    "crooked.ldt": ldt(0, _C, GAMMA, candela(_C, GAMMA)).encode(),
    # Half of the intensity within two degrees.
    "narrow.ies": ies([0], _NARROW, 1e5 * np.exp2(-((_NARROW / 2) ** 2))[None]).encode(),
    # None straight on.
    "batwing.ies": ies([0], GAMMA, 500 * np.sin(np.radians(2 * GAMMA))[None] ** 2).encode(),
    "led.tm25ray": tm25(rays(400)),
    "led.dat": dat(rays(300, seed=2)),
    "two.csv": text(_two_rays()).replace(b"\r", b""),
}
