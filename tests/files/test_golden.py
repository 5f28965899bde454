"""Files that earlier programs wrote open for ever; see `golden`.

``first`` is by the first program that wrote sessions, ``staged`` by the first that ran in stages;
``scenes`` holds examples as earlier programs wrote them, in versions 1 and 2.
``compared`` has locks, kept runs and a view, ``checked`` a run whose error is verified, ``started``
a lens of another task, ``drawn`` the picture of its target. ``mirror`` and ``two-faces`` are of
version 2.
"""

import io
import json
import zipfile
from pathlib import Path

import numpy as np
import pytest

import resources
from workbench.analysis.validation import validate
from workbench.files.session import read_session, write_session
from workbench.scene import Scene

GOLDEN = Path(__file__).parent / "golden"
NAMES = sorted(path.name for path in GOLDEN.glob("*.freeform"))
SCENES = sorted((GOLDEN / "scenes").iterdir())
NEWER = ("mirror.freeform", "two-faces.freeform")


def arrays_of(path):
    """The arrays as numpy itself reads them, by the names of their entries."""
    with zipfile.ZipFile(path) as archive:
        return {
            name.removesuffix(".npy"): np.load(io.BytesIO(archive.read(name)))
            for name in archive.namelist()
            if name.endswith(".npy")
        }


def header_of(path):
    with zipfile.ZipFile(path) as archive:
        return json.loads(archive.read("session.json"))


def assert_result(result, figures, arrays):
    entries = {"entrance": "entrance_points"}
    for face, heights in result.state.heights.items():
        np.testing.assert_array_equal(heights, arrays[entries.get(face, "control_points")])
    np.testing.assert_array_equal(result.state.irradiance, arrays["irradiance"])
    np.testing.assert_array_equal(result.losses, arrays["loss"])
    assert result.state.loss == figures["loss"]
    for name in ("iterations", "seconds"):
        assert getattr(result, name) == figures[name]
    message = result.state.account.to_data()
    assert {name: message[name] for name in figures["ledger"]} == figures["ledger"]


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_scene_files_of_earlier_versions_mean_the_same(path):
    assert json.loads(path.read_bytes())["version"] < 3
    today = resources.path("examples", path.name)
    assert Scene.from_json(path.read_bytes()) == Scene.from_json(today.read_bytes())


@pytest.mark.parametrize("name", NAMES)
def test_golden_files_open_with_all_their_content(name):
    session = read_session(GOLDEN / name)
    header, arrays = header_of(GOLDEN / name), arrays_of(GOLDEN / name)
    assert header["version"] == (2 if name in NEWER else 1)
    assert session.scene.optic.control_points == (6, 5)
    np.testing.assert_array_equal(session.target, arrays["target"])
    if "result" in header:
        assert_result(session.result, header["result"], arrays)
    for number, run in enumerate(session.runs):
        folder = f"runs/{number}/"
        own = {k.removeprefix(folder): v for k, v in arrays.items() if k.startswith(folder)}
        np.testing.assert_array_equal(run.target, own["target"])
        assert_result(run.result, header["runs"][number]["result"], own)


@pytest.mark.parametrize("name", NAMES)
def test_golden_files_lose_nothing_when_written_again(name, tmp_path):
    session = read_session(GOLDEN / name)
    write_session(session, tmp_path / name)
    before, after = arrays_of(GOLDEN / name), arrays_of(tmp_path / name)
    assert before.keys() == after.keys()
    for entry, array in before.items():
        np.testing.assert_array_equal(after[entry], array)
    again = read_session(tmp_path / name)
    assert again.scene == session.scene
    assert again.view == session.view
    assert again.picture == session.picture


@pytest.mark.parametrize(
    ("name", "faces", "error", "efficiency"),
    [
        # Light that crosses the plane of the mirror's base beside its outline misses the mirror.
        ("mirror", ["mirror"], 0.2626, 0.4389),
        ("two-faces", ["entrance", "exit"], 0.0978, 0.9702),
    ],
)
def test_verified_figures_of_mirrors_and_lenses_of_two_faces(name, faces, error, efficiency):
    session = read_session(GOLDEN / f"{name}.freeform")
    assert list(session.heights) == faces
    found = validate(session.scene, session.target, session.heights, 10_000, accuracy=1e-3)
    assert found.verified.relative_l2_corrected == pytest.approx(error, abs=1e-3)
    assert found.verified.efficiency == pytest.approx(efficiency, abs=1e-3)
