"""The scene: what a person edits. Frozen, validated values; every length in one unit.

Field by field this is the scene file (``*.json``), so a scene that exists is a scene that is
possible: whatever cannot be built, traced or made is refused here, with the path of the field.
"""

from workbench.scene.area_source import AreaSource
from workbench.scene.auto_net import AutoNet
from workbench.scene.collimated_source import CollimatedSource, GaussianProfile, UniformProfile
from workbench.scene.diffuser import Diffuser, GaussianScatter, LambertianScatter
from workbench.scene.element import DEFAULT_WAVELENGTH, Element, PlacedFace
from workbench.scene.emission import ExactMethod, MeshMethod
from workbench.scene.faces import (
    LARGEST_NET,
    Base,
    ConicFace,
    Face,
    FlatBase,
    PlacedBase,
    PlaneFace,
    SphereBase,
    SplineFace,
)
from workbench.scene.far_field import FarField
from workbench.scene.fields import LENGTH, FieldDescription, Measure
from workbench.scene.filter import BoxFilter, Filter, GaussianFilter
from workbench.scene.grid_source import GridSource
from workbench.scene.image import DrawnTarget, Image, Receiver, WantedImage
from workbench.scene.kinds import Kinds
from workbench.scene.lens import Lens
from workbench.scene.material import CustomIndex
from workbench.scene.measured_source import MeasuredSource, PhotometricSource, RayFileSource
from workbench.scene.mirror import Mirror
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
from workbench.scene.task import AnyElement, Scene, Unit

__all__ = [
    "DEFAULT_WAVELENGTH",
    "LARGEST_NET",
    "LENGTH",
    "AnyElement",
    "AnyReceiver",
    "AnyRegion",
    "AreaSource",
    "AutoNet",
    "AutoRun",
    "BallTarget",
    "Base",
    "BoxFilter",
    "CollimatedSource",
    "ConicFace",
    "CustomIndex",
    "Diffuser",
    "DrawnTarget",
    "Element",
    "EllipseRegion",
    "ExactMethod",
    "Face",
    "FarField",
    "FieldDescription",
    "Filter",
    "Finish",
    "FlameTarget",
    "FlatBase",
    "GaussianFilter",
    "GaussianProfile",
    "GaussianScatter",
    "GridSource",
    "Image",
    "ImageTarget",
    "Kinds",
    "LambertianScatter",
    "Lens",
    "LightOfPoints",
    "Measure",
    "MeasuredSource",
    "MeshMethod",
    "Mirror",
    "NonNegative",
    "PaperRun",
    "Part",
    "PhotometricSource",
    "PlacedBase",
    "PlacedFace",
    "PlaneFace",
    "PointSource",
    "PolygonRegion",
    "Positive",
    "RayFileSource",
    "Receiver",
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
    "SplineFace",
    "Stage",
    "Target",
    "TextTarget",
    "TopHatTarget",
    "UniformProfile",
    "Unit",
    "WantedImage",
]
