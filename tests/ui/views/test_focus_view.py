"""Light before and behind the screen: traced for eyes, the latest distance first."""

from dataclasses import replace

import numpy as np
import pytest

from ui.views import focus_view
from ui.views.focus_view import FocusView, z_at
from workbench.analysis.validation import validate, validating
from workbench.geometry.faces import FaceArrays
from workbench.measured.lamps import light_unit
from workbench.scene import Scene

pytestmark = pytest.mark.usefixtures("kernels")

FEW, MANY = 2_000, 8_000
PLACES = 31


@pytest.fixture(autouse=True)
def fewer_rays(monkeypatch):
    monkeypatch.setattr(focus_view, "_FEW", FEW)
    monkeypatch.setattr(focus_view, "_MANY", MANY)
    monkeypatch.setattr(focus_view, "_CURVE_RAYS", FEW)


@pytest.fixture
def wavy(session, frames):
    """Makes frames of wavy lenses, whose light is another at each distance."""

    def make(iteration, session=session):
        waves = 0.5 + 0.01 * iteration * np.sin(np.arange(120.0)).reshape(12, 10)
        return frames(iteration, session, heights=FaceArrays({"lens.back": waves}))

    return make


@pytest.fixture
def frame(wavy):
    return wavy(1)


@pytest.fixture
def traces(monkeypatch):
    """Notes distances and rays of all traces."""
    seen = []

    def noting(scene, target, heights, rays, *others, **named):
        if named:  # not the test's own
            seen.append((named["screen_z"], rays))
        return validating(scene, target, heights, rays, *others, **named)

    monkeypatch.setattr("workbench.analysis.validation.validating", noting)
    return seen


@pytest.fixture
def view(frame, traces, show, qtbot):
    view = FocusView()
    view.show_frame(frame)
    show(view, 420, 420)
    qtbot.waitUntil(lambda: view._answer is not None, timeout=30_000)
    yield view


def traced(view, frame, qtbot, rays=MANY):
    """Wait for the light at the shown distance; what it has to be."""
    scene, target = frame.session.scene, frame.session.target
    heights = frame.state.heights["lens.back"]
    wanted = validate(scene, target, {"lens.back": heights}, rays, screen_z=view.z)
    light = light_unit(scene).density * wanted.irradiance
    qtbot.waitUntil(lambda: np.array_equal(view._values, light), timeout=30_000)
    return wanted


def test_view_begins_at_the_screen_and_moves_to_any_distance(view, frame, qtbot):
    scene = frame.session.scene
    assert view.z == scene.receiver.z
    found = traced(view, frame, qtbot)
    assert f"z = {scene.receiver.z:.4g} cm (screen): error" in view._readout.text()
    assert f"{100 * found.efficiency:.1f} % of the light" in view._readout.text()
    near, far = (z_at(frame, part) for part in (500, 1500))
    top = scene.optic.highest
    assert near - top == pytest.approx((scene.receiver.z - top) / 2)
    assert far - top == pytest.approx((scene.receiver.z - top) * 1.5)
    for part, z in ((500, near), (1500, far), (1235, z_at(frame, 1235))):
        view._slider.setValue(part)
        assert view.z == z
        traced(view, frame, qtbot)
        assert f"z = {z:.4g} cm: error" in view._readout.text()
    view._back.click()
    assert view.z == scene.receiver.z


def test_a_wide_view_states_value_and_distance(view, frame, qtbot):
    traced(view, frame, qtbot)
    view.resize(1500, 420)
    view._shared.pointed.emit((0.0, 0.0))
    assert " at x = 0 cm" in view._readout.text()
    assert "z = 5 cm (screen): error" in view._readout.text()


def test_the_image_follows_the_lens_when_it_stops_changing(view, frame, wavy, traces, qtbot):
    traced(view, frame, qtbot)
    traces.clear()
    for iteration in (2, 3, 4):
        view.show_frame(wavy(iteration))
    assert traces == []
    assert "when the design rests" in view._readout.text()
    traced(view, wavy(4), qtbot)
    assert [rays for _, rays in traces] == [FEW, MANY]


def test_the_curve_shows_the_error_at_many_distances(view, frame, traces, qtbot):
    traced(view, frame, qtbot)
    assert not view._curve.isVisible()
    traces.clear()
    view._more.click()
    curve = view._curve
    qtbot.waitUntil(lambda: len(curve.errors) == PLACES, timeout=30_000)
    assert [z for z, _ in curve.errors] == [z for z, _ in traces]
    assert {rays for _, rays in traces} == {FEW}
    session, heights = frame.session, frame.state.heights["lens.back"]
    for z, error in curve.errors[::10]:
        wanted = validate(session.scene, session.target, {"lens.back": heights}, FEW, screen_z=z)
        assert error == wanted.relative_l2_corrected
    qtbot.waitUntil(
        lambda: hasattr(curve, "_curve") and len(curve._curve.curve.get_xdata()) == PLACES
    )
    np.testing.assert_allclose(
        curve._curve.curve.get_ydata(), [100 * error for _, error in curve.errors]
    )
    view._slider.setValue(600)
    qtbot.waitUntil(lambda: curve._curve.mark.get_xdata()[0] == view.z)
    assert len(curve.errors) == PLACES
    view._more.click()
    assert not curve.isVisible()


def test_nothing_is_traced_for_a_far_field_that_comes_while_a_screen_waits(
    view, wavy, session, traces, qtbot
):
    view.show_frame(wavy(2))
    far = {"kind": "far_field", "half_angle": [10.0, 10.0], "pixels": [32, 32]}
    data = session.scene.to_data()
    data["images"][0]["receiver"] = far
    far_session = replace(session, scene=Scene.from_data(data))
    view.show_frame(wavy(1, far_session))
    traces.clear()
    qtbot.wait(600)  # errors in slots fail a test
    assert traces == []
    assert "no distance" in view._readout.text()
