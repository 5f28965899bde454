"""How fast a run goes, and how long it may still take."""

from collections import deque

_SPAN = 4.0  # seconds of run time that count as recent


class Pace:
    """Iterations a second over the last seconds of run time; pauses do not count."""

    def __init__(self) -> None:
        self._seen: deque[tuple[float, int]] = deque()

    def note(self, seconds: float, iteration: int) -> None:
        """Take note of how far a run is; another run begins anew."""
        seen = self._seen
        if seen and (iteration < seen[-1][1] or seconds < seen[-1][0]):
            seen.clear()
        seen.append((seconds, iteration))
        while len(seen) > 2 and seconds - seen[1][0] >= _SPAN:
            seen.popleft()

    @property
    def rate(self) -> float | None:
        """Iterations a second; None until it is known."""
        if not self._seen:
            return None
        (began, first), (ended, last) = self._seen[0], self._seen[-1]
        return (last - first) / (ended - began) if last > first and ended > began else None

    def left(self, iterations: int) -> float | None:
        """Seconds that so many more iterations take at this pace; None until it is known."""
        rate = self.rate
        return None if rate is None else iterations / rate
