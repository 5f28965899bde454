"""How fast a run goes, and how long it may still take."""

from collections import deque
from itertools import pairwise
from statistics import median

_SPAN = 4.0  # seconds of run time that count as recent
# Steps that tell a pace. The first lens and the first step, in which kernels are compiled, are none
# of them, and one slow step among others does not count: of a run of 33 s the time left was first
# given as 75 minutes.
_STEPS = 3


class Pace:
    """Pace of the measured steps of the last seconds of run time; pauses do not count."""

    def __init__(self) -> None:
        self._seen: deque[tuple[float, int]] = deque()

    def note(self, seconds: float, iteration: int) -> None:
        """Take note of how far a run is; another run begins anew."""
        seen = self._seen
        if seen and (iteration < seen[-1][1] or seconds < seen[-1][0]):
            seen.clear()
        if iteration == 0 or (seen and iteration == seen[-1][1]):
            return
        seen.append((seconds, iteration))
        while len(seen) > 1 + _STEPS and seconds - seen[1][0] >= _SPAN:
            seen.popleft()

    @property
    def rate(self) -> float | None:
        """Iterations a second; None until enough steps have been measured."""
        seen = list(self._seen)
        if not seen or seen[-1][1] - seen[0][1] < _STEPS:
            return None
        step = median(
            each
            for (began, first), (ended, last) in pairwise(seen)
            for each in [(ended - began) / (last - first)] * (last - first)
        )
        return 1 / step if step > 0 else None

    def left(self, iterations: int) -> float | None:
        """Seconds that so many more iterations take at this pace; None until it is known."""
        rate = self.rate
        return None if rate is None else iterations / rate
