"""Assembly of a session's report, with a fresh check of its lens."""

from collections.abc import Iterator, Mapping
from datetime import datetime
from functools import partial

from workbench import __version__
from workbench.analysis.cross_check import cross_check
from workbench.analysis.making.as_made import checking
from workbench.analysis.manufacture import Manufacture, manufacture, surface_maps
from workbench.analysis.metrics import relative_l2
from workbench.analysis.shop_limits import Limits
from workbench.analysis.tolerance_fields import Tolerances
from workbench.analysis.tolerances import Distribution, perturbed
from workbench.analysis.validation_figures import Validation
from workbench.arrays import Array
from workbench.design.session import KeptRun, Session, result_of, verified_error
from workbench.design.task import origin
from workbench.errors import visible
from workbench.extended.bound import Bound
from workbench.geometry.surface import even_counts, freeform_nets
from workbench.measured.lamps import light_unit
from workbench.pictures import report as pictures
from workbench.pictures.axes import Extent
from workbench.pictures.part.drawing import PartDrawing
from workbench.pictures.train_section import draw_train_section
from workbench.powers import written
from workbench.progress import finished
from workbench.report.content import Fact, PagePicture, Report, Section
from workbench.report.element_table import element_table
from workbench.report.figures import (
    account_rows,
    area_table,
    bound_rows,
    check_rows,
    made_rows,
    manufacture_rows,
    percent,
    result_table,
    tolerance_rows,
    tracer_rows,
)
from workbench.report.scene_rows import scene_rows
from workbench.scene import Element, Scene
from workbench.scene.image import side_in_words, viewed_from
from workbench.units import sized

_SAMPLES = 257  # samples of maps along the longer side of the lens
# Inches: height of a row of two panels without the panels, width of a panel, tallest row.
_BESIDE, _PANEL, _ROW = 0.75, 2.4, 3.1
# Inches: title over a picture beside another one, its width, and height of both pictures at most.
_TITLE, _HALF, _SEEN, _SEEN_OF_SEVERAL = 0.3, 3.7, 4.6, 2.7
_VIEW = 3.7  # inches, height of the 3D view


def gather(
    session: Session,
    name: str,
    dated: datetime,
    rays: int,
    tolerances: tuple[Tolerances, int] | None = None,
    with_mitsuba: bool = False,
) -> Report:
    """Check a lens and assemble its report.

    `session`: A session with a lens; `name`: name of the session; `dated`: date of the session, not
    of today: two reports of one session must be equal; `rays`: least number of rays of the
    independent check; `tolerances`: tolerances and number of perturbed lenses, each traced with a
    quarter of the rays; `with_mitsuba`: whether Mitsuba 3 traces the lens too; see `cross_check`.
    Raises `Refused` if the session has no lens, a tolerance is not possible, or Mitsuba cannot
    trace the scene or is not installed; `RunFailed` if no light reaches the receiver.
    """
    scene, target, result = session.scene, session.target, result_of(session)
    if tolerances is not None:
        tolerances[0].check(scene)
    heights = result.state.heights
    found = finished(checking(scene, target, heights, rays))
    made = [
        (optic, manufacture(optic, heights), Limits.asked(scene, optic)) for optic in scene.optics
    ]
    seen = [session.of_image(number) for number in range(len(found.images))]
    whiches = [f", image {n + 1}" if found.further else "" for n in range(len(found.images))]
    images = list(zip(seen, found.images, whiches, strict=True))
    sections = [
        Section(
            f"Light {scene.receiver.place}",
            pictures=tuple(_seen_picture(*image) for image in images),
            note=f"Both images are {side_in_words(scene, viewed_from(scene))}, at the same flux. "
            f"Size of the {scene.receiver.called}: {_size_in_words(scene)}.",
        ),
        Section(
            "Result",
            table=result_table(scene, found, made),
            note="By the independent check: other code traces the finished lens.",
        ),
        *(_drawing(scene, optic, heights) for optic in scene.optics),
        Section(
            "Elements",
            table=element_table(scene),
            pictures=(*_train_section(session), _arrangement(session, found)),
            note="In the order in which light meets them; positions are those of front vertices. "
            "Long distances are drawn short in the view.",
        ),
        *(section for image in images for section in _image_sections(*image)),
        *([_mitsuba_section(session, rays)] if with_mitsuba else []),
        *(_manufacture(session, *each) for each in made),
    ]
    if tolerances is not None:
        sections.append(_tolerances(session, *tolerances, max(rays // 4, 1)))
    sections.append(
        Section(
            "Design run",
            (
                Fact(scene.optic.called, origin(session)),
                Fact("loss of the optimiser", written(result.state.loss)),
                Fact("iterations", str(result.iterations)),
                Fact("seconds", f"{result.seconds:.1f}"),
                *(_run_fact(run, scene) for run in session.runs),
            ),
            (PagePicture("Loss", partial(pictures.draw_loss, result=result), 2.6),),
        )
    )
    sections += [Section(group, rows) for group, rows in scene_rows(scene).items()]
    dated = dated.astimezone()
    subtitle = f"Design of {dated:%Y-%m-%d %H:%M %Z} · Freeform Lens Workbench {__version__}"
    return Report(visible(name), subtitle, dated, tuple(sections))


def _seen_picture(session: Session, found: Validation, which: str) -> PagePicture:
    x, y = session.scene.receiver.half_extent
    draw = partial(pictures.draw_seen, session=session, irradiance=_clearest(found), which=which)
    most = _SEEN_OF_SEVERAL if which else _SEEN
    return PagePicture(f"Light and target{which}", draw, min(_TITLE + _HALF * y / x, most))


def _size_in_words(scene: Scene) -> str:
    extent = Extent.of_receiver(scene)
    left, right, bottom, top = extent.bounds
    return sized(f"{right - left:g} × {top - bottom:g}", extent.unit)


def _clearest(found: Validation) -> Array:
    """The image without ray noise, where there is one."""
    return (found.by_cells or found).irradiance


def _drawing(scene: Scene, optic: Element, heights: Mapping[str, Array]) -> Section:
    drawing = PartDrawing(optic, heights, scene.unit, pictures.WIDTH)
    return Section(
        "Drawing" if len(scene.optics) == 1 else f"Drawing of {optic.name}",
        pictures=(PagePicture("Front view and sections", drawing.draw, drawing.height),),
        note=f"Dimensions in {drawing.unit}, scale {drawing.scale_in_words} on A4, first-angle "
        "projection; the front view is seen from +z. The freeform faces are those of the exported "
        "file.",
    )


def _train_section(session: Session) -> Iterator[PagePicture]:
    if session.scene.is_train:
        yield PagePicture("Section", partial(draw_train_section, session=session), 3.0)


def _arrangement(session: Session, found: Validation) -> PagePicture:
    called = session.scene.optic.called.capitalize()
    lights = [image.irradiance for image in found.images]
    draw = partial(pictures.draw_lens, session=session, lights=lights)
    return PagePicture(f"{called}, rays and {session.scene.receiver.called}", draw, _VIEW)


def _image_sections(session: Session, found: Validation, which: str) -> Iterator[Section]:
    scene, light = session.scene, _clearest(found)
    own = result_of(session).state.irradiance
    difference, remark = relative_l2(found.irradiance, own), found.beside_run(own, scene.receiver)
    density = scene.receiver.density
    yield Section(
        f"{density.capitalize()}{which}",
        table=area_table(found),
        pictures=(
            PagePicture(
                f"{density.capitalize()} and difference to the target",
                partial(pictures.draw_images, session=session, irradiance=light),
                _row(scene.receiver.half_extent),
            ),
            PagePicture(
                f"Cross-sections through the middle of the {scene.receiver.called}",
                partial(pictures.draw_sections, session=session, irradiance=light),
                2.6,
            ),
        ),
        note=f"{density.capitalize()} and target are compared at the same flux: red is too much "
        "light, blue too little.",
    )
    yield Section(
        f"Independent check{which}",
        (*check_rows(found, difference, remark), *bound_rows(Bound(scene, session.target))),
        note="Traced anew by other means than the optimiser's, against the untouched target: "
        "by cells without random rays, and with fresh random rays. Relative L2 error = "
        "‖I − T‖ / ‖T‖, both divided by their sum.",
    )
    if found.steps:
        yield Section(
            "Error as made",
            made_rows(found),
            note="Relative L2 error of the lens as designed, and after each process of its "
            "manufacture and those before it, with 95 % intervals; the last one is the error of "
            "the finished part.",
        )
    yield Section(
        f"Light account{which}",
        account_rows((found.by_cells or found).account, scene, light_unit(scene)),
        note="Parts of the emitted light.",
    )


def _mitsuba_section(session: Session, rays: int) -> Section:
    scene = session.scene
    found = cross_check(scene, session.target, result_of(session).state.heights, rays)
    draw = partial(
        pictures.draw_two_tracers,
        session=session,
        ours=found.ours.irradiance,
        mitsuba=found.mitsuba.irradiance,
    )
    return Section(
        "Beside Mitsuba 3",
        tracer_rows(found),
        (PagePicture("Images of both tracers", draw, 2 * _row(scene.receiver.half_extent)),),
        note="Mitsuba 3, a renderer that knows nothing of this program, traces the lens as a mesh "
        "with the normals of its faces. The images are compared, each divided by its sum.",
    )


def _row(*half_widths: tuple[float, float]) -> float:
    return min(_BESIDE + _PANEL * max(y / x for x, y in half_widths), _ROW)


def _manufacture(session: Session, optic: Element, found: Manufacture, limits: Limits) -> Section:
    scene, heights = session.scene, result_of(session).state.heights
    count = even_counts(optic.half_width, _SAMPLES)
    over_base = partial(pictures.draw_faces, session=session, element=optic)
    drawn = [PagePicture("Freeform faces over their base", over_base, _row(optic.half_width))]
    for face in reversed(freeform_nets(optic)):
        maps = surface_maps(optic, heights, count, face)
        draw = partial(pictures.draw_manufacture, maps=maps, limits=limits, unit=scene.unit)
        name = f"Thickness, slope and curvature of the {scene.face_in_words(face)}"
        drawn.append(PagePicture(name, draw, 2 * _row(optic.half_width)))
    return Section(
        "Manufacture" if len(scene.optics) == 1 else f"Manufacture of {optic.name}",
        manufacture_rows(found, limits, scene.unit),
        tuple(drawn),
        note=f"Found at a place (x, y) in {scene.unit}, and a bound that holds everywhere. Limits "
        "are those of the scene; what is beyond them is hatched.",
    )


def _tolerances(session: Session, within: Tolerances, samples: int, rays: int) -> Section:
    heights = result_of(session).state.heights
    nominal, *others = perturbed(session.scene, session.target, heights, within, samples, rays)
    spread = Distribution.of(nominal, others)
    errors = [each.relative_l2 for each in others]
    draw = partial(pictures.draw_tolerances, nominal=nominal.relative_l2, errors=errors)
    return Section(
        "Tolerances",
        tolerance_rows(session.scene, within, spread, samples),
        (PagePicture("Which part of the lenses stays below an error", draw, 2.8),),
        note="Lenses that are off at random, evenly within these, traced one by one; relative L2 "
        "error without ray noise.",
    )


def _run_fact(run: KeptRun, scene: Scene) -> Fact:
    result, state, checked = run.result, run.result.state, run.verified
    error = f", error {verified_error(checked)}" if checked else ""
    return Fact(
        run.name,
        f"loss {written(state.loss)} after {result.iterations} iterations in "
        f"{result.seconds:.1f} s, {percent(state.account.efficiency, 1)} {scene.receiver.place}"
        f"{error}",
    )
