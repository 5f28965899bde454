"""All views of a window; importing this module takes seconds."""

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from ui.commands.table import COLOURS, FACES_BY, RAYS, RAYS_BY, VIEWS
from ui.views.derivative_view import DerivativeView
from ui.views.focus_view import FocusView
from ui.views.image_link import ImageLink
from ui.views.light_images import ErrorView, IrradianceView, TargetView
from ui.views.light_view import LightView
from ui.views.loss_view import HistorySlider, LossView
from ui.views.photo_view import PhotoView
from ui.views.plot_view import PlotView
from ui.views.scene_view import SceneView
from ui.views.section_view import SectionView
from ui.views.surface_view import SurfaceView
from ui.views.view import ComputingView, View

if TYPE_CHECKING:
    from ui.shown.shown_lens import FrameHistory, ShownLens


class Views(QObject):
    """Creates the views and connects them."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.link = link = ImageLink(self)
        self.scene, self.history_slider = SceneView(), HistorySlider()
        self.derivative, self.focus, self.loss = DerivativeView(), FocusView(link), LossView()
        self.photo = PhotoView(link)
        self.computing: dict[str, ComputingView] = {
            "derivative": self.derivative,
            "focus": self.focus,
            "photo": self.photo,
        }
        self.loss.add_below(self.history_slider)
        self.docked: dict[str, View] = {
            "irradiance": IrradianceView(link),
            "target": TargetView(link),
            "error": ErrorView(link),
            "derivative": self.derivative,
            "surface": SurfaceView(),
            "focus": self.focus,
            "photo": self.photo,
            "loss": self.loss,
            "section": SectionView(link),
            "light": LightView(link),
        }
        self.derivative.chosen.connect(self.scene.nets.mark)
        self.scene.picked.connect(self.derivative.choose)

    def follow(self, shown: "ShownLens", history: "FrameHistory") -> None:
        """Connect the views to the shown lens; slider and loss curve show the history."""
        for view in (self.scene, *self.docked.values()):
            shown.add(view)
        self.history_slider.frame_chosen.connect(shown.frame_changed)
        history.changed.connect(lambda: self.history_slider.show_frames(history.frames))
        history.changed.connect(lambda: self.loss.show_verified(history.checks))

    def plots(self) -> dict[str, PlotView]:
        """Views with axes, by dock name."""
        return {name: view for name, view in self.docked.items() if isinstance(view, PlotView)}

    def show_colours(self, name: str) -> None:
        """Show light in one of `workbench.pictures.axes.UNSIGNED`."""
        self.link.set_colours(name)
        self.scene.show_colours(name)

    def slots(self) -> dict[str, Callable[[], object]]:
        return {
            "fit_view": self.scene.fit,
            **{f"{view}_view": partial(self.scene.fit, view) for view in VIEWS},
        }

    def choices(self) -> dict[str, Callable[[], object]]:
        return {
            **{name: partial(self.scene.show_rays, rays) for name, rays in RAYS.items()},
            **{name: partial(self.scene.colour_rays, by) for name, by in RAYS_BY.items()},
            **{name: partial(self.scene.colour_faces, by) for name, by in FACES_BY.items()},
            **{name: partial(self.show_colours, colours) for name, colours in COLOURS.items()},
        }

    def toggles(self) -> dict[str, Callable[[bool], object]]:
        """Functions of checkable commands."""
        return {
            "exploded": self.scene.explode,
            "perspective": self.scene.see_in_perspective,
            "relief": self.scene.exaggerate_relief,
        }

    def close(self) -> None:
        self.scene.close_plotter()
        for view in self.computing.values():
            view.close_threads()
