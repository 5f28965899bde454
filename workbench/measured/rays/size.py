"""How large the place is that rays come from."""

from typing import NamedTuple, Self

import numpy as np

from workbench.arrays import Array

# Means of u⁴ and v⁴ over that of u² v², for places u, v over their deviations: 3.6 for an even
# rectangle, 6 for what is round.
_ROUND = 4.8


class Size(NamedTuple):
    """Where rays start in a plane across the axis.

    Attributes
    ----------
    middle, deviation : tuple[float, float]
        Mean along x and y, and standard deviation.
    round : bool
        Whether it is rather an ellipse than a rectangle.
    """

    middle: tuple[float, float]
    deviation: tuple[float, float]
    round: bool

    @classmethod
    def of(cls, start: Array, flux: Array) -> Self:
        """Of starts, shape (m, 2), with their flux.

        Examples
        --------
        Corners of a square, and the middle:

        >>> import numpy as np
        >>> start = np.array([[1.0, 1], [1, -1], [-1, 1], [-1, -1], [0, 0]])
        >>> Size.of(start, np.ones(5))
        Size(middle=(0.0, 0.0), deviation=(0.894..., 0.894...), round=False)
        """
        part = flux / flux.sum()
        x, y = (part @ start).tolist()
        squares = np.square(start - (x, y))
        v_x, v_y = (part @ squares).tolist()
        both = float(part @ squares.prod(axis=1))
        fourth_x, fourth_y = (part @ np.square(squares)).tolist()
        round_ = fourth_x * v_y**2 + fourth_y * v_x**2 > _ROUND * both * v_x * v_y
        return cls((x, y), (v_x**0.5, v_y**0.5), round_)

    @property
    def half_width(self) -> tuple[float, float]:
        """Of an even rectangle, or of an even ellipse, of the same deviation."""
        times = 2.0 if self.round else 3**0.5
        return times * self.deviation[0], times * self.deviation[1]
