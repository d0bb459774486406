# SPDX-License-Identifier: MIT
"""The page of a tournament: `regista report -o`, and what `regista tournament` writes at its end."""

import base64
import csv
import hashlib
import html.parser
import io
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import unittest
import urllib.parse
import xml.etree.ElementTree

import tournament

THREE = ("small.yaml", "worse.yaml", "other.yaml")
NOBODY = 65534
HOSTILE = "</title></style><script>alert(1)</script>\"'>"
# Elements without an end, and those of a picture that may have none.
VOID = {"meta", "br", "wbr", "img", "link", "input", "hr"}


class Page(html.parser.HTMLParser):
    """A page as a reader that nobody here wrote understands it."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.elements, self.open, self.wrong, self.text = [], [], [], []
        self.feed(text)
        self.close()
        self.wrong += self.open

    def handle_starttag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag, attrs):
        self.elements.append((tag, dict(attrs)))

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.wrong.append(tag)

    def handle_data(self, data):
        self.text.append((self.open[-1] if self.open else None, data))

    def of(self, tag):
        return [attributes for name, attributes in self.elements if name == tag]

    def whole(self):
        return "".join(data for tag, data in self.text if tag not in ("style", "script"))


class Pages(tournament.Tournament):
    pages = True

    def page(self, name="tournament.html"):
        page = Page((self.folder / name).read_text())
        self.assertEqual(page.wrong, [])
        # One script, and the page allows no other.
        self.assertEqual(len(page.of("script")), 1)
        script = "".join(data for tag, data in page.text if tag == "script")
        digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
        policy = [meta["content"] for meta in page.of("meta") if meta.get("http-equiv") == "Content-Security-Policy"]
        self.assertEqual(policy, ["default-src 'none'; style-src 'unsafe-inline'; img-src data:; "
                                  f"script-src 'sha256-{digest}'"])
        ids = [attributes["id"] for _, attributes in page.elements if "id" in attributes]
        self.assertEqual(len(ids), len(set(ids)))
        for tag, attributes in page.elements:
            self.assertNotIn(tag, ("iframe", "object", "embed", "img", "link", "form", "base"))
            for name, value in attributes.items():
                self.assertFalse(name.startswith("on"), (tag, name))
                if name in ("href", "src", "xlink:href"):
                    self.assertTrue(value.startswith(("#", "data:text/csv", ".")), value)
                if name == "href" and value.startswith("#"):
                    self.assertIn(value[1:], ids)
        return page

    def tables(self, page):
        """Every table that can be taken away, by the name of its file."""
        prefix = "data:text/csv;charset=utf-8,"
        return {link["download"]: urllib.parse.unquote(link["href"].removeprefix(prefix))
                for link in page.of("a") if "download" in link}

    def test_says_what_the_report_says(self):
        self.play(pairs=6)
        page, report = self.page(), self.report("--resume", pairs=6)
        pairing = report["pairings"][0]
        text = page.whole()
        self.assertIn(f"{pairing['goals'][0]} : {pairing['goals'][1]}", text)
        self.assertIn(f"{pairing['wins']} – {pairing['draws']} – {pairing['losses']}", text)
        self.assertEqual(len(page.of("svg")), 5)
        tables = self.tables(page)
        self.assertEqual(set(tables), {f"{name}.csv" for name in ("elo", "value", "goal_differences", "roles", "packets")})
        elo = list(csv.DictReader(io.StringIO(tables["elo.csv"])))
        self.assertEqual([int(row["pair"]) for row in elo], [1, 2, 3, 4, 5, 6])
        self.assertAlmostEqual(float(elo[-1]["elo"]), pairing["elo"], places=9)
        goals = list(csv.DictReader(io.StringIO(tables["goal_differences.csv"])))
        self.assertEqual(sum(int(row["played"]) + int(row["forfeited"]) for row in goals), 12)
        table = self.table("--metrics")
        mean = sum(float(row["home.striker.overlap_seconds" if row["home"] == "small" else "away.striker.overlap_seconds"])
                   for row in table) / len(table)
        roles = {row["role"]: row for row in csv.DictReader(io.StringIO(tables["roles.csv"]))}
        self.assertAlmostEqual(float(roles["striker"]["small overlap_seconds"]), mean, places=9)
        # The teams differ in the striker's target, and in nothing else but their names.
        self.assertIn("roles.playing[striker].target.shift", text)
        self.assertIn("first_free", text)
        self.assertNotIn("wall", text)

    def test_is_the_same_for_any_number_of_workers_and_written_again(self):
        pages = []
        for workers, name in ((1, "one"), (2, "two")):
            self.play("--workers", workers, "--results", f"{name}.db", pairs=4)
            # The commands that play it again name the results.
            pages.append((self.folder / f"{name}.html").read_bytes().replace(b"two.db", b"one.db"))
        self.succeed("report", "one.db", "-o", "again.html")
        pages.append((self.folder / "again.html").read_bytes())
        self.assertEqual(pages[0], pages[1])
        self.assertEqual(pages[0], pages[2])

    def test_formats_and_tests(self):
        for number, (more, options) in enumerate((
                ((), dict(teams=THREE, pairs=3)), (("--format", "gauntlet"), dict(teams=THREE, pairs=3)),
                (("--sprt", "0,200"), dict(teams=("small.yaml", "worse.yaml"), pairs=200)),
                (("--metric", "goals"), dict(pairs=3)), (("--metric", "overlap_seconds"), dict(pairs=3)),
                ((), dict(pairs=1)), ((), dict(teams=("small.yaml", "small.yaml"), pairs=2)))):
            self.play(*more, "--results", f"{number}.db", **options)
            self.page(f"{number}.html")
        self.assertIn("llr.csv", self.tables(self.page("2.html")))
        self.assertIn("small is stronger than worse.", self.page("2.html").whole())
        self.assertIn("against 2 others", self.page("1.html").whole())
        self.assertIn("No difference was found between 3 teams", self.page("0.html").whole())
        self.assertIn("are the same team", self.page("6.html").whole())

    def test_a_tournament_tells_where_its_page_is(self):
        done = self.run_program(*self.arguments(pairs=1, ), "--results", "a.db")
        self.assertEqual(done.returncode, 0)
        self.assertTrue(done.stderr.endswith("page: a.html\n"), done.stderr)
        self.play("--results", "b.db", "--no-page", pairs=1)
        self.assertFalse((self.folder / "b.html").exists())
        self.play("--results", "c", pairs=1)
        self.page("c.html")
        self.play("--results", "d.html", pairs=1)  # the results, however they are called
        self.page("d.html.html")
        self.assertEqual(self.count("d.html"), 2)

    def test_a_tournament_replaces_its_own_page_and_no_other_file(self):
        self.play(pairs=2)
        whole = (self.folder / "tournament.html").read_text()
        self.write("tournament.html", whole[:600])
        self.play("--resume", pairs=2)
        self.assertEqual((self.folder / "tournament.html").read_text(), whole)
        for other in ("<html>mine</html>", ""):
            self.write("tournament.html", other)
            done = self.run_program(*self.arguments("--quiet", "--resume", pairs=2))
            self.assertEqual((done.returncode, done.stderr), (
                0, "regista: no page was written: Regista did not write tournament.html, so the file stays\n"))
            self.assertIn("Tournament: small vs other", done.stdout)
            self.assertEqual((self.folder / "tournament.html").read_text(), other)
        for make in (os.mkdir, os.mkfifo):
            (self.folder / "tournament.html").unlink()
            make(self.folder / "tournament.html")
            done = self.run_program(*self.arguments("--quiet", "--resume", pairs=2))
            self.assertEqual((done.returncode, done.stderr.count("\n")), (0, 1))
            if make is os.mkdir:
                (self.folder / "tournament.html").rmdir()
                self.write("tournament.html", "")

    def test_an_interrupted_tournament_has_none(self):
        with self.start(*self.arguments("--quiet", "--workers", "1", pairs=400), stdout=subprocess.DEVNULL,
                        stderr=subprocess.DEVNULL) as process:
            self.wait_for(lambda: self.count() >= 3)
            process.send_signal(signal.SIGINT)
            process.wait(timeout=20)
        self.assertEqual(process.returncode, 130)
        self.assertFalse((self.folder / "tournament.html").exists())
        done = self.run_program("report", "tournament.db", "-o", "so far.html")
        self.assertEqual(done.returncode, 0)
        self.assertIn("the tournament is not at its end", done.stderr)
        self.assertIn("Not at its end yet", self.page("so far.html").whole())

    def test_files_that_exist(self):
        self.play("--no-page", pairs=1)
        self.succeed("report", "tournament.db", "-o", "a.html")
        whole = (self.folder / "a.html").read_bytes()
        self.write("a.html", "<p>mine")
        self.assertEqual(self.refused("report", "tournament.db", "-o", "a.html"),
                         "--output a.html: exists already; --force replaces it")
        self.assertEqual((self.folder / "a.html").read_text(), "<p>mine")
        os.symlink("a.html", self.folder / "link.html")
        self.assertIn("exists already", self.refused("report", "tournament.db", "-o", "link.html"))
        self.succeed("report", "tournament.db", "-o", "link.html", "--force")
        self.assertTrue((self.folder / "link.html").is_symlink())
        self.assertEqual((self.folder / "a.html").read_bytes(), whole)
        results = (self.folder / "tournament.db").read_bytes()
        for more in ((), ("--force",)):
            self.assertIn("is a file that this report reads", self.refused("report", "tournament.db", "-o", "tournament.db", *more))
            self.assertIn("scenes", self.refused("report", "tournament.db", "-o", "scenes", *more))
            self.assertIn("/dev/null", self.refused("report", "tournament.db", "-o", "/dev/null", *more))
        self.assertEqual((self.folder / "tournament.db").read_bytes(), results)
        self.assertIn("nowhere/a.html", self.refused("report", "tournament.db", "-o", "nowhere/a.html"))
        self.assertEqual([file.name for file in self.folder.glob("*.html.*")], [])

    def test_what_does_not_go_together(self):
        self.play("--no-page", pairs=1)
        for more, line in ((("-o", "a.html", "--json"), "-o and --json"), (("-o", "a.html", "--csv"), "-o and --csv"),
                           (("--figures", "f", "--csv"), "--figures and --csv"),
                           (("--force",), "--force belongs to"), (("-o", "a.html", "--metrics"), "--metrics adds")):
            self.assertIn(line, self.refused("report", "tournament.db", *more))
        self.assertFalse((self.folder / "a.html").exists())

    def test_a_folder_that_cannot_be_written_to(self):
        self.play("--no-page", pairs=1)
        closed = self.folder / "closed"
        closed.mkdir()
        closed.chmod(0o555)
        self.folder.chmod(0o755)
        options = dict(user=NOBODY, group=NOBODY, extra_groups=[]) if os.geteuid() == 0 else {}
        for more in (("-o", "closed/a.html"), ("--figures", "closed/figures")):
            line = self.refused("report", "tournament.db", *more, **options)
            self.assertIn(more[1], line)
            self.assertIn("Permission denied", line)

    def test_a_full_disk(self):
        self.play("--no-page", pairs=1)
        full = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))
        self.write("a.html", "<p>mine")
        for more in ((), ("--force",)):
            name = "a.html" if more else "b.html"
            done = self.run_program("report", "tournament.db", "-o", name, *more, preexec_fn=full)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertEqual(done.stderr.splitlines()[-1], f"regista: cannot write to {name}: File too large")
        self.assertEqual((self.folder / "a.html").read_text(), "<p>mine")
        self.assertEqual(sorted(file.name for file in self.folder.glob("*.html*")), ["a.html"])

    def test_no_other_program_is_needed(self):
        self.play(pairs=2)
        nothing = {"PATH": str(self.folder / "scenes"), "TMPDIR": "/nowhere"}
        done = self.run_program("report", "tournament.db", "-o", "a.html", environment=nothing)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(len(self.page("a.html").of("svg")), 5)

    def test_figures_as_files(self):
        self.play(pairs=3)
        self.succeed("report", "tournament.db", "--figures", "figures")
        names = ("elo", "goal_differences", "packets", "roles", "value")
        folder = self.folder / "figures"
        self.assertEqual(sorted(file.name for file in folder.iterdir()),
                         [f"{name}{end}" for name in names for end in (".csv", ".svg")])
        tables = self.tables(self.page())
        for name in names:
            self.assertEqual((folder / f"{name}.csv").read_text(), tables[f"{name}.csv"])
            root = xml.etree.ElementTree.parse(folder / f"{name}.svg").getroot()
            self.assertEqual(root.tag, "{http://www.w3.org/2000/svg}svg")
            self.assertTrue(root.findtext("{http://www.w3.org/2000/svg}title"))
        # Bars are as high as the table says.
        counts = [int(row["played"]) for row in csv.DictReader(io.StringIO(tables["goal_differences.csv"]))]
        root = xml.etree.ElementTree.parse(folder / "goal_differences.svg").getroot()
        heights = [float(rect.get("height")) for group in root.iter("{http://www.w3.org/2000/svg}g")
                   for rect in group.findall("{http://www.w3.org/2000/svg}rect") if rect.get("height") != "12"]
        self.assertEqual(len(heights), sum(count > 0 for count in counts))
        for height, count in zip(sorted(heights), sorted(count for count in counts if count > 0)):
            self.assertAlmostEqual(height / max(heights), count / max(counts), delta=0.01)
        self.assertIn("exists already", self.refused("report", "tournament.db", "--figures", "figures"))
        self.succeed("report", "tournament.db", "--figures", "figures", "--force")

    def test_names_that_try_to_get_out(self):
        # Teams of the same name are told apart by their files, which may be called anything.
        file = "'=`id`\"<script>alert(1)<a\n\u202e%s&#60;.yaml"
        self.write(file, (self.folder / "other.yaml").read_text().replace("team: other", "team: small"))
        self.play(teams=("small.yaml", file), pairs=2)
        self.assertNotIn("\u202e", self.page().whole())
        self.assertIn("'=`id`\"<script>alert(1)<a\\n\\u202e%s&#60;.yaml", self.page().whole())
        self.assertEqual(len(self.page().of("svg")), 5)
        label = json.dumps("=" + HOSTILE + "\n\u202e").replace("'", "''")
        self.change(f"UPDATE meta SET value = json_set(value, '$.teams[1].label', json('{label}')) "
                    "WHERE name = 'schedule'")
        failure = json.dumps({"side": 1, "plugin": HOSTILE, "call": HOSTILE, "robot": 1, "tick": 2, "what": HOSTILE})
        self.change("DELETE FROM metrics WHERE row = 3")
        self.change("UPDATE matches SET ended = 'forfeit', hash = NULL, failure = '"
                    + failure.replace("'", "''") + "' WHERE row = 3")
        self.change("UPDATE metric_names SET names = replace(replace(names, '\"striker\"', '\"=a,\\\"b\\n`id`''\"'), "
                    "'\"packets_by_reason.period\"', '\"packets_by_reason.<b>\\\" %s\"')")
        self.succeed("report", "tournament.db", "-o", "a.html", "--figures", "figures")
        page = self.page("a.html")
        self.assertEqual(len(page.of("svg")), 5)
        self.assertIn(HOSTILE, page.whole())
        self.assertNotIn("\u202e", page.whole())
        self.assertEqual((self.folder / "a.html").read_text().count("<script"), 1)
        for file in (self.folder / "figures").glob("*.svg"):
            self.assertNotIn("<script", file.read_text())
        for table in self.tables(page).values():
            for row in csv.reader(io.StringIO(table)):
                for field in row:
                    self.assertTrue(not field.startswith(("=", "+", "@")), field)
        roles = list(csv.reader(io.StringIO(self.tables(page)["roles.csv"])))
        self.assertTrue(any(row[0].startswith("'=a,\u201db") for row in roles))
        self.assertEqual({len(row) for row in roles}, {7})

    def links(self, page):
        """To what stands beside the page."""
        return [link["href"] for link in page.of("a") if "download" not in link and not link["href"].startswith("#")]

    def test_links_to_recordings(self):
        self.play("--record-every", "2", pairs=2)
        (self.folder / "tournament.recordings/notes.txt").write_text("")
        self.write("tournament.recordings/x.mcap", "")
        self.write("tournament.recordings/01.mcap", "")
        self.succeed("report", "tournament.db", "-o", "a.html")
        page = self.page("a.html")
        self.assertEqual(self.links(page), ["./tournament.recordings/1.mcap", "./tournament.recordings/3.mcap"])
        self.assertNotIn("left out", page.whole())
        self.assertIn("regista view tournament.recordings/3.mcap -o tournament-3.html", page.whole())
        (self.folder / "a b").mkdir()
        self.succeed("report", "tournament.db", "-o", "a b/c.html")
        links = self.links(self.page("a b/c.html"))
        self.assertEqual(links[0], "../tournament.recordings/1.mcap")
        self.assertEqual((self.folder / "a b" / links[0]).resolve(), self.folder / "tournament.recordings/1.mcap")
        # By whatever path the results are found.
        self.succeed("report", self.folder / "tournament.db", "-o", self.folder / "b.html")
        self.assertEqual((self.folder / "b.html").read_bytes(), (self.folder / "a.html").read_bytes())

    def test_recordings_of_other_matches_are_not_linked(self):
        """Of results that were deleted, and of a match that was cut off and later played without a recording."""
        self.play("--record-every", "1", pairs=2)
        self.assertEqual(len(self.links(self.page())), 4)
        whole = (self.folder / "tournament.recordings/2.mcap").read_bytes()
        (self.folder / "tournament.recordings/2.mcap").write_bytes(whole[:len(whole) // 2])
        shutil.copy(self.folder / "tournament.recordings/1.mcap", self.folder / "tournament.recordings/3.mcap")
        self.write("tournament.recordings/99.mcap", "")
        self.succeed("report", "tournament.db", "-o", "a.html")
        page = self.page("a.html")
        self.assertEqual(self.links(page), [f"./tournament.recordings/{row}.mcap" for row in (1, 4)])
        for file in self.folder.glob("tournament.db*"):
            file.unlink()
        self.play("--seed", "100", pairs=2)
        self.assertEqual(self.links(self.page()), [])
        for file in self.folder.glob("tournament.db*"):
            file.unlink()
        self.play(teams=("worse.yaml", "other.yaml"), pairs=2)
        self.assertEqual(self.links(self.page()), [])
        # Of a team that was changed since under its name, though scores may be the same.
        for file in self.folder.glob("tournament.db*"):
            file.unlink()
        self.play("--record-every", "1", pairs=2)
        for file in self.folder.glob("tournament.db*"):
            file.unlink()
        self.play("--limit", "5", pairs=2)
        self.assertEqual(self.links(self.page()), [])

    def test_results_of_similar_names_share_nothing(self):
        self.play("--results", "b.db", "--record-every", "4", pairs=2)
        page = (self.folder / "b.html").read_bytes()
        self.play("--results", "b.sqlite", "--seed", "9", "--record-every", "4", pairs=2)
        self.assertEqual((self.folder / "b.html").read_bytes(), page)
        self.assertEqual(self.links(self.page("b.html")), ["./b.recordings/1.mcap"])
        self.assertEqual(self.links(self.page("b.sqlite.html")), ["./b.sqlite.recordings/1.mcap"])

    def test_the_command_plays_it_again(self):
        self.play("--seed", "7", "--set", "b.utility.terms.near.weight=0.5", pairs=2)
        page = self.page()
        commands = next(text for tag, text in page.text if tag == "pre" and "run study.yaml" in text)
        self.assertNotIn(str(self.program), page.whole())  # by whatever path it was started
        done = subprocess.run(["/bin/sh", "-ec", f'regista() {{ "{self.program}" "$@"; }}\n' + commands.replace(
            "run study.yaml", "run study.yaml --quiet --results ../again.db")], cwd=self.folder, text=True,
            capture_output=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        fingerprint = re.compile("the same one\\): <code>(\\w+)</code>")
        self.assertEqual(*(fingerprint.findall((self.folder / name).read_text()) for name in ("tournament.html", "again.html")))

    def test_results_of_an_older_program(self):
        self.play(pairs=1)
        self.change("DELETE FROM meta WHERE name = 'documents'")
        self.succeed("report", "tournament.db", "-o", "a.html")
        self.assertIn("do not hold the teams' documents", self.page("a.html").whole())
        self.change("INSERT INTO meta VALUES('documents', '[\"a: [\", \"b\"]', 0)")
        self.succeed("report", "tournament.db", "-o", "b.html")
        self.assertIn("cannot be compared", self.page("b.html").whole())
        self.change("UPDATE meta SET value = '{' WHERE name = 'documents'")
        self.assertIn("damaged", self.refused("report", "tournament.db", "-o", "c.html"))


if __name__ == "__main__":
    unittest.main()
