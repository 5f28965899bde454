"""How long the real window is held up while a design runs. Figures are printed, not asserted.

``LATENCY_SECONDS=120 python -m pytest -m slow tests/ui/test_latency.py`` measures two minutes.
"""

import os

import pytest

import resources
from workbench.files.session import Session, open_design

pytestmark = pytest.mark.slow

_SECONDS = float(os.environ.get("LATENCY_SECONDS", "20"))
_WARMING_SECONDS = 5.0  # imports, first drawings


@pytest.fixture
def window(display, open_window):
    """The window with the flame example, which the paper's method never finishes."""
    shipped = open_design(resources.path("examples", "flame.json"))
    data = shipped.scene.to_data()
    data["run"] = {"method": "paper", "iterations": 1_000_000}
    data["lens"]["control_points"] = [64, 64]  # on finer nets its learning rate is too bold
    window = open_window(Session(shipped.scene.from_data(data), shipped.target), "flame")
    window.resize(1600, 1000)
    window.build()
    return window


@pytest.mark.timeout(0)
@pytest.mark.parametrize("shown", [True, False], ids=["3D shown", "3D hidden"])
def test_the_window_answers_during_a_run(shown, window, latency_probe, qtbot, capsys, request):
    frames = []
    window.loaded.control.runner.frame_ready.connect(frames.append)
    window.commands["scene_view"].setChecked(shown)
    window.start()
    qtbot.waitUntil(lambda: bool(frames), timeout=60_000)
    qtbot.wait(int(1000 * _WARMING_SECONDS))
    begun = frames[-1].snapshot.iteration
    latency_probe.start()
    qtbot.wait(int(1000 * _SECONDS))
    latency_probe.stop()
    steps = frames[-1].snapshot.iteration - begun
    with qtbot.waitSignal(window.loaded.control.ended):
        window.loaded.control.runner.stop()
    assert steps > 0
    with capsys.disabled():
        report = latency_probe.report(request.node.callspec.id)
        print(f"\n{report}, {steps / _SECONDS:.1f} iterations/s", end="")
