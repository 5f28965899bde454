"""Formats of exports, by the endings of file names.

Writers are imported when they are needed: torch and OpenCASCADE import slowly.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, BinaryIO, NamedTuple

from workbench.errors import Refused
from workbench.files.export.options import Cutting, Drawing, Tile, Turning
from workbench.messages import Message
from workbench.option_groups import OptionGroup

if TYPE_CHECKING:
    from workbench.files.export.design import Design, Deviation
    from workbench.scene import Element


class Format(NamedTuple):
    """A format."""

    endings: tuple[str, ...]  # endings of file names, in lower case
    name: str  # name for users
    # Module of this package, or the full name of one that draws, and its function that writes the
    # format.
    module: str
    writer: str
    content: str | None = None  # function of that module that computes the written data
    front: bool = False  # whether the file holds the freeform front face, not the last face
    takes_unit: bool = False  # whether lengths are in the requested unit of meshes
    # Function of that module that refuses a design or its options before anything is written.
    check: str | None = None
    options: tuple[type[OptionGroup], ...] = ()  # its groups of options
    of_element: bool = True  # whether the file holds one element, not the whole train or its light

    @property
    def of_entrance(self) -> "Format":
        """The same format for the freeform entrance face, named before the ending."""
        endings = tuple(f".entrance{ending}" for ending in self.endings)
        name = f"{self.name}, entrance face"
        return self._replace(endings=endings, name=name, front=True)

    def load(self) -> "Callable[[Design, BinaryIO], Deviation]":
        """Import and return the function that writes a design."""
        module = self._load_module()
        write: Callable[[Any, BinaryIO], Deviation] = getattr(module, self.writer)
        content = (lambda design: design) if self.content is None else getattr(module, self.content)
        return lambda design, file: write(content(self._seen(design)), file)

    def check_design(self, design: "Design") -> None:
        """Raise Refused if the options of a design cannot be written."""
        if self.check is not None:
            getattr(self._load_module(), self.check)(self._seen(design))

    def _seen(self, design: "Design") -> "Design":
        options = tuple(each for each in design.options if type(each) in self.options)
        return replace(design.at_front(self.front), options=options)

    def _load_module(self) -> ModuleType:
        return import_module(self.module if "." in self.module else f"{__package__}.{self.module}")


_DRAWINGS = "workbench.pictures.part.sheet"
GCODE = Format(
    (".nc", ".gcode"),
    "G-code",
    "gcode",
    "write_gcode",
    check="check_cutting",
    options=(Cutting,),
)
"""The format with options of cutting."""

OF_ONE_FACE = (
    Format((".face.step", ".face.stp"), "STEP sheet", "step", "write_step_face"),
    Format((".face.iges", ".face.igs"), "IGES sheet", "iges", "write_iges_face"),
    Format((".xyz", ".asc"), "point cloud with normals", "tables", "write_points"),
    Format((".dat",), "OpticStudio grid sag", "tables", "write_grid_sag"),
    GCODE,
    Format((".sts",), "slow tool servo table", "turning", "write_turning", options=(Turning,)),
    Format(
        (".inspection.csv",),
        "inspection points",
        "inspection",
        "write_inspection",
        options=(Drawing,),
    ),
    Format((".height.png",), "height map, 16 bit", "maps", "write_png", "height"),
    Format((".height.npy",), "height map", "maps", "write_npy", "height"),
    Format((".height.csv",), "height map", "maps", "write_csv", "height"),
)
"""Formats of the designed face only."""

FORMATS = (
    Format((".step", ".stp"), "STEP solid", "step", "write_step"),
    Format(
        (".train.step", ".train.stp"),
        "STEP, all elements",
        "step_train",
        "write_step_train",
        of_element=False,
    ),
    Format((".iges", ".igs"), "IGES solid", "iges", "write_iges"),
    Format((".stl",), "STL mesh", "meshes", "write_stl", takes_unit=True, options=(Tile,)),
    Format((".obj",), "OBJ mesh", "meshes", "write_obj", takes_unit=True, options=(Tile,)),
    Format((".ply",), "PLY mesh", "meshes", "write_ply", takes_unit=True, options=(Tile,)),
    Format((".3mf",), "3MF mesh", "meshes", "write_3mf", takes_unit=True, options=(Tile,)),
    Format((".glb",), "glTF mesh", "meshes", "write_glb", options=(Tile,)),
    Format(
        (".zip",),
        "package for a shop",
        "package",
        "write_package",
        takes_unit=True,
        check="check_cutting",
        options=(Cutting, Drawing),
    ),
    Format((".pdf",), "part drawing", _DRAWINGS, "write_drawing", options=(Drawing,)),
    Format((".dxf",), "part drawing", _DRAWINGS, "write_dxf", options=(Drawing,)),
    *OF_ONE_FACE,
    *(
        Format(endings, name, module, writer, content, of_element=False)
        for endings, name, module, writer, content in (
            ((".irradiance.png",), "irradiance, 16 bit", "maps", "write_png", "irradiance"),
            (
                (".irradiance.tiff", ".irradiance.tif"),
                "irradiance, 32 bit",
                "maps",
                "write_tiff",
                "irradiance",
            ),
            ((".irradiance.exr",), "irradiance, 32 bit", "maps", "write_exr", None),
            ((".irradiance.npy",), "irradiance", "maps", "write_npy", "irradiance"),
            ((".irradiance.csv",), "irradiance", "maps", "write_csv", "irradiance"),
            ((".ies",), "intensity, IES LM-63", "photometric", "write_ies", None),
            ((".ldt",), "intensity, EULUMDAT", "photometric", "write_ldt", None),
            ((".tm25ray",), "rays behind the lens, IES TM-25", "tables", "write_tm25", None),
            ((".rays.csv",), "rays on the screen", "tables", "write_rays", None),
        )
    ),
    *(each.of_entrance for each in OF_ONE_FACE),
)
"""All formats; formats of the same kind of file are distinguished by a double ending."""

ENDINGS = tuple(ending for found in FORMATS for ending in found.endings)


def formats_for(optics: "Sequence[Element]") -> list[Format]:
    """Formats for designed elements."""
    front = any(optic.designed_front for optic in optics)
    return [found for found in FORMATS if front or not found.front]


def format_of(path: Path) -> Format:
    """Return the format of a file name's ending; raise Refused if there is none."""
    name = path.name.lower()
    # Endings of one face end like those of the body, and those of the entrance face, which come
    # last, like those of the exit face.
    for found in reversed(FORMATS):
        if name.endswith(found.endings):
            return found
    raise Refused(
        str(path),
        Message("has no known ending; use one of {endings}", endings=", ".join(ENDINGS)),
    )
