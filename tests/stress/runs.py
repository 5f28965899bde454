"""What has to hold for every run of the best method, however extreme its task."""

from typing import Any

import numpy as np
import pytest

from tests.stress.scenes import Case
from workbench.arrays import Array
from workbench.design import descent
from workbench.design.limits import HeightLimits
from workbench.design.run import run
from workbench.errors import Refused, RunFailed
from workbench.scene import Scene

TARGETS = ("tophat", "one pixel", "line", "checkerboard", "noise", "denormal", "huge")


def target(kind: str, scene: Scene) -> Array:
    """A target that is hard to reach."""
    n_x, n_y = scene.receiver.pixels
    rng = np.random.default_rng(1)
    image = np.zeros((n_y, n_x))
    if kind == "tophat":
        image[n_y // 4 : n_y - n_y // 4, n_x // 4 : n_x - n_x // 4] = 1
    elif kind == "one pixel":
        image[rng.integers(n_y), rng.integers(n_x)] = 1
    elif kind == "line":
        image[:, rng.integers(n_x)] = 1
    elif kind == "checkerboard":
        image[np.add.outer(np.arange(n_y), np.arange(n_x)) % 2 == 0] = 1
    else:
        image = rng.random((n_y, n_x)) * {"noise": 1, "denormal": 1e-310, "huge": 1e300}[kind]
    return image


def check_within(heights: Array, allowed: HeightLimits) -> None:
    """No height is beyond its ends by more than rounding."""
    lower, upper = allowed.lower, allowed.upper
    rounding = 1e-12 * (upper - lower).max() + 1e-15 * np.abs(upper).max()
    assert (heights >= lower - rounding).all()
    assert (heights <= upper + rounding).all()


def check_run(case: Case, image: str, monkeypatch: pytest.MonkeyPatch) -> str:
    """Run a few iterations; returns the sentence with which the run refused or failed, or none."""
    descents: list[list[float]] = []
    minimise = descent.minimise

    def observed(*args: Any) -> Any:
        values: list[float] = []
        descents.append(values)
        for x, found in minimise(*args):
            values.append(found.value)
            yield x, found

    monkeypatch.setattr(descent, "minimise", observed)
    scene = case.scene
    settings = scene.run.model_copy(update={"iterations": 6})
    scene = scene.model_copy(update={"run": settings})
    allowed = HeightLimits.of_faces(scene.optic)
    stated = ""
    best: list[float] = []
    try:
        for snapshot in run(scene, target(image, scene)):
            assert np.isfinite(snapshot.state.loss)
            assert np.isfinite(snapshot.state.irradiance).all()
            for face, heights in snapshot.state.heights.items():
                check_within(heights, allowed[face])
            light = snapshot.state.account.to_data()
            emitted = light.pop("emitted")
            largest = max(1, *map(abs, light.values()))
            assert sum(light.values()) == pytest.approx(emitted, abs=1e-5 * largest)
            if snapshot.best and not snapshot.judged:
                best.append(snapshot.merit)  # a lens without light is worse than any other
    except (Refused, RunFailed) as error:
        stated = str(error)
        assert stated.strip()
        assert "\n" not in stated
    assert (np.diff(best) < 0).all()
    for values in descents:
        assert (np.diff(values) <= 0).all()
    return stated
