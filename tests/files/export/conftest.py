from types import SimpleNamespace

import numpy as np
import pytest
import trimesh

from tests.accounts import account_of
from tests.scenes import changed
from workbench.design.lens_state import LensState
from workbench.design.levels import COARSE
from workbench.design.snapshot import Result
from workbench.files.export.design import Design
from workbench.geometry.faces import FaceArrays
from workbench.geometry.surface import freeform_nets
from workbench.scene import Scene


def pytest_collection_modifyitems(items):
    """Mark tests that read a file by OpenCASCADE."""
    for item in items:
        if "read_solid" in getattr(item, "fixturenames", ()):
            item.add_marker(pytest.mark.full)


@pytest.fixture
def make_design(make_scene, rng):
    """A wavy lens, 2 × 1.4 wide; ``heights`` in place of the waves, fields of the scene changed.

    A freeform entrance face is wavy, too, and of another net than the exit face.
    """

    def make(changes=None, heights=None, chord_error=None, entrance=None):
        changes = {"lens.half_width": [1.0, 0.7]} | (changes or {})
        scene = make_scene(changes)
        if heights is None:
            heights = 0.5 + 0.05 * rng.normal(size=scene.optic.net_shape)
        faces = (
            {"lens.back": heights}
            if entrance is None
            else {"lens.back": heights, "lens.front": entrance}
        )
        for name, net in freeform_nets(scene.optic).items():
            faces.setdefault(name, 0.05 * rng.normal(size=net.shape))
        return designed(scene, faces, rng, chord_error)

    return make


@pytest.fixture
def make_mirror(rng):
    """A wavy mirror, 2 × 1.4 wide; ``heights`` in place of the waves, fields changed."""
    data = {
        "unit": "cm",
        "mirror": {"half_width": [1.0, 0.7], "control_points": [7, 6], "thickness": 0.3},
        "source": {"kind": "collimated", "rays": [64, 64]},
        "screen": {"z": -5.0, "half_width": [1.0, 1.0], "pixels": [4, 4]},
        "target": {"builtin": "tophat"},
    }

    def make(changes=None, heights=None):
        scene = Scene.from_data(changed(changes or {}, data))
        if heights is None:
            heights = 0.05 * rng.normal(size=scene.optic.net_shape)
        return designed(scene, {"mirror.face": heights}, rng, 1e-4)

    return make


def designed(scene, faces, rng, chord_error):
    """The element of a scene with control heights of its faces, and light of no meaning."""
    n_x, n_y = scene.receiver.pixels
    state = LensState(
        heights=FaceArrays({face: np.asarray(heights) for face, heights in faces.items()}),
        irradiance=rng.random((n_y, n_x)),
        loss=0.1,
        account=account_of(1.0, 0.7, 0.1, 0.0, 0.0, 0.06, 0.04, 0.1),
    )
    return Design(scene, Result(state, losses=np.zeros(1), seconds=1.0), chord_error)


@pytest.fixture
def volume():
    """Exact volume of a lens: a basis function's integral is its support over degree + 1."""

    def below(face):
        weights = [
            (knots[p + 1 :] - knots[: -p - 1]) / (p + 1) * (2 * r)
            for knots, p, r in zip(
                face.net.knots, face.net.degree, face.net.half_width, strict=True
            )
        ]
        above = face.heights - face.scene.optic.entrance_z
        return float(weights[0] @ above @ weights[1])

    def integral(design):
        exit_, *entrance = map(below, design.faces)
        return exit_ - sum(entrance)

    return integral


@pytest.fixture
def read_solid():
    """Reads a STEP or IGES file by OpenCASCADE: its shape, what its checker says, its faces.

    Lengths come in millimetres, whatever the file's unit.
    """
    from OCP.Bnd import Bnd_Box
    from OCP.BRep import BRep_Tool
    from OCP.BRepBndLib import BRepBndLib
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.IGESControl import IGESControl_Reader
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    as_face = getattr(TopoDS, "Face_s", None) or TopoDS.Face  # its name before and since 8.0

    def parts(shape, kind):
        explorer, found = TopExp_Explorer(shape, kind), []
        while explorer.More():
            found.append(explorer.Current())
            explorer.Next()
        return found

    def read(path):
        reader = STEPControl_Reader() if path.suffix == ".step" else IGESControl_Reader()
        assert reader.ReadFile(str(path)) == IFSelect_ReturnStatus.IFSelect_RetDone
        reader.TransferRoots()
        shape = reader.OneShape()
        return described(shape)

    def described(shape):
        properties, box = GProp_GProps(), Bnd_Box()
        BRepGProp.VolumeProperties_s(shape, properties, 1e-12)
        BRepBndLib.AddOptimal_s(shape, box, False, False)
        shells = parts(shape, TopAbs_ShapeEnum.TopAbs_SHELL)
        return SimpleNamespace(
            solids=[described(s) for s in parts(shape, TopAbs_ShapeEnum.TopAbs_SOLID)]
            if shape.ShapeType() == TopAbs_ShapeEnum.TopAbs_COMPOUND
            else [],
            box=np.array([(p.X(), p.Y(), p.Z()) for p in (box.CornerMin(), box.CornerMax())]),
            is_solid=shape.ShapeType() == TopAbs_ShapeEnum.TopAbs_SOLID,
            is_valid=BRepCheck_Analyzer(shape).IsValid(),
            is_closed=len(shells) == 1 and BRep_Tool.IsClosed_s(shells[0]),
            volume=properties.Mass(),
            surfaces=[
                BRep_Tool.Surface_s(as_face(face))
                for face in parts(shape, TopAbs_ShapeEnum.TopAbs_FACE)
            ],
        )

    return read


@pytest.fixture
def write(tmp_path):
    """Writes a file by a writer; its path and what the writer says of it."""

    def do(writer, content, name):
        path = tmp_path / name
        with path.open("xb") as file:
            deviation = writer(content, file)
        return path, deviation

    return do


@pytest.fixture
def closed_mesh(write):
    """Writes a lens as a mesh by a writer; the body in the file, which has to be one and closed.

    Lengths are in the unit of the scene again.
    """

    def do(writer, design, ending):
        path, deviation = write(writer, design, f"lens{ending}")
        assert 0 < deviation.size <= 1e-3
        mesh = trimesh.load_mesh(path)
        assert mesh.is_watertight
        assert mesh.is_winding_consistent
        assert mesh.body_count == 1
        mesh.apply_scale(1 / (design.metres * (1 if ending == ".glb" else 1e3)))
        return mesh

    return do


@pytest.fixture
def coarse_tables(monkeypatch):
    """Tables of few values of light by few beams, which are made sooner."""
    monkeypatch.setattr("workbench.files.export.fitted_table.MOST_VALUES", 4000)
    monkeypatch.setattr("workbench.files.export.far_light.JUDGED", COARSE)
    monkeypatch.setattr("workbench.files.export.far_light._MOST_BEAMS", 1 << 12)
    monkeypatch.setattr("workbench.files.export.far_light._ENOUGH_PIXELS", 256)


@pytest.fixture
def small_grids(monkeypatch):
    """Grids of few points, which are written and read sooner."""
    monkeypatch.setattr("workbench.files.export.design._STEPS", 40)
    monkeypatch.setattr("workbench.files.export.cut_plan._FINE", 5e-3)


@pytest.fixture
def few_gouges(monkeypatch):
    """Noses of tools are looked for gouges at few places."""
    monkeypatch.setattr("workbench.files.export.turning._CHECKED", 1000)
