"""All kinds of manufacturing processes."""

from typing import Annotated

from workbench.scene.making.figure_error import FigureError
from workbench.scene.making.milling import Milling
from workbench.scene.making.moulding import Moulding
from workbench.scene.making.polishing import Polishing
from workbench.scene.making.printing import Printing
from workbench.scene.making.turning import Turning
from workbench.scene.part import Kinds

AnyProcess = Annotated[
    Milling | Turning | Polishing | Moulding | Printing | FigureError, Kinds("kind")
]
