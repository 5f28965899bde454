"""Files that earlier programs wrote open for ever; see `golden`.

``first`` is by the first program that wrote sessions, ``staged`` by the first that ran in stages;
``compared`` has locks, kept runs and a view, ``checked`` a run whose error is verified, ``started``
a lens of another task, ``drawn`` the picture of its target. ``mirror`` and ``two-faces`` are of
version 2. ``two-images`` is of version 3: both faces of a lens beside z = 0 are designed for two
images, one of them is locked in part, and a run is kept.
"""

import io
import json
import re
import zipfile
from pathlib import Path

import numpy as np
import pytest

from workbench.analysis.validation import validate
from workbench.files.session import read_session, write_session
from workbench.geometry.faces import NO_LOCKS

GOLDEN = Path(__file__).parent / "golden"
NAMES = sorted(path.name for path in GOLDEN.glob("*.freeform"))
VERSIONS = {"mirror.freeform": 2, "two-faces.freeform": 2, "two-images.freeform": 3}
# Names in version 3 of entries of versions 1 and 2; a mirror had those of an exit face.
RENAMED = {
    "target": "images/0/target",
    "irradiance": "images/0/irradiance",
    "control_points": "faces/lens.back",
    "entrance_points": "faces/lens.front",
    "locked": "faces/lens.back.locked",
    "start": "faces/lens.back.start",
}


def arrays_of(path):
    """The arrays as numpy itself reads them, by the names of their entries."""
    with zipfile.ZipFile(path) as archive:
        return {
            name.removesuffix(".npy"): np.load(io.BytesIO(archive.read(name)))
            for name in archive.namelist()
            if name.endswith(".npy")
        }


def renamed(arrays, scene):
    """Arrays by the names of their entries in version 3."""

    def new(name):
        folder = re.match(r"(runs/\d+/)?", name)[0]
        last = name.removeprefix(folder)
        last = RENAMED.get(last, last).replace("lens.back", scene.optic.designed_face)
        return folder + last

    return {new(name): array for name, array in arrays.items()}


def header_of(path):
    with zipfile.ZipFile(path) as archive:
        return json.loads(archive.read("session.json"))


def assert_result(result, figures, arrays, z):
    """A result is that of the file, whose heights are counted from ``z``."""
    for face, heights in result.state.heights.items():
        np.testing.assert_array_equal(heights, arrays[f"faces/{face}"] + z)
    lights = [result.state.irradiance, *(light.irradiance for light in result.state.further)]
    for number, irradiance in enumerate(lights):
        np.testing.assert_array_equal(irradiance, arrays[f"images/{number}/irradiance"])
    np.testing.assert_array_equal(result.losses, arrays["loss"])
    assert result.state.loss == figures["loss"]
    for name in ("iterations", "seconds"):
        assert getattr(result, name) == figures[name]
    message = result.state.account.to_data()
    assert {name: message[name] for name in figures["ledger"]} == figures["ledger"]


@pytest.mark.parametrize("name", NAMES)
def test_golden_files_open_with_all_their_content(name):
    session = read_session(GOLDEN / name)
    header, arrays = header_of(GOLDEN / name), arrays_of(GOLDEN / name)
    arrays = renamed(arrays, session.scene)
    assert header["version"] == VERSIONS.get(name, 1)
    assert session.scene.optic.control_points == (6, 5)
    z = session.scene.optic.position[2]
    for number, image in enumerate(session.scene.wanted(session.target)):
        np.testing.assert_array_equal(image.target, arrays[f"images/{number}/target"])
    for face, locked in session.locked.items():
        np.testing.assert_array_equal(locked, arrays[f"faces/{face}.locked"])
    if "result" in header:
        assert_result(session.result, header["result"], arrays, z)
    for number, run in enumerate(session.runs):
        folder = f"runs/{number}/"
        own = {k.removeprefix(folder): v for k, v in arrays.items() if k.startswith(folder)}
        np.testing.assert_array_equal(run.target, own["images/0/target"])
        assert_result(run.result, header["runs"][number]["result"], own, z)


@pytest.mark.parametrize("name", NAMES)
def test_golden_files_lose_nothing_when_written_again(name, tmp_path):
    session = read_session(GOLDEN / name)
    write_session(session, tmp_path / name)
    before, after = renamed(arrays_of(GOLDEN / name), session.scene), arrays_of(tmp_path / name)
    assert before.keys() == after.keys()
    for entry, array in before.items():
        np.testing.assert_array_equal(after[entry], array)
    again = read_session(tmp_path / name)
    assert again.scene == session.scene
    assert again.locked == session.locked
    assert again.view == session.view
    assert again.picture == session.picture


def test_figures_of_the_first_program():
    session = read_session(GOLDEN / "first.freeform")
    assert session.result.state.loss == 0.002639537211507559
    assert session.result.state.account.lost["left_side"] == 0
    assert session.result.stage_starts == ()
    assert (session.locked, session.runs, session.view, session.start) == (NO_LOCKS, (), None, None)


@pytest.mark.parametrize(
    ("name", "faces", "error", "efficiency"),
    [
        # Light that crosses the plane of the mirror's base beside its outline misses the mirror.
        ("mirror", ["mirror.face"], 0.2626, 0.4389),
        ("two-faces", ["lens.front", "lens.back"], 0.0978, 0.9702),
    ],
)
def test_verified_figures_of_mirrors_and_lenses_of_two_faces(name, faces, error, efficiency):
    session = read_session(GOLDEN / f"{name}.freeform")
    assert list(session.heights) == faces
    found = validate(session.scene, session.target, session.heights, 10_000, accuracy=1e-3)
    assert found.verified.relative_l2_corrected == pytest.approx(error, abs=1e-3)
    assert found.verified.efficiency == pytest.approx(efficiency, abs=1e-3)
