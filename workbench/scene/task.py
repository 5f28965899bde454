"""The scene as a whole: parts that fit together."""

import json
from typing import Any, Literal, Self

from pydantic import ValidationError, model_validator

from workbench import units
from workbench.errors import Refused
from workbench.refusals import refusal
from workbench.scene import limits
from workbench.scene.lens import Lens
from workbench.scene.part import Part
from workbench.scene.run import AutoRun, RunField, RunSettings, Stage
from workbench.scene.screen import FilterField, GaussianFilter, Screen
from workbench.scene.source import (
    CollimatedSource,
    GridSource,
    MeshMethod,
    PointSource,
    SourceField,
)
from workbench.scene.target import ImageTarget, TargetField

Unit = Literal["mm", "cm", "m", "inch"]

MOST_STAGES = 100
"""Most stages of a run: each is checked as a scene of its own."""


class Scene(Part):
    """A whole design task. Only lens, source, screen and target are required."""

    format: Literal["freeform-scene"] = "freeform-scene"
    version: Literal[1] = 1
    unit: Unit = "mm"
    lens: Lens
    source: SourceField
    screen: Screen
    filter: FilterField = GaussianFilter()
    target: TargetField
    run: RunField = AutoRun()

    @model_validator(mode="after")
    def _source_stands_before_the_lens(self) -> Self:
        source = self.source
        if not isinstance(source, CollimatedSource) and source.nearest_z >= self.lens.entrance_z:
            field = "position" if isinstance(source, PointSource) else "center"
            raise Refused(
                f"source.{field}[2]",
                f"{source.nearest_z:g} is not before the entrance face; "
                f"less than {self.lens.entrance_z:g}",
            )
        return self

    @model_validator(mode="after")
    def _lengths_go_together(self) -> Self:
        half_width, screen, source = self.lens.half_width, self.screen, self.source
        lengths = [("screen.z", screen.z)]
        lengths += [(f"screen.half_width[{axis}]", r) for axis, r in enumerate(screen.half_width)]
        if self.run.min_radius is not None:
            lengths.append(("run.min_radius", self.run.min_radius))
        limits.check_lengths(lengths, half_width, limits.FAR)
        if isinstance(source, CollimatedSource):
            return self
        field = "position" if isinstance(source, PointSource) else "center"
        x, y, z = getattr(source, field)
        aside = [(f"source.{field}[0]", x), (f"source.{field}[1]", y)]
        if isinstance(source, GridSource):
            aside += [(f"source.half_width[{k}]", r) for k, r in enumerate(source.half_width)]
        limits.check_lengths(aside, half_width, limits.FARTHEST)
        limits.check_way(f"source.{field}[2]", self.lens.entrance_z - z, half_width)
        return self

    @model_validator(mode="after")
    def _mesh_within_memory(self) -> Self:
        if isinstance(self.source, CollimatedSource):
            return self
        if isinstance(how := self.source.intersection, MeshMethod):
            lens = self.lens
            across, up = (
                (count - degree) * n
                for count, degree, n in zip(
                    lens.control_points, lens.degree, how.subdivisions, strict=True
                )
            )
            if across * up > 1 << 24:
                raise Refused(
                    "source.intersection.subdivisions",
                    f"{list(how.subdivisions)} make {across} × {up} rectangles; "
                    f"at most {1 << 24} in all",
                )
        return self

    @model_validator(mode="after")
    def _screen_clears_the_lens(self) -> Self:
        if self.screen.z <= self.lens.highest:
            raise Refused(
                "screen.z",
                f"{self.screen.z:g} may touch the lens; "
                f"more than {self.lens.highest:g}, the highest that the exit face can become",
            )
        return self

    @model_validator(mode="after")
    def _bends_can_be_limited(self) -> Self:
        for field in ("smoothness", "min_radius"):
            value = getattr(self.run, field)
            if value is not None and min(self.lens.degree) < 2:
                raise Refused(
                    f"run.{field}",
                    f"{value:g} is about curvature, and faces of degree 1 are flat between edges; "
                    "lens.degree of at least 2",
                )
        return self

    @model_validator(mode="after")
    def _stages_are_possible(self) -> Self:
        self.parts()
        return self

    @property
    def image(self) -> str | None:
        """Image file of the target; None for a built-in shape."""
        return self.target.image if isinstance(self.target, ImageTarget) else None

    def parts(self) -> tuple[Self, ...]:
        """The run as scenes without stages, one after the other; the last is what is wanted.

        Raises
        ------
        Refused
            If a stage is not possible, there are too many, or they leave no iteration for the
            scene itself.
        """
        stages = self.run.stages
        if not stages:
            return (self,)
        if len(stages) > MOST_STAGES:
            raise Refused("run.stages", f"{len(stages)} are given; at most {MOST_STAGES}")
        left = self.run.iterations - sum(stage.iterations for stage in stages)
        if left < 1:
            raise Refused(
                "run.stages",
                f"they leave none of the {self.run.iterations} iterations for the scene itself; "
                f"more than {self.run.iterations - left} in all are needed",
            )
        data = self.to_data()
        del data["run"]["stages"]
        parts = []
        for number, stage in enumerate(stages):
            try:
                parts.append(self.from_data(_with_stage(data, stage)))
            except Refused as refused:
                path = refused.path.removeprefix("lens.").removeprefix("run.")
                raise Refused(f"run.stages[{number}].{path}", refused.reason) from None
        last = self.run.model_copy(update={"stages": (), "iterations": left})
        return (*parts, self.model_copy(update={"run": last}))

    def in_unit(self, unit: Unit) -> Self:
        """The same scene with all its lengths in another unit.

        Which fields are lengths stands with the fields, as `part.LENGTH`.

        Raises
        ------
        Refused
            If the numbers would be too large or too small to be computed with.
        """
        if unit == self.unit:
            return self
        scene = self.scaled(units.ratio(self.unit, unit))
        return self.from_data(scene.to_data() | {"unit": unit})

    @classmethod
    def from_json(cls, text: str | bytes) -> Self:
        """Read a scene from the text of a scene file.

        Raises
        ------
        Refused
            With the path of the field, the value and what is allowed.
        """
        try:
            return cls.model_validate_json(text)
        except ValidationError as error:
            raise refusal(error, cls) from None

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


def _with_stage(scene: dict[str, Any], stage: Stage) -> dict[str, Any]:
    """Data of a scene with what a stage changes."""
    changes = stage.model_dump(mode="json", exclude_none=True)
    run = scene["run"]
    if changes.get("method", run["method"]) != run["method"]:
        # Settings of the one method mean nothing to the other.
        shared = set(RunSettings.model_fields)
        run = {name: value for name, value in run.items() if name in shared}
    run = run | {k: v for k, v in changes.items() if k in ("iterations", "method", "learning_rate")}
    parts = {name: changes[name] for name in ("source", "filter") if name in changes}
    lens = scene["lens"] | {k: changes[k] for k in ("control_points",) if k in changes}
    return scene | parts | {"lens": lens, "run": run}
