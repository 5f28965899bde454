"""Why runs end: the messages, and which of them mean that a run has converged."""

from workbench.said import Said

DONE = "all iterations are done"
LOCKED = "all control points are locked"
STOPPED = "stopped"
SMALL = "converged: error below {error:g} %"
LOWEST = "converged: no step makes the image better"
SLOW = "converged: less than {gain:g} % better in {patience} iterations"
FLAT = "converged: error less than {points:g} percentage points lower in {patience} iterations"
IN_VAIN = "{ended}; no iteration made the lens better"
NO_IMAGE = "{ended}; the exit face alone makes no image"
GAINED = (
    "{ended}; after {iterations} iterations the error of both faces was {times:.2g} times that "
    "of the exit face behind a flat entrance"
)
FAILED = "failed: {why}"

CONVERGED = (SMALL, LOWEST, SLOW, FLAT)
ENDINGS = (DONE, LOCKED, STOPPED, *CONVERGED, IN_VAIN, NO_IMAGE, GAINED)
"""All but failures, whose reasons are without number."""


def has_converged(ended: str) -> bool:
    """Whether a run ended because nothing got better."""
    if not isinstance(ended, Said):
        return False
    return ended.words in CONVERGED or has_converged(ended.values.get("ended", ""))
