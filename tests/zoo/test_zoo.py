# SPDX-License-Identifier: MIT
"""The zoo: each faulty plugin of zoo.json plays for a team against an innocent one, and nobody but its own team pays.

What zoo.json expects of an animal:
  plays    no match is lost by it, and every match is that of its sound twin
  forfeit  its team forfeits every match
  once     no match is lost by it, but a broken promise is reported: what is looked for in the second play of a pairing's
           first match alone
  behind   the same, if its sound twin loses a match; it does in at least one run
  refused  its file cannot be used: the program says so before the first match
  lost     forfeit or refused
  dies     matches of it are forfeited, or could not be played
  either   whatever its team loses; also that matches of it could not be played
An animal that needs longer matches says so, by `limit`; `match: false` is one that `regista match` cannot tell from
its user, who ends it by a signal, or that writes to the terminal what it likes.
`said` is what standard error says of it, and one that `differs` is found not to be reproducible. Of one that `shares`
it is found that its robots do not decide alone, by this call of it; of no other animal. One that `keeps` a variable of
this name outside of its instances is remarked on, though nothing comes of it.
`what` is a regular expression for the report's reason, `call` the call in which its team is to be blamed, and then the
plugin that is named is the animal itself. Of all of them holds what `Animals.holds` says, above all: the innocent team
forfeits nothing, a match that was played is that of the sound twin, and no match ends better than that. An animal that
is not `steady` changes what is played, so its matches are compared with nobody's. `check` is for test_checks.py.

REGISTA_ZOO_GROUP: the file of faults/ whose animals are tried; empty: all. REGISTA_ZOO_RUNS: how often, default 1.
Runs of an even number begin with the team of the animal, the others with the innocent one; every other animal
begins with run 1.
"""

import functools
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import threading
import time
import unittest

import program
import tournament
from processes import processes

ZOO = program.TEST_PLUGINS / "zoo"
ANIMALS = json.loads((pathlib.Path(__file__).parent / "zoo.json").read_text())
GROUP = os.environ.get("REGISTA_ZOO_GROUP", "")
RUNS = int(os.environ.get("REGISTA_ZOO_RUNS", "1"))

# What a team says where an animal takes the place of a sound plugin.
PLACES = {
    "assigner": ("assigner: {plugin: first_free}", "assigner: {{plugin: {}}}"),
    "positioner": ("positioner: {plugin: at_the_ball}", "positioner: {{plugin: {}}}"),
    "sender": ("sender: {plugin: every_second}", "sender: {{plugin: {}}}"),
    "context": ("plugin: ball_seen", "plugin: {}"),
    # With an assigner that looks at utilities.
    "utility": ("{plugin: nearness, weight: 1, params: {scale: 2}}}}\nassigner: {plugin: first_free}",
                "{{plugin: {}, weight: 1}}}}}}\nassigner: {{plugin: greedy}}"),
    "predictor": ("ball:      {plugin: last_news}", "ball:      {{plugin: {}}}"),
    "behaviour": ("target: {at: [", "behaviour: {}, target: {{at: ["),
}
LONGEST = 120  # s that a command may take: a call that hangs is given up after one or a few
MOST_TEXT = 8 << 20  # bytes that a command may write: plugins write at most one megabyte, or without end


def _safe():
    """Nothing that goes wrong here takes the machine with it, whether or not the program limits what is played."""
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def shared_memory():
    """What animals name there. Other tests keep files there meanwhile, by other names."""
    return {name for name in os.listdir("/dev/shm") if name.startswith("regista")}


def unplayed(report):
    """Pairs that could not be played, because nobody can be blamed for the deaths in them."""
    return report["unplayed"]["pairs"]


class Zoo(tournament.Tournament):
    plugins = (*tournament.Tournament.plugins, program.TEST_PLUGINS.parent / "plugins" / "greedy.so")

    def setUp(self):
        super().setUp()
        self.addCleanup(self.kill_all)
        (self.folder / "temporary").mkdir()
        self.shared_memory = shared_memory()

    def environment(self, changes=None):
        return {**super().environment(changes), "TMPDIR": str(self.folder / "temporary")}

    @functools.cached_property
    def limits(self):
        """As short as can be asked for, of each command."""
        out = {}
        for command in ("tournament", "match"):
            offered = self.run_program(command, "--help").stdout
            shortest = (("--processor-seconds", 1), ("--memory", 512), ("--wall-seconds", 3))
            out[command] = [word for option, value in shortest
                            if re.search(rf"^ *{option}\b", offered, re.MULTILINE) for word in (option, value)]
        return out

    def kill_all(self):
        for number in processes(self.program):
            try:
                os.kill(number, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def bounded(self, *arguments, longest=LONGEST):
        """What a command says, which may be without end, and may be held open by a process that it left behind."""
        with self.start(*arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, preexec_fn=_safe) as process:
            streams = [process.stdout, process.stderr]
            said = ["", ""]
            enough = threading.Event()

            def read(which):
                # One that is left behind may write for ever; it is told apart by what it holds open.
                while not enough.is_set() and (piece := os.read(streams[which].fileno(), 65536)):
                    said[which] += piece.decode(errors="replace")
                    if len(said[which]) > MOST_TEXT:
                        enough.set()

            readers = [threading.Thread(target=read, args=(which,), daemon=True) for which in (0, 1)]
            for reader in readers:
                reader.start()
            end = time.monotonic() + longest
            while process.poll() is None and time.monotonic() < end and not enough.is_set():
                time.sleep(0.01)
            ended = process.poll() is not None
            if not ended:
                self.kill_all()
            for reader in readers:
                reader.join(1.0)
            held = any(reader.is_alive() for reader in readers)
            left = processes(self.program) if held else []
            if held:
                self.kill_all()  # so that nobody waits for what it holds
        self.assertTrue(ended, f"{arguments} did not end within {longest} s and {MOST_TEXT} bytes")
        self.assertFalse(held, f"left behind, holding its output: {left}")
        return subprocess.CompletedProcess(arguments, process.returncode, *said)

    def run_it(self, *arguments):
        """A command that ends by itself, and leaves nothing behind but the results."""
        done = self.bounded(*arguments)
        self.assertIn(done.returncode, (0, 2), (arguments, done.stderr[-2000:]))
        self.leaves_nothing()
        self.assertEqual([name for name in os.listdir(self.folder) if name.endswith((".db-wal", ".db-shm"))], [])
        return done

    def leaves_nothing(self):
        for what, there in (("processes", lambda: processes(self.program)),
                            ("shared memory", lambda: shared_memory() - self.shared_memory)):
            end = time.monotonic() + 5
            while (left := there()) and time.monotonic() < end:
                time.sleep(0.02)
            if left:
                self.kill_all()  # so that the next command is not blamed for it
            self.assertFalse(left, f"{what} left behind")
        self.assertEqual(os.listdir(self.folder / "temporary"), [])

    def team_of(self, animal, name="bad"):
        sound, its = PLACES[animal["kind"]]
        text = program.TEAM.format(name=name)
        self.assertIn(sound, text)
        self.write(f"{name}.yaml", text.replace(sound, its.format(animal["name"])))
        (self.folder / name).mkdir(exist_ok=True)
        shutil.copy2(ZOO / f"{animal['name']}.so", self.folder / name)

    @staticmethod
    def play(animal, run):
        """The seed of a run, of matches in which goals fall, and how long an animal needs, if not 10 s."""
        return ["--seed", 2 * run + 5, *(["--limit", animal["limit"]] if "limit" in animal else [])]

    def words(self, team, animal, run):
        """The tournament of a run: one match on either side, the team named first or last."""
        teams = [team, "small"] if run % 2 == 0 else ["small", team]
        return self.arguments("--json", "--quiet", *self.play(animal, run), "--plugins", team, "--results",
                              f"{team}{run}.db", *self.limits["tournament"],
                              teams=[f"{each}.yaml" for each in teams], pairs=1)

    def decided(self, file):
        return self.stored("SELECT row, home_goals, away_goals, ended, hash FROM matches ORDER BY row", file)

    def matches(self, team, run):
        """Of each row that was decided: goals for and against the team, how it ended, and what it was."""
        out = {}
        for row, home, away, ended, hashed in self.decided(f"{team}{run}.db"):
            at_home = (row % 2 == 1) == (run % 2 == 0)
            out[row] = ((home, away) if at_home else (away, home), ended, hashed)
        return out


class Animals(Zoo):
    """A method for each animal of the group is added below."""

    twins = {}
    was_behind = set()

    def twin(self, animal, run):
        """The same matches, played by the sound one."""
        kind = animal["kind"]
        which = kind, run, animal.get("limit")
        if which not in self.twins:
            self.team_of({"name": f"sound_{kind}", "kind": kind}, "twin")
            done = self.run_it(*self.words("twin", animal, run))
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(json.loads(done.stdout)["forfeits"], [])
            self.twins[which] = self.matches("twin", run)
        return self.twins[which]

    def holds(self, animal):
        self.team_of(animal)
        first = ANIMALS.index(animal) % 2
        for run in range(first, first + max(RUNS, 2 if animal["expect"] == "behind" else 1)):
            with self.subTest(animal["name"], run=run):
                self.tournament(animal, run)
            if not animal.get("match", True):
                continue
            with self.subTest(animal["name"], run=run, match=True):
                self.match(animal, run, ["--json"] if run % 2 else [])
        if animal["expect"] == "behind":
            self.assertIn(animal["name"], self.was_behind)

    def one_line(self, animal, done):
        """The line with which the program refuses; what a plugin itself writes stands beside it."""
        self.assertEqual(done.stdout, "")
        lines = [line for line in done.stderr.splitlines() if line.startswith("regista: ")]
        # A file that cannot be used is told in a line of its own, if it stands in a folder that was asked for.
        notes = [line for line in lines if line.startswith("regista: not used: ")]
        lines = [line for line in lines if line not in notes]
        self.assertEqual(len(lines), 1, done.stderr[-2000:])
        if "call" in animal or animal["expect"] == "refused":
            self.assertIn(animal["name"], lines[0])
        return lines[0]

    def tournament(self, animal, run):
        expected, twin = animal["expect"], self.twin(animal, run)
        done = self.run_it(*self.words("bad", animal, run))
        if done.returncode == 2:
            self.assertIn(expected, ("refused", "lost", "either"), done.stderr[-2000:])
            self.one_line(animal, done)
            return
        self.assertNotEqual(expected, "refused")
        report = json.loads(done.stdout)
        innocent, = (team for team in report["teams"] if team["name"] == "small")
        self.assertEqual(innocent["failures"], 0, report["forfeits"])
        self.assertEqual({each["team"] for each in report["forfeits"]} - {"bad"}, set())
        lost = sum(each["matches"] for each in report["forfeits"])
        played = self.matches("bad", run)
        if expected == "plays":
            self.assertEqual((lost, unplayed(report), len(played)), (0, 0, 2), report)
        elif expected in ("forfeit", "lost"):
            self.assertEqual((lost, unplayed(report)), (2, 0), report)
        elif expected == "once":
            self.assertEqual((lost, unplayed(report), len(played)), (0, 0, 2), report)
            first, = report["broken_promises"]["listed"]
            self.assertRegex(first["what"], rf"plugin {animal['name']}, {animal['call']}: changed its input")
        elif expected == "behind" and any(scored < conceded for (scored, conceded), *_ in twin.values()):
            self.was_behind.add(animal["name"])
            self.assertGreater(lost, 0, report)
        elif expected == "dies":
            self.assertGreater(lost + unplayed(report), 0, report)
        if expected not in ("once", "either", "dies"):
            self.assertEqual(report["broken_promises"]["matches"], 0, report)
        if "said" in animal:
            self.assertRegex(done.stderr, animal["said"])
        if animal.get("differs"):
            self.assertGreater(report["not_reproducible"]["matches"], 0, report)
        if "shares" in animal:
            self.assertEqual(report["not_reproducible"]["matches"], 0, report)
            self.assertEqual([each["match"] for each in report["not_alone"]["listed"]], [1], report)
            self.assertRegex(report["not_alone"]["listed"][0]["what"],
                             rf"robot \d, tick \d+.*: plugin {animal['name']}\b.*\b{animal['shares']}\b")
        elif expected not in ("either", "dies"):  # chance may look like anything
            self.assertEqual(report["not_alone"]["matches"], 0, report)
        if "keeps" in animal:
            self.assertRegex(report["kept_outside"]["listed"][0]["what"], rf"\b{animal['name']}\.so: {animal['keeps']}$")
        for each in report["forfeits"]:
            if "call" in animal:
                self.assertEqual((each["plugin"], each["call"]), (animal["name"], animal["call"]), each)
            self.assertTrue(re.search(animal["what"], each["what"]), each)
        for row, ((scored, conceded), ended, hashed) in played.items():
            if ended == "set_aside" or not animal.get("steady", True):
                continue
            (twin_scored, twin_conceded), *_, twin_hash = twin[row]
            self.assertLessEqual(scored - conceded, twin_scored - twin_conceded, "it gained by its fault")
            if ended != "forfeit":
                self.assertEqual(hashed, twin_hash, "not the match of its sound twin")

    def match(self, animal, run, more):
        expected, teams = animal["expect"], ["bad.yaml", "small.yaml"]
        if run % 2:
            teams.reverse()
        done = self.run_it("match", *teams, "--opening", "scenes/left.yaml", *self.play(animal, run), "--plugins",
                           "bad", *self.limits["match"], *more)
        if expected not in ("either", "once", "behind", "dies"):
            self.assertEqual(done.returncode, 0 if expected == "plays" else 2, done.stderr[-2000:])
        if done.returncode == 0:
            if more:
                json.loads(done.stdout)
            return
        line = self.one_line(animal, done)
        if expected == "forfeit":
            self.assertTrue(re.search(animal["what"], line), line)
            self.assertIn("bad", line)
            if animal.get("call", "destroy") != "destroy":
                self.assertRegex(line, rf"\b{animal['name']}\b.*\brobot [1-7]\b.*\btick \d+\b")
                self.assertIn(animal["call"], line)


def _method(animal):
    return lambda self: self.holds(animal)


for _animal in ANIMALS:
    if GROUP in ("", _animal["file"]):
        setattr(Animals, f"test_{_animal['name']}", _method(_animal))


class Verdicts(Zoo):
    """Sequential tests of a team that dies when it is behind, or when it has begun: it gains no verdict by that, and
    the innocent team loses none."""

    TRIED = ("crashes_when_behind", "thread_crashes_when_behind", "thread_crashes")  # contexts
    ORDER = {"H0": 0, None: 1, "INCONCLUSIVE": 1, "H1": 2}  # what is said of the team that was named first

    @staticmethod
    def folders(*teams):
        return [word for team in ("bad", "twin") if team in teams for word in ("--plugins", team)]

    def verdict(self, first, second):
        done = self.run_it(*self.arguments("--json", "--quiet", "--sprt", "0,50", *self.folders(first, second),
                                           "--failures-in-a-row", "0", "--limit", 30, "--results",
                                           f"{first}_{second}.db", *self.limits["tournament"], teams=(f"{first}.yaml", f"{second}.yaml"),
                                           pairs=8))
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        report = json.loads(done.stdout)
        self.assertEqual({each["team"] for each in report["forfeits"]} - {"bad"}, set())
        lost = sum(each["matches"] for each in report["forfeits"])
        return self.ORDER[report["verdict"]], unplayed(report), lost

    def test_nothing_is_gained(self):
        self.team_of({"name": "sound_context", "kind": "context"}, "twin")
        for innocent in ("small", "worse"):
            first, second = self.verdict("twin", innocent)[0], self.verdict(innocent, "twin")[0]
            for name in self.TRIED:
                with self.subTest(name, innocent=innocent):
                    animal, = (each for each in ANIMALS if each["name"] == name)
                    shutil.rmtree(self.folder / "bad", ignore_errors=True)
                    for file in self.folder.glob("*bad*.db"):
                        file.unlink()
                    self.team_of(animal)
                    self.assertLessEqual(self.verdict("bad", innocent)[0], first)
                    found, left_out, lost = self.verdict(innocent, "bad")
                    if innocent == "small":  # nobody is behind the other one
                        self.assertGreater(left_out + lost, 0, "it never died")
                    if left_out == 0:
                        self.assertGreaterEqual(found, second)


class Centralised(Zoo):
    """A team whose robots may share memory, because the document of the study says so."""

    def test_it_is_said_on_purpose(self):
        animal, = (each for each in ANIMALS if each["name"] == "shares_a_table")
        self.team_of(animal)
        self.write("t.yaml", "tournament: centralised\nteams: [{team: bad.yaml}, {team: small.yaml}]\npairs: 1\nseed: 5\n"
                             "openings: [scenes]\nplay_twice: true\nseeds: consecutive\n")
        words = ("tournament", "t.yaml", "--no-page", "--quiet", "--plugins", "bad")
        said = self.run_it(*words, "--results", "alone.db").stdout
        self.assertRegex(said, r"^robots do not decide alone: .*\n[^$]*\nNot a result of robots that decide alone: ")
        with (self.folder / "t.yaml").open("a") as document:
            document.write("allow_shared_memory: true\n")
        shared = self.run_it(*words, "--results", "shared.db").stdout
        self.assertNotIn("decide alone", shared)
        self.assertRegex(shared, r"\nRobots of a team may share memory here: .*\n")
        self.assertEqual(self.decided("shared.db"), self.decided("alone.db"))


class Visitors(Zoo):
    """Teams that use none of the animals, with all of them in a folder of plugins."""

    def test_each_animal_has_a_place_and_a_file(self):
        names = [animal["name"] for animal in ANIMALS]
        self.assertEqual(len(names), len(set(names)))
        for animal in ANIMALS:
            self.assertIn(animal["kind"], PLACES)
            self.assertTrue((ZOO / f"{animal['name']}.so").exists(), f"{animal['name']}.so is not built")

    def test_a_match(self):
        words = ("match", "small.yaml", "other.yaml", "--opening", "scenes/left.yaml", "--json")
        alone = self.run_it(*words)
        among = self.run_it(*words, "--plugins", ZOO)
        self.assertEqual(among.returncode, 0, among.stderr[-2000:])
        self.assertEqual(*({**json.loads(done.stdout), "wall_seconds": None, "played": None} for done in (among, alone)))

    def test_a_tournament(self):
        alone = self.run_it(*self.arguments("--json", "--quiet", "--results", "alone.db"))
        among = self.run_it(*self.arguments("--json", "--quiet", "--results", "among.db", "--plugins", ZOO))
        self.assertEqual(among.returncode, 0, among.stderr[-2000:])
        self.assertEqual(self.decided("among.db"), self.decided("alone.db"))
        self.assertEqual(json.loads(among.stdout)["forfeits"], json.loads(alone.stdout)["forfeits"])

    def test_documents(self):
        done = self.run_it("config", "check", "small.yaml", "--plugins", ZOO)
        self.assertEqual((done.returncode, done.stdout), (0, "small.yaml: team, sound\n"), done.stderr[-2000:])

    def test_the_list(self):
        sound = set(self.ids())
        done = self.run_it("plugin", "list", "--json", "--plugins", ZOO)
        self.assertEqual(done.returncode, 0, done.stderr[-2000:])
        listed = {plugin["id"] for plugin in json.loads(done.stdout)["plugins"]}
        broken = {animal["name"] for animal in ANIMALS if animal["expect"] == "refused"}
        self.assertEqual(sound - listed, set())
        self.assertEqual({animal["name"] for animal in ANIMALS} - listed, broken)
        for name in broken:
            self.assertIn(f"{name}.so", done.stdout)


if __name__ == "__main__":
    unittest.main()
