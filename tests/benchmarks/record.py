"""Records error, time and memory of small designs of all kinds, to see what a change does to them.

``python -m tests.benchmarks.record -o before.json``, and after the change
``python -m tests.benchmarks.record -o after.json --compare before.json``.

Each scene is designed in a process of its own. Errors repeat exactly with the same number of
threads. Times are comparable only where no other program uses the cores: with three times as many
busy threads as cores, two records of the same program had steps that differed by a factor of two.
The exit status is 1 where a scene failed or a figure is worse than before.
"""

import argparse
import json
import os
import platform
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from tests.benchmarks.scenes import SCENES

_ROOT = Path(__file__).parents[2]
Figures = Mapping[str, Any]


class Figure(NamedTuple):
    """What is recorded of a scene.

    Attributes
    ----------
    heading : str
        What people read, with its unit.
    form : str
        Format specification of its values.
    noise : float or None
        Relative change from which on it counts as worse; None where a change is not judged.
    more_is_better : bool
        Which change is for the worse.
    """

    heading: str
    form: str
    noise: float | None = None
    more_is_better: bool = False


FIGURES = {
    "error": Figure("verified error", ".5f", 0.02),
    "iterations": Figure("iterations", "d"),
    "seconds": Figure("run, s", ".2f"),
    "step": Figure("step, s", ".4f", 0.05),
    "memory": Figure("peak memory, MiB", ".0f", 0.05),
    "efficiency": Figure("efficiency", ".4f", 0.02, more_is_better=True),
}
"""Figures by name. A step is the median of all steps; memory is that of the process of the run."""


class Change(NamedTuple):
    """A figure of a scene before and after; None where the scene failed."""

    scene: str
    figure: str
    old: float | None
    new: float | None

    @property
    def ratio(self) -> float | None:
        """New over old, where both are known."""
        return None if self.new is None or not self.old else self.new / self.old

    @property
    def worse(self) -> bool:
        """Whether it is worse by more than noise."""
        noise, more_is_better = FIGURES[self.figure][2:]
        if noise is None or self.old is None:
            return False
        if self.new is None:
            return True
        change = self.old - self.new if more_is_better else self.new - self.old
        return change > noise * abs(self.old)


def compare(old: Mapping[str, Figures], new: Mapping[str, Figures]) -> list[Change]:
    """Return how the figures of the scenes that both records have differ.

    Parameters
    ----------
    old, new : mapping of str to mapping
        Figures of scenes by name.
    """
    return [
        Change(scene, figure, old[scene].get(figure), figures.get(figure))
        for scene, figures in new.items()
        if scene in old
        for figure in FIGURES
    ]


def table(changes: Sequence[Change]) -> Iterator[str]:
    """Lines of a table of changes, and last what is worse."""
    line = "{:<24}  {:<16}  {:>9}  {:>9}  {:>6}  {}".format
    yield line("scene", "", "old", "new", "ratio", "").rstrip()
    for change in changes:
        figure = FIGURES[change.figure]
        values = _shown(change.old, figure.form), _shown(change.new, figure.form)
        mark = "worse" if change.worse else ""
        ratio = _shown(change.ratio, ".3f")
        yield line(change.scene, figure.heading, *values, ratio, mark).rstrip()
    worse = sum(change.worse for change in changes)
    yield f"{worse} of {len(changes)} figures are worse by more than noise"


def _shown(value: float | None, form: str) -> str:
    return "-" if value is None else format(value, form)


def _machine() -> dict[str, Any]:
    return {
        "cores": os.cpu_count(),
        "threads": os.environ.get("OMP_NUM_THREADS", "all cores"),
        "load before": round(os.getloadavg()[0], 2),
        "python": platform.python_version(),
    }


def _measured(name: str) -> dict[str, Any]:
    """Figures of a scene; the reason alone where its process fails."""
    command = [sys.executable, "-m", "tests.benchmarks.measure", name]
    done = subprocess.run(command, cwd=_ROOT, capture_output=True, text=True, check=False)
    if done.returncode == 0:
        found: dict[str, Any] = json.loads(done.stdout.splitlines()[-1])
        return found
    lines = done.stderr.strip().splitlines()
    return {"failed": lines[-1] if lines else f"exit status {done.returncode}"}


def record(output: Path, names: Sequence[str]) -> dict[str, Any]:
    """Measure scenes, and write what is known after each of them.

    Parameters
    ----------
    output : path
        The JSON file to write.
    names : sequence of str
        Scenes.
    """
    scenes: dict[str, Any] = {}
    found = {"machine": _machine(), "scenes": scenes}
    output.write_text(json.dumps(found, indent=1) + "\n", "utf-8")
    for name in names:
        scenes[name] = _measured(name)
        output.write_text(json.dumps(found, indent=1) + "\n", "utf-8")
        print(f"{name}: {_summary(scenes[name])}", flush=True)
    return found


def _summary(figures: Figures) -> str:
    if "failed" in figures:
        return f"failed: {figures['failed']}"
    return "; ".join(
        f"{figure.heading} {figures[name]:{figure.form}}" for name, figure in FIGURES.items()
    )


def main(arguments: Sequence[str] | None = None) -> int:
    """Record, compare where that is asked for, and return the exit status."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.record", description=__doc__)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument("-o", "--output", type=Path, required=True, help="JSON file to write")
    names = list(SCENES)
    parser.add_argument(
        "--only", nargs="+", metavar="NAME", choices=names, default=names, help=", ".join(names)
    )
    parser.add_argument("--compare", type=Path, metavar="JSON", help="an earlier record")
    given = parser.parse_args(arguments)
    old = None if given.compare is None else json.loads(given.compare.read_text("utf-8"))
    new = record(given.output, given.only)
    failed = any("failed" in figures for figures in new["scenes"].values())
    changes = []
    if old is not None:
        changes = compare(old["scenes"], new["scenes"])
        print(f"\nold: {old['machine']}\nnew: {new['machine']}\n")
        print("\n".join(table(changes)))
    return int(failed or any(change.worse for change in changes))


if __name__ == "__main__":
    sys.exit(main())
