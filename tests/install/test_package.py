"""cpack -G DEB: what is in the package. tools/checks/try_debian_package installs it in a clean root."""

import os
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from run_command import run  # noqa: E402

BUILD, VERSION = Path(os.environ["CONFORMAL_BUILD"]), os.environ["CONFORMAL_VERSION"]


class Package(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        run("cpack", "-G", "DEB", "-D", "CPACK_DEBIAN_COMPRESSION_TYPE=gzip", "--config", BUILD / "CPackConfig.cmake", "-B", cls.temporary.name)
        cls.package = next(Path(cls.temporary.name).glob("*.deb"))

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_it_has_program_library_headers_module_data_and_pages(self):
        files = {line.split(maxsplit=5)[5].split(" -> ")[0] for line in run("dpkg-deb", "-c", self.package).splitlines()}
        for wanted in ("bin/bem_contact", "lib/libconformal_contact.so", f"lib/libconformal_contact.so.{VERSION}",
                       *(f"lib/libbem_contact_{name}.so.{VERSION}" for name in ("hdf5", "openblas", "crypto", "http")), "lib/libbem_contact_sequence.a", "include/conformal_contact.h",
                       "include/bem_contact/sequence/sequence.hpp", "lib/pkgconfig/conformal_contact.pc",
                       "lib/cmake/conformal_contact/conformal_contact-config.cmake",
                       "lib/python3/dist-packages/bem_contact/__init__.py", "share/man/man1/bem_contact-solve.1",
                       "share/bash-completion/completions/bem_contact", "share/conformal_contact/scenes/hertz.toml",
                       "share/conformal_contact/influence/small_rail.h5", "share/conformal_contact/tools/plot",
                       "lib/python3/dist-packages/bem_contact/plotting/style.py", "share/doc/conformal-contact/copyright",
                       "share/doc/conformal-contact/LICENSES"):
            self.assertIn("./usr/" + wanted, files)
        self.assertTrue([f for f in files if "dist-packages/bem_contact/_core." in f])
        self.assertFalse([f for f in files if not f.startswith("./usr") and f != "./"])

    def test_it_says_what_it_needs(self):
        def field(name):
            return run("dpkg-deb", "-f", self.package, name).strip()

        self.assertEqual(field("Package"), "conformal-contact")
        self.assertEqual(field("Version"), VERSION)
        needed = field("Depends")
        for library in ("libhdf5-", "libopenblas0", "libssl3", "libfftw3-double3", "libfmt", "python3-numpy"):
            self.assertIn(library, needed)


if __name__ == "__main__":
    unittest.main()
