"""The scene: what a person edits. Frozen, validated values; every length in one unit.

Field by field this is the scene file (``*.json``), so a scene that exists is a scene that is
possible: whatever cannot be built, traced or made is refused here, with the path of the field.
"""

from workbench.scene.element import DEFAULT_WAVELENGTH, Element
from workbench.scene.faces import LARGEST_NET, ConicFace, PlaneFace
from workbench.scene.fields import LENGTH, AutoNet, FieldDescription, Measure
from workbench.scene.image import (
    AnyRegion,
    DrawnTarget,
    EllipseRegion,
    Image,
    PolygonRegion,
    RectangleRegion,
    Region,
    WantedImage,
)
from workbench.scene.lens import CustomIndex, Lens
from workbench.scene.mirror_diffuser import Diffuser, GaussianScatter, LambertianScatter, Mirror
from workbench.scene.part import Kinds, NonNegative, Part, Positive
from workbench.scene.points import ExactMethod, LightOfPoints, MeshMethod, PointSource
from workbench.scene.receiver import AnyReceiver
from workbench.scene.receivers import FarField, Receiver, Screen
from workbench.scene.run import (
    AutoRun,
    BoxFilter,
    Filter,
    GaussianFilter,
    PaperRun,
    Run,
    RunSettings,
    Stage,
)
from workbench.scene.sources import (
    CollimatedSource,
    GaussianProfile,
    MeasuredSource,
    PhotometricSource,
    RayFileSource,
    Source,
    UniformProfile,
)
from workbench.scene.spline_face import (
    Base,
    Face,
    FlatBase,
    PlacedBase,
    PlacedFace,
    SphereBase,
    SplineFace,
)
from workbench.scene.target import (
    LEVELS,
    BallTarget,
    BeamTarget,
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
from workbench.scene.wide_sources import AreaSource, GridSource

__all__ = [
    "DEFAULT_WAVELENGTH",
    "LARGEST_NET",
    "LENGTH",
    "LEVELS",
    "AnyElement",
    "AnyReceiver",
    "AnyRegion",
    "AreaSource",
    "AutoNet",
    "AutoRun",
    "BallTarget",
    "Base",
    "BeamTarget",
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
