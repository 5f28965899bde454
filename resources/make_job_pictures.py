"""Designs each job and pictures its result for the start page: ``resources/jobs/*.jpg``.

Needs a screen, real or virtual: ``xvfb-run -a -s '-screen 0 1600x1000x24' python -m
resources.make_job_pictures``; some minutes. A class name, such as ``Torch``, does one job alone.
"""

import sys
from pathlib import Path

from PySide6.QtCore import QEventLoop, QSize, Qt

import resources
from resources.make_screenshot import begin, open_window, settle
from ui.widgets import theme
from ui.widgets.native import rgb_image
from workbench.design.task import begin as session_of
from workbench.jobs import JOBS, Job
from workbench.jobs.job import LensJob

_WINDOW = QSize(1000, 780)  # whose 3D scene is about as large as a picture
_PICTURE = QSize(480, 300)


def make(kind: type[Job]) -> None:
    """Design a job with the answers it proposes, and write its picture."""
    window = open_window("tophat", _WINDOW)
    job = kind()
    if (
        isinstance(job, LensJob) and "target" in kind.model_fields
    ):  # the picture shows the screen from behind
        target = job.target.model_copy(update={"viewed_from": "back"})
        job = job.with_answers({"target": target.model_dump(mode="json", exclude_none=True)})
    window.document.begin(session_of(job.scene(), Path.cwd()), kind.__name__)
    window.commands["workspace_make"].trigger()
    assert window.loaded is not None
    settle()
    done = QEventLoop()
    window.loaded.control.ended.connect(done.quit, Qt.ConnectionType.SingleShotConnection)
    window.start()
    done.exec()
    settle()
    pixels = window.loaded.views.scene.picture(2)
    assert pixels is not None
    picture = rgb_image(pixels).scaled(
        _PICTURE,
        Qt.AspectRatioMode.KeepAspectRatioByExpanding,
        Qt.TransformationMode.SmoothTransformation,
    )
    place = picture.rect()
    place.setSize(_PICTURE)
    place.moveCenter(picture.rect().center())
    picture.copy(place).save(str(resources.path("jobs", f"{kind.__name__}.jpg")), quality=90)
    window.discard_and_close()


if __name__ == "__main__":
    theme.choose(begin(), "dark")
    for each in JOBS:
        if each.__name__ in sys.argv[1:] or not sys.argv[1:]:
            make(each)
