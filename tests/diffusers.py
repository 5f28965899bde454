"""A small train of a lens and a diffuser."""

from typing import Any


def with_diffuser(
    scatter: dict[str, Any] | None = None,
    receiver: dict[str, Any] | None = None,
    **fields: Any,
) -> dict[str, Any]:
    """A scene of a lens 20 wide, a diffuser at z = 22 and a receiver at z = 30.

    Parameters
    ----------
    scatter, receiver : dict, optional
        In place of a Gaussian scatter of 6°, and of a plane 40 wide with 40 pixels along each axis.
    **fields
        Of the diffuser.
    """
    faces = [
        {"shape": "plane"},
        {"shape": "bspline", "control_points": [24, 24], "height_range": [-3, 3]},
    ]
    plane = {
        "kind": "plane",
        "position": [0, 0, 30],
        "half_width": [20, 20],
        "pixels": [40, 40],
    }
    return {
        "format": "freeform-scene",
        "version": 3,
        "unit": "mm",
        "source": {"kind": "collimated"},
        "elements": [
            {
                "kind": "lens",
                "name": "lens",
                "half_width": [10, 10],
                "material": {"index": 1.5},
                "thickness": 4,
                "faces": faces,
            },
            {
                "kind": "diffuser",
                "name": "film",
                "position": [0, 0, 22],
                "half_width": [25, 25],
                "scatter": scatter or {"kind": "gaussian", "sigma": 6},
                "transmittance": 0.9,
                **fields,
            },
        ],
        "images": [{"receiver": receiver or plane, "target": {"builtin": "tophat"}}],
        "run": {"iterations": 12},
    }
