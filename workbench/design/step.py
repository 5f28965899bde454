"""What a method hands to the run after each evaluation of a lens."""

from typing import NamedTuple

from workbench.design.lens_state import LensState


class Step(NamedTuple):
    """One evaluated lens."""

    # The lens, with the net of its stage, and its light; losses can be compared over the run.
    state: LensState
    notes: tuple[str, ...] = ()  # what was chosen for this lens's trace, and what was left out
    # What tells the best lens, where that is not the loss alone; infinite where no light is on the
    # screen.
    merit: float | None = None
