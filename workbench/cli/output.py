"""Commands that write files of a designed lens: ``freeform export``, ``pictures``, ``report``."""

import math
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import closing
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import Any, BinaryIO

from tqdm import tqdm

from workbench.analysis.tolerance_fields import Tolerances
from workbench.design.session import Session, result_of
from workbench.design.snapshot import Pace, Snapshot
from workbench.files.atomic import check_writable, make_folder, replacing
from workbench.files.export.options import GROUPS
from workbench.files.export.write import export as write_all
from workbench.files.session import read_session
from workbench.pictures import PICTURES, write_images
from workbench.report.content import HTML, Report, check_ending
from workbench.scene import Scene


def export(
    path: Path,
    files: Sequence[Path],
    chord_error: float | None,
    options: Mapping[str, Any],
    mesh_unit: str,
    element: str | None = None,
) -> None:
    """Write the lens of a session and its light in the formats of the file endings.

    ``options`` are values of all groups of options. Raise Refused if the session has no valid lens,
    or a file cannot be written, or, after the other files, a format cannot hold the data; RunFailed
    if an external library fails.
    """
    groups = [group.of(options) for group in GROUPS]
    session = read_session(path)
    result_of(session, str(path))
    for written in write_all(session, files, chord_error, groups, mesh_unit, element=element):
        print(written.sentence, flush=True)


def pictures(path: Path, folder: Path, stops: float | None = None, light: str = "") -> None:
    """Draw the lens of a session into a folder, which is made if missing.

    Raise Refused if the session has no lens, or the folder or a picture cannot be written;
    RunFailed if no light reaches the screen of a photo.
    """
    session = read_session(path)
    result_of(session, str(path))
    make_folder(folder)
    drawn = [(name, write, session) for name, write in PICTURES.items()]
    images = [(session.of_image(number), number) for number in range(len(session.scene.receivers))]
    drawn += [(_named("irradiance", number), write_images, shown) for shown, number in images[1:]]
    if stops is not None:
        photo = partial(_write_photo, stops=stops, light=light)
        drawn += [(_named("photo", number), photo, shown) for shown, number in images]
    for name, _, _ in drawn:
        check_writable(folder / name)
    for name, write, shown in drawn:
        with replacing(folder / name) as file:
            write(shown, file)


def _named(name: str, number: int) -> str:
    return f"{name}-{number + 1}.png" if number else f"{name}.png"


def _write_photo(session: Session, file: BinaryIO, stops: float, light: str) -> None:
    # Slow imports, rarely needed.
    from workbench.analysis.photo.light import LIGHTS
    from workbench.analysis.photo.photo import photograph, write_png

    heights = result_of(session).state.heights
    with closing(PartProgress("photo")) as progress:
        photo = photograph(session.scene, session.target, heights, LIGHTS.get(light), progress.show)
    write_png(photo, stops, file)
    print(f"photo: {photo.summary}")


def report(
    path: Path,
    files: Sequence[Path],
    rays: int,
    tolerances: tuple[Tolerances, int] | None,
    with_mitsuba: bool,
) -> None:
    """Check the lens of a session and write its report.

    Raise Refused if the session has no lens, a file cannot be written, a tolerance is not possible,
    or Mitsuba is not installed; RunFailed if no light reaches the receiver.
    """
    writers = [_writer(file) for file in files]
    session = read_session(path)
    result_of(session, str(path))
    for file in files:
        check_writable(file)
    from workbench.report.gather import gather  # slow import

    dated = datetime.fromtimestamp(path.stat().st_mtime)
    found = gather(session, path.stem, dated, rays, tolerances, with_mitsuba)
    for file, write in zip(files, writers, strict=True):
        with replacing(file) as stream:
            write(found, stream)


def _writer(file: Path) -> Callable[[Report, BinaryIO], None]:
    check_ending(file)
    if file.suffix.lower() in HTML:
        from workbench.report.write import write_html

        return write_html
    from workbench.report.write import write_pdf

    return write_pdf


# Without a terminal a line is printed after this part of the run or this many seconds.
_PART, _SECONDS = 0.05, 10.0
_DELAY = 0.5  # seconds before a bar appears
_LINES = 10.0  # seconds between lines of fractions


class PartProgress:
    """Progress of a named task as a fraction, if it takes long."""

    def __init__(self, name: str) -> None:
        self._name = name
        self._last = time.monotonic()
        self._bar: tqdm | None = None
        if sys.stderr.isatty():
            self._bar = tqdm(
                total=1.0,
                file=sys.stderr,
                dynamic_ncols=True,
                delay=_DELAY,
                leave=False,
                bar_format="{desc}  {bar} {percentage:.0f} %  {remaining} left",
                desc=name,
            )

    def show(self, fraction: float) -> None:
        """Show the finished fraction."""
        if self._bar is not None:
            self._bar.update(fraction - self._bar.n)
        elif time.monotonic() - self._last > _LINES:
            self._last = time.monotonic()
            print(f"{self._name}  {100 * fraction:.0f} %", file=sys.stderr, flush=True)

    def close(self) -> None:
        """Remove the bar."""
        if self._bar is not None:
            self._bar.close()


class Progress:
    """Progress of a run: iteration, loss and time left until the end or a deadline."""

    def __init__(self, scene: Scene, deadline: float) -> None:
        self._scene, self._deadline = scene, deadline
        self._pace = Pace()
        self._lacks_printed = False
        self._bar: tqdm | None = None
        self._line: Snapshot | None = None  # last printed snapshot
        self._notes: tuple[str, ...] = ()

    def show(self, snapshot: Snapshot) -> None:
        """Show the next snapshot; each note, and missing resolution, is printed once."""
        self._pace.note(snapshot.seconds, snapshot.iteration)
        if sys.stderr.isatty():
            self._draw(snapshot)
        elif self._is_due(snapshot):
            self._line = snapshot
            done = f"{snapshot.iteration}/{snapshot.iterations}"
            print(f"{done}  {self._state(snapshot)}", file=sys.stderr, flush=True)
        new = [note for note in snapshot.notes if note not in self._notes]
        self._notes = snapshot.notes
        if new:
            tqdm.write("; ".join(new), file=sys.stderr)
        lacks = snapshot.state.shortfall
        if lacks is not None and lacks.needed is not None and not self._lacks_printed:
            self._lacks_printed = True
            tqdm.write(lacks.at_field(self._scene), file=sys.stderr)

    def close(self) -> None:
        """Leave the bar and continue below it."""
        if self._bar is not None:
            self._bar.close()

    def _draw(self, snapshot: Snapshot) -> None:
        if self._bar is None:
            self._bar = tqdm(
                total=snapshot.iterations,
                file=sys.stderr,
                dynamic_ncols=True,
                bar_format="{bar} {n_fmt}/{total_fmt}{postfix}",
            )
        self._bar.set_postfix_str(self._state(snapshot), refresh=False)
        self._bar.update(snapshot.iteration - self._bar.n)

    def _is_due(self, snapshot: Snapshot) -> bool:
        last = self._line
        if snapshot.judged:  # the figures of the result say that
            return False
        return (
            last is None
            or snapshot.iteration == snapshot.iterations
            or snapshot.iteration - last.iteration >= _PART * snapshot.iterations
            or snapshot.seconds - last.seconds >= _SECONDS
        )

    def _state(self, snapshot: Snapshot) -> str:
        loss = f"loss {snapshot.state.loss:.4g}"
        measured = self._pace.left(snapshot.iterations - snapshot.iteration)
        left = min(self._deadline - time.perf_counter(), math.inf if measured is None else measured)
        if math.isinf(left):  # too early for an estimate
            return loss
        at_most = "at most " if self._scene.run.method == "auto" else ""
        return f"{loss}  {at_most}{tqdm.format_interval(max(left, 0.0))} left"
