"""Runner, views and all that needs the slow libraries; importing this takes seconds."""

from functools import partial

from PySide6.QtCore import QObject, QPoint, QSettings, QTimer, Signal
from PySide6.QtGui import QAction

from ui.commands.actions import keep_colours
from ui.dialogs.preferences import CHECK
from ui.document.frame import Frame
from ui.document.shown_lens import ShownLens
from ui.files.plots import Plots, ScenePictures, Videos
from ui.lens.tools import LensTools
from ui.manufacture.pane import ManufacturePane
from ui.manufacture.tolerance_pane import TolerancePane
from ui.panels.edits import Edit
from ui.run.cards import Findings, ResultCards
from ui.run.check_figures import CheckFigures
from ui.run.checks import BoundOfDesign, Check
from ui.run.control import RunControl
from ui.run.follow import Follow
from ui.run.log import RunLog
from ui.run.runs import Runs
from ui.views.view import View
from ui.views.views import Views
from ui.window.docks import EarlyParts
from ui.window.edit_notices import PostponedEdits
from ui.words import tr
from workbench.scene.image import Region

FOLLOW = "run/follow"
"""Setting of live update, which is on by default."""


class LoadedParts(QObject):
    """Makes runner and views, and connects them with the window's early parts."""

    state_changed = Signal()

    def __init__(self, early: EarlyParts, settings: QSettings, parent: QObject) -> None:
        super().__init__(parent)
        self._early = early
        document, there, messages = early.document, early.panes, early.messages
        self.control = RunControl(document, self)
        self.shown = shown = ShownLens(document, self)
        names = "plan", "cut", "export", "report", "photograph", "inspect", "faces_by_limits"
        making = [early.commands[name] for name in names]
        self.manufacture, self.tolerances = ManufacturePane(settings, making), TolerancePane()
        panes: dict[str, View] = {"manufacture": self.manufacture, "tolerances": self.tolerances}
        self.views = views = Views(self, panes)
        self.check = Check(self)
        self.bound = BoundOfDesign(document, self)
        self.figures = CheckFigures(settings, early.commands["check"])
        self.runs = Runs(document, self.control, self)
        self.runs.check.wanted = lambda: CHECK.kept(settings) == "check"
        self.follow = Follow(document, self.control, self)
        plots = views.plots | {
            "manufacture": self.manufacture.map,
            "tolerances": self.tolerances.plot,
        }
        self.plots = Plots(plots, early.dialogs)
        self.tools = LensTools(document, self.control, views.scene, self)
        self.postponed = PostponedEdits(early.forms, self.control, messages, self)
        self._pictures = ScenePictures(views.scene, early.dialogs)
        self.videos = Videos(self.control.history, views.shared, early.dialogs)
        RunLog(document, self.control, early.log.add)
        self.findings = Findings(self.control, self.runs.error_of)
        self.cards = ResultCards(self.findings, early.commands)
        made = {"scene": views.scene, "check": self.figures, "runs": self.runs.table}
        there.put_views({**views.around, **made, "result": self.cards})
        for name in panes.keys() & views.computing.keys():
            there.docks[name].visibilityChanged.connect(views.computing[name].uncover)
        views.shared.drawn.connect(lambda _: there.show("section"))
        views.shared.image_pinned.connect(there.images.follow_pin)
        views.shared.regions_drawn.connect(self._edit_regions)
        views.shared.changed.connect(self._follow_marking)
        views.follow(document, shown, self.control.history)
        views.scene.escaped.connect(early.commands["turn"].trigger)
        views.scene.menu_asked.connect(self._show_scene_menu)
        menu = early.commands.scene_menu
        self._edit_part = QAction(menu)
        self._edit_part.triggered.connect(lambda: self._show_part(self._edit_part.data()))
        menu.insertAction(menu.insertSeparator(menu.actions()[0]), self._edit_part)
        self._connect_run()
        self._connect_check()
        self._connect_cards()
        self._connect_commands()
        keep_colours(settings, early.commands)
        self._connect_follow(settings)
        self.runs.refused.connect(messages.warn)
        self.tools.message.connect(messages.note)
        self.manufacture.figures.limits_changed.connect(views.shared.slot("limits"))
        self.tolerances.failed.connect(messages.warn)
        self.tolerances.save_asked.connect(partial(self.plots.choose_and_save_plot, "tolerances"))

    @property
    def state(self) -> str:
        return self.control.runner.state

    def allow(self, resting: bool, go_on: bool) -> None:
        self.views.allow(resting, go_on)

    def close(self) -> None:
        for part in (self.follow, self.control, self.views, self.tools):
            part.close()

    def _connect_run(self) -> None:
        control, early, shown = self.control, self._early, self.shown
        runner = control.runner
        runner.frame_ready.connect(shown.frame_changed)
        runner.unshown.connect(shown.emptied)
        runner.unshown.connect(shown.untraced)
        shown.frame_changed.connect(self.check.show_frame)
        shown.frame_changed.connect(self._show_frame)
        shown.emptied.connect(self.check.show_nothing)
        early.document.session_changed.connect(self.check.show_design)
        runner.failed.connect(early.messages.warn)
        runner.waiting.connect(early.show_waiting)
        runner.state_changed.connect(self.state_changed)
        self.runs.check.failed.connect(early.log.add)
        self.runs.compared.connect(self.views.loss.show_runs)
        self.views.loss.frame_chosen.connect(self._rewind)
        self.views.loss.continued.connect(
            lambda frame: early.begin(lambda: control.go_on_from(frame))
        )

    def _connect_check(self) -> None:
        check, figures, early = self.check, self.figures, self._early
        check.use_rays(figures.rays)
        figures.rays_chosen.connect(check.use_rays)
        check.under_way_changed.connect(figures.follow)
        check.checked.connect(figures.show_check)
        check.checked.connect(self.runs.note_check)
        self.runs.check.ended.connect(check.take)
        check.asked.connect(self.runs.check.background.cancel)  # it would find the same
        self.runs.check.background.changed.connect(
            lambda task: figures.await_figures(not task.ended)
        )
        check.under_way_changed.connect(self._reword_check)
        check.summary_ready.connect(early.log.add)
        check.failed.connect(early.messages.warn)
        self.bound.failed.connect(early.log.add)
        self.bound.follow(early.document.session)

    def _connect_cards(self) -> None:
        findings, cards, commands = self.findings, self.cards, self._early.commands
        self.shown.frame_changed.connect(findings.show_frame)
        self.shown.emptied.connect(findings.show_nothing)
        self.shown.outdated_changed.connect(cards.show_outdated)
        self.runs.checked.connect(findings.refresh)
        self.bound.found.connect(findings.use_bounds)
        self.bound.found.connect(lambda _, sentence: cards.setToolTip(sentence))
        findings.located.connect(self.views.scene.show_spots)
        findings.edit_asked.connect(self._edit)
        findings.command_asked.connect(lambda name: commands[name].trigger())
        findings.failed.connect(self._early.log.add)

    def _connect_follow(self, settings: QSettings) -> None:
        follow, early, command = self.follow, self._early, self._early.commands["follow"]
        follow.settled.connect(self.runs.show)
        follow.settled.connect(self.runs.check.check_result)
        follow.failed.connect(early.messages.warn)
        self.check.under_way_changed.connect(partial(follow.hold, "check"))
        self.tools.editing_began.connect(follow.rest)
        command.triggered.connect(lambda on: settings.setValue(FOLLOW, on))
        early.commands.connect_toggles({"follow": follow.switch})
        command.setChecked(bool(settings.value(FOLLOW, True, bool)))
        follow.switch(command.isChecked())

    def _connect_commands(self) -> None:
        commands, control, begin = self._early.commands, self.control, self._early.begin
        self.plots.offer([commands[name] for name in self.plots.slots()])
        commands.connect(
            {
                "start": lambda: begin(control.start),
                "continue": lambda: begin(control.go_on),
                "pause": control.toggle_pause,
                "stop": control.runner.stop,
                "check": self.check.toggle,
                "save_video": self.videos.choose_and_save,
                **self.views.slots(),
                **self.runs.slots(),
                **self.plots.slots(),
                **self.tools.slots(),
                **self._pictures.slots(),
            }
        )
        commands.connect_toggles(self.views.toggles())
        commands.connect_toggles({"mark_region": self._mark_regions})
        commands.connect_choices(self.views.choices())

    def _mark_regions(self, on: bool) -> None:
        shared = self.views.shared
        if on and not shared.now.marking:
            self._early.panes.show("irradiance")
            self.views.around["irradiance"].setFocus()
        shared.mark_regions(on)

    def _follow_marking(self) -> None:
        self._early.commands["mark_region"].setChecked(self.views.shared.now.marking)

    def _edit_regions(self, regions: tuple[Region, ...], text: str) -> None:
        if self.control.busy:
            self._early.messages.note(tr("Stop the run first, then mark regions."))
            return
        data = [region.model_dump(mode="json") for region in regions]
        edit = Edit("regions", text, {"regions": data}, alone=True, waits=False)
        self._early.forms.edit(edit)

    def _show_scene_menu(self, at: QPoint) -> None:
        seen = self.views.scene.part_at(at)
        self._edit_part.setVisible(seen is not None)
        if seen is not None:
            text = tr("Edit {part} in the form").format(part=tr(seen.called))
            self._edit_part.setText(text)
            self._edit_part.setData(seen.path)
        self._early.commands.scene_menu.popup(at)

    def _show_part(self, path: str) -> None:
        self._early.panes.show("design")
        # Once a dock that was hidden has its place.
        QTimer.singleShot(0, self, partial(self._early.forms.show_part, path))

    def _edit(self, text: str, changes: dict[str, object]) -> None:
        path = next(iter(changes))
        self._early.forms.edit(Edit(path, text, changes, alone=True, waits=False))

    def _rewind(self, frame: Frame) -> None:
        self.control.drop_preview()
        self.shown.frame_changed.emit(frame)
        if frame is self.control.history.frames[-1]:
            self.control.preview()  # which tells why the run ended

    def _show_frame(self, frame: Frame) -> None:
        self._early.status.show_frame(frame, self.control.busy)

    def _reword_check(self, under_way: bool) -> None:
        commands = self._early.commands
        commands["check"].setText(
            tr("Cancel &check") if under_way else commands.command("check").text
        )
