"""Design tasks at random with several elements: designed and fixed lenses, mirrors, diffusers."""

import io
from typing import Any

import numpy as np

from tests.stress.lamps import LAMPS
from tests.stress.random_tasks import TaskDraw

SOURCES = ("collimated", "beam", "sun", "point", "grid", "area", "ray_file")
SPECTRUM = [[0.45, 0.4], [0.63, 0.6]]


def _bowl() -> bytes:
    """Control heights of a fixed face, which is not symmetric."""
    x, y = np.linspace(-1, 1, 7)[:, None], np.linspace(-1, 1, 6)
    file = io.BytesIO()
    np.save(file, 0.4 + 0.06 * x**2 + 0.04 * y**2 + 0.02 * x * y)
    return file.getvalue()


class TrainDraw(TaskDraw):
    """Draws the fields of one train of elements along an axis that a mirror may fold."""

    files = LAMPS | {"bowl.npy": _bowl()}

    def __init__(self, seed: int, number: int) -> None:
        super().__init__(seed, number)
        self._at = 0.0  # along the axis
        self._fold: float | None = None  # where the axis turns from +z to +y

    def scene(self) -> dict[str, Any]:
        """A whole scene of version 3; some are refused."""
        source = self._source(self.one_of(*SOURCES), aside=False)
        if "center" in source:
            source["position"] = source.pop("center")
        if source["kind"] == "collimated":
            source["direction"] = [self.one_of(0.0, 0.0, self.between(-8, 8)) for _ in "xy"]
        if source["kind"] != "ray_file" and self.one_of(True, False, False):
            source["spectrum"] = SPECTRUM
        mirror_at = self.one_of(None, None, 0, 1)  # elements in front of it
        kinds = [self.one_of("plane", "conic", "fixed", "designed"), "designed"]
        elements: list[dict[str, Any]] = []
        for number, kind in enumerate(kinds):
            if number == mirror_at:
                elements.append(self._mirror_of_train())
            elements.append(self._lens_of_train(f"lens{number}", kind))
        if self.one_of(True, False, False):
            elements.append(self._diffuser())
        return {
            "format": "freeform-scene",
            "version": 3,
            "unit": "mm",
            "source": source,
            "elements": elements,
            "images": [{"receiver": self._receiver_of_train(), "target": {"builtin": "flame"}}],
            "run": {"iterations": 2, "seed": 0},
        }

    def _placed(self, width: float, gap: float, **fields: Any) -> dict[str, Any]:
        """An element at a distance behind the one in front of it, now and then askew."""
        self._at += gap
        x, y = (self.one_of(0.0, 0.0, self.between(-0.1, 0.1)) for _ in "xy")
        about_x, about_y = (self.one_of(0.0, 0.0, self.between(-6, 6)) for _ in "xy")
        position = [x, y, self._at]
        if self._fold is not None:
            position = [x, self._at - self._fold, self._fold - y]
            about_x -= 90.0
        return {
            "position": position,
            "tilt": [about_x, about_y, 0.0],
            "half_width": [width, width * self.one_of(1.0, 0.8)],
            **fields,
        }

    def _lens_of_train(self, name: str, kind: str) -> dict[str, Any]:
        face: dict[str, Any] = {"shape": "plane"}
        if kind == "conic":
            face = {"shape": "conic", "radius": self.one_of(-1, 1) * self.between(5, 30)}
        elif kind == "fixed":
            face = {"shape": "bspline", "fixed": True, "heights": "bowl.npy"}
            face["control_points"] = [7, 6]
        elif kind == "designed":
            face = {"shape": "bspline", **self._net()}
        lens = self._placed(
            1.0 + 0.25 * self._at,
            self.between(0.5, 2) if self._at else 0.0,
            kind="lens",
            name=name,
            material=self.one_of("PMMA", {"index": 1.5}),
            thickness=0.4,
            faces=[{"shape": "plane"}, face],
            outline=self.one_of("rectangle", "ellipse"),
            min_thickness=0.05,
        )
        self._at += 0.4
        return lens

    def _mirror_of_train(self) -> dict[str, Any]:
        width = 1.2 + 0.3 * self._at
        mirror = self._placed(width, 2 * width if self._at else 0.0, kind="mirror", name="fold")
        self._fold = self._at
        self._at += 1.8 * width
        face = self.one_of({"shape": "plane"}, {"shape": "bspline", **self._net()})
        mirror["half_width"][1] = 1.5 * width
        return mirror | {"tilt": [45.0, 0.0, 0.0], "face": face, "reflectance": 0.9}

    def _diffuser(self) -> dict[str, Any]:
        return self._placed(
            3.0 + 0.4 * self._at,
            self.between(2, 6),
            kind="diffuser",
            name="film",
            scatter={"kind": "gaussian", "sigma": self.between(0.3, 5)},
            transmittance=self.one_of(1.0, 0.8),
        )

    def _receiver_of_train(self) -> dict[str, Any]:
        pixels = [self.one_of(8, 16, 24), self.one_of(8, 16, 24)]
        if self._fold is None and self.one_of(True, False, False):
            half = [self.between(10, 40) for _ in "xy"]
            return {"kind": "far_field", "half_angle": half, "pixels": pixels}
        far = self.size(3, 60)
        return self._placed(2.0 + far * self.between(0.2, 0.6), far, kind="plane", pixels=pixels)
