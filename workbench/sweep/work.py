"""What is done at each point, in a process of its own or on another machine."""

from typing import Any, NamedTuple

from workbench.arrays import Array
from workbench.defects import unexpected
from workbench.design.design_run import DesignRun
from workbench.design.session import Session, result_of
from workbench.design.snapshot import Result
from workbench.errors import Refused, RunFailed
from workbench.scene import Scene


class DesignTask(NamedTuple):
    """A design task.

    Attributes
    ----------
    scene : Scene
        The scene.
    target : ndarray, shape (n_y, n_x)
        The wanted image.
    rays : int
        Rays of the independent check, at least.
    """

    scene: Scene
    target: Array
    rays: int


class Done(NamedTuple):
    """A lens, and the figures of its independent check (`Validation.to_data`)."""

    result: Result
    check: dict[str, Any]


class Failed(NamedTuple):
    """Why there is no lens, in one sentence."""

    reason: str


def attempt(task: DesignTask, threads: int | None = None) -> Done | Failed:
    """Design a lens and check it; whatever goes wrong is in the result.

    Parameters
    ----------
    task : DesignTask
        The design task.
    threads : int, optional
        How many work on it; as many as there are cores by default.
    """
    try:
        return _design(task, threads)
    except (Refused, RunFailed) as failure:
        return Failed(str(failure))
    except Exception as error:  # one point must not end all
        return Failed(unexpected(error))


def _design(task: DesignTask, threads: int | None) -> Done:
    import torch  # late: takes seconds, which the process that waits for results can do without

    from workbench.analysis.validation import validate
    from workbench.design.kernels import compile_all

    if threads is not None:
        torch.set_num_threads(threads)
    compile_all()  # which is no part of any run's time
    run = DesignRun(Session(task.scene, task.target))
    for _ in run:
        pass
    result = result_of(run.session)
    check = validate(
        task.scene, task.target, result.state.heights, task.rays, threads=threads
    ).to_data()
    return Done(result, check)
