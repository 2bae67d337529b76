"""Words, and what each kind of answer shows: the same in pictures, on pages and in notebooks (record/words.json)."""

import json
from pathlib import Path

# It lies beside an installed package, and in the room record of the source tree.
SHARED = json.loads(next(folder / "words.json" for folder in (Path(__file__).parent, Path(__file__).parents[3] / "record")
                         if (folder / "words.json").exists()).read_text(encoding="utf-8"))
WORDS = SHARED["words"]  # of the names in the files; a name that is not there stands as it is
VIEWS = SHARED["views"]  # prominent numbers, columns of tables, figures
