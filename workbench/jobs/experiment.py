"""The experiments of the paper, ready to be repeated."""

from typing import Annotated, Literal

from pydantic import ConfigDict

import resources
from workbench.files.scene import read_scene
from workbench.jobs.job import Job
from workbench.scene import AutoNet, AutoRun, PaperRun, RunSettings, Scene
from workbench.scene.fields import Choices, about

_Name = Literal[
    "tophat-none-zeros",
    "tophat-sparse-uniform",
    "tophat-sparse-random",
    "tophat-dense-uniform",
    "flame-x1",
    "flame-x3",
    "flame-x5",
    "ball-x1",
    "ball-x3",
    "ball-x5",
    "flame-point",
    "flame-stages",
]
_TITLES = tuple((example.name, example.title) for example in resources.EXAMPLES)


class Experiment(Job):
    """Designs of de Koning, Heemels, Adam and Möller (2023), to repeat or to improve on."""

    model_config = ConfigDict(title="Experiments of the paper")

    name: Annotated[_Name, Choices(_TITLES), about("Experiment", "A design of the paper.")] = (
        "flame-x3"
    )
    method: Annotated[
        Literal["auto", "paper"],
        Choices((("auto", "Automatic"), ("paper", "As in the paper"))),
        about(
            "Method",
            "How the lens is found: by the best that this program knows, on as many control points "
            "as the target needs, or as then. The 64 × 64 control points of the paper are too few "
            "for fine detail: a flame stays 19 % off.",
        ),
    ] = "auto"

    def scene(self) -> Scene:
        """The example of that name, with the method that was chosen and a net that suits it."""
        scene = read_scene(resources.path("examples", f"{self.name}.json"))
        if self.method == "auto":
            scene = scene.with_optic(scene.optic.shaped(control_points=AutoNet()))
        if self.method == scene.run.method:
            return scene
        kind = PaperRun if self.method == "paper" else AutoRun
        same = {name: getattr(scene.run, name) for name in RunSettings.model_fields}
        return scene.altered(run=kind.model_validate(same | kind.defaults_for(scene)))
