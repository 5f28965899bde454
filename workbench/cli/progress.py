"""Progress on standard error: a bar on a terminal, plain lines elsewhere."""

import math
import sys
import time

from tqdm import tqdm

from workbench.design.pace import Pace
from workbench.design.snapshot import Snapshot
from workbench.scene import Scene

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
