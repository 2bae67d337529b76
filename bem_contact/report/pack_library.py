"""Packs a JavaScript file for a page: gzip, then base64. The same bytes each time.

    pack_library.py plotly.js OUTPUT
"""

import base64
import gzip
import sys
from pathlib import Path

source, output = map(Path, sys.argv[1:])
output.write_bytes(base64.b64encode(gzip.compress(source.read_bytes(), mtime=0)))
