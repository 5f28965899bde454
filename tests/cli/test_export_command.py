from io import BytesIO
from zipfile import ZipFile

import pytest
import trimesh

from tests.accounts import result_of
from workbench.files.session import Session, write_session


@pytest.fixture
def lens(make_scene, rng, tmp_path):
    """A session with a wavy lens."""
    scene = make_scene()
    result = result_of(0.5 + 0.02 * rng.random((12, 10)), rng.random((32, 32)))
    path = tmp_path / "lens.freeform"
    write_session(Session(scene, rng.random((32, 32)), result), path)
    return path


def test_a_line_per_file_states_its_deviation(freeform, lens, tmp_path):
    step, mesh = tmp_path / "a.step", tmp_path / "a.stl"
    status, stdout, stderr = freeform("export", lens, step, mesh, "--chord-error", "0.001")
    assert (status, stderr) == (0, "")
    first, second = stdout.splitlines()
    assert first == f"{step}: STEP solid, rounding 0 cm"
    start, end = f"{mesh}: STL mesh, chord error ", " µm, lengths in mm"
    assert second.startswith(start) and second.endswith(end)
    assert 0 < 1e-4 * float(second.removeprefix(start).removesuffix(end)) <= 0.001
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


def test_a_tile_is_cut_out_where_it_is_asked_for_in_meshes_alone(freeform, lens, tmp_path):
    path, package = tmp_path / "a.obj", tmp_path / "a.zip"
    given = "--tile-side", "0.5", "--tile-x", "0.5", "--tile-y", "-0.25"
    status, stdout, _ = freeform(
        "export", lens, path, package, "--tool-radius", "0.05", "--scallop", "5e-3", *given
    )
    assert status == 0
    assert stdout.splitlines()[0].endswith(", test tile, lengths in mm")
    bounds = trimesh.load_mesh(path).bounds[:, :2].ravel().tolist()
    assert bounds == pytest.approx([2.5, -5, 7.5, 0], abs=1e-9)
    with ZipFile(package) as files:
        (name,) = (each for each in files.namelist() if each.endswith(".stl"))
        whole = trimesh.load_mesh(BytesIO(files.read(name)), file_type="stl")
    assert whole.extents[:2] == pytest.approx([20, 20])


@pytest.mark.parametrize(
    "arguments, reason",
    [
        (["a.step", "a.dwg"], "a.dwg: has no known ending; use one of .step, "),
        (["missing/a.step"], "missing/a.step: cannot be written: its folder does not exist"),
        (["lens.freeform"], "lens.freeform: is the session itself; another file is needed"),
        (["a.stl", "--chord-error", "0"], "'0'; a number greater than 0 is needed"),
        (["a.stl", "--chord-error", "inf"], "'inf'; a finite number is needed"),
        (["a.stl", "--mesh-unit", "feet"], "'feet'"),
        (["a.stl", "--chord-error", "1e-12"], "--chord-error: 1e-12 cm is finer than the numbers"),
        (["a.stl", "--tile-side", "0.5", "--tile-x", "0.9"], "0.5 cm about (0.9, 0) is not within"),
        (["a.stl", "--tile-y", "nan"], "tile_y: nan; a finite number is needed"),
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


@pytest.mark.parametrize(
    "name, given, reason",
    [
        ("b.nc", ["--tool-radius", "-1"], "tool_radius: -1; a length above 0"),
        ("b.zip", ["--tool-radius", "50"], "wider than the part"),
        ("b.nc", ["--stock", "1e-6"], "0.01 µm is too thin for the part"),
        (
            "b.nc",
            ["--tool-radius", "0.1", "--cutter", "1 mm"],
            "a standard cutter is chosen as well",
        ),
        ("b.nc", ["--dialect", "heidenhain"], "invalid choice: 'heidenhain'"),
        ("b.zip", ["--points-per-turn", "1"], "points_per_turn: 1; from 16 to 100,000"),
        ("b.zip", ["--form-tolerance", "0"], "form_tolerance: 0; a length above 0"),
    ],
)
def test_impossible_options_are_refused_before_anything_is_written(
    freeform, lens, tmp_path, monkeypatch, name, given, reason
):
    monkeypatch.chdir(tmp_path)
    status, stdout, stderr = freeform("export", lens, "a.stl", name, *given)
    assert (status, stdout) == (2, "")
    assert reason in stderr and stderr.count("\n") == 1
    assert list(tmp_path.iterdir()) == [lens]


def test_files_that_are_refused_stop_no_other_and_are_named(freeform, lens, tmp_path):
    files = [tmp_path / name for name in ("a.stl", "a.step", "a.obj", "a.height.csv")]
    status, stdout, stderr = freeform("export", lens, *files, "--chord-error", "1e-12")
    assert status == 2
    assert [line.split(":")[0] for line in stdout.splitlines()] == [str(files[1]), str(files[3])]
    assert stderr.count("\n") == 1
    assert all(f"{file}: " in stderr and not file.exists() for file in files[::2])
    assert all(file.exists() for file in files[1::2])


def test_a_tool_path_tells_the_cutter_and_what_it_leaves(freeform, lens, tmp_path):
    path = tmp_path / "a.nc"
    given = "--tool-radius", "0.05", "--scallop", "1e-3", "--rim", "0.1", "--feed", "250"
    status, stdout, stderr = freeform("export", lens, path, *given)
    assert (status, stderr) == (0, "")
    assert "G-code, simulated cut off by " in stdout
    assert "cutter radius 0.05 cm," in stdout
    assert " F250\n" in path.read_text()
    assert "\nM3 S10000\nG4 P3\n" in path.read_text()
