"""The lens as made, for other Python programs: errors, plans, mean errors and photographs.

`workbench.api` has these functions too.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from workbench.design.session import Session, result_of
from workbench.progress import finished

if TYPE_CHECKING:
    from workbench.analysis.making.as_made import MadeStep
    from workbench.analysis.making.photograph import Corner, Photograph
    from workbench.analysis.making.plan import ShopPlans, ShopRates
    from workbench.analysis.making.robust import ExpectedError
    from workbench.arrays import Array


def as_made(session: Session, rays: int = 1_000_000) -> "tuple[MadeStep, ...]":
    """Errors of a lens as designed and after each of the scene's processes.

    Parameters
    ----------
    session : Session
        A session with a lens, whose scene has processes.
    rays : int
        Each error comes from at most four times as many random rays.

    Raises
    ------
    Refused
        If the session has no lens, or it is no body.

    Examples
    --------
    >>> from resources import path
    >>> from workbench import DesignRun, Scene, begin, load
    >>> task = load(path("examples", "tophat-none-zeros.json"))
    >>> processes = [{"kind": "polishing", "width": 0.02}]
    >>> data = task.scene.to_data() | {"processes": processes, "run": {"method": "auto"}}
    >>> run = DesignRun(begin(Scene.from_data(data)), iterations=1)
    >>> for snapshot in run:
    ...     pass
    >>> [step.title for step in as_made(run.session, rays=100_000)]
    ['', 'Polishing']
    """
    from workbench.analysis.making.as_made import tracing_made  # late: it loads torch

    heights = result_of(session).state.heights
    return finished(tracing_made(session.scene, session.target, heights, rays=rays))


def plan(
    session: Session,
    wanted: float | None = None,
    ball_radius: float | None = None,
    rates: "ShopRates | None" = None,
) -> "ShopPlans":
    """Plans to mill and polish a lens, the one that takes the least time first.

    Parameters
    ----------
    session : Session
        A session with a lens.
    wanted : float, optional
        Relative L2 error as made, by default 1.1 times that as designed.
    ball_radius : float, optional
        Of the cutter, scene units; by default one that fits.
    rates : ShopRates, optional
        What times are computed with.

    Raises
    ------
    Refused
        If the session has no lens, or no plan reaches the wanted error.

    Examples
    --------
    >>> from resources import path
    >>> from workbench import DesignRun, load
    >>> run = DesignRun(load(path("examples", "tophat-none-zeros.json")), iterations=1)
    >>> for snapshot in run:
    ...     pass
    >>> cheapest, *_ = plan(run.session, wanted=1.0).plans
    >>> cheapest.processes[0].kind, cheapest.minutes > 0
    ('milling', True)
    """
    from workbench.analysis.making.plan import fitting_ball, planning  # late: it loads torch

    scene, heights = session.scene, result_of(session).state.heights
    ball = ball_radius or fitting_ball(scene, heights)
    return finished(planning(scene, session.target, heights, ball, wanted, rates))


def expected_error(session: Session) -> "ExpectedError":
    """Mean error of a lens over the scene's uncertainty, as a run sees it.

    Parameters
    ----------
    session : Session
        A session with a lens.

    Raises
    ------
    Refused
        If the session has no lens.

    Examples
    --------
    >>> from resources import path
    >>> from workbench import DesignRun, load
    >>> run = DesignRun(load(path("examples", "tophat-none-zeros.json")), iterations=1)
    >>> for snapshot in run:
    ...     pass
    >>> expected_error(run.session).cases  # nothing is uncertain
    1
    """
    from workbench.analysis.making.robust import expected_error  # late: it loads torch

    return expected_error(session.scene, session.target, result_of(session).state.heights)


def photograph(session: Session, picture: "Array", corners: "Sequence[Corner]") -> "Photograph":
    """Compare a photograph of the projected light with the prediction, and find likely causes.

    Parameters
    ----------
    session : Session
        A session with a lens.
    picture : ndarray, shape (rows, columns)
        Light of the photograph.
    corners : sequence of tuple[float, float]
        Columns and rows of the receiver's corners, from that of row 0 and column 0 along row 0.

    Raises
    ------
    Refused
        If the session has no lens, the corners make no quadrilateral in the photograph, or the
        picture is not within them.

    Examples
    --------
    >>> from resources import path
    >>> from workbench import DesignRun, load
    >>> run = DesignRun(load(path("examples", "tophat-none-zeros.json")), iterations=1)
    >>> for snapshot in run:
    ...     pass
    >>> import numpy as np
    >>> corners = (0, 0), (9, 0), (9, 9), (0, 9)
    >>> photograph(run.session, np.ones((8, 8)), corners)
    Traceback (most recent call last):
    workbench.errors.Refused: corners: are beside the photograph of 8 × 8 pixels
    """
    from workbench.analysis.making.photograph import comparing  # late: it loads torch

    heights = result_of(session).state.heights
    return finished(comparing(session.scene, session.target, heights, picture, corners))
