"""Each job of the start page as a new user does it: ``python -m tests.soak.new_user FOLDER``.

The real program starts with an empty home folder on a screen of its own. Mouse and keyboard choose
a job, wait for what can be expected of it, begin it, and wait until its lens is as good as it gets.
The folder gets pictures of each stage, to be looked at; printed are seconds, clicks and keys, and
what is told.
"""

import time

from PySide6.QtCore import QCoreApplication

from tests.soak.arguments import arguments
from tests.soak.hand import Hand
from tests.soak.screen import virtual_screen
from ui.words import speak, tr
from workbench.jobs import JOBS
from workbench.scene.kinds import title_of

_WINDOW = "Freeform"
_PATIENCE = 300.0  # seconds, on a machine that does much else
_STILL = 15  # looks in succession at which no lens follows


def do(job: str, hand: Hand) -> dict[str, float]:
    """Do one job; seconds from the start of the program, and from Begin to lenses."""
    page, begin = tr("New design"), tr("&Begin").replace("&", "")
    computing = tr("Computing what can be expected…")
    follows = tr("Following: error {error:.1f} %, still getting better").partition("{")[0]
    designing = tr("Following: the first design is under way")
    begun = time.monotonic()
    hand.until(lambda: hand.find(page), "start page", _PATIENCE)
    hand.fill_screen(_WINDOW)
    hand.focus(page)
    hand.click(job)
    hand.picture("1-chosen")
    hand.until(lambda: not hand.having(computing), "what can be expected", _PATIENCE)
    reported = {"prospect": time.monotonic() - begun}
    hand.picture("2-prospect")
    begun = time.monotonic()
    hand.click(begin, "QPushButton")
    hand.until(lambda: not hand.find(page), "the window behind the page")
    hand.picture("3-begun")
    hand.until(lambda: hand.having(follows), "first lens", _PATIENCE)
    reported["first lens"] = time.monotonic() - begun
    hand.picture("4-first")
    still = 0
    give_up = begun + _PATIENCE
    while still < _STILL and time.monotonic() < give_up:
        time.sleep(0.1)
        still = 0 if hand.having(follows) or hand.having(designing) else still + 1
    reported["good lens"] = time.monotonic() - begun
    hand.picture("5-good")
    hand.focus(_WINDOW)
    hand.press("F8")
    hand.until(lambda: hand.find(tr("Figures of the check")), "figures of the check", _PATIENCE)
    hand.picture("6-checked")
    return reported


def main() -> None:
    """Do all jobs, or some."""
    parser = arguments("tests.soak.new_user")
    parser.add_argument("--job", action="append", help="title of one in English; all by default")
    options = parser.parse_args()
    application = QCoreApplication([])
    speak(application, options.language)
    for job in options.job or [title_of(kind) for kind in JOBS]:
        folder = options.folder / job.lower().replace(" ", "-")
        folder.mkdir(parents=True)
        with virtual_screen(folder, tuple(options.size)) as screen:
            hand = Hand(screen, folder, options.scale, options.theme, language=options.language)
            try:
                reported = do(tr(job), hand)
                figures = ", ".join(f"{name} {seconds:.0f} s" for name, seconds in reported.items())
                readout = hand.having(
                    tr("Error {error} · light {place} {shares}").partition("{")[0]
                )
                print(f"{job}: {figures}, {hand.steps} steps; {readout}", flush=True)
            finally:
                hand.close()


if __name__ == "__main__":
    main()
