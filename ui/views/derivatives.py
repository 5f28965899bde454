"""Derivative maps as views ask for them, in a thread beside the window."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QThread

if TYPE_CHECKING:
    from threading import Event

    from workbench.analysis.derivatives import DerivativeMap
    from workbench.scene import Scene


@dataclass(frozen=True, eq=False)
class Question:
    """Whose derivative is asked for.

    Attributes
    ----------
    scene : Scene
        What is traced.
    control_points : ndarray, shape (n_u, n_v)
        Heights of the lens.
    index : tuple[int, int]
        The control point.
    """

    scene: "Scene"
    control_points: npt.NDArray[np.float64]
    index: tuple[int, int]


def derivative(question: Question, left: "Event") -> "DerivativeMap":
    """The map of a question, in the thread of whom it is asked; see `Latest.ask`."""
    # Late: torch comes with it, and the window shows before that.
    import torch

    from workbench.analysis.derivatives import irradiance_derivative

    # For this thread alone; a core stays the window's.
    torch.set_num_threads(max(1, QThread.idealThreadCount() - 1))
    return irradiance_derivative(question.scene, question.control_points, question.index)
