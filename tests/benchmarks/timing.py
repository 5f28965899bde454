"""Times of several things that are compared, measured in turns.

Another program that takes a core for a while then slows all of them alike, and ratios hold.
"""

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from statistics import median

_FEWEST = 3


@dataclass(frozen=True)
class Times:
    """Times of one call.

    Attributes
    ----------
    seconds : tuple of float
        One time a round.
    """

    seconds: tuple[float, ...]

    @property
    def median(self) -> float:
        """Median of all rounds."""
        return median(self.seconds)

    def ratio(self, other: "Times") -> float:
        """How many times longer than another's, the median of what each round says."""
        return median(a / b for a, b in zip(self.seconds, other.seconds, strict=True))


def in_turns(
    calls: Mapping[str, Callable[[], object]], rounds: int = 15, seconds: float = 20.0
) -> dict[str, Times]:
    """Time some calls, one after the other in each round.

    Parameters
    ----------
    calls : mapping from name to callable
        What is timed; each is called once more beforehand, to warm up.
    rounds : int
        Rounds at most.
    seconds : float
        No new round is begun after this time, once there are three.
    """
    for call in calls.values():
        call()
    taken: dict[str, list[float]] = {name: [] for name in calls}
    first = time.perf_counter()
    for number in range(max(rounds, _FEWEST)):
        if number >= _FEWEST and time.perf_counter() - first > seconds:
            break
        for name, call in calls.items():
            start = time.perf_counter()
            call()
            taken[name].append(time.perf_counter() - start)
    return {name: Times(tuple(each)) for name, each in taken.items()}
