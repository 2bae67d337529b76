"""Builds the package with CMake. On Debian 12 or 13, without a network:

    /usr/bin/python3 -m venv --system-site-packages env
    env/bin/pip install --no-build-isolation ./bem_contact/python

BEM_CONTACT_BUILD=BUILD takes everything from a build that is there instead of compiling again.
"""

import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

ROOT = Path(__file__).resolve().parents[2]
VERSION = re.search(r"project\(conformal_contact VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]

def run(*command):
    subprocess.run([str(part) for part in command], check=True)

class BuildWithCMake(build_py):
    def run(self):
        super().run()
        package = Path(self.build_lib) / "bem_contact"
        with tempfile.TemporaryDirectory() as folder:
            build, prefix = os.environ.get("BEM_CONTACT_BUILD"), Path(folder) / "prefix"
            if not build:
                build = Path(folder) / "build"
                run("cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-Wno-dev", "-DCONFORMAL_WITH_FEM=OFF",
                    "-DCONFORMAL_TESTS=OFF", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=60")
                run("cmake", "--build", build)
            run("cmake", "--install", build, "--prefix", prefix)
            installed = next(prefix.glob("lib/**/bem_contact/__init__.py")).parent
            for file in (*installed.glob("_core*.so"), installed / "_numbers.pyi"):
                shutil.copy2(file, package)
            shutil.copy2(installed / "plotting" / "words.json", package / "plotting")
            # By the names under which they are opened, libbem_contact_hdf5.so.MAJOR.MINOR.
            libraries = [file for file in prefix.glob("lib/**/libbem_contact_*.so.*") if re.search(r"\.so\.\d+\.\d+$", file.name)]
            for name, file in (*(("lib", library) for library in libraries), ("bin", prefix / "bin" / "bem_contact")):
                (package / name).mkdir(exist_ok=True)
                shutil.copy2(file, package / name)

class Compiled(Distribution):
    def has_ext_modules(self):
        return True  # the wheel is for this kind of machine and this Python

setup(version=VERSION, packages=["bem_contact", "bem_contact.plotting"], package_data={"bem_contact": ["py.typed", "*.pyi"]},
      cmdclass={"build_py": BuildWithCMake}, distclass=Compiled)
