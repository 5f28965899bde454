"""``freeform benchmark``."""

import json
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from workbench.analysis.benchmark.names import (
    BENCHMARKS,
    WITH_CURVES,
    WITH_PICTURES,
    Settings,
)
from workbench.cli.interruption import EndedBySignal, number_of
from workbench.errors import Refused
from workbench.files.atomic import check_writable, make_folder, replacing


def benchmark(
    names: Sequence[str], folder: Path, settings: Settings, against: Path | None, as_json: bool
) -> None:
    """Run benchmarks; each writes a table (Markdown and JSON) and a picture into a folder.

    Raise Refused if there is no such benchmark, the folder is not writable, or one of the
    benchmarks has no such settings; KeyboardInterrupt after Ctrl-C, with finished benchmarks
    written.
    """
    _check(names, folder, against)
    chosen = {"--pixels": settings.pixels, "--only": settings.only}
    for option in (option for option, value in chosen.items() if value):
        for name in names:
            if name != WITH_PICTURES:
                raise Refused(name, f"has no pictures; {option} is for {WITH_PICTURES}")
    from workbench.analysis.benchmark.machine import Machine  # slow import

    earlier = _earlier(against)
    machine = Machine.here()
    if not as_json:
        print(machine.to_markdown(), flush=True)
    found = {}
    stop = None
    for name in names:
        rows, seconds, stop = _measure(name, settings)
        if rows:
            found[name] = _write(name, rows, earlier, seconds, folder, as_json)
        if stop:
            break
    if as_json:
        print(json.dumps({"machine": machine.to_data(), "benchmarks": found}))
    if stop:
        kept = f"what was finished is in {folder}" if found else "nothing was finished"
        raise EndedBySignal(number_of(stop), f"interrupted; {kept}")


def draw_result(name: str, result: Path, folder: Path, against: Path | None) -> None:
    """Draw the picture of a finished benchmark; raise Refused if that is not possible."""
    if name not in WITH_CURVES:
        raise Refused(name, f"has no curves; --result is for {', '.join(WITH_CURVES)}")
    _check([name], folder, against)
    from workbench.analysis.benchmark.frontier import kept_courses  # slow import

    _draw(name, kept_courses(result), _earlier(against), folder)
    print(folder / f"{name}.png")


def _check(names: Sequence[str], folder: Path, against: Path | None) -> None:
    for name in names:
        if name not in BENCHMARKS:
            raise Refused(name, f"is no benchmark; there are {', '.join(BENCHMARKS)}")
        if against is not None and name not in WITH_CURVES:
            raise Refused(name, f"has no curves; --against is for {', '.join(WITH_CURVES)}")
    make_folder(folder)
    for name in names:
        check_writable(folder / f"{name}.png")


def _earlier(against: Path | None) -> Sequence[Any]:
    if against is None:
        return ()
    from workbench.analysis.benchmark.frontier import earlier_courses

    return earlier_courses(against)


def _measure(name: str, settings: Settings) -> tuple[list[Any], float, KeyboardInterrupt | None]:
    from workbench.analysis.benchmark.suite import SUITE

    rows: list[Any] = []
    start = time.perf_counter()
    progress = _Progress(name)
    stop = None
    try:
        for row in SUITE[name].measure(settings, progress.show):
            rows.append(row)
    except KeyboardInterrupt as error:
        stop = error
    progress.close()
    return rows, time.perf_counter() - start, stop


def _write(
    name: str,
    rows: Sequence[Any],
    earlier: Sequence[Any],
    seconds: float,
    folder: Path,
    as_json: bool,
) -> dict[str, Any]:
    from workbench.analysis.benchmark.suite import SUITE

    tables = SUITE[name].tables(rows)
    text = "\n".join(table.to_markdown() for table in tables)
    if not as_json:
        print(f"## {name} ({seconds:.0f} s)\n\n{text}", flush=True)
    figures = {"seconds": seconds, **{table.title: table.to_data() for table in tables}}
    with replacing(folder / f"{name}.md") as file:
        file.write(text.encode())
    with replacing(folder / f"{name}.json") as file:
        file.write(json.dumps(figures, indent=1).encode())
    _draw(name, rows, earlier, folder)
    return figures


def _draw(name: str, rows: Sequence[Any], earlier: Sequence[Any], folder: Path) -> None:
    from workbench.pictures.benchmark import draw

    seen = [each for each in earlier if any(each.scene == row.scene for row in rows)]
    with replacing(folder / f"{name}.png") as file:
        draw(name, [*rows, *seen], file)


class _Progress:
    """Progress on standard error: one changing line on a terminal, else many lines."""

    _SECONDS = 10.0  # from one line to the next

    def __init__(self, name: str) -> None:
        self._name = name
        self._case = ""
        self._last = -self._SECONDS
        self._is_terminal = sys.stderr.isatty()

    def show(self, case: str, state: str) -> None:
        now = time.perf_counter()
        line = f"{self._name}: {case}  {state}".rstrip()
        if self._is_terminal:
            if case != self._case or now - self._last > 0.1:
                print(f"\r\x1b[K{line}", end="", file=sys.stderr, flush=True)
                self._last = now
        elif case != self._case or now - self._last > self._SECONDS:
            print(line, file=sys.stderr, flush=True)
            self._last = now
        self._case = case

    def close(self) -> None:
        if self._is_terminal:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)
