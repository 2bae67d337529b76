"""What is said while profiles are read: the logger "bem_contact" of Python's logging.

    logging.getLogger("bem_contact").setLevel(logging.WARNING)     # no more lines of the level info

Where neither this logger nor the root has a handler of yours, lines go to standard error.
"""

import logging
import sys

from .profiles import in_plain_names


class _StandardError(logging.StreamHandler):
    """As logging's last resort: what standard error is at the time. Silent where the user has handlers."""

    def __init__(self):
        logging.Handler.__init__(self)

    @property
    def stream(self):
        return sys.stderr

    def emit(self, record):
        if not logging.getLogger().handlers and logger.handlers == [self]:
            super().emit(record)

    def format(self, record):
        return f"{record.levelname.lower()}: {record.getMessage()}"


logger = logging.getLogger("bem_contact")
logger.addHandler(_StandardError())
if logger.level == logging.NOTSET:
    logger.setLevel(logging.INFO)


def say(level, text):
    """Called by the compiled part."""
    logger.log({"info": logging.INFO, "warning": logging.WARNING}.get(level, logging.ERROR), "%s", in_plain_names(text))
