"""The stages of a run as a list, in their order."""

from ui.panels.part_list import PartListRow
from ui.words import inside, tr
from workbench.scene import Stage
from workbench.scene.kinds import title_of


class StageListRow(PartListRow[Stage]):
    """The stages one below the other, and what can be done with them."""

    def __init__(self) -> None:
        super().__init__(
            "run.stages",
            tr("In turn"),
            tr(
                "A run goes through these stages before the scene itself, each going on "
                "from the lens of the one before: from a point source to an extended "
                "one, say, or from a coarse net to a fine one."
            ),
            tr("stage"),
            tr("Stages of the run"),
            (
                tr("Add a stage behind the others"),
                tr("Add a copy of the chosen stage behind it"),
                tr("Remove the chosen stage"),
                tr("Run the chosen stage sooner"),
                tr("Run the chosen stage later"),
            ),
        )
        self._left = 0

    def show_stages(self, stages: tuple[Stage, ...], iterations: int) -> None:
        """Show the stages, and the iterations that they leave of all."""
        self._left = iterations - sum(stage.iterations for stage in stages)
        then = tr("Then the scene as it stands, {iterations}.").format(
            iterations=_iterations(self._left)
        )
        self.show_parts(stages, then if stages else tr("None: the scene is run as it stands."))

    def _new(self, which: int) -> Stage:
        """Half of what is left for the scene is a fair share; the scene refuses what is none."""
        return Stage(iterations=max(1, self._left // 2))

    def _summary(self, part: Stage) -> str:
        parts = [_iterations(part.iterations)]
        if part.method is not None:
            (method,) = (field for field in Stage.fields() if field.name == "method")
            parts.append(inside(tr(dict(method.choices)[part.method])))
        if part.control_points is not None:
            n_u, n_v = part.control_points
            parts.append(tr("net of {n_u} × {n_v}").format(n_u=n_u, n_v=n_v))
        if part.source is not None:
            parts.append(inside(tr(title_of(type(part.source)))))
        if part.filter is not None:
            kind = inside(tr(title_of(type(part.filter))))
            parts.append(tr("{kind} filter").format(kind=kind))
        return ", ".join(parts)


def _iterations(count: int) -> str:
    return tr("1 iteration") if count == 1 else tr("{count} iterations").format(count=count)
