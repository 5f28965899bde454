"""The scene: an optical train with a source and images, and how to design it."""

from collections.abc import Iterable, Mapping
from typing import Annotated, Literal, Self

from pydantic import Field

from workbench import units
from workbench.arrays import Array
from workbench.errors import Refused, refused_within
from workbench.levels import EXPERT, LIMITS
from workbench.messages import Message
from workbench.scene import limits
from workbench.scene.element import Element
from workbench.scene.fields import Choices, about
from workbench.scene.image import (
    MOST_IMAGES,
    Image,
    Region,
    WantedImage,
    check_regions,
    images_like,
    wanted_images,
)
from workbench.scene.lens import Lens
from workbench.scene.making.kinds import AnyProcess
from workbench.scene.making.process import BallCut, check_processes
from workbench.scene.making.uncertainty import Uncertainty
from workbench.scene.mirror_diffuser import Diffuser, Mirror
from workbench.scene.paraxial import of_designed_element, seen_by
from workbench.scene.part import Kinds
from workbench.scene.receivers import Receiver
from workbench.scene.run import RADII, AutoRun, Filter, GaussianFilter, Run, stage_scenes
from workbench.scene.source import Line, check_spectrum, lines_of
from workbench.scene.sources import Source
from workbench.scene.spline_face import SplineFace
from workbench.scene.target import Target
from workbench.scene.train import (
    Train,
    check_bends,
    check_elements,
    check_receivers,
    too_many,
)
from workbench.scene.versions import SceneFile

Unit = Literal["mm", "cm", "m", "inch"]
AnyElement = Annotated[Lens | Mirror | Diffuser, Kinds("kind", level=EXPERT)]


class Scene(Train, SceneFile):
    """An optical train with a source and images, and how to design it.

    Only elements, source and images are required.

    Examples
    --------
    >>> scene = Scene.from_data({
    ...     "version": 3,
    ...     "source": {"kind": "point", "position": [0, 0, -4]},
    ...     "elements": [{
    ...         "kind": "lens", "name": "lens", "half_width": [1, 1], "material": {"index": 1.5},
    ...         "thickness": 0.5, "faces": [{"shape": "plane"}, {"shape": "bspline"}],
    ...     }],
    ...     "images": [{
    ...         "receiver": {
    ...             "kind": "plane", "position": [0, 0, 5], "half_width": [1, 1],
    ...             "pixels": [128, 128],
    ...         },
    ...         "target": {"builtin": "tophat"},
    ...     }],
    ... })
    >>> scene.source.emission, scene.run.method
    ('uniform', 'auto')
    >>> Scene.from_data(scene.to_data()) == scene
    True
    >>> Scene.from_data(scene.to_data() | {"unit": "parsec"})
    Traceback (most recent call last):
    workbench.errors.Refused: unit: 'parsec' is not available; allowed: 'mm', 'cm', 'm' or 'inch'
    """

    format: Literal["freeform-scene"] = "freeform-scene"
    version: Literal[3] = 3
    unit: Annotated[
        Unit,
        EXPERT,
        Choices(tuple((unit, unit) for unit in units.METRES)),
        about(
            "Unit",
            "Unit of every length in the scene. Another one converts them all: a lens of 1 cm "
            "becomes one of 10 mm.",
        ),
    ] = "mm"
    source: Annotated[Source, about("Source", "Where the light comes from.")]
    elements: Annotated[
        tuple[AnyElement, ...],
        Field(min_length=1),
        about(
            "Elements",
            "Lenses, mirrors and diffusers in the order in which light meets them. Light that "
            "passes one by is lost there.",
        ),
    ]
    images: Annotated[
        tuple[Image, ...],
        Field(min_length=1),
        about(
            "Images",
            "Where light is wanted, and which. Two freeform faces can form several images; one "
            "face forms a compromise.",
        ),
    ]
    filter: Annotated[
        Filter,
        EXPERT,
        about(
            "Image filter",
            "How a ray's light is shared among pixels, by the paper's method and in derivative "
            "maps. Automatic has no filter.",
        ),
    ] = GaussianFilter()
    regions: Annotated[
        tuple[Region, ...],
        about(
            "Regions",
            "Parts of the screen, or of the angles of the far field, whose light is stated by "
            "itself, as on a desk or a lane: how much there is, and how even it is; of several "
            "images, the same parts of each. They do not change the lens.",
        ),
    ] = ()
    processes: Annotated[
        tuple[AnyProcess, ...],
        LIMITS,
        about(
            "Manufacture",
            "Steps by which the designed elements are made, in their order. Runs design for the "
            "image as made, and checks trace it. Left empty, elements are ideal.",
        ),
    ] = ()
    uncertainty: Annotated[
        Uncertainty,
        LIMITS,
        about(
            "Uncertainty",
            "Standard deviations of the set-up that is built. Runs then lower the mean error over "
            "them, and not that of the exact set-up alone.",
        ),
    ] = Uncertainty()
    run: Annotated[Run, about("Run", "How the design is found.")] = AutoRun()

    def check(self) -> None:
        """Refuse parts that do not go together, and stages that are not possible."""
        check_spectrum(self)
        check_elements(self)
        check_bends(self)
        check_processes(self.processes, self.elements)
        self.source.measured_in(self.unit)
        if self.is_train:
            source, first = self.entrance
            source.check_before(first)
            check_receivers(self, self.receivers)
            for focused in self.focused:
                if focused.optic.free:
                    of_designed_element(focused).check()
            return
        optic = self.optic
        asked = [(f"run.{name}", r) for name, r in self.run.bends.items() if name in RADII]
        limits.check_lengths(asked, optic.half_width, limits.FAR)
        self.source.check_before(optic)
        if len(self.images) > MOST_IMAGES:
            raise too_many("images", len(self.images), MOST_IMAGES)
        for number, image in enumerate(self.images):
            with refused_within(f"images[{number}]"):
                image.check_lit_by(optic)
        check_regions(self.regions)
        stage_scenes(self)

    @property
    def lines(self) -> tuple[Line, ...]:
        """Its light line by line: an image is the sum over `Line.part` times that of each."""
        return lines_of(self)

    @property
    def entrance(self) -> tuple[Source, Element]:
        """Source and first element in the coordinates of that element, see `Element.origin`."""
        first = self.first
        return seen_by(self.source, first), first.straightened

    def with_images(self, images: Iterable[Image]) -> Self:
        """Return the scene with other images."""
        return self.model_copy(update={"images": tuple(images)})

    @property
    def receiver(self) -> Receiver:
        """Receiver of the first image."""
        return self.images[0].receiver

    def with_receiver(self, receiver: Receiver) -> Self:
        """Return the scene with another receiver of the first image."""
        first, *others = self.images
        return self.with_images((first.model_copy(update={"receiver": receiver}), *others))

    @property
    def target(self) -> Target:
        """Target of the first image."""
        return self.images[0].target

    @property
    def receivers(self) -> tuple[Receiver, ...]:
        """The receivers of all images."""
        return tuple(image.receiver for image in self.images)

    @property
    def single(self) -> tuple[Self, ...]:
        """The scene for each of its images as if there were no other, the first one first."""
        if len(self.images) == 1:
            return (self,)
        return tuple(self.with_images((image,)) for image in self.images)

    def wanted(self, target: Array) -> tuple[WantedImage, ...]:
        """All images that are wanted, with the target (n_y, n_x) of the first one.

        Raises `Refused` if the target of a further image has yet to be drawn.
        """
        return wanted_images(self, target)

    @property
    def alone(self) -> "Scene":
        """The scene with the designed element alone; see `paraxial.of_designed_element`."""
        return of_designed_element(self)

    @property
    def is_train(self) -> bool:
        """Whether there are several elements, or one that is tilted or shifted."""
        return len(self.elements) > 1 or not self.elements[0].upright

    def check_one_element(self, who: str) -> None:
        """Refuse several elements, and one that is tilted or shifted; see `check_one_image`."""
        self._check_one("elements", who)
        if not self.first.upright:
            raise Refused(
                "elements[0].tilt" if any(self.first.tilt) else "elements[0].position",
                Message(
                    "the element is not upright, which {who} cannot take into account; 0", who=who
                ),
            )

    @property
    def diffuser(self) -> Diffuser | None:
        """The diffuser before the receivers, which can only be the last element."""
        last = self.elements[-1]
        return last if isinstance(last, Diffuser) else None

    @property
    def bends(self) -> dict[str, float]:
        """What runs ask of the bends of faces: `Run.bends`, and that balls fit that mill them."""
        asked, cuts = self.run.bends, self.ball_cuts
        if cuts and min(self.optic.degree) > 1:  # else there are edges, which no ball fits
            radii = [asked.get("min_tool_radius", 0.0), *(cut.radius for cut in cuts)]
            asked["min_tool_radius"] = max(radii)
        return asked

    @property
    def ball_cuts(self) -> tuple[BallCut, ...]:
        """The cuts with a ball cutter among its processes, in their order."""
        return tuple(filter(None, (process.ball_cut for process in self.processes)))

    @property
    def ideal(self) -> Self:
        """The scene without processes: elements as designed."""
        return self.model_copy(update={"processes": ()})

    def check_no_diffuser(self, who: str) -> None:
        """Refuse a diffuser, as `check_one_image` refuses several images."""
        if self.diffuser is not None:
            raise Refused(
                f"elements[{len(self.elements) - 1}].kind",
                Message("'diffuser', which {who} cannot take into account; none", who=who),
            )

    def check_one_image(self, who: str) -> None:
        """Refuse further images for what knows one image only, called so within a sentence."""
        self._check_one("images", who)

    def _check_one(self, field: str, who: str) -> None:
        count = len(getattr(self, field))
        if count > 1:
            several = Message(
                "{count} given, which {who} cannot take into account; one", count=count, who=who
            )
            raise Refused(field, several)

    @property
    def image(self) -> str | None:
        """Image file of the target; None for a built-in shape."""
        return self.target.file

    @property
    def light_files(self) -> dict[str, bytes | None]:
        """Files of its sources and fixed faces, by name: their contents, where carried along."""
        stages = range(len(self.run.stages) + 1)
        parts = [self.source_of(number).light_files for number in stages]
        parts += [element.face_files for element in self.elements]
        return {name: data for files in parts for name, data in files.items()}

    def carrying(self, files: Mapping[str, bytes | None]) -> Self:
        """The scene with the contents of files of its sources and fixed faces, where given."""
        stages = tuple(
            stage.model_copy(update={"source": stage.source and stage.source.carrying(files)})
            for stage in self.run.stages
        )
        run = self.run.model_copy(update={"stages": stages}) if stages else self.run
        elements = []
        for number, element in enumerate(self.elements):
            with refused_within(f"elements[{number}]"):
                elements.append(element.carrying(files))
        update = {"source": self.source.carrying(files), "run": run, "elements": tuple(elements)}
        return self.model_copy(update=update)

    def with_fixed_heights(self, face: str, data: bytes) -> Self:
        """Return the scene with the content of a file of heights of a fixed face, by its id."""
        number, placed = self._placed(face)
        if not isinstance(placed.face, SplineFace):
            raise TypeError(f"{face} is no B-spline face")
        with refused_within(f"elements[{number}].{placed.path}"):
            carrying = placed.face.carrying(data)
        return self.with_element(number, self.elements[number].with_face(face, carrying))

    def with_contents_of(self, other: "Scene") -> Self:
        """The scene with what another one carries along: files of light, and targets as drawn."""
        scene = self.carrying(other.light_files)
        if len(self.images) == 1:
            return scene
        return scene.with_images((scene.images[0], *images_like(scene, other)))

    def source_of(self, stage: int) -> Source:
        """The source of a stage, by its number; behind all stages that of the scene itself."""
        stages = self.run.stages
        own = stages[stage].source if stage < len(stages) else None
        return own or self.source

    def stage_scenes(self) -> tuple["Scene", ...]:
        """The run as scenes without stages, one after the other; the last is what is wanted.

        Raises `Refused` if stages are not possible.
        """
        return stage_scenes(self)

    def with_net(self, shape: tuple[int, int] | None) -> Self:
        """The scene with what its ``"auto"`` control points come to; see `Element.with_net`."""
        scene = self
        for number in self.designed_numbers:
            scene = scene.with_element(number, self.elements[number].with_net(shape))
        if scene == self:
            return self
        scene.check()
        return scene

    def settled(self) -> Self:
        """The scene with numbers in place of what the program has chosen."""
        scene = self
        for number in self.designed_numbers:
            element = self.elements[number]
            if element.known_shape is not None:
                shaped = element.shaped(control_points=element.known_shape)
                scene = scene.with_element(number, shaped)
        return scene

    def in_unit(self, unit: Unit) -> Self:
        """The same scene with all its lengths in another unit.

        Raises `Refused` if numbers would be too large or too small to be computed with.
        """
        if unit == self.unit:
            return self
        return self.scaled(units.ratio(self.unit, unit)).altered(unit=unit)
