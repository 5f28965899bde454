"""Plots, predicted photo and 3D picture: to the clipboard and to files."""

import csv
import io
import json
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import BinaryIO

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QCursor, QGuiApplication, QImage

from ui.background import Task
from ui.commands.panes import PANES
from ui.document.frame import iterations_before
from ui.document.shown_lens import FrameHistory
from ui.files.dialogs import FileDialogs, FileWriter, png_bytes
from ui.views.loss_strip import LossStrip
from ui.views.plot_view import PlotView
from ui.views.scene_view import SceneView
from ui.views.shared_view import SharedView
from ui.widgets.native import rgb_image
from ui.widgets.shelf import open_folder
from ui.words import error_text, in_sentence, later, tr
from workbench.errors import Refused
from workbench.files.atomic import replacing
from workbench.files.export.tables import write_table
from workbench.pictures.axes import Column
from workbench.progress import Interrupted

_PNG = ".png"
_TABLE, _DATA = ".csv", ".json"
_PICTURE = later("Picture in pixels (*.png)")
_FILTERS = later(
    {
        _PICTURE: _PNG,
        "Picture in lines (*.svg)": ".svg",
        "Numbers shown (*.csv)": _TABLE,
        "Figures (*.json)": _DATA,
    }
)
_VIDEOS = later(
    {
        "Animated picture (*.gif)": ".gif",
        "Animated picture in all colours (*.webp)": ".webp",
        "Animated PNG (*.apng)": ".apng",
    }
)
_WIDE = 1800  # pixels of a picture of the 3D scene, about


class _PictureFiles(FileWriter):
    def _write(self, path: Path, write: Callable[[BinaryIO], object], size: str = "") -> None:
        try:
            with replacing(path) as file:
                write(file)
        except Refused as refused:
            self._messages.warn(error_text(refused))
        else:
            folder = (tr("Open folder"), partial(open_folder, path))
            self._messages.done(_written(f"{path}{size}"), folder)

    def _write_later(self, path: Path, write: Callable[[Task], object]) -> None:
        """Write in the thread."""

        def work(task: Task) -> None:
            write(task)
            task.outcome, task.path = _written(path), path

        self.background.begin(work, title=tr("Export {name}").format(name=path.name))


def _written(path: object) -> str:
    return tr("{path} is written.").format(path=path)


class Plots(_PictureFiles):
    """Copies and saves the plot that was clicked, or reached by keyboard, last."""

    _WORK = later("plot")

    def __init__(self, plots: Mapping[str, PlotView | LossStrip], dialogs: FileDialogs) -> None:
        super().__init__(dialogs)
        self._plots = dict(plots)
        self._last = next(iter(plots))
        for name, plot in plots.items():
            plot.touched.connect(partial(self._touch, name))

    def slots(self) -> dict[str, Callable[[], object]]:
        return {"copy_plot": self.copy, "save_plot": self.choose_and_save}

    def offer(self, actions: Sequence[QAction]) -> None:
        for plot in self._plots.values():
            plot.offer(actions)

    def copy(self) -> None:
        name = self._current()
        if name is not None:
            with io.BytesIO() as file:
                self._plots[name].write(file, "png")
                QGuiApplication.clipboard().setImage(QImage.fromData(file.getvalue()))
            text = tr("A picture of the {pane} plot is on the clipboard.")
            self._messages.note(text.format(pane=_in_words(name)))

    def choose_and_save(self) -> None:
        name = self._current()
        if name is not None:
            self.choose_and_save_plot(name)

    def choose_and_save_plot(self, name: str) -> None:
        """Ask for a file and save a plot there, whichever was touched last."""
        title = tr("Save {pane} plot").format(pane=_in_words(name))
        known = self._plots[name].ENDINGS
        endings = {tr(text): ending for text, ending in _FILTERS.items() if ending in known}
        path = self._dialogs.to_save("plot", title, f"{self._document.name} {name}", endings)
        if path is not None:
            self.save(name, path)

    def save(self, name: str, path: Path) -> None:
        ending, plot = path.suffix.lower(), self._plots[name]
        if ending not in plot.ENDINGS:
            self._messages.warn(
                tr("{name}: a plot is saved as one of {known}").format(
                    name=path.name, known=", ".join(plot.ENDINGS)
                )
            )
        elif ending == _TABLE:
            self._write_table(plot.data(), path)
        elif ending == _DATA:
            self._write(
                path, lambda file: file.write(json.dumps(plot.figures(), indent=2).encode())
            )
        else:
            self._write(path, lambda file: plot.write(file, ending.removeprefix(".")))

    def _touch(self, name: str) -> None:
        self._last = name

    def _current(self) -> str | None:
        for name in (self._last, *self._plots):
            plot = self._plots[name]
            if plot.isVisible() and not plot.empty:
                plot.draw_now()  # what came in the meantime
                return name
        self._messages.note(tr("No plot is visible. The View menu shows the docks of plots."))
        return None

    def _write_table(self, columns: list[Column], path: Path) -> None:
        if self.background.busy:
            self._messages.note(tr("A plot is still being written. Save the next one after it."))
            return

        def write(_: Task) -> None:
            with io.StringIO() as line, replacing(path) as file:
                csv.writer(line, lineterminator="").writerow([column.name for column in columns])
                values = [column.values for column in columns]
                write_table(file, values, line.getvalue(), delimiter=",")

        self._write_later(path, write)  # takes seconds for a large image


def _in_words(name: str) -> str:
    return in_sentence(tr(PANES[name].title))


class Videos(_PictureFiles):
    """Saves the images of a run, one after the other, as a video."""

    _WORK = later("video")

    def __init__(self, history: FrameHistory, shared: SharedView, dialogs: FileDialogs) -> None:
        super().__init__(dialogs)
        self._history, self._shared = history, shared

    def choose_and_save(self) -> None:
        """Ask for a file, and write the recorded iterations of the shown image there."""
        frames = list(self._history.frames)
        if len(frames) < 2 or self.background.busy:
            self._messages.note(tr("A video needs a run of some iterations. Press Start."))
            return
        filters = {tr(text): ending for text, ending in _VIDEOS.items()}
        path = self._dialogs.to_save("plot", tr("Save video"), self._document.name, filters)
        if path is None:
            return
        now, caption = self._shared.now, tr("iteration {number}, error {error} %")
        number = self._shared.number_in(frames[-1].session.scene)

        def write(task: Task) -> None:
            from workbench.pictures.video import Video, check_video  # late: draws

            def in_words(iteration: int, error: float) -> str:
                return caption.format(number=iteration, error=f"{100 * error:.2f}")

            check_video(path)
            shown = [frame.of_image(number) for frame in frames]
            session = shown[-1].session
            video = Video(session.scene, session.target, in_words, now.colours)
            for done, frame in enumerate(shown):
                if task.stopped:
                    raise Interrupted
                video.add(frame.state.irradiance, iterations_before(frame))
                task.report(done / len(shown))
            with replacing(path) as file:
                video.write(file, path.suffix.lower())

        self._write_later(path, write)


class ScenePictures(_PictureFiles):
    """Copies and saves the picture of the 3D view."""

    def __init__(self, view: SceneView, dialogs: FileDialogs) -> None:
        super().__init__(dialogs)
        self._view = view

    def slots(self) -> dict[str, Callable[[], object]]:
        return {"copy_scene": self.copy, "save_scene": self.choose_and_save}

    def copy(self) -> None:
        image = self._image(1) if self._is_shown() else None
        if image is not None:
            QGuiApplication.clipboard().setImage(image)
            self._messages.done(tr("A picture of the 3D scene is on the clipboard."))

    def choose_and_save(self) -> None:
        """Ask for a file and save the picture there, magnified for print."""
        if not self._is_shown():
            return
        name, filters = f"{self._document.name} 3D", {tr(_PICTURE): _PNG}
        path = self._dialogs.to_save("plot", tr("Save picture of 3D"), name, filters)
        image = None if path is None else self._image(max(1, round(_WIDE / self._view.width())))
        if path is not None and image is not None:
            size = f" ({image.width()} × {image.height()})"
            self._write(path, lambda file: file.write(png_bytes(image)), size)

    def _is_shown(self) -> bool:
        if not self._view.isVisible():
            self._messages.note(tr("The 3D scene is hidden. View > 3D scene shows it."))
        return self._view.isVisible()

    def _image(self, times: int) -> QImage | None:
        QGuiApplication.setOverrideCursor(QCursor(Qt.CursorShape.WaitCursor))
        try:
            pixels = self._view.picture(times)
        finally:
            QGuiApplication.restoreOverrideCursor()
        return None if pixels is None else rgb_image(pixels)
