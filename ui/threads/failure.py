"""What a person reads of work in another thread that came to nothing."""

import logging

from ui.words import error_text, tr
from workbench.defects import details, unexpected
from workbench.errors import Refused, RunFailed

LOG = logging.getLogger("freeform-workbench")
"""Gets the traceback of each unexpected error; see `ui.startup.unexpected_errors`."""


def sentence_of(error: Exception, work: str) -> str:
    """Why some work failed.

    Parameters
    ----------
    error : Exception
        What ended it: a refusal, which is a sentence, or a defect of the program. The traceback of
        a defect goes to the log and into the file that the sentence names.
    work : str
        What the work is called: ``run``.
    """
    if isinstance(error, Refused | RunFailed):
        return error_text(error)
    LOG.error(details(error))
    return tr("The {work} ended with an {error}").format(work=work, error=unexpected(error))
