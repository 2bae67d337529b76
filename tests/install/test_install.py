"""The installed tree: moved to another folder, found by CMake and pkg-config, used from C, C++, Fortran and Python."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from run_command import run  # noqa: E402

BUILD, SOURCE = Path(os.environ["CONFORMAL_BUILD"]), Path(os.environ["CONFORMAL_SOURCE"])
VERSION = os.environ["CONFORMAL_VERSION"]
CLIENTS = Path(__file__).resolve().parent / "consumers"
HERTZ = 1237.56  # MPa at 1e5 N (data/scenes/hertz.toml); it goes with the cube root of the force


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        folder = Path(cls.temporary.name)
        run("cmake", "--install", BUILD, "--prefix", folder / "installed_first")
        cls.prefix = folder / "moved"
        (folder / "installed_first").rename(cls.prefix)
        cls.lib = next(cls.prefix.glob("lib/**/libconformal_contact.so")).parent
        cls.scene = cls.prefix / "share/conformal_contact/scenes/hertz.toml"
        cls.work = folder / "work"
        cls.work.mkdir()

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def check(self, *client, **options):
        pressures = [float(line) for line in run(*client, self.scene, **options).split()]
        self.assertEqual(len(pressures), 3)
        for i, pressure in enumerate(pressures):
            self.assertAlmostEqual(pressure / (HERTZ / (i + 1) ** (1 / 3)), 1, delta=1e-2)

    def configure(self, *options):
        return subprocess.run(["cmake", "-S", str(CLIENTS), "-B", str(self.work / "cmake"), "-Wno-dev",
                               f"-DCMAKE_PREFIX_PATH={self.prefix}", *options],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def test_cmake(self):
        done = self.configure(f"-DWANTED_VERSION={VERSION}")
        self.assertEqual(done.returncode, 0, done.stdout)
        run("cmake", "--build", self.work / "cmake")
        for client in ("c", "cpp", "f90", "static"):
            with self.subTest(client):
                self.check(self.work / "cmake" / f"client_{client}")
        for kind in ("conformal_contact", "static"):
            with self.subTest(kind):
                self.check_answers(self.work / "cmake" / f"answers_{kind}")

    def check_answers(self, client):
        """What the rooms above `sequence` answer: figures of scenes' own words, and closed forms."""
        found = {name: float(value) for name, value in map(str.split, run(client, self.scene.parent).splitlines())}
        for name, value, delta in (("tan_gamma_3mm", 0.1741, 1e-4), ("axle_Fy", 2e4, 1), ("case_status", 1, 0), ("slope_over_kalker", 1, 1e-2),
                                   ("volume_over_section", 1, 1e-9), ("p0_over_k", 4.37, 1e-2), ("full_slip_Fx", 1, 1e-6)):
            self.assertAlmostEqual(found[name], value, delta=delta, msg=name)
        self.assertGreater(found["table_datasets"], 10)

    def test_the_lines_of_the_page_work_when_pasted(self):
        page = (SOURCE / "data" / "tutorial" / "own_program.md").read_text()
        block = re.search(r"^    cmake --install build.*?(?=\n\n)", page, re.M | re.S)[0]
        lines = [line.strip() for line in block.splitlines()[1:]]  # it is installed
        copy = self.work / "tests" / "install" / "consumers"
        shutil.copytree(CLIENTS, copy)
        (self.work / "data").symlink_to(SOURCE / "data")
        lib = self.lib.relative_to(self.prefix)
        script = "\n".join(["set -e", *lines]).replace("/opt/conformal/lib", f"/opt/conformal/{lib}").replace("/opt/conformal", str(self.prefix))
        said = run("sh", "-c", script, cwd=self.work)
        self.assertAlmostEqual(float(said.split()[0]) / HERTZ, 1, delta=1e-2)
        for client in ("client_f90", "client_cpp"):
            self.check(copy / client, env=os.environ | {"LD_LIBRARY_PATH": str(self.lib)})
        project = self.work / "six_lines"
        project.mkdir()
        shutil.copy(CLIENTS / "client.cpp", project)
        (project / "CMakeLists.txt").write_text(re.search(r"```cmake\n(.*?)```", page, re.S)[1])
        run("cmake", "-S", project, "-B", project / "build", "-Wno-dev", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        run("cmake", "--build", project / "build")
        self.check(project / "build" / "client")

    def test_cmake_refuses_another_version(self):
        found = next(self.prefix.rglob("conformal_contact-config.cmake")).parent
        major, minor, patch = (int(part) for part in VERSION.split("."))
        for wanted in (f"{major + 1}.0", f"{major}.{minor + 1}", f"{major}.{minor}.{patch + 1}"):
            with tempfile.TemporaryDirectory() as other:
                (Path(other) / "CMakeLists.txt").write_text(  # without a language: none needs to be looked for
                    f"cmake_minimum_required(VERSION 3.25)\nproject(other NONE)\nfind_package(conformal_contact {wanted} REQUIRED)\n")
                done = subprocess.run(["cmake", "-S", other, "-B", f"{other}/build", f"-Dconformal_contact_DIR={found}"],
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            self.assertNotEqual(done.returncode, 0, wanted)
            self.assertRegex(done.stdout, f"conformal_contact-config.cmake, version: {re.escape(VERSION)}\n")

    def test_the_wheelset_of_the_examples(self):
        """A client that solves at each time step: tools/examples. It ends with 0 if the textbook's figures come out."""
        build = self.work / "examples"
        run("cmake", "-S", SOURCE / "tools" / "examples", "-B", build, "-Wno-dev", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        run("cmake", "--build", build)
        self.assertIn("Klingel", run(build / "wheelset_running", SOURCE / "tools/examples/coned_wheelset.toml"))

    def test_pkg_config(self):
        environment = os.environ | {"PKG_CONFIG_PATH": str(self.lib / "pkgconfig")}
        flags = run("pkg-config", "--cflags", "--libs", "conformal_contact", env=environment).split()
        self.assertEqual(run("pkg-config", "--modversion", "conformal_contact", env=environment).strip(), VERSION)
        loader = os.environ | {"LD_LIBRARY_PATH": str(self.lib)}
        program = self.work / "client.out"  # the page's lines compile those in C++ and Fortran
        run("gcc", "-std=c89", "-pedantic", "-Werror", CLIENTS / "client.c", "-o", program, *flags, cwd=self.work)
        self.check(program, env=os.environ | {"LD_LIBRARY_PATH": str(self.lib)})

    def test_the_program_and_its_pages(self):
        program = self.prefix / "bin" / "bem_contact"
        self.assertEqual(run(program, "--version").strip(), f"bem_contact {VERSION}")
        self.assertIn("certified: yes", run(program, "solve", self.scene))
        run(program, "solve", self.scene, "-o", self.work / "r.h5")
        run(program, "report", self.work / "r.h5", "-o", self.work / "r.html")  # the plotting library is in the program
        self.assertGreater((self.work / "r.html").stat().st_size, 1e6)
        # Both find the program and the package of their own tree.
        for plot in ((program, "plot"), (self.prefix / "share/conformal_contact/tools/plot",)):
            for what in (self.work / "r.h5", "S1002"):
                run(*plot, what, "-o", self.work / "picture.png", env={"PATH": "/usr/bin:/bin"})
                self.assertGreater((self.work / "picture.png").stat().st_size, 1e4)
                (self.work / "picture.png").unlink()
        run(self.prefix / "share/conformal_contact/tools/paraview", self.work / "r.h5", "-o", self.work / "r.vtm", env={"PATH": "/usr/bin:/bin"})
        self.assertTrue((self.work / "r.vtm").exists())
        pages = self.prefix / "share/man/man1"
        for name in ("bem_contact", "bem_contact-solve", "bem_contact-sweep", "bem_contact-influence-expand"):
            self.assertIn("--help".replace("-", "\\-"), (pages / f"{name}.1").read_text())
        completed = run("bash", "-c", f"""source {self.prefix}/share/bash-completion/completions/bem_contact
COMP_WORDS=(bem_contact solve --mod); COMP_CWORD=2; _bem_contact; echo "${{COMPREPLY[@]}}"
COMP_WORDS=(bem_contact solve --model ""); COMP_CWORD=3; _bem_contact; echo "${{COMPREPLY[@]}}"
COMP_WORDS=(bem_contact comp); COMP_CWORD=1; _bem_contact; echo "${{COMPREPLY[@]}}" """).splitlines()
        self.assertEqual(completed[0], "--model")
        self.assertIn("tangent_plane", completed[1].split())
        self.assertEqual(completed[2].split()[0], "compare")

    def test_the_cluster_tools_find_the_programs(self):
        tools = self.prefix / "share/conformal_contact/tools"
        (self.work / "config.toml").write_text("")
        found = run(sys.executable, "-c", "import cluster_tasks, sys; print(cluster_tasks.read('config.toml', sys.argv[1]).programs)",
                    tools / "cluster", cwd=self.work, env={"PATH": "/usr/bin:/bin", "PYTHONPATH": str(tools / "cluster")})
        self.assertEqual(Path(found.strip()), self.prefix / "bin")
        self.assertTrue((tools / "cluster" / "Snakefile").exists() and (tools / "influence").exists())

    def test_python(self):
        package = next(self.prefix.glob("lib/**/bem_contact/__init__.py")).parent.parent
        code = f"import bem_contact as b; print(b.__version__, b.solve({str(self.scene)!r}).pmax, b.__file__)"
        version, pmax, file = run(sys.executable, "-c", code, cwd="/",
                                  env=os.environ | {"PYTHONPATH": str(package)}).split()
        self.assertEqual(version, VERSION)
        self.assertAlmostEqual(float(pmax) / HERTZ, 1, delta=1e-2)
        self.assertTrue(file.startswith(str(self.prefix)))

    def test_pip(self):
        """A virtual environment with Debian's packages and no network; the build that is there is used."""
        folder = self.work / "environment"
        run("/usr/bin/python3", "-m", "venv", "--system-site-packages", folder)
        source = self.work / "source"  # setuptools writes beside what it builds
        shutil.copytree(SOURCE / "bem_contact" / "python", source / "bem_contact" / "python",
                        ignore=shutil.ignore_patterns("build", "*.egg-info", "__pycache__"))
        shutil.copy(SOURCE / "CMakeLists.txt", source)
        run(folder / "bin" / "pip", "install", "--no-build-isolation", "--no-index", "--no-deps",
            source / "bem_contact" / "python", env=os.environ | {"BEM_CONTACT_BUILD": str(BUILD)})
        clean = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PATH")}
        clean["PATH"] = "/usr/bin:/bin"
        python = folder / "bin" / "python3"
        code = f"import bem_contact as b; print(b.solve({str(self.scene)!r}).pmax, b.__file__)"
        pmax, file = run(python, "-c", code, cwd="/", env=clean).split()
        self.assertAlmostEqual(float(pmax) / HERTZ, 1, delta=1e-2)
        self.assertTrue(file.startswith(str(folder)))
        for program in ((python, "-m", "bem_contact"), (folder / "bin" / "bem_contact",)):
            self.assertEqual(run(*program, "--version", cwd="/", env=clean).strip(), f"bem_contact {VERSION}")
            self.assertIn("certified: yes", run(*program, "solve", self.scene, cwd="/", env=clean))
            run(*program, "plot", "S1002", "-o", self.work / "pip.png", cwd="/", env=clean)
            (self.work / "pip.png").unlink()

    def test_nothing_points_back(self):
        """No file of the installed tree knows where it was built or first installed."""
        for file in self.prefix.rglob("*"):
            if file.is_file() and file.suffix in (".cmake", ".pc", ".h", ".hpp", ".py"):
                text = file.read_text()
                self.assertNotIn(str(BUILD), text, file)
                self.assertNotIn(str(SOURCE), text, file)
                self.assertNotIn("installed_first/", text, file)

    def test_public_headers_only(self):
        headers = {str(h.relative_to(self.prefix / "include")) for h in (self.prefix / "include").rglob("*.h*")}
        self.assertIn("conformal_contact.h", headers)
        self.assertIn("bem_contact/sequence/sequence.hpp", headers)
        self.assertIn("bem_contact/uses/wheelset/solve_wheelset.hpp", headers)
        self.assertFalse({h for h in headers if "/app/" in h or "/python/" in h or "operator" in h})


if __name__ == "__main__":
    unittest.main()
