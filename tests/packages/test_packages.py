# SPDX-License-Identifier: MIT
"""The Debian packages in a root folder that holds nothing but what they depend on: installed, a match played, the template
built against them and played, removed, and nothing left. Needs root, for chroot."""

import gzip
import hashlib
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import tempfile
import time
import unittest

import root

SOURCE = pathlib.Path(os.environ["REGISTA_SOURCE"])
BUILD = pathlib.Path(os.environ["REGISTA_BUILD"])
PROGRAM = os.environ["REGISTA_PROGRAM"]
VERSION = os.environ["REGISTA_VERSION"]
COMMIT = "1700000000"  # any time will do

TEAMS = "/usr/share/regista/configs/teams"
MATCH = (f"{TEAMS}/paper.yaml", f"{TEAMS}/fixed_rate.yaml", "--seed", "1", "--json")
FROM_PACKAGE_TO_MATCH = 10.0  # seconds


def make(folder):
    root.output(os.environ["CPACK"], "--config", BUILD / "CPackConfig.cmake", "-B", folder,
                env={**os.environ, "SOURCE_DATE_EPOCH": COMMIT})
    return sorted(folder.glob("*.deb"))


def processor_seconds():
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime


@unittest.skipIf(os.geteuid() != 0, "not root: packages are installed with chroot, which only root may do")
@unittest.skipIf(subprocess.run(["unshare", "--mount", "true"], capture_output=True).returncode, "nothing can be mounted here")
class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = pathlib.Path(tempfile.mkdtemp(prefix="regista-packages-"))
        cls.addClassCleanup(shutil.rmtree, cls.work)
        cls.sdk, cls.program = make(cls.work / "made")
        cls.needed = root.closure(root.dependencies(root.output("dpkg-deb", "-f", cls.program, "Depends")))

    def setUp(self):
        self.root = root.Root(self.needed)
        self.addCleanup(self.root.remove)

    def install(self, *packages):
        done = self.root.dpkg("-i", *packages)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        # dpkg itself tells of what it does not find on this system's PATH.
        return [line for line in done.stderr.splitlines() if line.startswith("regista")]

    def succeed(self, *command):
        done = self.root.run(*command)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def play(self, *more):
        return json.loads(self.succeed("/usr/bin/regista", "match", *MATCH, *more))

    def test_names_and_what_is_said_of_them(self):
        architecture = root.output("dpkg", "--print-architecture").strip()
        self.assertEqual([self.sdk.name, self.program.name],
                         [f"regista-sdk_{VERSION}_all.deb", f"regista_{VERSION}_{architecture}.deb"])
        # What a package recommends is installed, too; a tool for figures brought ghostscript.
        self.assertEqual(root.output("dpkg-deb", "-f", self.program, "Recommends").strip(), "")

    def test_the_same_bytes_again(self):
        again = make(self.work / "again")
        self.assertEqual([hashlib.sha256(file.read_bytes()).hexdigest() for file in (self.sdk, self.program)],
                         [hashlib.sha256(file.read_bytes()).hexdigest() for file in again])

    def test_copyright_names_the_plugins_under_the_gpl(self):
        self.install(self.program)
        text = (self.root.path / "usr/share/doc/regista/copyright").read_text()
        named = set(re.findall(r"/usr/lib/regista/plugins/(\w+)\.so", text))
        built = re.findall(r"^regista_add_plugin\((\w+)",
                           (SOURCE / "plugins/positioners/voronoi/CMakeLists.txt").read_text(), re.M)
        self.assertEqual(named, set(built))
        for plugin in named:
            self.assertTrue((self.root.path / f"usr/lib/regista/plugins/{plugin}.so").exists())
        self.assertIn("/usr/share/common-licenses/GPL-3", text)

    def test_first_match(self):
        before, begin = processor_seconds(), time.monotonic()
        self.assertEqual(self.install(self.program), [])
        played = self.play()
        # Of the processor, because other tests run beside this one.
        spent, passed = processor_seconds() - before, time.monotonic() - begin
        print(f"from the package to the end of the first match: {passed:.1f} s, {spent:.1f} s of the processor")
        self.assertLessEqual(spent, FROM_PACKAGE_TO_MATCH)
        here = root.output(PROGRAM, "match", *(SOURCE / "configs/teams" / pathlib.Path(file).name for file in MATCH[:2]),
                           *MATCH[2:])
        self.assertEqual(played["state_hash"], json.loads(here)["state_hash"])

    def test_everything_a_user_finds(self):
        self.install(self.program)
        self.assertTrue(self.succeed("/usr/bin/regista", "--version").startswith(f"regista {VERSION} ("))
        self.assertEqual(set(self.succeed("/usr/bin/regista", "plugin", "list").splitlines()),
                         {line.replace(str(BUILD / "lib"), "/usr/lib") for line in
                          root.output(PROGRAM, "plugin", "list").splitlines()})
        for folder in sorted((SOURCE / "configs").iterdir()):
            files = [f"/usr/share/regista/configs/{file.relative_to(SOURCE / 'configs')}" for file in folder.glob("*.yaml")]
            if files:
                self.succeed("/usr/bin/regista", "config", "check", *files)
        self.play("--limit", "60", "--record", "/tmp/match.mcap")
        if (BUILD / "share/regista/viewer.html").exists():
            self.succeed("/usr/bin/regista", "view", "/tmp/match.mcap", "-o", "/tmp/match.html")
        share = self.root.path / "usr/share"
        manual = gzip.decompress((share / "man/man1/regista-match.1.gz").read_bytes()).decode()
        self.assertIn(r"regista match \- play one match between two teams", manual)
        self.assertNotIn(str(BUILD), manual)
        for file in ("bash-completion/completions/regista", "zsh/vendor-completions/_regista",
                     "fish/vendor_completions.d/regista.fish"):
            self.assertIn("tournament", (share / file).read_text())
        documents = share / "doc/regista"
        pages = [documents / "README.md", documents / "CHANGELOG.md", *sorted((documents / "docs").glob("*.md"))]
        for page in pages:
            for link in re.findall(r"\]\(([\w./-]+)(?:#[^)]*)?\)", page.read_text()):
                place = pathlib.PurePosixPath(os.path.normpath(page.parent.relative_to(documents) / link))
                self.assertTrue((documents / place).exists(), f"{page.name}: {link}")

    def test_a_library_that_is_not_depended_on_is_missed(self):
        """The root holds nothing of this system by accident: this test could not fail otherwise."""
        self.install(self.program)
        for file in self.root.path.glob("usr/lib/*/libnlopt.so*"):
            file.unlink()
        done = self.root.run("/usr/bin/regista", "--version")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("libnlopt", done.stderr)

    def made_plugin(self):
        """The folder of a new plugin, as the installed program makes it."""
        self.succeed("/usr/bin/regista", "plugin", "new", "assigner", "best_pair_first", "-o", "/tmp")
        return self.root.path / "tmp/best_pair_first"

    def test_new_plugin(self):
        """The compiler is this system's; all it finds of Regista stands in the root."""
        self.install(self.program, self.sdk)
        project = self.made_plugin()
        build = project / "build"
        root.output(os.environ["CMAKE"], "-S", project, "-B", build, "-G", os.environ["CMAKE_GENERATOR"],
                    f"-DCMAKE_CXX_COMPILER={os.environ['CXX']}", f"-DCMAKE_PREFIX_PATH={self.root.path}/usr",
                    "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
        commands = (build / "compile_commands.json").read_text()
        self.assertIn(f"{self.root.path}/usr/include", commands)
        self.assertNotIn(str(SOURCE), commands)
        root.output(os.environ["CMAKE"], "--build", build)
        root.output(os.environ["CTEST"], "--test-dir", build, "--no-tests=error")
        self.plays_with(build / "best_pair_first.so")

    def test_examples(self):
        """The examples build as they were installed."""
        self.install(self.program, self.sdk)
        build = self.work / "examples"
        root.output(os.environ["CMAKE"], "-S", self.root.path / "usr/share/regista/examples", "-B", build, "-G",
                    os.environ["CMAKE_GENERATOR"], f"-DCMAKE_CXX_COMPILER={os.environ['CXX']}",
                    f"-DCMAKE_PREFIX_PATH={self.root.path}/usr")
        root.output(os.environ["CMAKE"], "--build", build)
        self.assertEqual({file.stem for file in build.glob("*.so")}, {"log_ball", "draw_ways", "count_crossings", "claim_tasks"})

    def test_new_plugin_without_cmake(self):
        if not shutil.which("pkg-config"):
            self.skipTest("there is no pkg-config")
        self.install(self.program, self.sdk)
        found = {**os.environ, "PKG_CONFIG_PATH": str(self.root.path / "usr/share/pkgconfig")}

        def says(*what):
            return root.output("pkg-config", *what, "regista", env=found).split()

        interface = re.findall(r"#define REGISTA_ABI_M\w+ (\d+)u", (SOURCE / "sdk/include/regista/abi.h").read_text())
        self.assertEqual(says("--modversion"), [".".join(interface)])
        plugin = self.work / "best_pair_first.so"
        root.output(os.environ["CXX"], "-std=c++20", "-O2", *says("--cflags"), *says("--variable=plugin_compile"),
                    self.made_plugin() / "plugin.cpp", *says("--variable=plugin_link"), "-o", plugin)
        root.output("python3", SOURCE / "tests/architecture/exported_symbols.py", plugin)
        self.plays_with(plugin)

    def plays_with(self, plugin):
        (self.root.path / "tmp/plugins").mkdir()
        shutil.copy(plugin, self.root.path / "tmp/plugins")
        played = self.play("--limit", "120", "--plugins", "/tmp/plugins", "--set", "a.assigner.plugin=best_pair_first")
        self.assertEqual(played["failures"], [])
        self.assertNotEqual(played["state_hash"], self.play("--limit", "120")["state_hash"])

    def test_nothing_is_left(self):
        before = self.root.paths()
        for remove in ("--remove", "--purge"):
            self.install(self.program, self.sdk)
            self.assertGreater(len(self.root.paths()), len(before) + 200)
            self.play("--limit", "10")
            done = self.root.dpkg(remove, "regista", "regista-sdk")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(self.root.paths() ^ before, set())

    def test_an_older_build_in_usr_local_is_told(self):
        (self.root.path / "usr/local/bin/regista").touch()
        (self.root.path / "usr/local/lib/cmake/regista").mkdir()
        (self.root.path / "usr/local/include/regista").mkdir()
        self.assertEqual(sorted(self.install(self.program, self.sdk)), [
            "regista-sdk: /usr/local/include/regista is of another installation, and compilers and CMake find it before "
            "that in /usr; remove it",
            "regista-sdk: /usr/local/lib/cmake/regista is of another installation, and compilers and CMake find it before "
            "that in /usr; remove it",
            "regista: /usr/local/bin/regista is of another installation, and shells find it before /usr/bin/regista; remove "
            "it, or call /usr/bin/regista"])

    @unittest.skipUnless(shutil.which("lintian"), "lintian is not installed")
    def test_lintian_finds_no_error(self):
        done = subprocess.run(["lintian", "--fail-on", "error", self.sdk, self.program], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)


if __name__ == "__main__":
    unittest.main()
