"""The formats, by the endings of file names.

What writes them is imported when it is needed: torch and OpenCASCADE take long.
"""

from collections.abc import Callable, Collection
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, NamedTuple

from workbench.errors import Refused
from workbench.said import Said

if TYPE_CHECKING:
    from workbench.files.export.design import Design, Deviation


class Format(NamedTuple):
    """A format.

    Attributes
    ----------
    endings : tuple of str
        Endings of file names that ask for it, in lower case.
    name : str
        What people call it.
    module, writer : str
        The function that writes it, and the module of this package that has it.
    content : str, optional
        The function of that module that makes what is written.
    face : str, optional
        The face that a file holds, where it is not the one that each task shapes.
    takes_unit : bool
        Whether its lengths are in the unit of meshes that is asked for.
    """

    endings: tuple[str, ...]
    name: str
    module: str
    writer: str
    content: str | None = None
    face: str | None = None
    takes_unit: bool = False

    @property
    def of_entrance(self) -> "Format":
        """The same for files of a freeform entrance face, which is named before the ending."""
        endings = tuple(f".entrance{ending}" for ending in self.endings)
        name = f"{self.name}, entrance face"
        return self._replace(endings=endings, name=name, face="entrance")

    def load(self) -> "Callable[[Design, BinaryIO], Deviation]":
        """The function that writes a design."""
        module = import_module(f"{__package__}.{self.module}")
        write: Callable[[Any, BinaryIO], Deviation] = getattr(module, self.writer)
        content = (lambda design: design) if self.content is None else getattr(module, self.content)
        return lambda design, file: write(content(replace(design, face=self.face)), file)


GCODE = Format((".nc", ".gcode"), "G-code", "gcode", "write_gcode")
"""The one that asks how the face is cut."""

OF_ONE_FACE = (
    Format((".face.step", ".face.stp"), "STEP sheet", "step", "write_step_face"),
    Format((".face.iges", ".face.igs"), "IGES sheet", "iges", "write_iges_face"),
    Format((".xyz", ".asc"), "point cloud with normals", "point_cloud", "write_points"),
    Format((".dat",), "OpticStudio grid sag", "grid_sag", "write_grid_sag"),
    GCODE,
    Format((".height.png",), "height map, 16 bit", "maps", "write_png", "height"),
    Format((".height.npy",), "height map", "maps", "write_npy", "height"),
    Format((".height.csv",), "height map", "maps", "write_csv", "height"),
)
"""Those of the face that each task shapes, alone."""

FORMATS = (
    Format((".step", ".stp"), "STEP solid", "step", "write_step"),
    Format((".iges", ".igs"), "IGES solid", "iges", "write_iges"),
    Format((".stl",), "STL mesh", "stl", "write_stl", takes_unit=True),
    Format((".obj",), "OBJ mesh", "obj", "write_obj", takes_unit=True),
    Format((".ply",), "PLY mesh", "ply", "write_ply", takes_unit=True),
    Format((".3mf",), "3MF mesh", "threemf", "write_3mf", takes_unit=True),
    Format((".glb",), "glTF mesh", "gltf", "write_glb"),
    *OF_ONE_FACE,
    Format((".irradiance.png",), "irradiance, 16 bit", "maps", "write_png", "irradiance"),
    Format(
        (".irradiance.tiff", ".irradiance.tif"),
        "irradiance, 32 bit",
        "maps",
        "write_tiff",
        "irradiance",
    ),
    Format((".irradiance.exr",), "irradiance, 32 bit", "exr", "write_exr"),
    Format((".irradiance.npy",), "irradiance", "maps", "write_npy", "irradiance"),
    Format((".irradiance.csv",), "irradiance", "maps", "write_csv", "irradiance"),
    Format((".ies",), "intensity, IES LM-63", "photometric", "write_ies"),
    Format((".ldt",), "intensity, EULUMDAT", "photometric", "write_ldt"),
    Format((".tm25ray",), "rays behind the lens, IES TM-25", "tm25", "write_tm25"),
    Format((".rays.csv",), "rays on the screen", "rays", "write_rays"),
    *(each.of_entrance for each in OF_ONE_FACE),
)
"""All formats. What can be written in the same kind of file is distinguished by a double ending."""

ENDINGS = tuple(ending for found in FORMATS for ending in found.endings)
"""Endings of all formats."""


def formats_for(faces: Collection[str]) -> list[Format]:
    """The formats for a lens with freeform faces of these names."""
    return [found for found in FORMATS if found.face is None or found.face in faces]


def format_of(path: Path) -> Format:
    """The format that the ending of a file's name asks for.

    Raises
    ------
    Refused
        If it asks for none.
    """
    name = path.name.lower()
    # Those of one face end like those of the body, and those of the entrance face, which come
    # last, like those of the exit face.
    for found in reversed(FORMATS):
        if name.endswith(found.endings):
            return found
    raise Refused(
        str(path),
        Said("has no ending that tells a format; one of {endings}", endings=", ".join(ENDINGS)),
    )
