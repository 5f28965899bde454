"""``python -m ui`` is ``freeform-workbench``."""

import sys

from ui.app import main

sys.exit(main())
