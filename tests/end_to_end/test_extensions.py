# SPDX-License-Identifier: MIT
"""Plugins that log, draw and report numbers: the examples of the SDK, and plugins that use the extensions as they must
not be used."""

import collections
import csv
import io
import json
import re
import unittest

import jsonschema

import program
import recorded
import tournament

SHIPPED = tuple(program.TEST_PLUGINS.parent / "plugins" / f"{name}.so"
                for name in ("kalman_ball", "inverse_distance"))
EXAMPLES = tuple(program.TEST_PLUGINS.parent / "examples" / f"{name}.so"
                 for name in ("log_ball", "draw_ways", "count_crossings"))
LIES = program.TEST_PLUGINS / "lies"
SECONDS = 30
MATCH = ("match", "told.yaml", "small.yaml", "--limit", SECONDS, "--quiet", *program.PLAY_SOON)
LINE = re.compile(r"\[(debug|info|warning|error)\] (home|away) (\d), tick (\d+), (\w+): (.+)")

TUNING = """\
tuning: crossings
team: told.yaml
opponents: [{team: small.yaml}]
parameters: [utility.terms.ways.weight]
objective: {minimise: plugin_values.count_crossings.crossings}
limit: 15
set: {rules.durations.ready: 3, rules.durations.set: 1}
search: {algorithm: bobyqa, matches: 12, pairs: 1}
selection: {finalists: 1, matches: 2}
verification: {matches: 40}
slices: {points: 0}
"""


def told():
    """A team of which plugins log, draw and report."""
    text = program.TEAM.format(name="told").replace("plugin: ball_seen", "plugin: log_ball")
    text = text.replace("ball:      {plugin: last_news}", "ball: {plugin: kalman_ball}")  # forgets
    text = text.replace("{near: {", "{ways: {plugin: draw_ways, weight: 1, tune: [0, 2]}, near: {")
    return text.replace("plugin: first_free", "plugin: count_crossings")


class Told(program.Case):
    plugins = (program.SOUND, *program.BEHAVIOURS, *SHIPPED, *EXAMPLES)

    def setUp(self):
        super().setUp()
        self.write("told.yaml", told())

    def match(self, *more):
        done = self.run_program(*MATCH, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def recording(self):
        return recorded.Recording((self.folder / "a.mcap").read_bytes())


class Log(Told):
    def test_lines_are_shown_from_a_level_on(self):
        shown = [LINE.fullmatch(line).groups() for line in self.match().stderr.splitlines()]
        self.assertEqual({(side, plugin) for _, side, _, _, plugin, _ in shown}, {("home", "log_ball")})
        self.assertEqual({robot for _, _, robot, _, _, _ in shown}, set("1234567"))
        self.assertIn("info", {level for level, *_ in shown})
        warnings = [line for line in shown if line[0] == "warning"]
        self.assertLessEqual({text for *_, text in warnings}, {"lost the ball"})
        self.assertEqual([LINE.fullmatch(line).groups() for line in self.match("--log", "warning").stderr.splitlines()],
                         warnings)
        self.assertEqual(self.match("--log", "none").stderr, "")
        self.assertEqual(self.match("--log", "error").stderr, "")

    def test_a_level_that_is_none(self):
        self.assertEqual(self.refused(*MATCH, "--log", "warn"),
                         'unknown value "warn" in --log; known: debug, info, warning, error, none')

    def test_a_recording_holds_them(self):
        shown = [LINE.fullmatch(line).groups() for line in self.match("--record", "a.mcap").stderr.splitlines()]
        recording = self.recording()
        messages = [message for topic, message in recording.messages if topic == "/log"]
        self.assertEqual([(m["level"], m["side"], str(m["robot"]), m["plugin"], m["text"]) for m in messages],
                         [(level, side, robot, plugin, text) for level, side, robot, _, plugin, text in shown])
        for message in messages:
            jsonschema.validate(message, recording.schemas["/log"])


class Drawings(Told):
    def test_they_stand_in_the_recording_and_change_nothing(self):
        without = json.loads(self.match("--json").stdout)
        recorded_match = json.loads(self.match("--json", "--record", "a.mcap").stdout)
        self.assertEqual(without["state_hash"], recorded_match["state_hash"])
        self.assertEqual(without["plugin_values"], recorded_match["plugin_values"])
        recording = self.recording()
        drawn = collections.defaultdict(list)
        for topic, message in recording.messages:
            if topic != "/draw":
                continue
            jsonschema.validate(message, recording.schemas["/draw"])
            self.assertEqual((message["side"], message["plugin"]), ("home", "draw_ways"))
            drawn[message["layer"], message["robot"]].append(message)
        self.assertEqual({layer for layer, _ in drawn}, {"ways", "lengths"})
        for messages in drawn.values():
            times = [message["time"] for message in messages]
            self.assertGreater(len(times), SECONDS / 2)
            self.assertTrue(all(b - a > 0.499 for a, b in zip(times, times[1:])), times)
        # A recording of a team that draws takes at most 1.3 times as much.
        silent = (self.folder / "told.yaml").read_text().replace("plugin: draw_ways", "plugin: inverse_distance")
        self.write("told.yaml", silent)
        self.match("--record", "b.mcap")
        sizes = [(self.folder / name).stat().st_size for name in ("a.mcap", "b.mcap")]
        self.assertLess(sizes[0] / sizes[1], 1.3, sizes)
        way = drawn["ways", 3][-1]["shapes"][0]
        self.assertEqual((way["shape"], way["colour"], way["width"], len(way["at"])), ("line", "#e69f00ff", 0.03, 2))
        length = drawn["lengths", 3][-1]["shapes"][0]
        self.assertRegex(length["text"], r"^\d+\.\d m$")

    def test_a_picture_shows_them(self):
        self.match("--record", "a.mcap")
        self.succeed("view", "a.mcap", "--at", "20", "--robot", "3", "-o", "a.svg")
        picture = (self.folder / "a.svg").read_text()
        self.assertIn("draw_ways: ways", picture)
        self.assertRegex(picture, r">\d+\.\d m<")


class Metrics(Told):
    def test_they_are_numbers_of_the_match(self):
        played = json.loads(self.match("--json", "--metrics", "a.csv").stdout)
        decisions = played["plugin_totals"][0]["count_crossings"]["decisions"]
        self.assertGreater(decisions, 7 * SECONDS)
        self.assertLessEqual(decisions, 7 * 10 * (SECONDS + 1))
        crossings = played["plugin_values"][0]["count_crossings"]["crossings"]
        self.assertGreater(crossings, 0.0)
        self.assertLess(crossings, 21.0)
        self.assertIsNone(played["plugin_totals"][1])
        self.assertIn(f"\n  count_crossings: decisions {decisions}, crossings ", self.match().stdout)
        rows = {(row[0], row[1]): row[2] for row in csv.reader(io.StringIO((self.folder / "a.csv").read_text()))}
        self.assertEqual(float(rows["home", "plugin_totals.count_crossings.decisions"]), decisions)
        self.assertEqual(float(rows["home", "plugin_values.count_crossings.crossings"]), crossings)

    def test_info_and_reference_tell_of_them(self):
        self.assertIn("metrics:\n  decisions: sum\n      Decisions with an assignment, of all robots\n"
                      "  crossings: mean over time\n", self.succeed("plugin", "info", "count_crossings"))
        self.assertIn("| `crossings` | mean over time | Pairs of robots whose ways to their tasks cross |\n",
                      self.succeed("plugin", "reference"))

    def test_one_can_be_the_objective_of_a_tuning(self):
        self.write("tune.yaml", TUNING)
        text = self.succeed("tune", "tune.yaml", "--quiet", "--no-page")
        self.assertIn("plugin_values.count_crossings.crossings", text)
        self.write("tune.yaml", TUNING.replace("crossings.crossings", "crossings.crosings"))
        self.assertIn('unknown measure "plugin_values.count_crossings.crosings"; nearest: '
                      '"plugin_values.count_crossings.crossings"', self.refused("tune", "tune.yaml"))


class InATournament(tournament.Tournament):
    plugins = Told.plugins

    def setUp(self):
        super().setUp()
        self.write("told.yaml", told())

    def test_numbers_are_reported(self):
        for isolation in "after-death", "always":
            with self.subTest(isolation):
                text = self.play("--isolation", isolation, teams=("told.yaml", "small.yaml"), pairs=1)
                self.assertNotIn("standard error", text, "information is no remark")
                table = list(csv.DictReader(io.StringIO(self.succeed("report", "tournament.db", "--csv", "--metrics"))))
                decisions = [row["home.plugin_totals.count_crossings.decisions"] for row in table]
                self.assertEqual(sorted(map(bool, decisions)), [False, True], "the other team counts nothing")
                self.assertGreater(max(float(each or 0) for each in decisions), 0.0)
                self.succeed("report", "tournament.db", "-o", "page.html", "--force")
                self.assertIn("count_crossings: crossings", (self.folder / "page.html").read_text())
                (self.folder / "tournament.db").unlink()


class LiesInATournament(tournament.Tournament):
    def test_no_team_hides_the_warnings_of_the_other(self):
        self.with_context("logs_too_much", name="loud")
        self.with_context("warns_once", name="quiet")
        for isolation in "after-death", "always":
            with self.subTest(isolation):
                self.play("--isolation", isolation, "--plugins", LIES, teams=("loud.yaml", "quiet.yaml"), pairs=1)
                kept = self.succeed("report", "tournament.db", "--standard-error", "1").splitlines()
                self.assertEqual(sum("wrote more than 64 lines in one decision" in line for line in kept), 7, kept)
                self.assertEqual(sum(line.endswith("warns_once: it rains") for line in kept), 7, kept)
                (self.folder / "tournament.db").unlink()


class Lies(program.Case):
    def team(self, plugin):
        self.write("told.yaml", program.TEAM.format(name="told").replace("plugin: ball_seen", f"plugin: {plugin}"))

    def test_drawings(self):
        self.team("draws_too_much")
        done = self.run_program(*MATCH, "--plugins", LIES, "--record", "a.mcap")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(done.stderr.splitlines()), [
            f"[warning] home {robot}, tick 0, draws_too_much: draw: layer dust: a shape has 1000000000 points; at most 512 "
            "are taken; it is left out" for robot in range(1, 8)])
        self.assertNotIn("/draw", {topic for topic, _ in recorded.Recording((self.folder / "a.mcap").read_bytes()).messages})

    def test_a_megabyte_of_log(self):
        self.team("logs_too_much")
        done = self.run_program(*MATCH, "--plugins", LIES)
        self.assertEqual(done.returncode, 0, done.stderr[-1000:])
        lines = done.stderr.splitlines()
        self.assertEqual(sum("wrote more than 64 lines in one decision" in line for line in lines), 7)
        self.assertLess(len(done.stderr), 7 * (1.1 * (256 << 10) + 1000))
        self.assertTrue(all(len(line) < 1100 for line in lines))

    def test_what_is_no_number_ends_the_match(self):
        self.team("lies_in_numbers")
        self.assertRegex(self.refused(*MATCH, "--plugins", LIES),
                         r'^plugin lies_in_numbers .*robot 3, tick 50: metric: reported nan as metric "truth"$')

    def test_a_pass_to_nobody_ends_the_match(self):
        self.write("told.yaml", program.TEAM.format(name="told") + "behaviours: {support: {plugin: passes_to_nobody}}\n")
        self.assertRegex(self.refused(*MATCH, "--plugins", LIES),
                         r'^plugin passes_to_nobody .*robot 3, tick [0-9]+: pass: a kick meant for robot 8; teammates are those '
                         r'from 1 to 7 but 3$')

    def test_two_metrics_of_one_name(self):
        self.team("declares_twice")
        said = self.refused(*MATCH, "--plugins", program.TEST_PLUGINS / "declares_twice")
        self.assertIn('declares_twice.so: plugin "declares_twice": declares the metric "hits" twice', said)


if __name__ == "__main__":
    unittest.main()
