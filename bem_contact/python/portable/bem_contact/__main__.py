"""`python -m bem_contact` is the program."""

import sys

from . import main

sys.exit(main())
