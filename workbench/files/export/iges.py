"""IGES: the solid of the STEP file, as OpenCASCADE writes it (optional extra ``iges``)."""

import tempfile
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from workbench.errors import Refused, RunFailed
from workbench.files.export.design import METRES, Design, Deviation
from workbench.files.export.step import write_step

_UNIT = {"mm": "MM", "cm": "CM", "m": "M", "inch": "INCH"}
_PLACES = 33  # along each axis, where the face that has been written is measured


def write_iges(design: Design, file: BinaryIO) -> Deviation:
    """Write the solid, and measure the exit face that is read back.

    Raises
    ------
    Refused
        If OpenCASCADE is not installed.
    RunFailed
        If it fails.
    """
    try:
        import OCP.IGESControl  # noqa: F401
    except ImportError as error:
        raise Refused(
            ".iges", "needs OpenCASCADE, which pip install 'freeform-lens-workbench[iges]' brings"
        ) from error
    _be_quiet()
    with tempfile.TemporaryDirectory() as folder:
        step, iges = Path(folder, "lens.step"), Path(folder, "lens.iges")
        with step.open("wb") as solid:
            write_step(design, solid)
        _convert(step, iges, _UNIT[design.unit])
        file.write(iges.read_bytes())
        error_found = _face_error(design, iges)
    return Deviation("error of the exit face", error_found, design.unit)


def _be_quiet() -> None:
    """Keep OpenCASCADE from telling standard output what it reads."""
    from OCP.Message import Message, Message_Gravity

    for printer in Message.DefaultMessenger_s().Printers():
        printer.SetTraceLevel(Message_Gravity.Message_Fail)


def _convert(step: Path, iges: Path, unit: str) -> None:
    from OCP.IGESControl import IGESControl_Writer
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TCollection import TCollection_HAsciiString as Text

    solids = 1  # not faces alone
    writer = IGESControl_Writer(unit, solids)
    if not writer.AddShape(_read(STEPControl_Reader(), step)):
        raise RunFailed("OpenCASCADE could not turn the solid into IGES")
    writer.ComputeModel()
    # Neither user nor time, so that the same lens gives the same file.
    model = writer.Model()
    header = model.GlobalSection()
    header.SetAuthorName(Text(""))
    header.SetFileName(Text("lens.iges"))
    header.SetSendName(Text("freeform lens"))
    header.SetDate(Text("19700101.000000"))
    header.SetLastChangeDate(Text("19700101.000000"))
    model.SetGlobalSection(header)
    if not writer.Write(str(iges)):
        raise RunFailed("OpenCASCADE could not write the IGES file")


def _read(reader: Any, path: Path) -> Any:
    from OCP.IFSelect import IFSelect_ReturnStatus

    if reader.ReadFile(str(path)) != IFSelect_ReturnStatus.IFSelect_RetDone:
        raise RunFailed(f"OpenCASCADE could not read the {path.suffix} file again")
    reader.TransferRoots()
    return reader.OneShape()


def _face_error(design: Design, path: Path) -> float:
    """Largest distance, along z, of the B-spline face in a file from the exit face."""
    surface = _spline_face(path)
    low_u, high_u, low_v, high_v = surface.Bounds()
    places = [
        surface.Value(u, v)
        for u in np.linspace(low_u, high_u, _PLACES).tolist()
        for v in np.linspace(low_v, high_v, _PLACES).tolist()
    ]
    # OpenCASCADE reads into millimetres.
    x, y, z = np.array([[p.X(), p.Y(), p.Z()] for p in places]).T * 1e-3 / METRES[design.unit]
    r_x, r_y = design.scene.optic.half_width
    # Rounding may lead a hair beyond the rim, where the polynomials go on.
    basis = design.net.points((x / r_x + 1) / 2, (y / r_y + 1) / 2)
    return float(np.abs(basis.evaluate(design.heights)[0] - z).max())


def _spline_face(path: Path) -> Any:
    from OCP.BRep import BRep_Tool
    from OCP.Geom import Geom_BSplineSurface
    from OCP.IGESControl import IGESControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    as_face = getattr(TopoDS, "Face_s", None) or TopoDS.Face  # its name before and since 8.0
    faces = TopExp_Explorer(_read(IGESControl_Reader(), path), TopAbs_ShapeEnum.TopAbs_FACE)
    while faces.More():
        surface = BRep_Tool.Surface_s(as_face(faces.Current()))
        if isinstance(surface, Geom_BSplineSurface):
            return surface
        faces.Next()
    raise RunFailed("OpenCASCADE finds no B-spline face in the IGES file that it wrote")
