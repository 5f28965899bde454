"""What a person reads of work in another thread that came to nothing."""

import logging

from ui.words import error_text, tr
from workbench.defects import details, unexpected
from workbench.errors import Refused, RunFailed

LOG = logging.getLogger("freeform-workbench")
"""Gets the traceback of each unexpected error; see `ui.startup.unexpected_errors`."""


def sentence_of(error: Exception, work: str) -> str:
    """Return why some named work failed; a defect's traceback goes to the log."""
    if isinstance(error, Refused | RunFailed):
        return error_text(error)
    LOG.error(details(error))
    return tr("The {work} ended with an {error}").format(work=work, error=unexpected(error))
