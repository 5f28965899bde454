"""The scene as a whole: parts that fit together."""

import json
from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

from pydantic import (
    AfterValidator,
    ConfigDict,
    SerializerFunctionWrapHandler,
    ValidationError,
    model_serializer,
)

from workbench import units
from workbench.arrays import Array
from workbench.errors import Refused
from workbench.refusals import refusal
from workbench.said import Said
from workbench.scene import limits
from workbench.scene.far_field import FarField
from workbench.scene.fields import SINCE_2, Version, about
from workbench.scene.filter import Filter, GaussianFilter
from workbench.scene.further_image import (
    FurtherImage,
    WantedImage,
    check_images,
    images_like,
    wanted_images,
)
from workbench.scene.kinds import only
from workbench.scene.lens import Lens
from workbench.scene.mirror import Mirror
from workbench.scene.optic import Optic
from workbench.scene.part import Part
from workbench.scene.receiver import AnyReceiver
from workbench.scene.region import Region, check_regions
from workbench.scene.run import AutoRun, Run
from workbench.scene.screen import Screen
from workbench.scene.source import Source
from workbench.scene.stages import stage_scenes
from workbench.scene.target import Target

Unit = Literal["mm", "cm", "m", "inch"]


class _Versioned(Part, extra="ignore"):
    """What a file says of itself."""

    version: Version = 1


class Scene(Part):
    """A whole design task.

    Only lens or mirror, source, screen or far_field, and target are required.

    Examples
    --------
    >>> scene = Scene.from_data({
    ...     "lens": {"half_width": [1, 1], "refractive_index": 1.5, "control_points": [64, 64]},
    ...     "source": {"kind": "point", "position": [0, 0, -4]},
    ...     "screen": {"z": 5, "half_width": [1, 1], "pixels": [128, 128]},
    ...     "target": {"builtin": "tophat"},
    ... })
    >>> scene.source.emission, scene.run.method
    ('uniform', 'auto')
    >>> Scene.from_data(scene.to_data()) == scene
    True
    >>> Scene.from_data(scene.to_data() | {"unit": "parsec"})
    Traceback (most recent call last):
    workbench.errors.Refused: unit: 'parsec' is not available; allowed: 'mm', 'cm', 'm' or 'inch'
    """

    model_config = ConfigDict(
        json_schema_extra={
            "allOf": [
                {"oneOf": [{"required": [one]}, {"required": [other]}]}
                for one, other in (("lens", "mirror"), ("screen", "far_field"))
            ]
        }
    )

    format: Literal["freeform-scene"] = "freeform-scene"
    # Which one a file said is forgotten, or the same scene would differ: needed_version is written.
    version: Annotated[Version, AfterValidator(lambda given: 1)] = 1
    unit: Annotated[
        Unit,
        about(
            "Unit",
            "Unit of every length in the scene. Another one converts them all: a lens of 1 cm "
            "becomes one of 10 mm.",
        ),
    ] = "mm"
    lens: Annotated[Lens | None, about("Lens", "What shapes the light.")] = None
    mirror: Annotated[
        Mirror | None,
        SINCE_2,
        about("Mirror", "What shapes the light by reflecting it, in place of a lens."),
    ] = None
    source: Annotated[Source, about("Source", "Where the light comes from.")]
    screen: Annotated[Screen | None, about("Screen", "Where the light is wanted.")] = None
    far_field: Annotated[
        FarField | None,
        SINCE_2,
        about("Far field", "Directions in which the light is wanted, in place of a screen."),
    ] = None
    filter: Annotated[
        Filter,
        about(
            "Image filter",
            "How a ray's light is shared among pixels, by the paper's method and in derivative "
            "maps. Automatic has no filter.",
        ),
    ] = GaussianFilter()
    target: Annotated[Target, about("Target", "The image that the light shall draw.")]
    further_images: Annotated[
        tuple[FurtherImage, ...],
        SINCE_2,
        about(
            "Further images",
            "Images that the same light shall make elsewhere, on its way to the screen or beyond. "
            "Two freeform faces can place light and direct it; one face finds what lies between.",
        ),
    ] = ()
    regions: Annotated[
        tuple[Region, ...],
        SINCE_2,
        about(
            "Regions",
            "Parts of the screen, or of the angles of the far field, whose light is stated by "
            "itself, as on a desk or a lane: how much there is, and how even it is; of several "
            "images, the same parts of each. They do not change the lens.",
        ),
    ] = ()
    run: Annotated[Run, about("Run", "How the design is found.")] = AutoRun()

    def check(self) -> None:
        """Refuse parts that do not go together, and stages that are not possible."""
        optic = self.optic
        self.receiver.check_lengths(optic.half_width)
        radii = {name: getattr(self.run, name) for name in ("min_radius", "min_tool_radius")}
        asked = [(f"run.{name}", radius) for name, radius in radii.items() if radius is not None]
        limits.check_lengths(asked, optic.half_width, limits.FAR)
        self.source.measured_in(self.unit)
        self.source.check_before(optic)
        self.receiver.check_lit_by(optic)
        check_images(self)
        check_regions(self.regions)
        for field in ("smoothness", *radii):
            value = getattr(self.run, field)
            if value is not None and min(optic.degree) < 2:
                raise Refused(
                    f"run.{field}",
                    Said(
                        "{value:g} is about curvature, and faces of degree 1 are flat between "
                        "edges; {field} of at least 2",
                        value=value,
                        field=f"{optic.called}.degree",
                    ),
                )
        stage_scenes(self)

    @model_serializer(mode="wrap")
    def _written(self, write: SerializerFunctionWrapHandler) -> dict[str, Any]:
        version, data = self.needed_version, write(self)
        for name in ("further_images", "regions"):  # which earlier programs do not know
            if not getattr(self, name):
                data.pop(name, None)
        return self.known_to(version, data) | {"version": version}

    @property
    def optic(self) -> Optic:
        """What shapes the light: the lens or the mirror."""
        return only({"lens": self.lens, "mirror": self.mirror})

    def with_optic(self, optic: Optic) -> Self:
        """The scene with another optic of the same kind, which goes with all else."""
        return self.model_copy(update={self.optic.called: optic})

    @property
    def receiver(self) -> AnyReceiver:
        """Where the light is wanted: the screen or the far field."""
        return only({"screen": self.screen, "far_field": self.far_field})

    def with_receiver(self, receiver: AnyReceiver) -> Self:
        """The scene with another receiver of the same kind."""
        name = "far_field" if self.screen is None else "screen"
        return self.model_copy(update={name: receiver})

    @property
    def receivers(self) -> tuple[AnyReceiver, ...]:
        """The receiver, and those of further images."""
        return (self.receiver, *(image.receiver for image in self.further_images))

    @property
    def single(self) -> tuple[Self, ...]:
        """The scene for each of its images as if there were no other, the first one first."""
        if not self.further_images:
            return (self,)
        alone = self.model_copy(update={"further_images": ()})
        others = (
            {name: getattr(image, name) for name in ("screen", "far_field", "target")}
            for image in self.further_images
        )
        return (alone, *(alone.model_copy(update=changes) for changes in others))

    def images(self, target: Array) -> tuple[WantedImage, ...]:
        """All images that are wanted, the first one first.

        Parameters
        ----------
        target : ndarray, shape (n_y, n_x)
            Of the first one, which has a weight of 1.

        Raises
        ------
        Refused
            If the target of a further image has yet to be drawn.
        """
        return wanted_images(self, target)

    def check_one_image(self, who: str) -> None:
        """Refuse further images where only one is known.

        Parameters
        ----------
        who : str
            What knows one image only, within a sentence.

        Raises
        ------
        Refused
            With the field of the further images.
        """
        if self.further_images:
            count = len(self.further_images)
            raise Refused(
                "further_images",
                Said(
                    "{count} given, which {who} cannot take into account; none",
                    count=count,
                    who=who,
                ),
            )

    @property
    def image(self) -> str | None:
        """Image file of the target; None for a built-in shape."""
        return self.target.file

    @property
    def light_files(self) -> dict[str, bytes | None]:
        """Files of its sources, by name: what they hold, where that is carried along."""
        return {
            name: data
            for number in range(len(self.run.stages) + 1)
            for name, data in self.source_of(number).light_files.items()
        }

    def carrying(self, files: Mapping[str, bytes | None]) -> Self:
        """The scene with what files of its sources hold, as far as that is given."""
        stages = tuple(
            stage.model_copy(update={"source": stage.source and stage.source.carrying(files)})
            for stage in self.run.stages
        )
        run = self.run.model_copy(update={"stages": stages}) if stages else self.run
        return self.model_copy(update={"source": self.source.carrying(files), "run": run})

    def with_contents_of(self, other: "Scene") -> Self:
        """The scene with what another one carries along: files of light, and targets as drawn."""
        scene = self.carrying(other.light_files)
        if not self.further_images:
            return scene
        return scene.model_copy(update={"further_images": images_like(scene, other)})

    def source_of(self, stage: int) -> Source:
        """The source of a stage, by its number; behind all stages that of the scene itself."""
        stages = self.run.stages
        own = stages[stage].source if stage < len(stages) else None
        return own or self.source

    def stage_scenes(self) -> tuple["Scene", ...]:
        """The run as scenes without stages, one after the other; the last is what is wanted.

        Raises
        ------
        Refused
            If a stage is not possible, there are too many, or they leave no iteration for the
            scene itself.
        """
        return stage_scenes(self)

    def with_net(self, shape: tuple[int, int] | None) -> Self:
        """The scene with what its ``"auto"`` control points come to; see `Optic.with_net`."""
        optic = self.optic.with_net(shape)
        return self if optic is self.optic else self.altered(**{optic.called: optic})

    def settled(self) -> Self:
        """The scene with numbers in place of what the program has chosen."""
        optic = self.optic
        if optic.known_shape is None:
            return self
        return self.with_optic(optic.model_copy(update={"control_points": optic.known_shape}))

    def in_unit(self, unit: Unit) -> Self:
        """The same scene with all its lengths in another unit.

        Which fields are lengths stands with the fields, as `fields.LENGTH`.

        Raises
        ------
        Refused
            If the numbers would be too large or too small to be computed with.
        """
        if unit == self.unit:
            return self
        scaled = self.scaled(units.ratio(self.unit, unit))  # which is checked
        return scaled.altered(unit=unit)

    @classmethod
    def from_json(cls, text: str | bytes) -> Self:
        """Read a scene from the text of a scene file.

        Raises
        ------
        Refused
            With the path of the field, the value and what is allowed.
        """
        try:
            scene = cls.model_validate_json(text)
            version = _Versioned.model_validate_json(text).version
        except ValidationError as error:
            raise refusal(error, cls) from None
        lens = scene.lens
        if version >= 2 and lens is not None and "reflection" not in lens.model_fields_set:
            return scene.altered(lens=lens.altered(reflection="fresnel"))
        return scene

    @classmethod
    def from_data(cls, data: dict[str, Any]) -> Self:
        """Read a scene from plain dictionaries and lists, as `json.loads` gives them."""
        return cls.from_json(json.dumps(data))

    def to_json(self) -> str:
        """The text of a scene file, indented."""
        return self.model_dump_json(indent=2, exclude_none=True) + "\n"

    def to_data(self) -> dict[str, Any]:
        """The scene as plain dictionaries and lists."""
        data: dict[str, Any] = self.model_dump(mode="json", exclude_none=True)
        return data
