"""Light sources before the lens: `Source`, the list of their kinds."""

from typing import Annotated

from workbench.scene.area_source import AreaSource
from workbench.scene.collimated_source import CollimatedSource
from workbench.scene.grid_source import GridSource
from workbench.scene.kinds import Kinds
from workbench.scene.measured_source import PhotometricSource, RayFileSource
from workbench.scene.points import PointSource

Source = Annotated[
    CollimatedSource | PointSource | GridSource | PhotometricSource | RayFileSource | AreaSource,
    Kinds("kind"),
]
