"""IGES: the shape of the STEP file, converted by OpenCASCADE (optional extra ``iges``)."""

import tempfile
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from workbench.arrays import Array
from workbench.errors import Refused, RunFailed
from workbench.files.export.design import METRES, Design, Deviation
from workbench.files.export.step import write_step, write_step_face
from workbench.messages import Message

_UNIT = {"mm": "MM", "cm": "CM", "m": "M", "inch": "INCH"}
_SAMPLES = 33  # along each axis, for measuring the written face


def write_iges(design: Design, file: BinaryIO) -> Deviation:
    """Write the solid, and measure the freeform faces as read back.

    Raise Refused if OpenCASCADE is not installed, RunFailed if it fails.
    """
    return _write(design, design.faces, write_step, file)


def write_iges_face(design: Design, file: BinaryIO) -> Deviation:
    """Write the face of a design as a sheet, and measure it; see `write_iges`."""
    return _write(design, [design], write_step_face, file)


def _write(
    design: Design,
    faces: Sequence[Design],
    as_step: Callable[[Design, BinaryIO], Deviation],
    file: BinaryIO,
) -> Deviation:
    try:
        import OCP.IGESControl  # noqa: F401
    except ImportError as error:
        raise Refused(
            ".iges",
            Message("needs OpenCASCADE, which pip install 'freeform-lens-workbench[iges]' brings"),
        ) from error
    _silence()
    with tempfile.TemporaryDirectory() as folder:
        step, iges = Path(folder, "lens.step"), Path(folder, "lens.iges")
        with step.open("wb") as shape:
            as_step(design, shape)
        _convert(step, iges, _UNIT[design.unit])
        file.write(iges.read_bytes())
        error_found = _face_error(faces, iges)
    called = design.optic.face_called if len(faces) == 1 else "freeform faces"
    return Deviation(f"error of the {called}", error_found, design.unit)


def _silence() -> None:
    from OCP.Message import Message as OcpMessage
    from OCP.Message import Message_Gravity

    for printer in OcpMessage.DefaultMessenger_s().Printers():
        printer.SetTraceLevel(Message_Gravity.Message_Fail)


def _convert(step: Path, iges: Path, unit: str) -> None:
    from OCP.IGESControl import IGESControl_Writer
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TCollection import TCollection_HAsciiString as Text

    solids = 1  # write solids, not only faces
    writer = IGESControl_Writer(unit, solids)
    if not writer.AddShape(_read(STEPControl_Reader(), step)):
        raise RunFailed(Message("OpenCASCADE could not turn the shape into IGES"))
    writer.ComputeModel()
    # Neither user nor time: the same lens gives the same file.
    model = writer.Model()
    header = model.GlobalSection()
    header.SetAuthorName(Text(""))
    header.SetFileName(Text("lens.iges"))
    header.SetSendName(Text("freeform lens"))
    header.SetDate(Text("19700101.000000"))
    header.SetLastChangeDate(Text("19700101.000000"))
    model.SetGlobalSection(header)
    if not writer.Write(str(iges)):
        raise RunFailed(Message("OpenCASCADE could not write the IGES file"))


def _read(reader: Any, path: Path) -> Any:
    from OCP.IFSelect import IFSelect_ReturnStatus

    if reader.ReadFile(str(path)) != IFSelect_ReturnStatus.IFSelect_RetDone:
        raise RunFailed(
            Message("OpenCASCADE could not read the {ending} file again", ending=path.suffix)
        )
    reader.TransferRoots()
    return reader.OneShape()


def _face_error(faces: Sequence[Design], path: Path) -> float:
    found = [_places(faces[0], surface) for surface in _spline_faces(path)]
    if not found:
        raise RunFailed(
            Message("OpenCASCADE finds no B-spline face in the IGES file that it wrote")
        )
    return max(min(_distance(face, places) for places in found) for face in faces)


def _places(design: Design, surface: Any) -> Array:
    low_u, high_u, low_v, high_v = surface.Bounds()
    places = [
        surface.Value(u, v)
        for u in np.linspace(low_u, high_u, _SAMPLES).tolist()
        for v in np.linspace(low_v, high_v, _SAMPLES).tolist()
    ]
    # OpenCASCADE reads into millimetres.
    return np.array([[p.X(), p.Y(), p.Z()] for p in places]).T * 1e-3 / METRES[design.unit]


def _distance(face: Design, places: Array) -> float:
    x, y, z = places
    r_x, r_y = face.net.half_width
    # Rounding may exceed the rim slightly, where the polynomials continue.
    basis = face.net.points((x / r_x + 1) / 2, (y / r_y + 1) / 2)
    return float(np.abs(basis.evaluate(face.heights)[0] - z).max())


def _spline_faces(path: Path) -> Iterator[Any]:
    from OCP.BRep import BRep_Tool
    from OCP.Geom import Geom_BSplineSurface
    from OCP.IGESControl import IGESControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    as_face = getattr(TopoDS, "Face_s", None) or TopoDS.Face  # name before and since version 8.0
    faces = TopExp_Explorer(_read(IGESControl_Reader(), path), TopAbs_ShapeEnum.TopAbs_FACE)
    while faces.More():
        surface = BRep_Tool.Surface_s(as_face(faces.Current()))
        if isinstance(surface, Geom_BSplineSurface):
            yield surface
        faces.Next()
