# SPDX-License-Identifier: MIT
"""`regista tournament`: what is played, what is said about it, and what is refused."""

import json
import os
import shlex
import shutil
import signal
import sqlite3
import subprocess
import time
import unittest

import program
import tournament


class Matches(tournament.Tournament):
    pages = True

    def test_every_row_is_the_match_that_the_program_plays_by_itself(self):
        self.play("--seed", "7")
        rows = self.stored("SELECT row, job, seed, home_goals, away_goals, hash FROM matches "
                           "JOIN fixtures ON fixture = id ORDER BY row")
        self.assertEqual([row[2] for row in rows], [7, 7, 8, 8, 9, 9])
        self.assertGreater(sum(row[3] + row[4] for row in rows), 0)
        stored = self.metrics()
        for row, job, seed, home, away, state_hash in rows:
            job = json.loads(job)
            a_at_home = row % 2 == 1
            self.assertEqual(job["teams"], ["small.yaml", "other.yaml"] if a_at_home else ["other.yaml", "small.yaml"])
            self.assertEqual(job["opening"], f"scenes/{'right' if seed == 8 else 'left'}.yaml")
            again = ("match", *job["teams"], "--seed", seed, "--opening", job["opening"])
            done = self.run_program(*again, "--json")
            self.assertRegex(done.stderr, r"^regista: other\.yaml:\d+:\d+: warning: .* no role plays the ball: [^\n]*\n$")
            alone = json.loads(done.stdout)
            self.assertEqual((alone["score"], alone["state_hash"]), ([home, away], state_hash))
            metrics = stored[row]
            self.assertEqual(metrics["roles"], alone["roles"])
            self.assertEqual(metrics["packets"], alone["packets"])
            done = self.run_program("match", "--from", "tournament.db", "--row", row, "--json")
            self.assertEqual((done.returncode, json.loads(done.stdout)["state_hash"]), (0, state_hash), done.stderr)
            self.assertIn(f"the same match as row {row}: hash {state_hash}", done.stderr)

    def test_a_match_is_played_again_though_its_files_were_edited_or_removed(self):
        self.play("--seed", "7", "--set", "a.utility.terms.near.params.scale=3")
        stored = self.stored("SELECT row, hash FROM matches ORDER BY row")
        self.write("small.yaml", program.TEAM.format(name="small").replace("scale: 2", "scale: 5"))
        shutil.rmtree(self.folder / "scenes")
        for row, state_hash in stored:
            done = self.run_program("match", "--from", "tournament.db", "--row", row, "--json", "--record", f"{row}.mcap")
            self.assertEqual((done.returncode, json.loads(done.stdout)["state_hash"]), (0, state_hash), done.stderr)
            self.assertRegex(done.stderr, f"row {row}: its files have changed \\(.*no such file.*\\); played as tournament.db "
                                          "holds them\n")
            self.assertIn(f"the same match as row {row}: hash {state_hash}", done.stderr)
            self.assertTrue((self.folder / f"{row}.mcap").exists())
        # Nothing is left of the copies.
        again = self.succeed("match", "--from", "tournament.db", "--row", "1", "--quiet", "--json",
                             environment={"TMPDIR": str(self.write("aside/none", "").parent)})
        self.assertEqual(json.loads(again)["state_hash"], stored[0][1])
        self.assertEqual(os.listdir(self.folder / "aside"), ["none"])
        # Nor does it matter where copies are laid out.
        done = self.run_program("match", "--from", "tournament.db", "--row", "1", environment={"TMPDIR": "aside"})
        self.assertIn(f"the same match as row 1: hash {stored[0][1]}", done.stderr)
        self.assertEqual(os.listdir(self.folder / "aside"), ["none"])
        for recording in self.folder.glob("*.mcap"):
            self.assertNotIn(b"regista-", recording.read_bytes().replace(str(self.folder).encode(), b""))
        # No copy is kept of plugins.
        with (self.plugin_folder / program.SOUND.name).open("ab") as plugin:
            plugin.write(b"more")
        line = self.refused("match", "--from", "tournament.db", "--row", "1")
        self.assertIn("--row 1: was played with something else: plugin ", line)
        self.assertRegex(line, r"something else: plugin [a-z_]+ \(\S+\) has changed, plugin [^;]* has changed; as things ")
        self.assertNotIn("yaml has changed", line)

    def test_what_documents_name_is_kept_with_them(self):
        """Files that a team extends, and those of parameters, the opponent's too."""
        plugins = program.PROGRAM.parent.parent / "lib/regista/plugins"
        for each in program.BEHAVIOURS:
            (self.plugin_folder / each.name).unlink()  # they are there too
        configs = program.SOURCE / "configs"
        for folder in ("teams", "formations"):
            shutil.copytree(configs / folder, self.folder / folder)
        self.write("formation.yaml", "extends: teams/formation.yaml\nteam: mine\n")
        (self.folder / "mine.yaml").symlink_to("formation.yaml")
        self.succeed("tournament", "--team", "mine.yaml", "--team", self.folder / "formation.yaml", "--set",
                     "a.tasks.offset.at_most=1", "--pairs", 1, "--limit", 5, "--plugins", plugins, "--no-page", "--quiet")
        state_hash = self.stored("SELECT hash FROM matches ORDER BY row")[1][0]
        again = lambda: self.run_program("match", "--from", "tournament.db", "--row", "2").stderr
        self.assertNotIn("have changed", again())
        with (self.folder / "teams/paper.yaml").open("a") as team:
            team.write("summary: another\ncontexts: ~\n")
        self.assertIn(f"the same match as row 2: hash {state_hash}", again())
        shutil.rmtree(self.folder / "formations")
        shutil.rmtree(self.folder / "teams")
        (self.folder / "formation.yaml").unlink()
        said = again()
        self.assertIn("row 2: its files have changed (", said)
        self.assertIn(f"the same match as row 2: hash {state_hash}", said)
        # Damaged documents are no obstacle to what needs none.
        self.change("UPDATE documents SET size = size + 1", mend=False)
        self.assertIn("tournament.db are damaged: the checksum of the document /", again())

    def test_the_report_counts_the_rows(self):
        report = self.only(pairs=12)
        goals = [0, 0]
        outcomes = {"wins": 0, "draws": 0, "losses": 0}
        pentanomial = [0] * 5
        scores = {}
        for row, seed, home, away in self.stored("SELECT row, seed, home_goals, away_goals FROM matches"):
            mine, theirs = (home, away) if row % 2 == 1 else (away, home)
            goals[0] += mine
            goals[1] += theirs
            outcome = "wins" if mine > theirs else "losses" if mine < theirs else "draws"
            outcomes[outcome] += 1
            scores.setdefault(seed, []).append({"wins": 2, "draws": 1, "losses": 0}[outcome])
        for points in scores.values():
            self.assertEqual(len(points), 2)
            pentanomial[sum(points)] += 1
        self.assertTrue(all(outcomes.values()), outcomes)  # else this test would show little
        self.assertGreater(sum(count > 0 for count in pentanomial), 1)
        self.assertEqual({key: report[key] for key in outcomes}, outcomes)
        self.assertEqual((report["goals"], report["pentanomial"]), (goals, pentanomial))
        self.assertEqual((report["games"], report["matches"], report["pairs"], report["first_seed"]), (24, 24, 12, 1))
        self.assertEqual([team["name"] for team in report["teams"]], ["small", "other"])
        self.assertEqual((report["forfeits"], report["set_aside"], report["verdict"]), ([], [], None))

    def test_the_report_in_words(self):
        text = self.play(pairs=4)
        report = self.only("--resume", pairs=4)
        self.assertTrue(text.startswith("Tournament: small vs other (4 pairs, seeds from 1, 2 scenes of about 10 s)\n"), text)
        self.assertIn(f"Games: 8, Wins: {report['wins']}, Losses: {report['losses']}, Draws: {report['draws']}, ", text)
        self.assertIn(f"Ptnml(0-2): {report['pentanomial']}\n", text)
        self.assertIn(f"Goals: {report['goals'][0]}:{report['goals'][1]}, per scene ", text)

    def test_one_and_two_and_four_workers_say_the_same(self):
        one = self.play("--workers", "1", "--results", "1.db", pairs=6)
        for workers in ("2", "4"):
            self.assertEqual(self.play("--workers", workers, "--results", f"{workers}.db", pairs=6), one)
            self.assertEqual(self.rows(f"{workers}.db"), self.rows("1.db"))

    def test_equal_teams(self):
        teams = ("small.yaml", "small.yaml")
        report = self.only(teams=teams)
        self.assertTrue(report["equal_teams"])
        self.assertEqual([team["name"] for team in report["teams"]], ["small (a)", "small (b)"])
        self.assertEqual(report["pentanomial"], [0, 0, 3, 0, 0])
        self.assertGreater(report["wins"], 0)
        # Each is played once, for both places that it has in the schedule.
        self.assertEqual(self.stored("SELECT row FROM matches ORDER BY row"), [(1,), (3,), (5,)])
        text = self.play("--resume", teams=teams)
        self.assertIn("\nA/A: small (a) and small (b) are equal, so every pair is a draw by construction\n", text)
        self.assertEqual(self.succeed("report", "tournament.db"), text)
        self.assertEqual(len(self.table()), 6)

    def test_values_for_one_team(self):
        changed = ("--set", "b.utility.terms.near.params.scale=3")
        report = self.only(*changed, teams=("small.yaml", "small.yaml"), pairs=2)
        self.assertFalse(report["equal_teams"])
        jobs = [json.loads(row[0]) for row in self.stored("SELECT job FROM matches JOIN fixtures ON fixture = id "
                                                          "ORDER BY row")]
        self.assertEqual([job["overrides"] for job in jobs],
                         [["away.utility.terms.near.params.scale=3"], ["home.utility.terms.near.params.scale=3"]] * 2)

    def test_a_line_for_each_match_when_nobody_watches(self):
        done = self.run_program(*self.arguments(pairs=2))
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 7, done.stderr)
        self.assertEqual(lines.pop(0), "2 pairs cannot give a verdict: at least 6 are needed")
        for i, line in enumerate(lines[:4]):
            home, away = ("small", "other") if i % 2 == 0 else ("other", "small")
            self.assertRegex(line, rf"^match {i + 1} of 4, seed {1 + i // 2}, \w+: {home} \d+:\d+ {away}$")
        self.assertRegex(lines[4], r"^4 matches played in \d+ s, \d+\.\d\d matches/s$")
        self.assertEqual(lines[5], "page: tournament.html")
        again = self.run_program(*self.arguments("--resume", pairs=2))
        self.assertRegex(again.stderr, r"^2 pairs cannot .*\n0 matches played in \d+ s; 4 were played before\npage: tournament\.html\n$")

    def test_a_gone_reader_or_full_disk_loses_no_match(self):
        with open("/dev/full", "w") as full:
            done = self.run_program(*self.arguments("--quiet"), stdout=full)
        self.assertEqual(done.returncode, 1)
        self.assertIn("cannot write to standard output", done.stderr)
        self.assertEqual(len(self.rows()), 6)


class Documents(tournament.Tournament):
    PAGE = """tournament: night
question: Which of them is better?
teams: [{team: small.yaml}, {team: other.yaml}]
pairs: 3
openings: scenes
seed: 7
set: {a.utility.terms.near.params.scale: 3}
seeds: consecutive
"""

    def test_a_document_says_what_options_say(self):
        self.write("night.yaml", self.PAGE)
        self.play("--seed", "7", "--set", "a.utility.terms.near.params.scale=3")
        by_document = self.succeed("tournament", "night.yaml", "--quiet", "--no-page")
        title, question, rest = by_document.split("\n", 2)
        self.assertEqual(question, "night: Which of them is better?")
        self.assertEqual(f"{title}\n{rest}", self.succeed("report", "tournament.db"))
        # So do options that are laid over another document, each in the place of what that says.
        self.write("other_night.yaml", self.PAGE.replace("seed: 7", "seed: 9").replace("pairs: 3", "pairs: 5")
                   .replace("openings: scenes", "openings: scenes/left.yaml"))
        words = ("tournament", "other_night.yaml", "--seed", "7", "--pairs", "3", "--openings", "scenes", "--results", "laid.db")
        self.assertEqual(self.succeed(*words, "--quiet", "--no-page"), by_document)
        report = json.loads(self.succeed("report", "night.db", "--json"))
        self.assertEqual((report["tournament"], report["question"]), ("night", "Which of them is better?"))
        self.assertEqual(self.rows("night.db"), self.rows())
        # Values can be laid over it; where it stops, it goes on.
        more = ("tournament", "night.yaml", "--set", "pairs=4", "--results", "more.db", "--quiet", "--no-page", "--json")
        self.assertEqual(json.loads(self.succeed(*more))["pairings"][0]["games"], 8)
        self.assertEqual(self.succeed("tournament", "night.yaml", "--resume", "--quiet", "--no-page"), by_document)
        self.assertIn("pairs: was 3, now 2",
                      self.refused("tournament", "night.yaml", "--set", "pairs=2", "--resume", "--quiet"))

    def test_every_key_means_its_option(self):
        rules, robot, wind = ("rules.yaml", "extends: {}/rules/spl2023.yaml\nrules: own\n"), \
            ("robot.yaml", "extends: {}/robots/nao.yaml\nrobot: own\n"), \
            ("wind.yaml", "disturbance: wind\nradio: {{loss: 0.2}}\n")
        for name, text in (rules, robot, wind):
            self.write(name, text.format(program.SOURCE / "configs"))
        common = ("--seed", "5", "--limit", "3", "--rules", "rules.yaml", "--robot", "robot.yaml", "--disturbance", "wind.yaml",
                  "--failures-in-a-row", "4", "--isolation", "always", "--play-once", "--seeds", "consecutive")
        keys = "seed: 5\nlimit: 3\nrules: rules.yaml\nrobot: robot.yaml\ndisturbance: wind.yaml\n" \
               "failures_in_a_row: 4\nisolation: always\nplay_twice: false\nseeds: consecutive\n"
        two, three = ("small.yaml", "other.yaml"), ("small.yaml", "other.yaml", "worse.yaml")
        for teams, options, page in (
                (three, ("--format", "gauntlet", "--pairs", "1"), "format: gauntlet\npairs: 1\n"),
                (two, ("--sprt=-3,8", "--model", "logistic", "--alpha", "0.04", "--beta", "0.2", "--pairs", "1"),
                 "test: {elo: [-3, 8], model: logistic, alpha: 0.04, beta: 0.2}\npairs: 1\n"),
                (two, ("--metric", "goals", "--alpha", "0.01", "--pairs", "2"), "test: {metric: goals, alpha: 0.01}\npairs: 2\n")):
            plans = []
            self.write("page.yaml", "tournament: page\nteams: [" + ", ".join(f"{{team: {team}}}" for team in teams) + "]\n"
                       + page + keys)
            for words in ([word for team in teams for word in ("--team", team)] + [*options, *common], ["page.yaml"]):
                self.succeed("tournament", *words, "--results", f"{len(plans)}.db", "--quiet", "--no-page")
                plans.append(json.loads(self.stored("SELECT value FROM meta WHERE name = 'schedule'", f"{len(plans)}.db")[0][0]))
                (self.folder / f"{len(plans) - 1}.db").unlink()
            plans[1]["document"] = plans[1]["document"].replace("tournament: page", "tournament: tournament")
            self.assertEqual(*plans)

    def test_mistakes_of_a_document_are_told_with_their_place(self):
        def told(old, new, *more):
            self.assertIn(old, self.PAGE)
            self.write("bad.yaml", self.PAGE.replace(old, new))
            line = self.refused("tournament", "bad.yaml", *more)
            checked = self.run_program("config", "check", "bad.yaml")
            self.assertEqual((checked.returncode, checked.stderr), (2, f"regista: {line}\n"))
            return line
        self.assertIn("bad.yaml:3:8: teams: ", told(", {team: other.yaml}", ""))
        self.assertIn('nearest: "other.yaml"', told("team: other.yaml", "team: othr.yaml"))
        self.assertIn("bad.yaml:4:16: unknown metric", told("pairs: 3", "test: {metric: no_such}\npairs: 3"))
        self.assertIn("bad.yaml:4:16: test: expected exactly one of",
                      told("pairs: 3", "test: {metric: goals, elo: [0, 20]}\npairs: 3"))
        self.assertIn("bad.yaml:4:16: test.metric: expected", told("pairs: 3", "test: {metric: ''}\npairs: 3"))
        self.assertIn("bad.yaml:4:13: test.elo: the first must be the smaller", told("pairs: 3", "test: {elo: [20, 20]}"))
        self.assertIn("test.model: belongs to elo", told("pairs: 3", "test: {metric: goals, model: logistic}\npairs: 3"))
        self.assertIn("bad.yaml:7:7: opening.ball.x: there is no opening",
                      told("openings: scenes\nseed: 7\nset: {a.utility.terms.near.params.scale", "seed: 7\n\nset: {opening.ball.x"))
        (self.folder / "none").mkdir()
        self.assertIn("bad.yaml:5:11: openings", told("openings: scenes", "openings: none"))
        self.assertIn("bad.yaml:5:20: openings: scenes/left.yaml is given twice",
                      told("openings: scenes", "openings: [scenes, scenes/left.yaml]"))
        self.assertIn('bad.yaml:7:42: a.utility.terms.near.params.scale: parameter "scale" of plugin nearness: "large" is not a number', told("scale: 3", "scale: large"))
        self.assertIn("bad.yaml:7:7: home.x: in a tournament each team plays on both sides",
                      told("a.utility.terms.near.params.scale", "home.x"))
        self.assertIn("bad.yaml:7:7: a.utility.terms.near.params.scal: unknown parameter ",
                      told("a.utility.terms.near.params.scale", "a.utility.terms.near.params.scal"))
        # A document and an option that cannot both be; an option of another study.
        self.write("night.yaml", self.PAGE.replace("pairs: 3", "pairs: 3\ntest: {metric: goals}"))
        self.assertIn("--sprt 0,20: test: expected exactly one of elo, metric; metric is there already (night.yaml:5:8)",
                      self.refused("tournament", "night.yaml", "--sprt", "0,20"))
        self.assertIn("--team small.yaml: teams: 1 elements; expected 2", self.refused("tournament", "night.yaml", "--team",
                                                                                       "small.yaml"))
        self.assertIn("`regista experiment` has one", self.refused("tournament", "night.yaml", "--game-minutes", "3"))
        self.assertFalse((self.folder / "bad.db").exists() or (self.folder / "night.db").exists())


class Changes(tournament.Tournament):
    def change(self, *more):
        return self.refused(*self.arguments("--quiet", "--resume", *more))

    def test_what_has_changed_is_named(self):
        self.play()
        rows = self.rows()
        self.assertIn("pairs: was 3, now 4", self.refused(*self.arguments("--quiet", "--resume", pairs=4)))
        self.assertIn("seed: was 1, now 2", self.change("--seed", "2"))
        self.assertIn("limits.processor_seconds: was 10, now 7", self.change("--processor-seconds", "7"))
        line = self.change("--set", "rules.durations.set=2")
        self.assertIn("set.rules.durations.set: was none, now 2, ", line)
        self.assertIn("rules spl2023 has changed", line)
        self.assertIn("team other: team other.yaml has changed", self.change("--set", "b.teammates_forgotten_after=20"))
        plugin = self.plugin_folder / program.SOUND.name
        sound = plugin.read_bytes()
        plugin.unlink()
        plugin.write_bytes(sound + b"\0")
        self.assertRegex(self.change(), r"team small: plugin \w+ \([^)]*contract_good\.so\) has changed")
        plugin.unlink()
        plugin.write_bytes(sound)
        content = self.program.read_bytes()
        self.program.unlink()
        self.program.write_bytes(content + b"\0")
        self.program.chmod(0o755)
        self.assertRegex(self.change(), r"was begun with something else: program has changed; ")
        self.assertEqual(self.rows(), rows)

    def test_comments_are_no_change(self):
        before = self.play()
        text = (self.folder / "small.yaml").read_text()
        self.write("small.yaml", "# A comment.\n\n" + text)
        self.assertEqual(self.play("--resume"), before)

    def test_a_plugin_that_is_replaced_while_it_plays(self):
        arguments = self.arguments("--workers", "1", pairs=400)
        with self.start(*arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            for _ in range(3):
                process.stderr.readline()
            plugin = self.plugin_folder / program.SOUND.name
            shutil.copy2(plugin, self.folder / "copy")
            with open(self.folder / "copy", "ab") as copy:
                copy.write(b"\0")
            os.replace(self.folder / "copy", plugin)
            out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (2, ""))
        self.assertRegex(err.splitlines()[-1], r"^regista: while the tournament was played: plugin .* has changed")


class BadInput(tournament.Tournament):
    def test_what_cannot_be_asked_for(self):
        ask = lambda *more, **options: self.refused(*self.arguments(*more, **options))
        self.assertIn("expected a document, or two teams or more", self.refused("tournament"))
        self.assertIn("--team small.yaml: teams: 1 elements; expected 2 to 1000", ask(teams=("small.yaml",)))
        self.assertIn("nobody.yaml", ask(teams=("small.yaml", "nobody.yaml")))
        self.assertIn("tournament: pairs: how many are played?", self.refused("tournament", "--team", "small.yaml", "--team", "other.yaml"))
        for pairs in ("0", "-1", "1.5", "many"):
            self.assertIn(f"--pairs {pairs}: pairs: ", self.refused("tournament", "--team", "small.yaml", "--team",
                                                                      "other.yaml", f"--pairs={pairs}"))
        self.assertIn("--workers: ", ask("--workers", "0"))
        self.assertIn("--seed", ask("--seed", "18446744073709551615"))
        self.assertIn("--processor-seconds 0: limits.processor_seconds: ", ask("--processor-seconds", "0"))
        self.assertIn("--memory 1: limits.memory: ", ask("--memory", "1"))
        self.assertIn("begin the path with a for the first team", ask("--set", "home.teammates_forgotten_after=20"))
        self.assertIn("--set a.no_such", ask("--set", "a.no_such=1"))
        self.assertIn("small letters", ask("--set", "A.no_such=1"))
        self.assertIn("expected a path inside it, as in a.", ask("--set", "a=1"))
        self.assertIn("a tournament has no opponent", ask("--set", "opponent.sender=1"))
        self.assertIn("--seed 9007199254740993: seed: ", ask("--seed", "9007199254740993"))
        self.assertIn("would never stop", self.refused("tournament", "--team", "small.yaml", "--team", "small.yaml",
                                                       "--sprt", "0,10"))
        self.assertIn("--set c.x=1: c.x: there are 2 teams, a to b", ask("--set", "c.x=1"))
        self.assertIn('--format gauntled: format: unknown value "gauntled"; nearest: "gauntlet"', ask("--format", "gauntled"))
        self.assertIn("--failures-in-a-row -1: failures_in_a_row: ", ask("--failures-in-a-row", "-1"))
        self.assertFalse((self.folder / "tournament.db").exists())

    def test_files_of_results(self):
        ask = lambda *more: self.refused(*self.arguments("--quiet", *more))
        self.assertIn("tournament.db: no such file; without --resume it is begun", ask("--resume"))
        self.assertIn("No such file", ask("--results", "no/such/folder.db"))
        self.play()
        self.assertIn("exists already; --resume continues it", ask())
        self.write("text.db", "not a database" * 100)
        self.assertIn("text.db: is no database", ask("--results", "text.db", "--resume"))
        sqlite3.connect(self.folder / "other.db").execute("CREATE TABLE matches(row)").connection.close()
        self.assertIn("is a database of another program", ask("--results", "other.db", "--resume"))
        with sqlite3.connect(self.folder / "tournament.db") as database:
            database.execute("PRAGMA user_version=99")
        database.close()
        self.assertIn("was written by a newer Regista", ask("--resume"))

    def test_a_file_that_another_process_has(self):
        with self.start(*self.arguments("--workers", 1, pairs=400), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as other:
            try:
                other.stderr.readline()  # it plays
                self.assertIn("in use by another process", self.refused(*self.arguments("--quiet", "--resume")))
            finally:
                other.kill()
                other.communicate()

    def test_the_worker_is_no_command_for_people(self):
        self.assertIn("is for the program itself", self.refused("play-one"))
        self.assertNotIn("play-one", self.succeed("--help"))
        self.assertNotIn("play-one", self.refused("no-such-command"))


class Interruption(tournament.Tournament):
    def test_a_signal_that_was_to_be_ignored_is_ignored(self):
        """As nohup does, and shells for what runs in the background."""
        ignore = lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN)
        with self.start(*self.arguments("--workers", "1"), stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                        preexec_fn=ignore) as process:
            process.stderr.readline()
            process.send_signal(signal.SIGHUP)
            out, err = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 0, err)
        self.assertIn("Tournament: small vs other", out)

    def test_a_report_is_not_lost_with_standard_error(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([str(self.program), *map(str, self.arguments())], cwd=self.folder, text=True,
                                  stdout=subprocess.PIPE, stderr=full)
        self.assertEqual(done.returncode, 0)
        self.assertIn("Tournament: small vs other", done.stdout)

    def test_ctrl_c_says_how_to_go_on(self):
        arguments = self.arguments("--workers", "2", pairs=400)
        with self.start(*arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            process.stderr.readline()
            asked = time.monotonic()
            process.send_signal(signal.SIGINT)
            out, err = process.communicate(timeout=30)
            self.assertLess(time.monotonic() - asked, 2.0)
        self.assertEqual((process.returncode, out), (130, ""))
        last = err.splitlines()[-1]
        self.assertRegex(last, r"^regista: interrupted after \d+ of 800 matches; to go on: ")
        again = shlex.split(last.split("to go on: ")[1])
        self.assertEqual(again, [str(self.program), *map(str, arguments), "--resume"])
        self.assertGreater(len(self.rows()), 0)


if __name__ == "__main__":
    unittest.main()
