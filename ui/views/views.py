"""All views of a window; importing this module takes seconds."""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QObject

from ui.commands.table import CHOICES, VIEWS
from ui.document.document import Document
from ui.document.shown_lens import FrameHistory, ShownLens
from ui.views.derivative_view import DerivativeView
from ui.views.focus_view import FocusView
from ui.views.light_images import ErrorView, IrradianceView, PinnedView, TargetView
from ui.views.light_view import LightView
from ui.views.loss_strip import LossStrip
from ui.views.photo_view import PhotoView
from ui.views.plot_view import PlotView
from ui.views.scene_view import SceneView
from ui.views.section_view import SectionView
from ui.views.shared_view import SharedView
from ui.views.surface_view import SurfaceView
from ui.views.view import ComputingView, View


class Views(QObject):
    """The 3D view, and by the names of their panes the views around it, ``others`` among them."""

    def __init__(self, parent: QObject, others: Mapping[str, View]) -> None:
        super().__init__(parent)
        self.shared = shared = SharedView(self)
        self.scene, self.photo = SceneView(shared), PhotoView(shared)
        self.derivative, self.loss = DerivativeView(shared), LossStrip(shared)
        self.around: dict[str, View] = {
            "irradiance": IrradianceView(shared),
            "pinned": PinnedView(shared),
            "target": TargetView(shared),
            "error": ErrorView(shared),
            "derivative": self.derivative,
            "surface": SurfaceView(),
            "focus": FocusView(shared),
            "photo": self.photo,
            "loss": self.loss,
            "section": SectionView(shared),
            "light": LightView(shared),
            **others,
        }

    def follow(self, document: Document, shown: ShownLens, history: FrameHistory) -> None:
        for view in (self.scene, *self.around.values()):
            view.follow(document, shown)
        history.changed.connect(lambda: self.loss.show_frames(history.frames))
        history.changed.connect(lambda: self.loss.show_verified(history.checks))

    @property
    def plots(self) -> dict[str, PlotView | LossStrip]:
        views = self.around.items()
        return {name: view for name, view in views if isinstance(view, PlotView | LossStrip)}

    @property
    def computing(self) -> dict[str, ComputingView]:
        return {name: view for name, view in self.around.items() if isinstance(view, ComputingView)}

    def allow(self, resting: bool, go_on: bool) -> None:
        for view in self.around.values():
            view.allow(resting=resting)
        self.loss.allow(resting=resting, go_on=go_on)

    def slots(self) -> dict[str, Callable[[], object]]:
        return {
            "fit_view": self.scene.fit,
            **{f"{view}_view": partial(self.scene.fit, view) for view in VIEWS},
        }

    def choices(self) -> dict[str, Callable[[], object]]:
        return {
            command: partial(self.shared.show, **{option: value})
            for option, commands in CHOICES.items()
            for command, value in commands.items()
        }

    def toggles(self) -> dict[str, Callable[[bool], object]]:
        options = {"exploded": "exploded", "perspective": "perspective", "relief": "exaggerated"}
        return {name: self.shared.slot(option) for name, option in options.items()}

    def close(self) -> None:
        self.scene.close_plotter()
