"""`bem_contact schema --json` describes scenes: every scene that is shipped fits it, and what the program refuses does not."""

import copy
import json
import os
import subprocess
import tempfile
import tomllib
import unittest
from pathlib import Path

try:
    import jsonschema
except ImportError:
    jsonschema = None

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ["BEM_CONTACT"]
BASE = tomllib.loads((ROOT / "data/scenes/hertz.toml").read_text())


def output_of(*words):
    return subprocess.run([PROGRAM, *words], capture_output=True, text=True)


def scenes():
    files = subprocess.run(["git", "ls-files", "data/scenes/*.toml"], cwd=ROOT, capture_output=True, text=True).stdout.split()
    return [ROOT / name for name in files] or sorted((ROOT / "data/scenes").glob("*.toml"))


def keys_of(properties, before=()):
    """(path, what it says) of every key."""
    for name, one in properties.items():
        if one.get("type") == "object" and "properties" in one:
            yield from keys_of(one["properties"], (*before, name))
        else:
            yield (*before, name), one


def with_value(scene, path, value):
    changed = copy.deepcopy(scene)
    table = changed
    for name in path[:-1]:
        table = table.setdefault(name, {})
    table[path[-1]] = value
    return changed


@unittest.skipIf(jsonschema is None, "python3-jsonschema is not installed")
class SceneSchema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        done = output_of("schema", "--json")
        assert done.returncode == 0, done.stderr
        cls.schema = json.loads(done.stdout)
        jsonschema.Draft7Validator.check_schema(cls.schema)
        cls.validator = jsonschema.Draft7Validator(cls.schema)

    def errors(self, scene):
        return [error.message for error in self.validator.iter_errors(scene)]

    def refused(self, scene_text):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "s.toml"
            file.write_text(scene_text)
            return output_of("check", str(file)).returncode == 2

    def test_shipped_scenes_fit(self):
        files = scenes()
        self.assertGreater(len(files), 20)
        for file in files:
            with self.subTest(file=file.name):
                self.assertEqual(self.errors(tomllib.loads(file.read_text())), [])

    def test_every_key_with_its_default_fits(self):
        self.assertEqual(self.errors(tomllib.loads(output_of("--print-default").stdout)), [])

    def test_mistakes_do_not_fit(self):
        for path, value in ((("load", "forces"), 1e4), (("motions", "xi"), 0.1), (("motion", "friction"), -0.1), (("motion", "friction"), "0.3"),
                            (("motion", "kind"), "stedy"), (("grid", "mx"), 1.5), (("compare", "modles"), 1)):
            with self.subTest(key=path):
                self.assertTrue(self.errors(with_value(BASE, path, value)))

    def test_a_value_beyond_its_range_is_refused_by_both(self):
        found = 0
        for path, one in keys_of(self.schema["properties"]):
            for bound, beyond in (("minimum", -1), ("maximum", 1), ("exclusiveMinimum", 0), ("exclusiveMaximum", 0)):
                if bound in one and one["type"] == "number" and len(path) == 2 and found < 25:
                    found += 1
                    value = one[bound] + beyond
                    with self.subTest(key=path, value=value):
                        self.assertTrue(self.errors(with_value({}, path, value)))
                        base = 'load.force = 1e5\nrail.profile = "60E1"\nwheel.profile = "S1002"\n' if "kind = patch" not in one["description"] \
                            else (ROOT / "data/scenes/hertz.toml").read_text().split("[")[0]
                        self.assertTrue(self.refused(f"{'.'.join(path)} = {float(value)}\n" + base))
        self.assertGreaterEqual(found, 25)

    def test_text_lists_one_table(self):
        self.assertIn("layer.compliance", output_of("schema", "layer").stdout)
        self.assertNotIn("motion.", output_of("schema", "layer").stdout)
        done = output_of("schema", "moton")
        self.assertEqual(done.returncode, 2)
        self.assertIn("Did you mean motion", done.stderr)


if __name__ == "__main__":
    unittest.main()
