"""Progress on standard error: a bar on a terminal, plain lines elsewhere."""

import math
import sys
import time

from tqdm import tqdm

from workbench.design.snapshot import Snapshot

# Elsewhere than on a terminal a line is due after this part of the run or this many seconds.
_PART, _SECONDS = 0.05, 10.0
_DELAY = 0.5  # seconds, before which nobody looks for a bar
_LINES = 10.0  # seconds from one line to the next, where parts are printed


class PartProgress:
    """Shows which part of something is done, if it takes long.

    Parameters
    ----------
    name : str
        What is done.
    """

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
        """Show the part that is done."""
        if self._bar is not None:
            self._bar.update(fraction - self._bar.n)
        elif time.monotonic() - self._last > _LINES:
            self._last = time.monotonic()
            print(f"{self._name}  {100 * fraction:.0f} %", file=sys.stderr, flush=True)

    def close(self) -> None:
        """Take the bar away."""
        if self._bar is not None:
            self._bar.close()


class Progress:
    """Shows where a run is, its loss and the time left.

    Parameters
    ----------
    deadline : float
        Time of `time.perf_counter` at which the run is stopped; may be infinite.
    """

    def __init__(self, deadline: float) -> None:
        self._deadline = deadline
        self._bar: tqdm | None = None
        self._line: Snapshot | None = None  # the last one that got a line
        self._notes: tuple[str, ...] = ()

    def show(self, snapshot: Snapshot) -> None:
        """Show the next snapshot of the run, and what its trace chose where that is new."""
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

    def close(self) -> None:
        """Leave the bar as it is and go on below it."""
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
        if snapshot.judged:  # which the figures of the result say
            return False
        return (
            last is None
            or snapshot.iteration == snapshot.iterations
            or snapshot.iteration - last.iteration >= _PART * snapshot.iterations
            or snapshot.seconds - last.seconds >= _SECONDS
        )

    def _state(self, snapshot: Snapshot) -> str:
        left = self._deadline - time.perf_counter()
        if snapshot.iteration > 0:
            to_do = snapshot.iterations - snapshot.iteration
            left = min(left, snapshot.seconds / snapshot.iteration * to_do)
        loss = f"loss {snapshot.state.loss:.4g}"
        if math.isinf(left):  # nothing is known yet
            return loss
        return f"{loss}  {tqdm.format_interval(max(left, 0.0))} left"
