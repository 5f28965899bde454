"""``freeform sweep``."""

import json
import sys
from collections.abc import Sequence
from pathlib import Path

from workbench.cli.interruption import EndedBySignal, number_of
from workbench.design.session import verified_error
from workbench.errors import RunFailed
from workbench.sweep.cluster import Cluster
from workbench.sweep.points import Point, Variation
from workbench.sweep.points import points as points_of
from workbench.sweep.processes import Processes
from workbench.sweep.sweep import PointRow, Store, to_data
from workbench.sweep.sweep import sweep as sweep_all


def sweep(
    scenes: Sequence[Path],
    vary: Sequence[str],
    folder: Path,
    jobs: int | None,
    dask: str | None,
    rays: int,
    as_json: bool,
) -> None:
    """Design a lens for each scene and each combination of values, in one table.

    Raise Refused if no point is possible, the folder is not writable or the cluster not reachable;
    RunFailed if some points have no lens; KeyboardInterrupt after Ctrl-C. Finished points are kept.
    """
    points = points_of(scenes, [Variation.parse(text) for text in vary])
    store = Store(folder)
    with store.locked():
        table, stop = _work(points, store, _workers(jobs, dask, len(points)), rays)
        store.write_table(table)
    print(json.dumps(to_data(table)) if as_json else _text(table))
    failed = sum(row.reason is not None for row in table)
    if stop:
        raise EndedBySignal(
            number_of(stop),
            f"interrupted; {len(table) - failed} of {len(points)} points are finished and kept in "
            f"{folder}, the same command goes on",
        )
    if failed:
        raise RunFailed(f"{failed} of {len(points)} points have no lens; the table has the reasons")


def _workers(jobs: int | None, dask: str | None, points: int) -> Cluster | Processes:
    if dask:
        return Cluster(dask)
    return Processes.of(points, jobs)


def _work(
    points: Sequence[Point], store: Store, workers: Cluster | Processes, rays: int
) -> tuple[list[PointRow], KeyboardInterrupt | None]:
    rows: dict[int, PointRow] = {}
    stop = None
    try:
        with workers:
            for number, row in sweep_all(points, store, workers, rays):
                rows[number] = row
                _print_row(points[number].name, row, len(rows), len(points))
    except KeyboardInterrupt as error:
        stop = error
    return [rows[number] for number in sorted(rows)], stop


def _print_row(name: str, row: PointRow, done: int, of: int) -> None:
    outcome = row.reason or f"error {verified_error(row.verified)}"
    print(f"{done}/{of}  {name}: {outcome}", file=sys.stderr, flush=True)


def _text(rows: Sequence[PointRow]) -> str:
    several = len({row.scene for row in rows}) > 1
    paths = list(rows[0].changes) if rows else []
    head = [*(["scene"] if several else []), *paths]
    lines = [
        [*head, "error without ray noise", "light on screen", "iterations", "seconds", "session"]
    ]
    for row in rows:
        start = [*([Path(row.scene).stem] if several else []), *row.changes.values()]
        figures = row.figures
        end = [row.reason or ""]
        if figures:
            end = [
                verified_error(row.verified),
                f"{figures['efficiency']:.1%}",
                f"{figures['iterations']:.0f}",
                f"{figures['seconds']:.1f}",
                row.session or "",
            ]
        lines.append([*start, *end])
    # A reason is long; no cell follows it.
    full = [line for line in lines if len(line) == len(lines[0])]
    widths = [max(map(len, cells)) for cells in zip(*full, strict=True)]
    return "\n".join(
        "  ".join(f"{cell:<{w}}" for cell, w in zip(line, widths, strict=False)).rstrip()
        for line in lines
    )
