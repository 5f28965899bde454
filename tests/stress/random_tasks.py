"""Whole design tasks at random over all kinds: sources, optics, receivers and their fields."""

from typing import Any

import numpy as np

from tests.stress.lamps import LAMPS
from workbench.errors import Refused
from workbench.scene import Scene

FILES = {
    "photometric": ("crooked.ies", "crooked.ldt", "narrow.ies", "batwing.ies"),
    "ray_file": ("led.tm25ray", "led.dat"),
}
SOURCES = ("collimated", "beam", "sun", "point", "grid", "area", "photometric", "ray_file")
OPTICS = ("lens", "lens", "two faces", "mirror")
RECEIVERS = ("screen", "screen", "far_field")


class TaskDraw:
    """Draws the fields of one task; the same seed and number draw the same task."""

    files = LAMPS

    def __init__(self, seed: int, number: int) -> None:
        self._random = np.random.default_rng([seed, number])

    def one_of(self, *values: Any) -> Any:
        """One of some values."""
        return values[self._random.integers(len(values))]

    def between(self, low: float, high: float) -> float:
        """A number, on three digits: a scene is easier to read."""
        return float(f"{self._random.uniform(low, high):.3g}")

    def size(self, low: float, high: float) -> float:
        """A positive number, even in its logarithm."""
        return float(f"{np.exp(self._random.uniform(np.log(low), np.log(high))):.3g}")

    def scene(self) -> dict[str, Any]:
        """A whole scene of version 2; some are refused."""
        kind = self.one_of(*OPTICS)
        optic = self._mirror() if kind == "mirror" else self._lens(kind == "two faces")
        name = "mirror" if kind == "mirror" else "lens"
        return {
            "format": "freeform-scene",
            "version": 2,
            "unit": "mm",
            name: optic,
            "source": self._source(self.one_of(*SOURCES), aside=kind == "mirror"),
            **self._receiver(-1 if kind == "mirror" else 1),
            "target": {"builtin": self.one_of("tophat", "tophat", "flame")},
            "run": {"iterations": 2, "seed": 0},
        }

    def _net(self) -> dict[str, Any]:
        return {
            "control_points": [self.one_of(8, 12, 16), self.one_of(8, 12, 16)],
            "degree": [self.one_of(3, 3, 3, 1, 2, 5), self.one_of(3, 3, 3, 1, 2, 4)],
        }

    def _lens(self, two_faces: bool) -> dict[str, Any]:
        lens = {
            "half_width": [1.0, self.one_of(1.0, 1.0, 0.4)],
            "refractive_index": self.one_of(1.5, 1.5, 1.1, 2.0),
            **self._net(),
            "outline": self.one_of("rectangle", "rectangle", "ellipse"),
            "reflection": self.one_of("fresnel", "fresnel", "schlick", "none"),
            "coating": self.one_of(None, None, [0.01, 0.2]),
            "absorption": self.one_of(0.0, 0.0, 0.5),
        }
        if two_faces:
            entrance = {"shape": "freeform", **self._net()}
            if self.one_of(True, False):
                entrance["height_range"] = [-self.between(0.02, 0.5), self.between(0.02, 0.2)]
            lens["entrance"] = entrance
        return lens

    def _mirror(self) -> dict[str, Any]:
        return {
            "half_width": [1.0, self.one_of(1.0, 1.0, 0.4)],
            **self._net(),
            "outline": self.one_of("rectangle", "rectangle", "ellipse"),
            "reflectance": self.one_of(1.0, 0.9),
        }

    def _source(self, kind: str, aside: bool) -> dict[str, Any]:
        if kind in ("collimated", "beam", "sun"):
            direction = [self.one_of(0.0, 0.0, self.between(-30, 30)) for _ in range(2)]
            source: dict[str, Any] = {"kind": "collimated", "direction": direction}
            if kind == "beam":
                source["profile"] = {"kind": "gaussian", "radius": self.size(0.02, 3)}
            if kind == "sun" or (kind == "beam" and self.one_of(True, False, False)):
                source["angular_diameter"] = self.size(0.1, 10)
            return source
        away = self.size(0.05, 30)
        off = max(1.0, away / 2) * (2.0 if aside else 0.5)
        place = [self.one_of(0.0, self.between(-off, off)) for _ in range(2)] + [-away]
        if kind in FILES:
            source = {
                "kind": kind,
                "file": self.one_of(*FILES[kind]),
                "position": place,
                "rotation": [self.one_of(0.0, 0.0, self.between(-40, 40)) for _ in range(3)],
            }
            return source | ({"file_unit": "mm"} if kind == "ray_file" else {})
        if kind == "point":
            return {"kind": kind, "position": place} | self._emission()
        half = [self.size(0.01, 0.5) * min(away, 2) for _ in range(2)]
        source = {"kind": kind, "center": place, "half_width": half, **self._emission()}
        if kind == "grid":
            return source | {"points": [self.one_of(1, 2, 3), self.one_of(1, 2)]}
        return source | {"outline": self.one_of("rectangle", "ellipse")}

    def _emission(self) -> dict[str, Any]:
        return {"emission": self.one_of("lambertian", "uniform")}

    def _receiver(self, onwards: int) -> dict[str, Any]:
        pixels = [self.one_of(8, 16, 24), self.one_of(8, 16, 24)]
        if self.one_of(*RECEIVERS) == "far_field":
            half = [self.one_of(self.between(5, 40), self.between(40, 85)) for _ in range(2)]
            center = [self.one_of(0.0, 0.0, self.between(-4, 4)) for _ in range(2)]
            return {"far_field": {"half_angle": half, "center": center, "pixels": pixels}}
        far = self.size(3, 200)
        wide = max(1.0, far * self.between(0.1, 1))
        return {
            "screen": {
                "z": onwards * far,
                "half_width": [wide, wide * self.one_of(1.0, 0.6)],
                "center": [self.one_of(0.0, 0.0, self.between(-1, 1) * wide / 2) for _ in "xy"],
                "tilt": [self.one_of(0.0, 0.0, self.between(-30, 30)) for _ in "xy"],
                "pixels": pixels,
            }
        }


def random_task(
    seed: int, number: int, draw: type[TaskDraw] = TaskDraw
) -> tuple[dict[str, Any], Scene | None]:
    """The data of a task and its scene, or None if the scene is refused."""
    data = draw(seed, number).scene()
    try:
        return data, Scene.from_data(data).carrying(draw.files)
    except Refused:
        return data, None
