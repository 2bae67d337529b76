"""What makes a picture hard to read: words on words, marks under a legend, names of the files in place of words."""

import contextlib
import re

from matplotlib.collections import PathCollection
from matplotlib.text import Text

NAME_OF_A_FILE = re.compile(r"\b(pmax|[a-z]+_[a-z_]+|(position|load|motion|wheelset)\.[a-z_]+)\b(?!\.)")
NARROWER, LOWER = 0.98, 0.9  # of the boxes of two words: their empty borders may touch


@contextlib.contextmanager
def recorded_words():
    """Words with their boxes, of all that is drawn meanwhile; the last drawing counts."""
    drawn, original = {}, Text.draw

    def draw(self, renderer, *arguments, **options):
        original(self, renderer, *arguments, **options)
        if self.get_visible() and self.get_text().strip():
            drawn[self] = self.get_window_extent(renderer).shrunk(NARROWER, LOWER)

    Text.draw = draw
    try:
        yield drawn
    finally:
        Text.draw = original


def marks_of(axis):
    """Places of all marks, in pixels."""
    for line in axis.lines:
        if line.get_marker() not in ("None", "", None) and line.get_transform() == axis.transData:
            yield from axis.transData.transform(line.get_xydata())
    for collection in axis.collections:
        if isinstance(collection, PathCollection):
            yield from axis.transData.transform(collection.get_offsets())


def faults(figure):
    """In words; empty for a picture that can be read."""
    with recorded_words() as drawn:
        figure.canvas.draw()
    boxes = list(drawn.items())
    found = [f"'{a.get_text()}' lies on '{b.get_text()}'" for k, (a, one) in enumerate(boxes) for b, other in boxes[k + 1:]
             if one.overlaps(other)]
    found += [f"'{a.get_text()}' has a name of the files" for a, _ in boxes if NAME_OF_A_FILE.search(a.get_text())]
    for axis in figure.axes:
        legend = axis.get_legend()
        hidden = legend and sum(legend.get_frame().get_window_extent().contains(*place) and axis.bbox.contains(*place)
                                for place in marks_of(axis))
        if hidden:
            found.append(f"{hidden} marks under the legend of '{axis.get_title(loc='left')}'")
    return found
