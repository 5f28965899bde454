"""The formats, told by the endings of file names.

What writes them is imported when it is needed: torch and OpenCASCADE take long.
"""

from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO, NamedTuple

from workbench.errors import Refused

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
    """

    endings: tuple[str, ...]
    name: str
    module: str
    writer: str
    content: str | None = None

    def load(self) -> "Callable[[Design, BinaryIO], Deviation]":
        """The function that writes a design."""
        module = import_module(f"{__package__}.{self.module}")
        write: Callable[[Design, BinaryIO], Deviation] = getattr(module, self.writer)
        if self.content is None:
            return write
        content = getattr(module, self.content)
        return lambda design, file: write(content(design), file)


FORMATS = (
    Format((".step", ".stp"), "STEP solid", "step", "write_step"),
    Format((".iges", ".igs"), "IGES solid", "iges", "write_iges"),
    Format((".stl",), "STL mesh", "stl", "write_stl"),
    Format((".obj",), "OBJ mesh", "obj", "write_obj"),
    Format((".ply",), "PLY mesh", "ply", "write_ply"),
    Format((".glb",), "glTF mesh", "gltf", "write_glb"),
    Format((".xyz", ".asc"), "point cloud with normals", "point_cloud", "write_points"),
    Format((".dat",), "OpticStudio grid sag", "grid_sag", "write_grid_sag"),
    Format((".height.png",), "height map, 16 bit", "maps", "write_png", "height"),
    Format((".height.npy",), "height map", "maps", "write_npy", "height"),
    Format((".height.csv",), "height map", "maps", "write_csv", "height"),
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
)
"""All formats. What can be written in the same kind of file is told by a double ending."""

ENDINGS = tuple(ending for found in FORMATS for ending in found.endings)
"""Endings of all formats."""


def format_of(path: Path) -> Format:
    """The format that the ending of a file's name asks for.

    Raises
    ------
    Refused
        If it asks for none.
    """
    name = path.name.lower()
    for found in FORMATS:
        if name.endswith(found.endings):
            return found
    raise Refused(str(path), f"has no ending that tells a format; one of {', '.join(ENDINGS)}")
