import numpy as np
import pytest
import trimesh

from tests.accounts import account_of
from workbench.design.lens_state import LensState
from workbench.design.snapshot import Result
from workbench.errors import RunFailed
from workbench.files.export.formats import FORMATS
from workbench.files.session import Session, write_session
from workbench.geometry.faces import FaceArrays


@pytest.fixture
def lens(make_scene, rng, tmp_path):
    """A session with a wavy lens."""
    scene = make_scene()
    result = Result(
        LensState(
            heights=FaceArrays({"exit": 0.5 + 0.02 * rng.random((12, 10))}),
            irradiance=rng.random((32, 32)),
            loss=0.1,
            account=account_of(1.0, 0.7, 0.1, 0.0, 0.0, 0.06, 0.04, 0.1),
        ),
        losses=np.zeros(1),
        seconds=1.0,
    )
    path = tmp_path / "lens.freeform"
    write_session(Session(scene, rng.random((32, 32)), result), path)
    return path


def test_a_line_per_file_states_its_deviation(freeform, lens, tmp_path):
    step, mesh = tmp_path / "a.step", tmp_path / "a.stl"
    status, stdout, stderr = freeform("export", lens, step, mesh, "--chord-error", "0.001")
    assert (status, stderr) == (0, "")
    first, second = stdout.splitlines()
    assert first == f"{step}: STEP solid, rounding 0 cm"
    start, end = f"{mesh}: STL mesh, chord error ", " · 10⁻⁶ cm, lengths in mm"
    assert second.startswith(start) and second.endswith(end)
    assert 0 < 1e-6 * float(second.removeprefix(start).removesuffix(end)) <= 0.001
    assert trimesh.load_mesh(mesh).is_watertight


@pytest.mark.parametrize("given, width", [((), 20), (("--mesh-unit", "scene"), 2)])
def test_meshes_are_in_millimetres_or_in_the_unit_that_is_asked_for(
    freeform, lens, tmp_path, given, width
):
    path = tmp_path / "a.obj"
    status, stdout, _ = freeform("export", lens, path, "--chord-error", "0.01", *given)
    assert status == 0
    assert stdout.strip().endswith("lengths in cm" if given else "lengths in mm")
    assert trimesh.load_mesh(path).extents[0] == pytest.approx(width)


def test_a_smaller_chord_error_takes_more_triangles(freeform, lens, tmp_path):
    sizes = []
    for chord_error in ("1e-3", "1e-4"):
        freeform("export", lens, tmp_path / "a.stl", "--chord-error", chord_error)
        sizes.append((tmp_path / "a.stl").stat().st_size)
    assert 5 < sizes[1] / sizes[0] < 20


@pytest.mark.parametrize(
    "arguments, reason",
    [
        (["a.step", "a.dwg"], "a.dwg: has no ending that tells a format; one of .step, "),
        (["missing/a.step"], "missing/a.step: cannot be written: its folder does not exist"),
        (["lens.freeform"], "lens.freeform: is the session itself; another file is needed"),
        (["a.stl", "--chord-error", "0"], "'0'; a number greater than 0 is needed"),
        (["a.stl", "--chord-error", "inf"], "'inf'; a finite number is needed"),
        (["a.stl", "--mesh-unit", "feet"], "'feet'"),
        (["a.stl", "--chord-error", "1e-12"], "--chord-error: 1e-12 cm is finer than the numbers"),
        ([], "the following arguments are required: FILE"),
    ],
)
def test_refused(freeform, lens, tmp_path, monkeypatch, arguments, reason):
    monkeypatch.chdir(tmp_path)
    status, stdout, stderr = freeform("export", lens, *arguments)
    assert (status, stdout) == (2, "")
    assert reason in stderr
    assert stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == [lens]


def test_files_that_are_refused_stop_no_other_and_are_named(freeform, lens, tmp_path):
    names = "a.nc", "a.stl", "a.gcode", "a.obj"
    files = [tmp_path / name for name in names]
    given = "--chord-error", "0.01", "--tool-radius", "50"
    status, stdout, stderr = freeform("export", lens, *files, *given)
    assert status == 2
    assert [line.split(":")[0] for line in stdout.splitlines()] == [str(files[1]), str(files[3])]
    assert stderr.count("\n") == 1
    for file in (files[0], files[2]):
        assert f"{file}: " in stderr and not file.exists()
    assert trimesh.load_mesh(files[1]).is_watertight and files[3].exists()


def test_a_library_that_fails_stops_no_other_file(freeform, lens, tmp_path, monkeypatch):
    def fail(design, file):
        raise RunFailed("no library")

    (step,) = {found.writer for found in FORMATS if ".step" in found.endings}
    monkeypatch.setattr(f"workbench.files.export.step.{step}", fail)
    files = tmp_path / "a.step", tmp_path / "a.stl"
    status, _, stderr = freeform("export", lens, *files, "--chord-error", "0.01")
    assert status == 1 and stderr == f"freeform: {files[0]}: no library\n"
    assert files[1].exists() and not files[0].exists()


def test_a_scene_without_a_lens_is_refused(freeform, scene_file, tmp_path):
    status, _, stderr = freeform("export", scene_file, tmp_path / "a.step")
    assert status == 2
    assert "is no session" in stderr


def test_a_tool_path_tells_the_cutter_and_what_it_leaves(freeform, lens, tmp_path):
    path = tmp_path / "a.nc"
    given = "--tool-radius", "0.05", "--scallop", "1e-3", "--rim", "0.1", "--feed", "250"
    status, stdout, stderr = freeform("export", lens, path, *given)
    assert (status, stderr) == (0, "")
    assert "G-code, simulated cut off by " in stdout
    assert "cutter radius 0.05 cm," in stdout
    assert " F250\n" in path.read_text()
    assert "\nM3 S10000\nG4 P3\n" in path.read_text()


@pytest.mark.parametrize(
    "option, value, allowed",
    [
        ("--spindle-speed", "0", "from 1 to 200,000 rpm"),
        ("--plunge-feed", "1e9", "from 1 to 100,000 mm/min"),
        ("--dwell", "nan", "from 0 to 600 s"),
    ],
)
def test_what_a_machine_cannot_do_is_refused(freeform, lens, tmp_path, option, value, allowed):
    status, _, stderr = freeform("export", lens, tmp_path / "a.nc", option, value)
    assert status == 2
    assert option in stderr and allowed in stderr


def test_help_lists_the_endings(freeform, capsys):
    with pytest.raises(SystemExit) as stop:
        freeform("export", "--help")
    assert stop.value.code == 0
    assert ".irradiance.tiff" in capsys.readouterr().out
