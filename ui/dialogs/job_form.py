"""The questions of a job, as the rows of the window's forms ask them."""

from pathlib import Path

from PySide6.QtWidgets import QVBoxLayout

from ui.panels.edits import Edit, put
from ui.panels.entries import RowForm
from ui.panels.images import of_image
from ui.panels.rows import Make, Rows
from ui.widgets.controls import STRETCH, filled
from ui.widgets.labels import WrappedLabel, text_label
from ui.words import tr
from workbench.errors import Refused
from workbench.jobs import Job
from workbench.powers import rounded
from workbench.scene import LEVELS, Finish, ImageTarget
from workbench.scene.part import summary_of, title_of

# What is done to pictures can be chosen later, in the window.
_LATER = {*Finish.model_fields, *LEVELS, "tone", "turn", "crop"} - {"viewed_from"}


class JobForm(RowForm):
    """Form of a job."""

    def __init__(self, job: Job) -> None:
        self.job = job
        own: dict[str, Make] = dict.fromkeys(_LATER, lambda field, path: [])
        makers = Rows(lambda: self.job.scene(), own, place="images[0].")
        fields = [field for field in job.fields() if field.tip]
        super().__init__(
            (row for field in fields for row in makers.of_field(field, field.name)),
            lambda: self.job,
            self._answer,
        )
        heading = text_label(tr(title_of(type(job))), "title")
        about = WrappedLabel(tr(summary_of(type(job))))
        filled(QVBoxLayout(self), heading, about, self.in_form(self.rows), STRETCH)
        self.show_rows()

    def choose_image(self, path: Path) -> None:
        """Use a picture file as target, with an image size of its aspect."""
        self.edit(self._edit_for(path))

    def _edit_for(self, path: Path) -> Edit:
        before = getattr(self.job, "target", Finish())
        target = of_image(path, Finish(viewed_from=before.viewed_from))
        changes: dict[str, object] = {"target": target}
        size = getattr(self.job, "image_size", None)
        if size is not None:
            changes["image_size"] = self._in_aspect(size, target)
        return Edit("target.image", tr("picture"), changes)

    def _in_aspect(self, size: tuple[float, float], target: dict[str, object]) -> list[float]:
        """Return an image size with the aspect of a picture."""
        from workbench.targets import picture_aspect  # late: takes long to import

        try:
            aspect = picture_aspect(ImageTarget.model_validate(target))
        except Refused:  # reported when the picture is drawn
            return list(size)
        larger = max(size)
        shorter = rounded(larger * min(aspect, 1 / aspect), 3)
        return [larger, shorter] if aspect > 1 else [shorter, larger]

    def choose_light(self, path: Path) -> None:
        self.edit(Edit("file", tr("file of light"), {"file": str(path.absolute())}))

    def _answer(self, edits: list[Edit]) -> None:
        """Apply edits; a typed file name of a picture is chosen."""
        data = self.job.model_dump(mode="json", exclude_none=True)
        for edit in edits:
            typed = edit.changes.get("target.image")
            put(self._edit_for(Path(str(typed))) if typed else edit, data)
        self.job = self.job.with_answers(data)
