"""What a kept run came to, in words and as a small picture."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QPixmap

from ui.run.status import clock
from ui.widgets.colours import rgb_image
from ui.words import tr
from workbench.design.loss import relative_error
from workbench.design.session import KeptRun
from workbench.extended.bound import percent
from workbench.pictures.images import full_scale, to_colours
from workbench.powers import written


def figures_of(run: KeptRun, verified: str) -> list[tuple[str, str]]:
    """Figures by their English names; ``verified`` is what checks said, empty for nothing."""
    result, (n_u, n_v) = run.result, run.scene.optic.net_shape
    return [
        ("Target", tr(run.scene.target.called)),
        ("Error", percent(relative_error(result.state, run.target))),
        ("Verified", verified or "–"),
        ("On screen", f"{100 * result.state.account.efficiency:.1f} %"),
        ("Time", clock(result.seconds)),
        ("Iterations", f"{result.iterations}"),
        ("Net", f"{n_u} × {n_v}"),
        ("Method", run.scene.run.method),
        ("Loss", written(result.state.loss)),
        ("Ended", tr(result.ended) or "–"),
    ]


def thumbnail_of(run: KeptRun, side: int) -> QPixmap:
    """The light of a run, so many pixels wide or high."""
    receiver, light = run.scene.receiver, run.result.state.irradiance
    top = full_scale(run.scene, run.target, receiver.total(light))
    step = max(1, max(light.shape) // (2 * side))
    image = rgb_image(to_colours(light[::step, ::step], top))
    (r_x, r_y) = receiver.half_extent
    width, height = (round(side * r / max(r_x, r_y)) or 1 for r in (r_x, r_y))
    stretched, smooth = (
        Qt.AspectRatioMode.IgnoreAspectRatio,
        Qt.TransformationMode.SmoothTransformation,
    )
    return QPixmap.fromImage(image.scaled(width, height, stretched, smooth))
