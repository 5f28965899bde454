"""Light sources before the lens: a class for each kind, and `Source`, the list of them."""

import math
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal

from pydantic import ConfigDict, Field

from workbench.scene.fields import about
from workbench.scene.grid_source import GridSource
from workbench.scene.kinds import Kinds
from workbench.scene.measured_source import PhotometricSource, RayFileSource
from workbench.scene.points import AnySource, PointSource

if TYPE_CHECKING:
    pass

RayCount = Annotated[int, Field(ge=1, le=4096)]


class CollimatedSource(AnySource):
    """Parallel light along the optical axis that fills the entrance face."""

    model_config = ConfigDict(title="Collimated light")

    kind: Literal["collimated"]
    rays: Annotated[
        tuple[RayCount, RayCount],
        about(
            "Rays",
            "Rays along x and y in each iteration of the paper's method, and for derivative maps. "
            "More give a smoother image and take longer; at least two per pixel and axis are "
            "good. Automatic chooses its own.",
        ),
    ] = (512, 512)
    along_axis: ClassVar[bool] = True

    @property
    def ray_count(self) -> int:
        """All its rays."""
        return math.prod(self.rays)

    @property
    def samples(self) -> tuple[int, int]:
        """Its rays."""
        return self.rays

    @property
    def mirrored(self) -> tuple[bool, bool]:
        """It is the same everywhere."""
        return True, True


Source = Annotated[
    CollimatedSource | PointSource | GridSource | PhotometricSource | RayFileSource, Kinds("kind")
]
