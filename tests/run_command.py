"""How tests in Python run a program that should succeed. A test puts this folder into sys.path and imports it."""

import subprocess


def run(*command, **options):
    """What the program prints. If it fails, the test fails with the end of all that it said."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command} ended with {done.returncode}:\n{(done.stdout + done.stderr)[-4000:]}")
    return done.stdout
