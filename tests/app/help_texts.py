"""Each `--help` shows an example and says what you should see. Is it seen? Every number of that sentence is in the output."""

import os
import re
import shlex
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["BEM_CONTACT"]
NUMBER = r"(?<![\w.])-?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.]*\d)"


def output_of(*words, folder=ROOT):
    done = subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


def commands(*above):
    """Of the program or of one of its commands, as its help lists them."""
    listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", output_of(*above, "--help")[1], re.M)
    names = re.findall(r"^  (\S+)", listed[1], re.M) if listed else []
    return [list(above), *(below for name in names for below in commands(*above, name))]


def examples(text):
    """Command lines of a paragraph, and the numbers of the sentence that says what should be seen."""
    for paragraph in re.split(r"\n\s*\n", text):
        lines = re.findall(r"^    bem_contact (.*?)(?:  +#.*)?$", paragraph, re.M)
        seen = re.search(r"You should see(.*?)(?:[.:]\s|\Z)", paragraph, re.S)
        if lines and seen and (numbers := re.findall(NUMBER, seen[1])):
            yield lines, numbers


def shows(output, number):
    """Whether the output has this number, or one that rounds to it."""
    digits = len(number.partition("e")[0].partition(".")[2])
    power = int(number.partition("e")[2] or 0)
    return any(abs(float(other) - float(number)) <= 0.5001 * 10.0 ** (power - digits) for other in re.findall(NUMBER, output))


class HelpTexts(unittest.TestCase):
    def test_what_you_should_see_is_seen(self):
        tried = 0
        for command in commands():
            for lines, numbers in examples(output_of(*command, "--help")[1]):
                with self.subTest(command=" ".join(command)), tempfile.TemporaryDirectory() as folder:
                    (Path(folder) / "data").symlink_to(ROOT / "data")
                    output = ""
                    for line in lines:
                        code, printed = output_of(*shlex.split(line), folder=folder)
                        self.assertEqual(code, 0, printed)
                        output += printed
                    for number in numbers:
                        self.assertTrue(shows(output, number), f"{number} is not in\n{output}")
                    tried += 1
        self.assertGreaterEqual(tried, 6)


if __name__ == "__main__":
    unittest.main()
