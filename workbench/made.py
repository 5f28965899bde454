"""The lens as made, for other Python programs: errors, plans, photographs and measured parts.

`workbench.api` has these functions too.
"""

from collections.abc import Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

from workbench.analysis.cells.image import ACCURACY
from workbench.analysis.inspection.inspection import Inspection, Units, corrected_session, inspected
from workbench.analysis.making.plan_options import PlanOptions
from workbench.analysis.validation import validate
from workbench.design.session import Session, result_of
from workbench.measured.surfaces import read_surface
from workbench.progress import finished
from workbench.reading import opened
from workbench.scene.making import presets
from workbench.scene.making.uncertainty import SHARES

if TYPE_CHECKING:
    from workbench.analysis.making.photograph import Corner, Photograph
    from workbench.analysis.making.plan import ShopPlans
    from workbench.analysis.making.robust import Compromise, ExpectedError
    from workbench.analysis.validation_figures import MadeStep
    from workbench.arrays import Array
    from workbench.measured.surfaces import PictureScale

File = str | PathLike[str]


def preset_processes(*names: str, unit: str) -> list[dict[str, Any]]:
    """Processes of presets, as a scene file has them.

    Parameters
    ----------
    *names : str
        Names of presets, such as ``mill-3mm``, in the order of manufacture.
    unit : str
        Unit of length of the scene.

    Raises
    ------
    Refused
        If there is no such preset; the message names all presets.

    Examples
    --------
    >>> preset_processes("turn", unit="cm")
    [{'kind': 'turning', 'nose_radius': 0.05, 'feed': 0.0005}]
    """
    return presets.preset_processes(names, unit)


def as_made(session: Session, rays: int = 4_000_000) -> "tuple[MadeStep, ...]":
    """Errors of a lens as designed and after each of the scene's processes; none without them.

    Parameters
    ----------
    session : Session
        A session with a lens, whose scene has processes.
    rays : int
        Rays of the check of the lens as made; each other error comes from at most as many.

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
    >>> [step.title for step in as_made(run.session, rays=20_000)]
    ['', 'Polishing']
    """
    from workbench.analysis.making.as_made import checking

    heights = result_of(session).state.heights
    return finished(checking(session.scene, session.target, heights, rays)).steps


def plan(
    session: Session, options: PlanOptions | None = None, rays: int = 1_000_000
) -> "ShopPlans":
    """Plans to mill and polish a lens, the one that takes the least time first.

    Parameters
    ----------
    session : Session
        A session with a lens.
    options : PlanOptions, optional
        Wanted error as made, cutter, and what times are computed with.
    rays : int
        Each check has at most four times as many.

    Raises
    ------
    Refused
        If the session has no lens, or no plan reaches the wanted error.

    Examples
    --------
    >>> from resources import path
    >>> from workbench import DesignRun, PlanOptions, load
    >>> run = DesignRun(load(path("examples", "tophat-none-zeros.json")), iterations=1)
    >>> for snapshot in run:
    ...     pass
    >>> cheapest, *_ = plan(run.session, PlanOptions(error=100), rays=50_000).plans
    >>> cheapest.processes[0].kind, cheapest.minutes > 0
    ('milling', True)
    """
    from workbench.analysis.making.plan import planning  # late: it loads torch

    heights = result_of(session).state.heights
    return finished(planning(session.scene, session.target, heights, options, rays))


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


def compromises(
    session: Session, shares: Sequence[float] = SHARES, iterations: int | None = None
) -> "tuple[Compromise, ...]":
    """Lenses for parts of the scene's uncertainty, with their errors over the whole of it.

    Parameters
    ----------
    session : Session
        A task, or a lens to start from.
    shares : sequence of float
        Parts of the standard deviations that each run knows: 0 for the exact set-up.
    iterations : int, optional
        Upper limit of each run in place of the scene's.

    Raises
    ------
    Refused
        If nothing is uncertain, or the scene cannot be run.

    Examples
    --------
    >>> from resources import path
    >>> from workbench import Scene, begin, load
    >>> data = load(path("examples", "tophat-none-zeros.json")).scene.to_data()
    >>> uncertain = {"uncertainty": {"distance": 0.2}, "run": {"method": "auto"}}
    >>> nominal, robust = compromises(begin(Scene.from_data(data | uncertain)), (0, 1), 1)
    >>> robust.error.cases
    3
    """
    from workbench.analysis.making.robust import compromising  # late: it loads torch

    return finished(compromising(session, shares, iterations))


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


def inspect(
    session: Session,
    *files: File,
    face: str | None = None,
    unit: str | None = None,
    height_unit: str | None = None,
    with_scale: bool = False,
    pictures: "PictureScale | None" = None,
) -> Inspection:
    """Align measurements of made parts to a face of a lens, and find how far they are off.

    Parameters
    ----------
    session : Session
        A session with the lens as designed.
    *files : path
        A measurement of each part: points, a grid of heights, a mesh or a picture of heights.
    face : str, optional
        Face that was measured, such as ``lens.back``; by default the designed face.
    unit, height_unit : str, optional
        Units of lengths and of heights: "mm", "cm", "m", "inch", "um" or "nm"; by default that
        of the file, or else of the scene.
    with_scale : bool
        Whether to determine a scale, too, as of shrinkage.
    pictures : PictureScale, optional
        Scale of pictures that have none of their own.

    Returns
    -------
    Inspection
        Placement and residual of each part, and the part of the residual that repeats.

    Raises
    ------
    Refused
        If the session has no lens, a file cannot be read, or its points do not fit the face.

    Examples
    --------
    >>> from resources import path
    >>> from workbench import DesignRun, export, load
    >>> run = DesignRun(load(path("examples", "tophat-none-zeros.json")), iterations=1)
    >>> for snapshot in run:
    ...     pass
    >>> written = export(run.session, "part.stl", chord_error=1e-3)
    >>> found = inspect(run.session, "part.stl")
    >>> found.parts[0].residual.rms < 1e-6
    True
    >>> list(found.as_measured(found.parts[0]))  # heights for `workbench.check`
    ['lens.back']
    """
    surfaces = []
    for path in map(Path, files):
        with opened(path) as file:
            surfaces.append((str(path), read_surface(path, file, pictures)))
    return inspected(session, surfaces, face, Units(unit, height_unit), with_scale)


def corrected(
    session: Session,
    inspection: Inspection,
    made_from: Session | None = None,
    rays: int = 4_000_000,
) -> Session:
    """Return a session whose face makes good what repeats in measured parts.

    Parameters
    ----------
    session : Session
        The lens as designed, with which the parts were compared.
    inspection : Inspection
        What `inspect` found.
    made_from : Session, optional
        The corrected lens that the parts were made from; by default the lens as designed.
    rays : int
        Rays of the check that gives the light of the corrected lens.

    Raises
    ------
    Refused
        If the corrected lens is no body.

    Examples
    --------
    >>> from resources import path
    >>> from workbench import DesignRun, export, load
    >>> run = DesignRun(load(path("examples", "tophat-none-zeros.json")), iterations=1)
    >>> for snapshot in run:
    ...     pass
    >>> written = export(run.session, "made.stl", chord_error=1e-3)
    >>> again = corrected(run.session, inspect(run.session, "made.stl"), rays=100_000)
    >>> again.result is not None
    True
    """
    base = None if made_from is None else result_of(made_from).state.heights
    scene, heights = session.scene, inspection.corrected(base)
    light = validate(scene, session.target, heights, rays, accuracy=ACCURACY)
    return corrected_session(session, heights, light)
