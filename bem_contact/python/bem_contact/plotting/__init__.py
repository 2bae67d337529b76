"""Pictures of what bem_contact writes: `bem_contact plot FILE`, `bem_contact.plot()` and `Result.plot()`.

`drawing` knows which module draws which kind of file, `kinds` what kind a file is, `style` what all pictures share. Nothing
here needs the compiled part of bem_contact.
"""


def plot(file, picture=None, *, others=(), options=()):
    """Draws a file that bem_contact wrote, or a profile, and returns the figure (matplotlib's).

    `picture`: where to write it: .png, .pdf or .svg, of wear also .gif or .html (None is returned then); None: nowhere.
    `others`: further profiles, drawn behind the first. `options`: of the command profile, as ["--smoothing", "8"].
    Raises InputError for a file that cannot be drawn, and where matplotlib or h5py is missing.
    """
    from .refusals import require_modules
    require_modules()
    from .drawing import draw
    return draw([str(name) for name in (file, *others)], picture, [str(word) for word in options])
