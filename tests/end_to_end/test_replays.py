# SPDX-License-Identifier: MIT
"""From a verdict to the match: the matches that a page lists, `regista report --replays` and `regista view --row`, and
the page of a study that is still played."""

import base64
import contextlib
import csv
import html.parser
import io
import json
import os
import re
import signal
import sqlite3
import subprocess
import time
import unittest

import zstandard

import experiment
import program
import recorded
import results_file
import test_tune
import tournament

VIEWER = ('<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>Regista</title></head><body>'
          '<script id="recording" data-name="@REGISTA_RECORDING_NAME@">@REGISTA_RECORDING@</script></body></html>')
DEATHS = program.TEST_PLUGINS / "deaths"
LIMITS = ("--processor-seconds", "1", "--memory", "512")


class Tables(html.parser.HTMLParser):
    """The section "matches" of a page: rows of cells of its tables, and its links."""

    def __init__(self, text):
        super().__init__()
        self.rows, self.links, self.cell = [], [], None
        self.feed(text[text.index('<section id="matches">'):text.index("</section>", text.index('id="matches"'))])

    @property
    def all(self):
        """Those of the second table, which has every match."""
        return [row for row in self.rows if row and row[0].isdigit()]

    def handle_starttag(self, tag, attrs):
        if tag == "tr":
            self.rows.append([])
        if tag == "td":
            self.rows[-1].append("")
            self.cell = True
        if tag == "a":
            self.links.append(dict(attrs)["href"])

    def handle_endtag(self, tag):
        if tag == "td":
            self.cell = None

    def handle_data(self, data):
        if self.cell:
            self.rows[-1][-1] += data


class Replays(tournament.Tournament):
    def setUp(self):
        super().setUp()
        self.write("share/regista/viewer.html", VIEWER)

    def text(self, name="tournament.html"):
        return (self.folder / name).read_text()

    def recording_in(self, name):
        """What a page plays back, and what it calls it."""
        page = self.text(name)
        found = re.search(r'<script id="recording" data-name="([^"]*)">([A-Za-z0-9+/=]*)</script>', page)
        return base64.b64decode(found[2]), found[1]

    def telling(self, most):
        """Rows, by the table that `regista report --csv` writes."""
        queues = {"forfeit": []}
        for match in self.table():
            row, home, away = int(match["row"]), int(match["home_goals"]), int(match["away_goals"])
            if match["forfeited_by"]:
                queues["forfeit"].append((0, 0, row))
            elif home != away:
                winner = match["home"] if home > away else match["away"]
                queues.setdefault(winner, []).append((-abs(home - away), min(home, away), row))
        wins = sorted(sorted(queue) for name, queue in queues.items() if name != "forfeit")
        order, turn = [], 0
        while len(order) < most and any(len(queue) > turn for queue in [*wins, queues["forfeit"]]):
            order += [sorted(queue)[turn][2] for queue in [*wins, queues["forfeit"]] if len(queue) > turn]
            turn += 1
        return order[:most]

    def again(self, *more, code=0, file="tournament.db"):
        done = self.run_program("report", file, "--replays", *more)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def test_the_page_lists_every_match(self):
        self.pages = True
        self.play(pairs=4)
        tables = Tables(self.text())
        matches = self.table()
        expected = [[match["row"], f"{match['home']} – {match['away']}", f"{match['home_goals']}:{match['away_goals']}",
                     match["seed"], match["opening"]] for match in matches]
        self.assertEqual(tables.all, expected)
        clearest = [row for row in tables.rows if row and row[0].startswith("won by ")]
        for team in ("small", "other"):
            wins = sorted((-abs(int(match["home_goals"]) - int(match["away_goals"])),
                           min(int(match["home_goals"]), int(match["away_goals"])), int(match["row"]))
                          for match in matches
                          if int(match["home_goals"]) != int(match["away_goals"]) and
                          match["home" if int(match["home_goals"]) > int(match["away_goals"]) else "away"] == team)
            self.assertEqual([int(row[1]) for row in clearest if row[0] == f"won by {team}"],
                             [row for _, _, row in wins[:5]])

    def test_the_most_telling_matches_are_played_again_and_linked(self):
        self.play(pairs=4)
        done = self.again("3")
        rows = self.telling(3)
        self.assertEqual(len(rows), 3)
        lines = done.stdout.splitlines()
        self.assertEqual([int(re.match(r"row (\d+): ", line)[1]) for line in lines[:-1]], rows)
        for row, line in zip(rows, lines):
            self.assertTrue(line.endswith(f", the same match: tournament.replays/{row}.html"), line)
        self.assertEqual(lines[-1], "page: tournament.html")
        self.assertRegex(done.stderr, r"^3 matches are played again: about \d+ s, by the time that the study took\n"
                                      r"by the first one, about \d+ s more\n$")
        links = Tables(self.text()).links
        self.assertEqual({link.split("#")[0] for link in links}, {f"./tournament.replays/{row}.html" for row in rows})
        for row in rows:
            # What is shown is the match as `regista match` records it.
            self.run_program("match", "--from", "tournament.db", "--row", row, "--quiet", "--record", f"{row}.mcap")
            data, name = self.recording_in(f"tournament.replays/{row}.html")
            self.assertEqual(recorded.Recording(data).logged, recorded.read(self.folder / f"{row}.mcap").logged)
            self.assertEqual(name, f"tournament.db, row {row}")
            # The page opens shortly before the first goal.
            goal = next(event["time"] for event in recorded.read(self.folder / f"{row}.mcap").of("/event")
                        if event["event"] == "goal")
            opens = next((float(link.split("#t=")[1]) for link in links if f"/{row}.html#t=" in link), 0.0)
            self.assertAlmostEqual(opens, max(0.0, goal - 4.0), delta=0.011)
        # The same page again, and from elsewhere.
        page = self.text()
        self.succeed("report", "tournament.db", "-o", "again.html")
        self.assertEqual(self.text("again.html"), page)
        self.succeed("report", "tournament.db", "-o", "bin/page.html")
        self.assertIn(f'href="../tournament.replays/{rows[0]}.html', self.text("bin/page.html"))

    def test_a_match_that_comes_out_otherwise_is_shown_as_such(self):
        self.play()
        row = self.telling(1)[0]
        stored = self.table()[row - 1]["state_hash"]
        self.change(f"UPDATE matches SET hash = '0123456789abcdef' WHERE row = {row}")
        done = self.again("1", code=1)
        self.assertIn(", NOT the same match: it ended", done.stdout)
        self.assertIn(stored, done.stdout)
        self.assertIn("came out otherwise</a>", self.text())
        self.assertIn("(came out otherwise)", self.text())  # beside the headline, too
        self.assertTrue(self.recording_in(f"tournament.replays/{row}.html")[1].endswith("(came out otherwise)"))
        self.assertFalse((self.folder / f"tournament.recordings/{row}.mcap").exists())
        done = self.run_program("view", "tournament.db", "--row", row)
        self.assertEqual((done.returncode, done.stdout), (1, f"tournament.replays/{row}.html\n"))
        self.assertIn("NOT the same match", done.stderr)

    def test_a_forfeit_is_played_to_its_end(self):
        text = program.TEAM.format(name="bad").replace("robot: 1, ", "")
        self.write("bad.yaml", text.replace("plugin: ball_seen", "plugin: crashes"))
        self.succeed(*self.arguments("--quiet", "--plugins", DEATHS, *LIMITS, teams=("bad.yaml", "small.yaml"), pairs=1))
        for file in (self.folder / "tournament.recordings").iterdir():
            file.unlink()
        done = self.again("1")
        self.assertIn("row 1: bad – small, forfeited by bad, the same match: tournament.replays/1.html\n", done.stdout)
        page = self.text()
        self.assertIn("forfeit of <bdi>bad</bdi>: plugin crashes, holds: ", page)
        shown = recorded.Recording(self.recording_in("tournament.replays/1.html")[0])
        self.assertGreaterEqual(shown.of("/game")[-1]["time"], 1.7)

    def test_one_match_is_one_command(self):
        self.play()
        for expected in ("the same match", "as it was recorded"):
            done = self.run_program("view", "tournament.db", "--row", "3")
            self.assertEqual((done.returncode, done.stdout), (0, "tournament.replays/3.html\n"))
            self.assertRegex(done.stderr, rf"^regista: row 3: (small|other) \d:\d (small|other), {expected}\n$")
        self.assertEqual(recorded.Recording(self.recording_in("tournament.replays/3.html")[0]).logged,
                         recorded.read(self.folder / "tournament.recordings/3.mcap").logged)
        # A recording of another match does not count.
        self.run_program("view", "tournament.db", "--row", "4")
        recordings = self.folder / "tournament.recordings"
        (recordings / "3.mcap").write_bytes((recordings / "4.mcap").read_bytes())
        self.assertIn("the same match", self.run_program("view", "tournament.db", "--row", "3").stderr)
        self.assertNotEqual((recordings / "3.mcap").read_bytes(), (recordings / "4.mcap").read_bytes())
        # To another place, from another folder.
        done = self.run_program("view", "../tournament.db", "--row", "3", "-o", "x.html", cwd=self.folder / "bin")
        self.assertEqual((done.returncode, done.stdout), (0, "x.html\n"), done.stderr)
        self.assertTrue((self.folder / "bin/x.html").exists())

    def test_documents_that_have_changed_are_those_of_the_results(self):
        self.play()
        self.write("small.yaml", program.TEAM.format(name="small").replace("shift: [0.4, 0]", "shift: [0.5, 0]"))
        done = self.run_program("view", "tournament.db", "--row", "1")
        self.assertEqual(done.returncode, 0)
        self.assertIn("files have changed", done.stderr)
        self.assertIn("the same match", done.stderr)

    def test_stored_documents_may_have_former_names(self):
        page = program.TEAM.format(name="small").replace("{at: [2, 0]}", "{at: ball, lateral: 1}")
        self.write("small.yaml", page)
        self.play(pairs=1)
        with contextlib.closing(sqlite3.connect(self.folder / "tournament.db")) as database, database:
            for path, content in database.execute("SELECT path, content FROM documents").fetchall():
                text = zstandard.ZstdDecompressor().decompressobj().decompress(content)
                former = text.replace(b"lateral: 1", b"across: 1")
                frame = zstandard.ZstdCompressor().compress(former)
                database.execute("UPDATE documents SET size = ?, content = ?, checksum = ? WHERE path = ?",
                                 (len(former), frame, results_file.checksum(path, len(former), frame), path))
                changed = former != text
                self.assertEqual(changed, path.endswith("small.yaml"))
        (self.folder / "small.yaml").unlink()
        done = self.run_program("view", "tournament.db", "--row", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("the same match", done.stderr)
        # In a page that people write it is a mistake.
        self.write("small.yaml", page.replace("lateral", "across"))
        self.assertRegex(self.refused("config", "check", "small.yaml"),
                         r"small\.yaml:\d+:\d+: .*target\.across is now lateral")

    def test_what_cannot_be(self):
        self.play(pairs=1)
        view = ("view", "tournament.db")
        self.assertEqual(self.refused(*view, "--row", "9"),
                         "--row 9: tournament.db has no such match, or matches before it are missing")
        self.assertIn("--row", self.refused(*view, "--row", "0"))
        self.assertIn("Say --row N", self.refused(*view))
        self.assertIn("--at", self.refused(*view, "--row", "1", "--at", "0:03"))
        self.assertIn("No such file", self.refused("view", "nothing.db", "--row", "1"))
        for more in (("--csv",), ("--json",), ("--study", "s"), ("--standard-error", "1")):
            self.assertIn("--replays", self.refused("report", "tournament.db", "--replays", "2", *more))
        for number in ("0", "-1", "x", "1001"):
            self.assertIn("--replays", self.refused("report", "tournament.db", "--replays", number))
        self.assertIn("of one file", self.refused("report", "tournament.db", "tournament.db", "--replays", "2"))
        (self.folder / "share/regista/viewer.html").unlink()
        self.assertIn("view: this build has no viewer page", self.refused(*view, "--row", "1"))
        self.assertIn("report: this build has no viewer page", self.refused("report", "tournament.db", "--replays", "1"))
        self.assertFalse((self.folder / "tournament.replays").exists())

    def test_without_a_win(self):
        self.play("--limit", "1", pairs=1)
        done = self.again("2")
        self.assertEqual(done.stdout, "page: tournament.html\n")
        self.assertIn("no match was won or forfeited; `regista view tournament.db --row N`", done.stderr)


class Live(tournament.Tournament):
    pages = True

    def live(self):
        """The seconds after which the page loads itself again; 0: never."""
        return int(re.search(r'<body data-live="(\d+)">', (self.folder / "tournament.html").read_text())[1])

    def test_the_page_of_a_running_study(self):
        # More than a fast machine plays in the test's time.
        with self.start(*self.arguments("--live", "--quiet", pairs=20000), stdout=subprocess.PIPE,
                        stderr=subprocess.PIPE) as process:
            self.wait_for(lambda: (self.folder / "tournament.html").exists())
            written, texts = set(), []
            while len(written) < 3:
                self.assertIsNone(process.poll(), "it ended too soon")
                state = os.stat(self.folder / "tournament.html").st_mtime_ns
                if state not in written:
                    written.add(state)
                    self.assertGreaterEqual(self.live(), 5)
                    texts.append((self.folder / "tournament.html").read_text())
                time.sleep(0.05)
            process.send_signal(signal.SIGINT)
            err = process.communicate(timeout=60)[1]
        # Seldom, and each time it says more.
        times = sorted(written)
        self.assertTrue(all(after - before >= 5e9 for before, after in zip(times, times[1:])), times)
        taken = [int(re.search(r"So far: (\d+) of 40000 matches", text)[1]) for text in texts]
        self.assertEqual(taken, sorted(set(taken)))
        self.assertIn('<noscript><meta http-equiv="refresh"', texts[0])
        # It was interrupted: it is loaded no more.
        self.assertEqual(process.returncode, 130)
        self.assertEqual(err.count("\n"), 1, err)
        self.assertEqual(self.live(), 0)

    def test_at_its_end_the_page_is_that_of_any_study(self):
        self.play("--live")
        live = (self.folder / "tournament.html").read_bytes()
        self.assertEqual(self.live(), 0)
        self.play("--results", "other.db")
        self.assertEqual(live, (self.folder / "other.html").read_bytes().replace(b"other.db", b"tournament.db"))

    def test_what_does_not_go_together(self):
        self.assertEqual(self.refused(*self.arguments("--live", "--no-page")), "--live and --no-page: one of them")

    def test_a_file_of_others_stays(self):
        self.write("tournament.html", "<html>mine</html>")
        done = self.run_program(*self.arguments("--live", "--quiet"))
        self.assertEqual(done.returncode, 0)
        self.assertIn("stays", done.stderr)
        self.assertEqual((self.folder / "tournament.html").read_text(), "<html>mine</html>")


class Experiments(experiment.Experiment):
    pages = True

    def test_arms_are_listed_and_their_matches_are_shown(self):
        self.write("share/regista/viewer.html", VIEWER)
        self.succeed(*self.arguments("--quiet", "--live"))
        rows = Tables((self.folder / "trial.html").read_text()).all
        self.assertEqual({name for row in rows for name in row[1].split(" – ")}, {"at the ball", "beside it", "worse"})
        done = self.run_program("view", "trial.db", "--row", "5")
        self.assertEqual((done.returncode, done.stdout), (0, "trial.replays/5.html\n"), done.stderr)
        self.succeed("report", "trial.db", "-o", "trial.html", "--force")
        self.assertIn("./trial.replays/5.html",
                      [link.split("#")[0] for link in Tables((self.folder / "trial.html").read_text()).links])


class Tunings(test_tune.Tuning):
    pages = True

    def test_matches_of_all_stages_are_shown(self):
        self.write("share/regista/viewer.html", VIEWER)
        self.document(matches=24)
        self.succeed(*self.arguments("--quiet", "--live"))
        page = (self.folder / "trial.html").read_text()
        rows = Tables(page).all
        self.assertEqual([int(row[0]) for row in rows], list(range(1, len(rows) + 1)))
        for row in rows:
            self.assertIn("tuned values", row[1].split(" – "))
        # Of the search, and of the last stage.
        for row in (1, len(rows)):
            done = self.run_program("view", "trial.db", "--row", row)
            self.assertEqual((done.returncode, done.stdout), (0, f"trial.replays/{row}.html\n"), done.stderr)


if __name__ == "__main__":
    unittest.main()
