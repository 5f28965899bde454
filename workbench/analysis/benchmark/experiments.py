"""The experiments of de Koning et al. (2023) in the example scenes, also by ``auto``."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from workbench.analysis.benchmark.examples import BenchmarkTask, Notify, Table, TableColumn
from workbench.analysis.benchmark.machine import PeakMemory
from workbench.analysis.derivatives import irradiance_derivative
from workbench.analysis.validation import validate
from workbench.arrays import Array
from workbench.design.run import run
from workbench.design.snapshot import History, Result
from workbench.errors import Refused, RunFailed
from workbench.optics import ready
from workbench.scene import Scene

DESIGNS = (
    "tophat-none-zeros",
    "tophat-sparse-uniform",
    "tophat-sparse-random",
    "tophat-dense-uniform",
    *(f"{shape}-x{magnification}" for shape in ("flame", "ball") for magnification in (1, 3, 5)),
    "flame-point",
    "flame-stages",
)
DERIVATIVES = (
    "derivative-degree3-filter3",
    "derivative-degree3-filter11",
    "derivative-degree5-filter3",
)
_PAPER_ITERATIONS = 1000
_RAYS = 16_000_000


@dataclass(frozen=True, eq=False)
class ExampleDesign:
    """One designed lens."""

    name: str
    group: str
    method: str
    scene: Scene
    target: Array  # (n_y, n_x)
    result: Result | None = None
    times: tuple[float, ...] = ()  # time after each iteration, s
    # Verified figures.
    error: float | None = None
    noise: float | None = None
    efficiency: float | None = None
    memory: int | None = None  # peak of the process, bytes
    failure: str = ""  # reason of a failure

    @property
    def loss(self) -> float | None:
        """Loss of the best lens, by the optimiser."""
        return None if self.result is None else self.result.state.loss

    @property
    def iterations(self) -> int | None:
        """Iterations taken."""
        return None if self.result is None else self.result.iterations

    @property
    def seconds(self) -> float | None:
        """Time of the whole run."""
        return None if self.result is None else self.result.seconds

    @property
    def milliseconds_an_iteration(self) -> float | None:
        """Time of an iteration, without the start of the run."""
        if len(self.times) < 2:
            return None
        return 1e3 * (self.times[-1] - self.times[0]) / (len(self.times) - 1)

    @property
    def megabytes(self) -> float | None:
        """Peak memory in MB."""
        return None if self.memory is None else self.memory / 1e6


@dataclass(frozen=True, eq=False)
class Derivative:
    """Derivative of the image of a flat lens with respect to its middle control height."""

    name: str  # of the example
    scene: Scene
    map: Array  # (n_y, n_x), change of flux per area, per scene unit of height
    sum: float  # change of the flux on the screen
    moved: float  # sum of the positive changes of flux
    pixels: int  # with a change

    @property
    def balance(self) -> float:
        """Sum relative to the flux that moves."""
        return self.sum / self.moved


def experiments(iterations: int | None, notify: Notify) -> Iterator[ExampleDesign | Derivative]:
    """Run all experiments, the quickest first."""
    ready.compile_all()  # not part of the run times
    for name in DERIVATIVES:
        notify(name, "")
        yield derivative(BenchmarkTask.of(name))
    for name in DESIGNS:
        for example, method in _methods(name):
            yield design(_limited(example, iterations), method, _RAYS, notify)


def design(example: BenchmarkTask, method: str, rays: int, notify: Notify) -> ExampleDesign:
    """Run one experiment and verify its lens; the result holds the reason of a failure."""
    case = f"{example.name}, {method}"
    found = ExampleDesign(example.name, example.group, method, example.scene, example.target)
    history = History()
    times: list[float] = []
    peak = PeakMemory()
    try:
        for snapshot in run(example.scene, example.target):
            history.add(snapshot)
            times.append(snapshot.seconds)
            notify(
                case, f"{snapshot.iteration}/{snapshot.iterations}, loss {snapshot.state.loss:.4g}"
            )
    except (Refused, RunFailed) as failure:
        found = replace(found, failure=str(failure))
    result = history.result()
    found = replace(found, result=result, times=tuple(times), memory=peak.bytes())
    if result is None:
        return found
    notify(case, "verifying")
    try:
        light = validate(example.scene, example.target, result.state.heights, rays)
    except RunFailed as failure:
        return replace(found, failure=found.failure or str(failure))
    return replace(found, error=light.relative_l2, noise=light.noise, efficiency=light.efficiency)


def derivative(example: BenchmarkTask) -> Derivative:
    """Compute the derivative of a flat lens's image for its middle control point."""
    scene = example.scene
    n_u, n_v = scene.optic.net_shape
    flat = {"lens.back": np.full((n_u, n_v), scene.optic.base.height)}
    found = irradiance_derivative(scene, flat, (n_u // 2, n_v // 2))
    return Derivative(
        name=example.name,
        scene=scene,
        map=found.map,
        sum=found.sum,
        moved=scene.receiver.total(found.map.clip(0)),
        pixels=int(np.count_nonzero(found.map)),
    )


def tables(found: Sequence[ExampleDesign | Derivative]) -> tuple[Table, ...]:
    """The experiments as rows: the designs, and the derivatives."""
    designs = (
        TableColumn("name", "experiment"),
        TableColumn("method", "method"),
        TableColumn("loss", "final loss", ".3g"),
        TableColumn("error", "verified error", ".2%"),
        TableColumn("noise", "±", ".2%"),
        TableColumn("efficiency", "light on the screen", ".1%"),
        TableColumn("iterations", "iterations"),
        TableColumn("milliseconds_an_iteration", "ms an iteration", ".0f"),
        TableColumn("seconds", "seconds", ".1f"),
        TableColumn("megabytes", "peak MB", ".0f"),
        TableColumn("failure", "failed"),
    )
    derivatives = (
        TableColumn("name", "derivative"),
        TableColumn("sum", "sum", ".2e"),
        TableColumn("moved", "flux moved", ".2e"),
        TableColumn("balance", "sum / moved", ".1e"),
        TableColumn("pixels", "pixels in reach"),
    )
    return (
        Table("Designs", designs, [each for each in found if isinstance(each, ExampleDesign)]),
        Table(
            "Derivatives with respect to one control height",
            derivatives,
            [each for each in found if isinstance(each, Derivative)],
        ),
    )


def _methods(name: str) -> Iterator[tuple[BenchmarkTask, str]]:
    example = BenchmarkTask.of(name)
    run = example.scene.run
    if run.method != "paper":
        stages = [stage.model_dump(mode="json", exclude_none=True) for stage in run.stages]
        paper = {"method": "paper", "iterations": _PAPER_ITERATIONS, "stages": stages}
        yield BenchmarkTask.of(name, changes={"run": paper}), "paper"
    yield example, run.method


def _limited(example: BenchmarkTask, iterations: int | None) -> BenchmarkTask:
    """Return the example with other iterations; stages change in proportion."""
    if iterations is None:
        return example
    data = example.scene.to_data()
    part = iterations / data["run"]["iterations"]
    data["run"]["iterations"] = iterations
    for stage in data["run"]["stages"]:
        stage["iterations"] = max(1, int(part * stage["iterations"]))
    return replace(example, scene=Scene.from_data(data))
