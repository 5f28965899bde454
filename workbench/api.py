"""What other Python programs may rely on; everything else may change without notice.

`workbench` offers it, too. Faces, sources and losses of one's own are in `workbench.custom`.

Examples
--------
A lens, designed, checked with other rays than the design's, exported and saved:

>>> from workbench import DesignRun, check, export, load, save
>>> from resources import path
>>> run = DesignRun(load(path("examples", "tophat-none-zeros.json")), iterations=1)
>>> for snapshot in run:
...     print(snapshot.iteration, snapshot.state.irradiance.shape)
0 (256, 256)
1 (256, 256)
>>> lens = run.session
>>> found = check(lens, rays=1_000_000)
>>> found.efficiency == found.account.on_screen
True
>>> [written.format for written in export(lens, "lens.step", "lens.dat")]
['STEP solid', 'OpticStudio grid sag']
>>> save(lens, "lens.freeform")
"""

from collections.abc import Iterable, Mapping, Sequence
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

from workbench.analysis.cells.image import ACCURACY
from workbench.analysis.inspection.inspection import Inspection
from workbench.analysis.making.plan_options import PlanOptions
from workbench.analysis.validation import validate
from workbench.analysis.validation_figures import Validation
from workbench.arrays import Array
from workbench.design.design_run import DesignRun
from workbench.design.session import Session, result_of
from workbench.design.snapshot import Result, Snapshot
from workbench.design.task import begin as begin_in
from workbench.errors import Refused, RunFailed
from workbench.files.export.options import MILLIMETRES, Cutting, Drawing, Tile, Turning
from workbench.files.export.write import Written
from workbench.files.export.write import export as write_files
from workbench.files.session import open_design, write_session
from workbench.geometry.faces import FaceArrays
from workbench.made import (
    as_made,
    compromises,
    corrected,
    expected_error,
    inspect,
    photograph,
    plan,
    preset_processes,
)
from workbench.option_groups import OptionGroup
from workbench.scene import Scene

__all__ = [
    "Cutting",
    "DesignRun",
    "Drawing",
    "FaceArrays",
    "Inspection",
    "PlanOptions",
    "Refused",
    "Result",
    "RunFailed",
    "Scene",
    "Session",
    "Snapshot",
    "Tile",
    "Turning",
    "Validation",
    "Written",
    "as_made",
    "begin",
    "check",
    "compromises",
    "corrected",
    "expected_error",
    "export",
    "inspect",
    "load",
    "photograph",
    "plan",
    "preset_processes",
    "save",
    "sensitivity",
]

if TYPE_CHECKING:
    from workbench.analysis.derivatives import Figure, Sensitivity

File = str | PathLike[str]


def load(path: File) -> Session:
    """Open a session, or a scene file together with its target.

    Raises
    ------
    Refused
        If a file cannot be read or what it says is not possible.

    Examples
    --------
    >>> from resources import path
    >>> session = load(path("examples", "tophat.json"))
    >>> session.scene.optic.net_shape, session.target.shape
    ((480, 480), (256, 256))
    """
    return open_design(Path(path))


def begin(scene: Scene, folder: File = ".") -> Session:
    """A session without a lens for a scene, whose target is drawn.

    Parameters
    ----------
    scene : Scene
        The design task.
    folder : path
        Where a relative path of the target's image starts.

    Raises
    ------
    Refused
        If the target cannot be drawn.

    Examples
    --------
    >>> scene = Scene.from_data({
    ...     "version": 3, "unit": "cm",
    ...     "source": {"kind": "point", "position": [0, 0, -4]},
    ...     "elements": [{
    ...         "kind": "lens", "name": "lens", "half_width": [1, 1], "material": {"index": 1.5},
    ...         "thickness": 0.5,
    ...         "faces": [{"shape": "plane"}, {"shape": "bspline", "control_points": [64, 64]}],
    ...     }],
    ...     "images": [{
    ...         "receiver": {
    ...             "kind": "plane", "position": [0, 0, 5], "half_width": [1, 1],
    ...             "pixels": [128, 128],
    ...         },
    ...         "target": {"builtin": "tophat"},
    ...     }],
    ... })
    >>> begin(scene).target.shape
    (128, 128)

    A target of one's own, any brightness, row 0 at +y:

    >>> import numpy as np
    >>> ring = np.hypot(*np.mgrid[-1:1:128j, -1:1:128j])
    >>> session = Session(scene, np.exp(-(((ring - 0.5) / 0.1) ** 2)))

    A lens to start from, heights (n_u, n_v) of the control points of its exit face:

    >>> plate = FaceArrays({"lens.back": np.full(scene.optic.net_shape, 0.5)})
    >>> session = Session(scene, session.target, start=plate)
    >>> session.heights["lens.back"].shape
    (64, 64)
    """
    return begin_in(scene, Path(folder))


def check(
    session: Session,
    rays: int = 4_000_000,
    seed: int = 1,
    heights: Mapping[str, Array] | None = None,
) -> Validation:
    """Trace the lens of a session by an independent tracer, by cells and with random rays.

    Parameters
    ----------
    session : Session
        A session with a lens.
    rays : int
        Rays to trace at least.
    seed : int
        The same seed gives the same rays.
    heights : mapping of str to ndarray, optional
        Control heights in place of those of the lens, as of `Inspection.as_measured`.

    Raises
    ------
    Refused
        If the session has no lens, it is no body, or there are too many rays.
    RunFailed
        If no light reaches the screen.

    Examples
    --------
    >>> from resources import path
    >>> run = DesignRun(load(path("examples", "tophat-none-zeros.json")), iterations=1)
    >>> for snapshot in run:
    ...     pass
    >>> found = check(run.session, rays=1_000_000)
    >>> low, high = found.verified.relative_l2_corrected_interval
    >>> low <= found.verified.relative_l2_corrected <= high
    True
    """
    lens = result_of(session).state.heights if heights is None else heights
    return validate(session.scene, session.target, lens, rays, seed, accuracy=ACCURACY)


def export(
    session: Session,
    *files: File,
    chord_error: float | None = None,
    mesh_unit: str = MILLIMETRES,
    options: Sequence[OptionGroup] = (),
) -> list[Written]:
    """Write the lens of a session and its light.

    Parameters
    ----------
    session : Session
        A session with a lens.
    *files : path
        Files to write; their endings select the formats.
    chord_error : float, optional
        How far a mesh may be from the exit face, scene units; 1e-4 of the larger half-width of
        the lens by default.
    mesh_unit : str
        Unit of lengths in STL, OBJ, PLY and 3MF files: "mm", "cm", "m", "inch", or "scene" for
        that of the scene. Most programs take them for millimetres.
    options : sequence
        Options of formats: `Cutting` of G-code, `Turning` of tables for diamond turning, `Drawing`
        of drawings and inspection points, `Tile` of meshes: a square of the face as a test piece.

    Returns
    -------
    list of Written
        What is in each file, and how far from the design.

    Raises
    ------
    Refused
        If the session has no lens, it is no body, the unit is unknown, an ending is unknown,
        or a file cannot be written. At the end, if a format cannot hold what is asked; the other
        files are written.

    Examples
    --------
    >>> from resources import path
    >>> run = DesignRun(load(path("examples", "tophat-none-zeros.json")), iterations=1)
    >>> for snapshot in run:
    ...     pass
    >>> written, = export(run.session, "lens.stl", chord_error=1e-3)
    >>> written.deviation.kind, written.deviation.size < 1e-3
    ('chord error', True)

    A ball cutter of 0.5 mm, in the scene's unit, as G-code:

    >>> cutting = Cutting(tool_radius=0.05, spindle_speed=12_000, feed=800)
    >>> written, = export(run.session, "lens.nc", options=[cutting])
    >>> written.format
    'G-code'
    """
    paths = [Path(file) for file in files]
    return list(write_files(session, paths, chord_error, options, mesh_unit))


def save(session: Session, path: File) -> None:
    """Write a session file.

    Raises
    ------
    Refused
        If it cannot be written; what was at ``path`` before is still there.

    Examples
    --------
    >>> from resources import path
    >>> save(load(path("examples", "tophat.json")), "tophat.freeform")
    >>> load("tophat.freeform").result is None
    True
    """
    write_session(session, Path(path))


def sensitivity(
    session: Session, figure: "Figure", paths: Iterable[str]
) -> Mapping[str, "Sensitivity"]:
    """Derivatives of a figure of the light of a lens by numbers of its scene.

    They are central differences of the image of beams, which has no noise; control heights stay,
    and move with their element. `workbench.custom` has gradients by backpropagation.

    Parameters
    ----------
    session : Session
        A session with a lens and one image.
    figure : callable
        A number of the irradiance (n_y, n_x) and of the account.
    paths : iterable of str
        Numbers of the scene, as in ``lens.thickness`` or ``source.position[2]``.

    Returns
    -------
    mapping of str to Sensitivity
        By path the derivative ``value``, and how far it may be ``off``.

    Raises
    ------
    Refused
        If the session has no lens or several images, or a path leads to no number.

    Examples
    --------
    >>> from resources import path
    >>> run = DesignRun(load(path("examples", "tophat-none-zeros.json")), iterations=1)
    >>> for snapshot in run:
    ...     pass
    >>> found = sensitivity(run.session, lambda image, account: account.efficiency,
    ...                     ["lens.material.index"])
    >>> found["lens.material.index"].value < 0  # a denser glass reflects more
    True
    """
    from workbench.analysis.derivatives import sensitivities  # loads torch

    return sensitivities(session.scene, result_of(session).state.heights, figure, paths)
