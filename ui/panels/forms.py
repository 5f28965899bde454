"""All forms: they turn edits into scenes, and show each refusal where it was caused."""

from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeySequence, QShortcut

from ui.document.document import Document
from ui.panels.area import FormArea
from ui.panels.edits import Edit, edited_scene, has_place
from ui.panels.elements import ElementsPanel
from ui.panels.entries import Entries, Waiting, row_of
from ui.panels.images import ImagesPanel, RegionsPanel, TargetPanel, of_image
from ui.panels.panel import Panel, PartPanel
from ui.panels.scene import (
    ProcessesPanel,
    ScenePanel,
    StagesPanel,
    of_light_file,
    parametrisation_rows,
)
from ui.words import error_text, tr
from workbench.errors import Refused
from workbench.files.session import Session
from workbench.scene import Image, ImageTarget, Scene
from workbench.scene.paths import value_at


class Forms(FormArea):
    """All panels of a scene."""

    message = Signal(str)
    file_refused = Signal(str)
    file_asked = Signal(str)  # for the part at a path
    postponed = Signal(str)
    refusals_changed = Signal()

    def __init__(self, document: Document) -> None:
        super().__init__(self._make_panels())
        self._document = document
        self._entries = Entries(self._make)
        self._pending = self._entries.waiting
        self.refusals: tuple[str, ...] = ()  # fields whose edits wait to be corrected, and why
        self._editing = False
        self._run_hint = ""
        self._later: list[Edit] = []  # made during a run
        self._next: Session | None = None  # with these
        for panel in self.panels:
            panel.edited.connect(self.edit)
            panel.reverted.connect(self._revert)
            panel.asked.connect(self._ask_file)
        self._target.refused.connect(self.file_refused)
        document.session_changed.connect(self._show_change)
        # A field takes Esc for its own text; this is for what was refused in any of them.
        self._escape = QShortcut(QKeySequence(Qt.Key.Key_Escape), self)
        self._escape.setContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        self._escape.activated.connect(self.revert_all)
        self._escape.setEnabled(False)
        self._show()

    def _make_panels(self) -> list[Panel]:
        parts = {field.name: field for field in Scene.fields() if field.parts}
        of_image = {field.name: field for field in Image.fields()}
        self._target = TargetPanel(of_image["target"])
        images, regions = ImagesPanel(parts["images"]), RegionsPanel(parts["regions"])
        processes = ProcessesPanel(parts["processes"])
        for panel in (images, regions, processes):
            panel.unfold(False)
        return [
            ScenePanel(),
            self._target,
            PartPanel(of_image["receiver"], "images[0].receiver"),
            PartPanel(parts["source"]),
            ElementsPanel(parts["elements"]),
            PartPanel(parts["run"], own={"parametrisation": parametrisation_rows}),
            PartPanel(parts["filter"]),
            images,
            regions,
            processes,
            PartPanel(parts["uncertainty"]),
            StagesPanel(),
        ]

    @property
    def refused(self) -> bool:
        return bool(self._pending)

    @property
    def refused_entry(self) -> str:
        """Undo text of the latest refused entry, if any."""
        if not self._pending:
            return ""
        waiting = list(self._pending.values())[-1]
        return tr("refused {edit}").format(edit=waiting.edit.text)

    @property
    def postponed_edits(self) -> int:
        return len(self._later)

    def commit(self) -> None:
        for row in self._rows():
            row.commit()

    def revert_latest(self) -> bool:
        """Revert text that is not entered, or else the latest refused entry; whether any."""
        row = next((row for row in self._rows() if row.unentered), None)
        paths = [p for p in self._pending if row.concerns(p)] if row else list(self._pending)[-1:]
        if row is None and not paths:
            return False
        row = row or row_of(paths[0], self._rows())
        for path in paths:
            del self._pending[path]
        self._show()
        if row is not None:
            self.reveal(row)
        return True

    def revert_all(self) -> bool:
        """Revert all typed or refused entries; whether there were any."""
        any_back = False
        while self.revert_latest():
            any_back = True
        return any_back

    def choose_image(self, file: Path, where: str = "") -> None:
        """Use an image file as a target, by default the first; the current one is reloaded."""
        where, scene = where or self._target.path, self._session.scene
        if where == self._target.path and scene.image == str(file.absolute()):
            self._read_image_again()
        else:
            changes: dict[str, object] = {where: of_image(file, value_at(scene, where))}
            text = tr("change of target image")
            self._use_file(Edit(f"{where}.image", text, changes, waits=False))

    def choose_light(self, file: Path) -> None:
        """Use a light file as the source."""
        changes: dict[str, object] = {"source": of_light_file(file, self._session.scene)}
        text = tr("change of file of light")
        self._use_file(Edit("source.file", text, changes, waits=False))

    def _use_file(self, edit: Edit) -> None:
        self.edit(edit)
        row = row_of(edit.path, self._rows())
        if row is not None:
            self.reveal(row)

    def switch_entrance(self) -> None:
        """Make the entrance face freeform, or flat again."""
        scene = self._session.scene
        two_faces = scene.optic.entrance.shape == "bspline"
        shape = "plane" if two_faces else "bspline"
        path = f"{scene.optic_path}.faces[0]"
        changes: dict[str, object] = {path: {"shape": shape}}
        text = tr("flat entrance face") if two_faces else tr("freeform entrance face")
        self.edit(Edit(f"{path}.shape", text, changes, alone=True))

    def adopt_aspect(self) -> None:
        """Set receiver and pixels to the aspect of the target's picture."""
        from workbench.targets import picture_aspect  # late: takes long to import

        session = self._session
        scene = session.scene
        receiver, target = scene.receiver, scene.target
        if not isinstance(target, ImageTarget):
            self.file_refused.emit(tr("The target is not a picture and has no aspect."))
            return
        try:
            aspect = picture_aspect(target, session.picture)
        except Refused as refused:
            self.file_refused.emit(
                tr("The picture cannot be read: {refused}").format(refused=error_text(refused))
            )
            return
        (half, _), (pixels, _) = receiver.half_extent, receiver.pixels
        path = "images[0].receiver"
        changes: dict[str, object] = {
            f"{path}.{receiver.extent}": [half, half / aspect],
            f"{path}.pixels": [pixels, max(round(pixels / aspect), 1)],
        }
        text = tr("aspect of the picture for the {receiver}", receiver=receiver.called)
        self.edit(Edit(f"{path}.{receiver.extent}", text, changes, alone=True))

    def _ask_file(self, path: str) -> None:
        self.file_asked.emit(path.rpartition(".")[0])

    def show_run(self, paused: bool = False) -> None:
        """Say that edits wait while a run is active."""
        self._run_hint = (
            tr("The design is paused. Changes wait until it ends.")
            if paused
            else tr("The design is running. Changes wait until it ends.")
        )
        self._show_hint()

    def make_postponed_edits(self) -> None:
        """Apply the postponed edits, each as its own step."""
        edits = self._later
        self.drop_postponed_edits()
        for edit in edits:
            self.edit(edit)

    def drop_postponed_edits(self) -> None:
        self._later, self._next = [], None
        self._show()

    def edit(self, edit: Edit) -> None:
        """Try an edit together with those that wait; keep it waiting if it is refused."""
        if edit.drag and self._document.in_run:
            return
        refused = self._entries.make(edit)
        if refused is not None and not (edit.waits or edit.drag):
            self.file_refused.emit(
                tr("The {edit} is refused: {refused}").format(
                    edit=edit.text, refused=error_text(refused)
                )
            )
        self._show()
        if refused is not None and edit.path in self._pending:
            self.message.emit(tr("Refused: {refused}").format(refused=self.refusals[-1]))

    def _make(self, edits: list[Edit]) -> None:
        self._editing = True
        try:
            scene = edited_scene(self._session.scene, edits)
            last = edits[-1]
            if self._document.in_run:
                self._postpone(edits, scene)
                return
            key = last.drag or ("" if last.alone else last.field)
            before = self._document.before(key).scene
            if last.drag and scene == before.with_net(None):  # taken back
                if before is not self._session.scene:
                    self._document.undo_stack.undo()
            else:
                self._document.edit(scene, last.step(before, scene), key)
        finally:
            self._editing = False

    def _read_image_again(self) -> None:
        if self._document.in_run:
            self.file_refused.emit(tr("Stop the run first, then reload the image."))
            return
        try:
            self._document.read_image_again()
        except Refused as refused:
            path = f"{self._target.path}.image"
            self._pending[path] = Waiting(Edit(path, tr("reload of the image"), {}), refused)
            self.message.emit(tr("Refused: {refused}").format(refused=error_text(refused)))
            self._show()

    def _postpone(self, edits: list[Edit], scene: Scene) -> None:
        if scene != self._session.scene:
            self._next = self._document.after_edit(scene)
            self._later += edits
            self.postponed.emit(self.postponed_text)

    @property
    def _session(self) -> Session:
        return self._document.session if self._next is None else self._next

    @property
    def postponed_text(self) -> str:
        texts = dict.fromkeys(edit.text for edit in self._later)
        return tr("Waiting for the end of the run: {edits}.").format(edits=", ".join(texts))

    def _revert(self, path: str) -> None:
        self._pending.pop(path, None)
        self._show()

    def _show_change(self) -> None:
        """Show a session from elsewhere (undo, a file), for which no refused edit waits."""
        if not self._editing:
            if self._document.session.scene != self._shown:
                self._pending.clear()
            self._show()

    def _show(self) -> None:
        session = self._session
        self._shown = self._document.session.scene
        self._show_hint()
        for panel in self.panels:
            panel.prepare(session)
        present = [row for row in self._rows() if row.present(session.scene)]
        for path, waiting in list(self._pending.items()):
            if not (has_place(session.scene, waiting.edit) and row_of(path, present)):
                del self._pending[path]
        reasons = self._entries.show(session.scene, self._rows(), present)
        self.show_rows(present, reasons.keys())
        edited = [row for path in self._pending if (row := row_of(path, present)) is not None]
        refusals = [f"{row.name}: {reasons[row]}" for row in edited]
        if tuple(refusals) != self.refusals:
            self.refusals = tuple(refusals)
            self._escape.setEnabled(bool(refusals))
            self.refusals_changed.emit()

    def _show_hint(self) -> None:
        self._hint.setText(self.postponed_text if self._later else self._run_hint)
        self._hint.setVisible(self._document.in_run)
