"""The questions of a job, as the rows of the window's forms ask them."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFormLayout, QFrame, QLabel, QScrollArea, QVBoxLayout, QWidget

from ui.panels.edits import Edit, Waiting, put, try_with_waiting
from ui.panels.fields import Row, TextRow
from ui.panels.images import image_rows, of_image
from ui.panels.rows import KindRow, Make, Rows
from ui.panels.scene import file_rows
from ui.widgets.labels import WrappedLabel
from ui.words import tr
from workbench.errors import Refused
from workbench.jobs import Job
from workbench.scene import Finish, ImageTarget
from workbench.scene.part import summary_of, title_of

# What is done to pictures can be chosen later, in the window.
_LATER = {*Finish.model_fields, "tone", "turn", "crop"} - {"viewed_from"}


class JobForm(QScrollArea):
    """Form of a job."""

    changed = Signal()
    image_asked = Signal()
    light_asked = Signal()

    def __init__(self, job: Job) -> None:
        super().__init__()
        self.job = job
        self._refused: dict[str, Waiting] = {}
        page = QWidget()
        column = QVBoxLayout(page)
        heading = QLabel(f"<b>{tr(title_of(type(job)))}</b>")
        about = WrappedLabel(tr(summary_of(type(job))))
        column.addWidget(heading)
        column.addWidget(about)
        form = QFormLayout()
        form.setVerticalSpacing(5)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.setLabelAlignment(Qt.AlignmentFlag.AlignLeft)
        column.addLayout(form)
        column.addStretch()
        self._form = form
        own: dict[str, Make] = dict.fromkeys(_LATER, lambda field, path: [])
        makers = Rows(
            lambda: self.job.scene(),
            own | {"image": image_rows, "file": file_rows},
            place="images[0].",
        )
        self.rows = [
            row for field in job.fields() if field.tip for row in makers.of_field(field, field.name)
        ]
        for row in self.rows:
            form.addRow(row.label, row)
            row.edited.connect(self._answer)
            row.reverted.connect(self._revert)
            if isinstance(row, KindRow | TextRow):
                asked = self.light_asked if row.path == "file" else self.image_asked
                row.asked.connect(lambda *_, asked=asked: asked.emit())
        self.setWidget(page)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.show_job()

    @property
    def refused(self) -> bool:
        return bool(self._refused)

    def commit(self) -> None:
        for row in self.rows:
            row.commit()

    def choose_image(self, path: Path) -> None:
        """Use a picture file as target, with an image size of its aspect."""
        before = getattr(self.job, "target", Finish())
        target = of_image(path, Finish(viewed_from=before.viewed_from))
        changes: dict[str, object] = {"target": target}
        size = getattr(self.job, "image_size", None)
        if size is not None:
            changes["image_size"] = self._in_aspect(size, target)
        self._edit(Edit("target.image", tr("picture"), changes))

    def _in_aspect(self, size: tuple[float, float], target: dict[str, object]) -> list[float]:
        """Return an image size with the aspect of a picture."""
        from workbench.targets import picture_aspect  # late: takes long to import

        try:
            aspect = picture_aspect(ImageTarget.model_validate(target))
        except Refused:  # whoever draws the picture says so
            return list(size)
        larger = max(size)
        shorter = float(f"{larger * min(aspect, 1 / aspect):.3g}")
        return [larger, shorter] if aspect > 1 else [shorter, larger]

    def choose_light(self, path: Path) -> None:
        self._edit(Edit("file", tr("file of light"), {"file": str(path.absolute())}))

    def _answer(self, edit: Edit) -> None:
        """Apply an edit of a row; a typed file name of a picture is chosen."""
        typed = edit.changes.get("target.image")
        if typed:
            self.choose_image(Path(str(typed)))
        else:
            self._edit(edit)

    def _edit(self, edit: Edit) -> None:
        refused = try_with_waiting(edit, self._refused, self._try)
        if refused is not None:
            self._refused[edit.path] = Waiting(edit, refused)
        self.show_job()
        self.changed.emit()

    def _try(self, edits: list[Edit]) -> Refused | None:
        data = self.job.model_dump(mode="json", exclude_none=True)
        try:
            for edit in edits:
                put(edit, data)
            self.job = self.job.with_answers(data)
        except Refused as refused:
            return refused
        return None

    def _revert(self, path: str) -> None:
        self._refused.pop(path, None)
        self.show_job()
        self.changed.emit()

    def show_job(self) -> None:
        """Show the job, and refused entries as typed."""
        present = [row for row in self.rows if row.present(self.job)]
        for row in self.rows:
            if row in present:
                row.show_scene(self.job, self._refused.keys())
            else:
                row.forget()
            self._form.setRowVisible(row, row in present)
            row.refuse("")
        for path, waiting in self._refused.items():
            concerned = partial(_first_concerned, present)
            refused_row = concerned(waiting.refused.path) or concerned(path)
            if refused_row is not None:
                refused_row.refuse(tr(waiting.refused.reason))


def _first_concerned(rows: list[Row], path: str) -> Row | None:
    return next((row for row in reversed(rows) if row.concerns(path)), None)
