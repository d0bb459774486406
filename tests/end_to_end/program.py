# SPDX-License-Identifier: MIT
"""Runs the program under test, installed with plugins of the tests alone, in a folder of its own.

The installation has the layout of a real one, bin/regista and lib/regista/plugins, so that what the program says about
the plugins there are does not depend on those that are shipped.
"""

import fcntl
import json
import os
import pathlib
import pty
import shutil
import struct
import subprocess
import tempfile
import termios
import threading
import unittest

PROGRAM = pathlib.Path(os.environ["REGISTA_PROGRAM"])
SOURCE = pathlib.Path(os.environ["REGISTA_SOURCE"])
TEST_PLUGINS = pathlib.Path(os.environ["REGISTA_TEST_PLUGINS"])
SANITIZED = os.environ.get("REGISTA_SANITIZE") == "ON"

# The plugins of the testkit's own tests: one simple, sound plugin of each kind.
SOUND = TEST_PLUGINS / "contract" / "contract_good.so"

# The shipped behaviours, by which the roles of the teams below act.
BEHAVIOURS = tuple(TEST_PLUGINS.parent / "plugins" / f"{name}.so"
                   for name in ("keep_goal", "play_ball", "search", "support"))

# What bad input may take until it is refused, in seconds of the processor. Sanitizers are slow to start.
AT_ONCE = 5.0 if SANITIZED else 1.0

# How long a command is waited for, in seconds.
PATIENCE = 480 if SANITIZED else 300

# Robots walk to their places for 45 s before a game is played: too long for a short match.
PLAY_SOON = ("--set", "rules.durations.ready=3", "--set", "rules.durations.set=1")

TEAM = """\
team: {name}
predictors:
  self:      {{plugin: last_news}}
  ball:      {{plugin: last_news}}
  opponents: {{plugin: last_news}}
  teammates: {{plugin: last_news}}
contexts:
  - {{name: playing, priority: 0, plugin: ball_seen}}
positioner: {{plugin: at_the_ball}}
tasks: {{keep: all, offset: {{at_most: 0.3}}}}
roles:
  playing:
    - {{name: goalkeeper, robot: 1, target: {{at: own_goal, shift: [0.4, 0]}}}}
    - {{name: striker, required: true, target: {{at: ball}}}}
    - {{name: supporter, target: {{at: ball, shift: [-1, 0]}}}}
    - {{name: left, target: {{at: [0, 2]}}}}
    - {{name: right, target: {{at: [0, -2]}}}}
    - {{name: back, target: {{at: [-3, 0]}}}}
    - {{name: front, target: {{at: [2, 0]}}}}
utility: {{terms: {{near: {{plugin: nearness, weight: 1, params: {{scale: 2}}}}}}}}
assigner: {{plugin: first_free}}
sender: {{plugin: every_second}}
"""


class Case(unittest.TestCase):
    """A folder with a program, its plugins and a team named "small" in small.yaml; commands run in that folder."""

    plugins = (SOUND, *BEHAVIOURS)
    maxDiff = None

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="regista-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name).resolve()
        self.program = self.folder / "bin" / "regista"
        self.program.parent.mkdir()
        shutil.copy2(PROGRAM, self.program)
        self.plugin_folder = self.folder / "lib" / "regista" / "plugins"
        self.plugin_folder.mkdir(parents=True)
        for plugin in self.plugins:
            self.assertTrue(plugin.exists(), f"{plugin} is not built")
            shutil.copy2(plugin, self.plugin_folder)
        self.write("small.yaml", TEAM.format(name="small"))

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
        return path

    def environment(self, changes=None):
        environment = {key: value for key, value in os.environ.items() if not key.startswith("REGISTA_")}
        environment.update(changes or {})
        return environment

    def start(self, *arguments, environment=None, **options):
        options.setdefault("cwd", self.folder)
        return subprocess.Popen([str(self.program), *map(str, arguments)], text=True,
                                env=self.environment(environment), stdin=subprocess.DEVNULL, **options)

    def on_terminal(self, *arguments, columns=80, terminal="xterm", status=0, environment=None, **options):
        """What a terminal of so many columns got on standard error, and standard output, of what must end so."""
        ours, theirs = pty.openpty()
        fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
        pieces = []

        def read():
            try:
                while piece := os.read(ours, 4096):
                    pieces.append(piece)
            except OSError:  # the other end is closed
                pass

        with self.start(*arguments, stdout=subprocess.PIPE, stderr=theirs,
                        environment={"TERM": terminal, "NO_COLOR": "", **(environment or {})}, **options) as process:
            os.close(theirs)
            reader = threading.Thread(target=read)
            reader.start()
            out = process.stdout.read()
            process.wait(timeout=120)
            reader.join()
        os.close(ours)
        self.assertEqual(process.returncode, status)
        return b"".join(pieces).decode(), out

    def run_program(self, *arguments, environment=None, timeout=PATIENCE, **options):
        options.setdefault("stdout", subprocess.PIPE)
        options.setdefault("stderr", subprocess.PIPE)
        with self.start(*arguments, environment=environment, **options) as process:
            try:
                out, err = process.communicate(timeout=timeout)
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                self.fail(f"{arguments} did not end within {timeout} s")
        return subprocess.CompletedProcess(arguments, process.returncode, out, err)

    def succeed(self, *arguments, **options):
        """Standard output of a command that must succeed without a word on standard error."""
        done = self.run_program(*arguments, **options)
        self.assertEqual((done.returncode, done.stderr), (0, ""), arguments)
        return done.stdout

    def ids(self, kind=None):
        """Ids of the plugins there are, of one kind or all, in the program's order."""
        plugins = json.loads(self.succeed("plugin", "list", "--json"))["plugins"]
        return [plugin["id"] for plugin in plugins if kind is None or kind in plugin["kinds"]]

    def refused(self, *arguments, code=2, **options):
        """The line with which a command refuses; nothing goes to standard output."""
        done = self.run_program(*arguments, timeout=30, **options)
        self.assertEqual((done.returncode, done.stdout), (code, ""), (arguments, done.stderr))
        self.assertTrue(done.stderr.startswith("regista: "), done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertTrue(done.stderr.endswith("\n"), done.stderr)
        return done.stderr.removeprefix("regista: ").removesuffix("\n")


class ShippedCase(Case):
    """The same with the plugins that are shipped."""

    plugins = ()

    def setUp(self):
        super().setUp()
        self.plugin_folder.rmdir()
        self.plugin_folder.symlink_to(TEST_PLUGINS.parent / "plugins")
