from dataclasses import replace

import lib3mf
import numpy as np
import pytest
import trimesh

from workbench.errors import Refused
from workbench.files.export.meshes import write_3mf, write_glb, write_obj, write_ply, write_stl
from workbench.files.export.options import Tile

WRITERS = {
    ".stl": write_stl,
    ".obj": write_obj,
    ".ply": write_ply,
    ".3mf": write_3mf,
    ".glb": write_glb,
}
CHORD_ERROR = 1e-3


def load(path):
    return load_3mf(path)[0] if path.suffix == ".3mf" else trimesh.load_mesh(path)


def load_3mf(path):
    """The mesh and its unit as the reader of the 3MF Consortium finds them; it is strict."""
    wrapper = lib3mf.get_wrapper()
    model = wrapper.CreateModel()
    reader = model.QueryReader("3mf")
    reader.SetStrictModeActive(True)
    reader.ReadFromFile(str(path))
    assert reader.GetWarningCount() == 0
    (found,) = iterated(model.GetMeshObjects(), "GetCurrentMeshObject")
    assert found.IsManifoldAndOriented()
    (item,) = iterated(model.GetBuildItems(), "GetCurrent")
    assert item.GetObjectResource().GetResourceID() == found.GetResourceID()
    vertices = [list(each.Coordinates) for each in found.GetVertices()]
    triangles = [list(each.Indices) for each in found.GetTriangleIndices()]
    return trimesh.Trimesh(vertices, triangles, process=False), model.GetUnit()


def iterated(found, current):
    while found.MoveNext():
        yield getattr(found, current)()


@pytest.mark.parametrize("ending", WRITERS)
class TestEveryFormat:
    def test_a_closed_body(self, make_design, write, volume, ending):
        design = replace(make_design({"unit": "m"}, chord_error=CHORD_ERROR), mesh_unit="m")
        path, deviation = write(WRITERS[ending], design, f"lens{ending}")
        assert deviation.kind == "chord error"
        assert deviation.unit == "m"
        assert 0 < deviation.size <= CHORD_ERROR
        mesh = load(path)
        assert mesh.is_watertight
        assert mesh.is_winding_consistent
        assert mesh.is_volume
        assert mesh.body_count == 1
        area = 4 * 1.0 * 0.7
        assert mesh.volume == pytest.approx(volume(design), abs=deviation.size * area)
        low, high = mesh.bounds
        assert low == pytest.approx([-1.0, -0.7, 0.0], abs=1e-6)
        assert high[:2] == pytest.approx([1.0, 0.7], abs=1e-6)


@pytest.mark.parametrize(
    "ending, scene_unit, mesh_unit, width",
    [
        (".3mf", "inch", "mm", 50.8),
        (".stl", "cm", "mm", 20),
        (".ply", "m", "mm", 2000),
        (".3mf", "inch", "inch", 2),
        (".obj", "inch", "inch", 2),
        (".3mf", "mm", "cm", 0.2),
    ],
)
def test_lengths_are_in_the_unit_that_file_and_message_state(
    make_design, write, ending, scene_unit, mesh_unit, width
):
    design = replace(make_design({"unit": scene_unit}, chord_error=0.01), mesh_unit=mesh_unit)
    path, deviation = write(WRITERS[ending], design, f"a{ending}")
    assert load(path).extents[:2] == pytest.approx([width, 0.7 * width], rel=1e-6)
    assert deviation.note == f"lengths in {mesh_unit}"
    assert 0 < deviation.size <= 0.01 and deviation.unit == scene_unit
    if ending == ".3mf":
        unit = {"mm": "MilliMeter", "cm": "CentiMeter", "inch": "Inch"}[mesh_unit]
        assert load_3mf(path)[1] == getattr(lib3mf.ModelUnit, unit)
    else:
        assert f"freeform lens, unit {mesh_unit}".encode() in path.read_bytes()[:200]


def test_stl_normals_point_outward(make_design, write):
    design = make_design(heights=np.full((12, 10), 0.5))
    path, _ = write(write_stl, design, "lens.stl")
    content = path.read_bytes()
    assert not content.startswith(b"solid")  # that would be text
    record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    records = np.frombuffer(content[84:], record)
    assert len(records) == np.frombuffer(content[80:84], "<u4")[0]
    middle = records["corners"].mean(axis=1) - [0, 0, 0.25]  # from inside the box
    assert np.linalg.norm(records["normal"], axis=1) == pytest.approx(1, abs=1e-6)
    assert ((middle * records["normal"]).sum(axis=1) > 0).all()


@pytest.mark.parametrize("outline", ["rectangle", "ellipse"])
def test_a_tile_is_a_square_of_the_face_on_a_flat_back(make_design, write, outline):
    design = make_design({"unit": "cm", "lens.outline": outline}, chord_error=CHORD_ERROR)
    tile = Tile(0.6, 0.1, -0.2)
    path, deviation = write(write_stl, replace(design, options=(tile,)), "tile.stl")
    assert deviation.size <= CHORD_ERROR
    mesh = trimesh.load_mesh(path)
    assert mesh.is_volume and mesh.body_count == 1
    low, high = mesh.bounds
    assert low == pytest.approx([-2, -5, 10 * design.flat_z], abs=1e-4)
    assert high[:2] == pytest.approx([4, 1], abs=1e-4)
    top = mesh.vertices[mesh.vertices[:, 2] > low[2] + 1e-6] / 10
    corner = top[np.argmin(top[:, 0] + top[:, 1])]
    exact = design.surface(np.array([-0.2]), np.array([-0.5]))[0]
    assert corner[2] == pytest.approx(float(exact[0, 0]), abs=1e-6)
    with pytest.raises(Refused, match="is not within the lens"):
        write(write_stl, replace(design, options=(replace(tile, tile_x=0.8),)), "out.stl")


def test_a_tile_has_a_flat_back_where_the_other_face_is_freeform(make_design, write):
    changes = {"version": 2, "unit": "cm", "lens.entrance": {"shape": "freeform"}}
    design = make_design(changes, chord_error=CHORD_ERROR)
    path, _ = write(write_obj, replace(design, options=(Tile(0.5),)), "tile.obj")
    mesh = trimesh.load_mesh(path)
    assert mesh.is_volume
    bottom = mesh.vertices[:, 2] < mesh.bounds[0, 2] + 1e-6
    assert mesh.area_faces[bottom[mesh.faces].all(axis=1)].sum() == pytest.approx(25)
