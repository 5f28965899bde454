"""The scene: what a person edits. Frozen, validated values; every length in one unit.

Field by field this is the scene file (``*.json``), so a scene that exists is a scene that is
possible: whatever cannot be built, traced or made is refused here, with the path of the field.
"""

from workbench.scene.area_source import AreaSource
from workbench.scene.auto_net import AutoNet
from workbench.scene.base import Base, FlatBase, SphereBase
from workbench.scene.collimated_source import CollimatedSource, GaussianProfile, UniformProfile
from workbench.scene.emission import ExactMethod, MeshMethod
from workbench.scene.entrance import FlatEntrance, FreeformEntrance
from workbench.scene.far_field import FarField
from workbench.scene.fields import LENGTH, FieldDescription, Measure
from workbench.scene.filter import BoxFilter, Filter, GaussianFilter
from workbench.scene.further_image import DrawnTarget, FurtherImage, WantedImage
from workbench.scene.grid_source import GridSource
from workbench.scene.kinds import Kinds
from workbench.scene.lens import Lens
from workbench.scene.measured_source import MeasuredSource, PhotometricSource, RayFileSource
from workbench.scene.mirror import Mirror
from workbench.scene.optic import Optic
from workbench.scene.part import NonNegative, Part, Positive
from workbench.scene.points import LightOfPoints, PointSource
from workbench.scene.receiver import AnyReceiver
from workbench.scene.region import (
    AnyRegion,
    EllipseRegion,
    PolygonRegion,
    RectangleRegion,
    Region,
)
from workbench.scene.run import AutoRun, PaperRun, Run, RunSettings, Stage
from workbench.scene.screen import Screen
from workbench.scene.source import Source
from workbench.scene.target import (
    BallTarget,
    Finish,
    FlameTarget,
    ImageTarget,
    RectangleTarget,
    RingTarget,
    Target,
    TextTarget,
    TopHatTarget,
)
from workbench.scene.task import Scene, Unit

__all__ = [
    "LENGTH",
    "AnyReceiver",
    "AnyRegion",
    "AreaSource",
    "AutoNet",
    "AutoRun",
    "BallTarget",
    "Base",
    "BoxFilter",
    "CollimatedSource",
    "DrawnTarget",
    "EllipseRegion",
    "ExactMethod",
    "FarField",
    "FieldDescription",
    "Filter",
    "Finish",
    "FlameTarget",
    "FlatBase",
    "FlatEntrance",
    "FreeformEntrance",
    "FurtherImage",
    "GaussianFilter",
    "GaussianProfile",
    "GridSource",
    "ImageTarget",
    "Kinds",
    "Lens",
    "LightOfPoints",
    "Measure",
    "MeasuredSource",
    "MeshMethod",
    "Mirror",
    "NonNegative",
    "Optic",
    "PaperRun",
    "Part",
    "PhotometricSource",
    "PointSource",
    "PolygonRegion",
    "Positive",
    "RayFileSource",
    "RectangleRegion",
    "RectangleTarget",
    "Region",
    "RingTarget",
    "Run",
    "RunSettings",
    "Scene",
    "Screen",
    "Source",
    "SphereBase",
    "Stage",
    "Target",
    "TextTarget",
    "TopHatTarget",
    "UniformProfile",
    "Unit",
    "WantedImage",
]
