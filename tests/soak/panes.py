"""What a person does with a lens once it is there: ``python -m tests.soak.panes FOLDER``.

The real program starts with an empty home folder on a screen of its own. Mouse and keyboard begin a
plate in the sun with a picture of 3:2, and then open what stands beside the design: the predicted
photo, regions, a check, manufacture, the cutter, tolerances, compared runs, a sweep and the manual.
The folder gets a picture of each, to be looked at.
"""

import re
import time
from pathlib import Path

from PIL import Image
from PySide6.QtCore import QCoreApplication

import resources
from tests.soak.arguments import arguments
from tests.soak.hand import Hand, middle
from tests.soak.screen import virtual_screen
from ui.words import speak, tr

_WINDOW = "Freeform"
_PATIENCE = 300.0  # seconds, on a machine that does much else
_TASKS = ("photo", "regions", "manufacture", "tolerances", "runs", "sweep", "manual")
_PIXELS = (240, 160)
_SLOW = 2.0  # seconds in which the window follows, on such a machine
_STILL = 15  # looks in succession at which no lens follows
_TYPED = re.compile(r"[!-~]+")  # signs that are on any keyboard
_PALETTE = "ctrl+shift+p"


class Person:
    """Does one thing after the other, and keeps a picture of each.

    Parameters
    ----------
    hand : Hand
        Of the program, which shows its start page.
    """

    def __init__(self, hand: Hand) -> None:
        self._hand = hand
        self._count = 0

    def begin(self, picture: Path) -> None:
        """Begin a plate in the sun with a picture, and wait for its lens."""
        page, hand = tr("New design"), self._hand
        hand.until(lambda: hand.find(page), "start page", _PATIENCE)
        hand.fill_screen(_WINDOW)
        hand.focus(page)
        hand.click(tr("Image"), "TextEditor", times=3, window=page)
        hand.type(str(picture))
        computing = tr("Computing what can be expected…")
        hand.until(lambda: not hand.having(computing), "what can be expected", _PATIENCE)
        self._keep("start page")
        hand.click(_plain(tr("&Begin")), "QPushButton")
        hand.until(lambda: not hand.find(page), "the window behind the page")
        self._rest()
        self._keep("lens")

    def photo(self) -> None:
        """Look at the predicted photo, and expose it longer."""
        hand = self._hand
        self._go_to("Predicted photo")
        hand.until(lambda: hand.having(tr("daylight (D65)")[1:]), "photo", _PATIENCE)
        self._keep("photo")
        x, y = middle(hand.wait(tr("Exposure"))["place"])
        hand.drag((x, y), (x + 30, y))
        self._keep("photo exposed longer")

    def regions(self) -> None:
        """Draw a rectangle and a polygon on the light, and check the lens there."""
        hand = self._hand
        hand.focus(_WINDOW)
        hand.press("alt+g")
        x, y, width, height = hand.wait("", kind="PlotCanvas")["place"]

        def at(across: float, down: float) -> tuple[int, int]:
            return round(x + across * width), round(y + down * height)

        hand.drag(at(0.3, 0.4), at(0.45, 0.55))
        time.sleep(_SLOW)
        for corner in ((0.5, 0.4), (0.65, 0.45)):
            hand.click_at(*at(*corner))
        hand.click_at(*at(0.55, 0.6), times=2)
        time.sleep(_SLOW)
        hand.press("Escape", "plus", "plus")
        time.sleep(_SLOW)
        self._keep("regions, nearer")
        hand.press("Home", "F8")
        hand.until(lambda: hand.find(tr("Figures of the check")), "check", _PATIENCE)
        self._keep("check")

    def manufacture(self) -> None:
        """Look at the face as a shop does, and simulate a cut."""
        hand = self._hand
        self._go_to("Manufacture")
        thinnest = tr("Thinnest")
        hand.until(lambda: hand.find(thinnest, "QLabel"), "manufacture", _PATIENCE)
        time.sleep(_SLOW)
        self._keep("manufacture")
        hand.click(_plain(tr("Ball cutter…")))
        hand.fill(tr("Tool radius"), "1.5")
        time.sleep(_SLOW)  # the simulation follows the field
        fits = tr("The cutter fits.")
        hand.until(lambda: hand.having(fits), "verdict", _PATIENCE)
        hand.click(_plain(tr("&Trace light")))
        polishing = tr("Polishing takes ridges away.")
        hand.until(lambda: hand.having(polishing), "cut", _PATIENCE)
        self._keep("cutter")
        hand.focus(tr("Ball cutter"))
        hand.press("Escape")

    def tolerances(self) -> None:
        """Let some lenses be a little off."""
        hand = self._hand
        self._go_to("Tolerances")
        self._keep("tolerances")
        hand.click(tr("Start"), "QPushButton")
        some = tr("{count} of {wanted} lenses").format(count=5, wanted=100)
        hand.until(lambda: hand.having(some), "sample", _PATIENCE)
        hand.click(tr("Cancel"), "QPushButton")
        time.sleep(_SLOW)
        self._keep("tolerances found")

    def runs(self) -> None:
        """Design it once more, and compare both runs."""
        hand = self._hand
        hand.focus(_WINDOW)
        hand.press("F5")
        time.sleep(15.0)
        hand.press("F7")
        self._go_to("Runs")
        hand.click(tr("Kept runs"))
        hand.press("ctrl+a")
        self._keep("runs")
        hand.click(tr("Compare"), "QPushButton")
        time.sleep(_SLOW)
        self._keep("runs compared")
        hand.focus(tr("Comparison of two runs"))
        hand.press("Escape")

    def sweep(self) -> None:
        """Design lenses of two widths, and open the smaller one."""
        hand, title = self._hand, tr("Sweep")
        self._command(tr("S&weep…").rstrip("…"))
        hand.fill(tr("Values of {field}").format(field=tr("Field")), "45, 50")
        self._keep("sweep")
        hand.click(tr("Start"), "QPushButton", window=title)
        done = tr("{count} of {wanted} designs").format(count=2, wanted=2)
        hand.until(lambda: hand.having(done), "sweep", _PATIENCE)
        self._keep("sweep done")
        hand.click(tr("Designs of the sweep"), window=title)
        hand.press("Home")
        hand.click(_plain(tr("&Open design")), "QPushButton", window=title)
        time.sleep(_SLOW)
        hand.press("Tab", "Return")  # Discard
        time.sleep(_SLOW)
        self._keep("sweep opened")
        hand.focus(title)
        hand.press("Escape")

    def manual(self) -> None:
        """Search the manual for a word, and for one that it does not have."""
        hand = self._hand
        hand.focus(_WINDOW)
        hand.press("F1")
        for words in ("ridges", "xyzzy"):
            hand.fill(tr("Search the manual"), words)
            self._keep(f"manual, {words}")
        hand.focus(tr("Manual"))
        hand.press("Escape")

    def _rest(self) -> None:
        """Wait until no better lens follows."""
        hand, still = self._hand, 0
        follows = tr("Following: error {error:.1f} %, still getting better").partition("{")[0]
        hand.until(lambda: hand.having(follows), "first lens", _PATIENCE)
        while still < _STILL:
            time.sleep(0.1)
            still = 0 if hand.having(follows) else still + 1

    def _go_to(self, pane: str) -> None:
        """Show a pane."""
        self._command(f"{tr('&Go to')} {tr(pane)}")

    def _command(self, name: str) -> None:
        """Give a command by the palette."""
        hand = self._hand
        hand.focus(_WINDOW)
        hand.press(_PALETTE)
        hand.type(" ".join(_TYPED.findall(_plain(name))), enter="Return")
        time.sleep(_SLOW)

    def _keep(self, name: str) -> None:
        self._count += 1
        self._hand.picture(f"{self._count:02}-{name.replace(', ', '-').replace(' ', '-')}")
        print(f"{name}: {self._hand.steps} steps", flush=True)


def _plain(text: str) -> str:
    return text.replace("&", "")


def main() -> None:
    """Do all of it."""
    parser = arguments("tests.soak.panes")
    parser.add_argument("--task", action="append", choices=_TASKS, help="all by default")
    options = parser.parse_args()
    speak(QCoreApplication([]), options.language)
    options.folder.mkdir(parents=True)
    picture = options.folder.absolute() / "three-two.png"
    with Image.open(resources.path("targets", "photo-256.png")) as photo:
        photo.crop((0, 43, 256, 213)).resize(_PIXELS).save(picture)
    with virtual_screen(options.folder, tuple(options.size)) as screen:
        hand = Hand(screen, options.folder, options.scale, options.theme, language=options.language)
        try:
            person = Person(hand)
            person.begin(picture)
            for task in options.task or _TASKS:
                getattr(person, task)()
        finally:
            hand.close()


if __name__ == "__main__":
    main()
