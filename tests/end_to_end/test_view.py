# SPDX-License-Identifier: MIT
"""`regista view`: pages and pictures of recorded matches."""

import base64
import json
import os
import pathlib
import re
import struct
import unittest
import xml.etree.ElementTree

import zstandard

import program
import recorded

MATCH = ("match", "small.yaml", "small.yaml", *program.PLAY_SOON, "--limit", "20", "--quiet")
SVG = "{http://www.w3.org/2000/svg}"
VIEWER = ('<html><script id="recording" data-name="@REGISTA_RECORDING_NAME@">@REGISTA_RECORDING@</script></html>')


def with_more(data, messages):
    """The recording `data` with more messages, [(topic, message)], at its end: outside of chunks, without a summary."""
    def record(opcode, content):
        return struct.pack("<BQ", opcode, len(content)) + content

    def text(string):
        return struct.pack("<I", len(string.encode())) + string.encode()

    end = len(recorded.MAGIC)
    for opcode, content in recorded.records(data, end):
        if opcode == recorded.DATA_END:
            break
        end += 9 + len(content)
    out = bytearray(data[:end])
    topics = sorted({topic for topic, _ in messages})
    for number, topic in enumerate(topics, 1000):
        out += record(recorded.CHANNEL, struct.pack("<HH", number, 0) + text(topic) + text("json") + text(""))
    for topic, message in messages:
        when = round(message["time"] * 1e9)
        head = struct.pack("<HIQQ", 1000 + topics.index(topic), 0, when, when)
        out += record(recorded.MESSAGE, head + json.dumps(message).encode())
    footer = 2
    return bytes(out + record(recorded.DATA_END, bytes(4)) + record(footer, bytes(20)) + recorded.MAGIC)


class View(program.Case):
    def setUp(self):
        super().setUp()
        self.succeed(*MATCH, "--record", "a.mcap")

    def install_viewer(self, text=VIEWER):
        self.write("share/regista/viewer.html", text)

    def picture(self, *more, file="a.mcap"):
        self.succeed("view", file, *more, "-o", "a.svg", "--force")
        return xml.etree.ElementTree.parse(self.folder / "a.svg").getroot()

    def texts(self, svg):
        return [element.text or "" for element in svg.iter(f"{SVG}text")]


class Pages(View):
    def test_the_page_holds_the_recording(self):
        self.install_viewer()
        os.rename(self.folder / "a.mcap", self.folder / 'my <"first"> & best.mcap')
        self.assertEqual(self.succeed("view", 'my <"first"> & best.mcap', "-o", "page.html"), "page.html\n")
        page = (self.folder / "page.html").read_text()
        found = re.fullmatch(r'<html><script id="recording" data-name="([^"]*)">([A-Za-z0-9+/=]*)</script></html>', page)
        self.assertEqual(found[1], "my &lt;&quot;first&quot;&gt; &amp; best.mcap")
        data = base64.b64decode(found[2], validate=True)
        shown, played = recorded.Recording(data), recorded.read(self.folder / 'my <"first"> & best.mcap')
        self.assertEqual(shown.logged, played.logged)
        self.assertEqual(shown.about, played.about)
        self.assertTrue(shown.whole)
        # A whole match has 1302 s; its page shall have at most 12 MB, with 0.9 MB of them for the viewer.
        seconds = played.of("/game")[-1]["time"]
        self.assertLess(len(found[2]) / seconds, 11.1e6 / 1302)

    def test_the_page_of_a_damaged_recording_holds_it_as_it_is(self):
        self.install_viewer()
        whole = (self.folder / "a.mcap").read_bytes()
        damaged = bytearray(whole)
        damaged[len(whole) // 2] ^= 1
        for name, data in (("cut", whole[:-100]), ("damaged", bytes(damaged))):
            (self.folder / f"{name}.mcap").write_bytes(data)
            done = self.run_program("view", f"{name}.mcap", "-o", "page.html", "--force")
            self.assertEqual(done.returncode, 0)
            self.assertRegex(done.stderr, rf"^regista: {name}\.mcap: is (cut off|damaged) at byte \d+")
            found = re.search(r">([A-Za-z0-9+/=]+)<", (self.folder / "page.html").read_text())[1]
            self.assertEqual(base64.b64decode(found, validate=True), data)

    def test_without_a_name_it_stands_beside_the_recording(self):
        self.install_viewer()
        self.assertEqual(self.succeed("view", "a.mcap"), "a.html\n")
        self.assertIn("--force", self.refused("view", "a.mcap"))
        self.assertEqual(self.succeed("view", "a.mcap", "--force"), "a.html\n")
        self.assertIn("is a file that this view reads", self.refused("view", "a.mcap", "-o", "a.mcap", "--force"))

    def test_a_build_without_viewer_says_what_is_missing(self):
        line = self.refused("view", "a.mcap")
        self.assertIn("Node.js", line)
        self.assertIn("npm ci", line)
        self.install_viewer("<html>another</html>")
        self.assertIn("belongs to another version", self.refused("view", "a.mcap"))

    def test_a_folder_that_may_not_be_written(self):
        self.install_viewer()
        (self.folder / "closed").mkdir(mode=0o555)
        self.folder.chmod(0o755)
        nobody = 65534
        options = dict(user=nobody, group=nobody, extra_groups=[]) if os.geteuid() == 0 else {}
        for more in ((), ("--at", "5")):
            line = self.refused("view", "a.mcap", *more, "-o", "closed/a.html", **options)
            self.assertIn("closed/a.html", line)
            self.assertIn("Permission denied", line)

    def test_folders_and_disks_that_take_nothing(self):
        self.install_viewer()
        self.assertIn("none/a.html", self.refused("view", "a.mcap", "-o", "none/a.html"))
        self.assertIn("small.yaml/a.html", self.refused("view", "a.mcap", "-o", "small.yaml/a.html"))


class BadRecordings(View):
    def test_files_that_are_no_recordings(self):
        self.write("empty.mcap", "")
        self.write("foreign.mcap", "PNG or whatever it is")
        (self.folder / "magic.mcap").write_bytes(recorded.MAGIC)
        (self.folder / "folder.mcap").mkdir()
        for name, words in (("empty", "is empty"), ("foreign", "is not an MCAP file"), ("magic", "within its header"),
                            ("folder", ""), ("none", "No such file")):
            for more in ((), ("--at", "1")):
                line = self.refused("view", f"{name}.mcap", *more)
                self.assertIn(f"{name}.mcap", line)
                self.assertIn(words, line)

    def test_a_file_of_a_later_version(self):
        data = (self.folder / "a.mcap").read_bytes()
        old = b"\x06\x00\x00\x00format\x01\x00\x00\x001"
        self.assertEqual(data.count(old), 1)
        (self.folder / "later.mcap").write_bytes(data.replace(old, old[:-1] + b"2"))
        self.assertIn("has format 2 of regista", self.refused("view", "later.mcap", "--at", "1"))

    def test_a_recording_of_something_else(self):
        data = (self.folder / "a.mcap").read_bytes()
        # The name of the metadata: a file of another program.
        other = data.replace(b"\x05\x00\x00\x00match", b"\x05\x00\x00\x00other", 1)
        (self.folder / "other.mcap").write_bytes(other)
        self.assertIn("is no recording of a match", self.refused("view", "other.mcap", "--at", "1"))

    def test_a_huge_file_is_refused_for_a_page(self):
        self.install_viewer()
        data = (self.folder / "a.mcap").read_bytes()
        # A hole after the last complete chunk: cut off, as far as a reader can tell.
        path = self.folder / "huge.mcap"
        path.write_bytes(data[:-2000])
        os.truncate(path, 2 << 30)
        done = self.run_program("view", "huge.mcap", timeout=60)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("no browser opens", done.stderr)


class Pictures(View):
    def test_shows_what_stands_in_the_recording(self):
        file = recorded.read(self.folder / "a.mcap")
        game = next(game for game in file.of("/game") if game["time"] == 15.0)
        decision = [d for d in file.of("/decision/home/3") if d["time"] <= 15.0][-1]
        about = json.loads(file.about["home"])
        svg = self.picture("--at", "15", "--robot", "3")
        texts = self.texts(svg)
        self.assertIn(f"small {game['score'][0]} : {game['score'][1]} small", texts)
        self.assertIn(f"small 3: {about['roles'][decision['role']]['name']}", texts)
        values = [f"{value:.2f}" for row in decision["utility"] for value in row if value is not None]
        shown = [element.text for element in svg.iter(f"{SVG}text") if "value" in element.get("class", "")]
        self.assertEqual([text for text in shown[:len(decision["rows"]) * len(decision["columns"])] if text != "–"],
                         values)
        taken = [element for element in svg.iter(f"{SVG}rect") if element.get("class") == "taken"]
        chosen = [row for row in decision["rows"] if decision["assigned"][row - 1] in decision["columns"]]
        self.assertEqual(len(taken), len(chosen))
        # Robots stand where they stood: centre of the picture's field and its scale, from the lines drawn.
        robots = [group.find(f"{SVG}circle") for group in svg.iter(f"{SVG}g")
                  if (group.get("class") or "").startswith("robot home")]
        # Who is penalised stands beside the field.
        plays = [i for i in range(len(robots)) if i + 1 not in game["penalised"][0]]
        xs = [float(robots[i].get("cx")) for i in plays]
        poses = [game["home"][i] for i in plays]
        scale = (xs[1] - xs[0]) / (poses[1][0] - poses[0][0])
        for x, pose in zip(xs, poses):
            self.assertLessEqual(abs(x - xs[0] - scale * (pose[0] - poses[0][0])), 0.2 + 0.01 * abs(scale))

    def test_shows_titles(self):
        self.succeed(*MATCH, "--record", "titled.mcap", "--set", "a.title=The First, e.V.", "--set", "b.title=Second")
        texts = self.texts(self.picture("--at", "15", "--robot", "3", file="titled.mcap"))
        self.assertTrue(any(re.fullmatch(r"The First, e\.V\. \d+ : \d+ Second", text) for text in texts), texts)
        self.assertTrue(any(text.startswith("The First, e.V. 3: ") for text in texts), texts)
        self.assertFalse(any(text.startswith("small") for text in texts), texts)

    def test_moments(self):
        file = recorded.read(self.folder / "a.mcap")
        clocked = next(game for game in file.of("/game") if game["half"] == 1 and game["clock"] >= 5)
        at = self.texts(self.picture("--at", "1/0:05"))
        self.assertEqual(at, self.texts(self.picture("--at", clocked["time"])))
        self.assertEqual(self.texts(self.picture("--at", "0:15")), self.texts(self.picture("--at", "15.0")))
        self.assertEqual(self.texts(self.picture("--at", "0")), self.texts(self.picture("--at", "0.1")))
        self.picture("--at", "0:15")
        self.assertEqual(self.succeed("view", "a.mcap", "--at", "0:15", "-o", "-"), (self.folder / "a.svg").read_text())

    def test_moments_and_robots_that_are_none(self):
        for typed in ("x", "-1", "1:", ":5", "7:75", "7:4", "7:4.5", "0/1:00", "1/2/3", "nan", "inf", "1e99", "1:2:3", ""):
            if typed:
                self.assertIn("--at", self.refused("view", "a.mcap", "--at", typed))
        self.assertIn("ends at 20.0 s", self.refused("view", "a.mcap", "--at", "20.2"))
        self.assertIn("ends 20.0 s after", self.refused("view", "a.mcap", "--at", "2/0:10"))
        for typed in ("0", "8", "x", "away/8", "left/1", "-1"):
            self.assertIn("--robot", self.refused("view", "a.mcap", "--at", "5", "--robot", typed))
        self.assertIn("--robot belongs to --at", self.refused("view", "a.mcap", "--robot", "3"))

    def test_hostile_names_do_no_harm(self):
        # No team file can name them, but a recording may come from anywhere.
        long_name = "a_name_of_30_letters_that_goes"
        self.succeed("match", "small.yaml", "small.yaml", *program.PLAY_SOON, "--limit", "10", "--quiet", "--record",
                     "b.mcap", "--set", f"a.team={long_name}")
        data = (self.folder / "b.mcap").read_bytes()
        name = "<script>\u202ealert(1)</script>".encode()
        self.assertLessEqual(len(name), len(long_name))
        old = f'"team":"{long_name}"'.encode()
        self.assertEqual(data.count(old), 1)
        padded = name.ljust(len(long_name))
        for key in (b"team", b"title"):
            data = data.replace(b'"%s":"%s"' % (key, long_name.encode()), b'"%s":"%s"' % (key, padded))
        (self.folder / "hostile.mcap").write_bytes(data)
        svg = self.picture("--at", "9", "--robot", "2", file="hostile.mcap")
        self.assertFalse([element for element in svg.iter() if element.tag.endswith("script")])
        self.assertTrue(any("<script>" in text for text in self.texts(svg)))
        self.assertFalse(any("\u202e" in text for text in self.texts(svg)))


def written_anew(data, change):
    """The recording `data` as another program may write it: without chunks and summary. change: takes and gives back
    [(channel, sequence, log time, text)] of all messages."""
    def record(opcode, content):
        return struct.pack("<BQ", opcode, len(content)) + content

    before, messages = b"", []
    for opcode, content in recorded.records(data, len(recorded.MAGIC)):
        if opcode == recorded.DATA_END:
            break
        if opcode != recorded.CHUNK:
            before += record(opcode, content)
            continue
        size, at = struct.unpack_from("<Q", content, 16)[0], 32 + struct.unpack_from("<I", content, 28)[0] + 8
        plain = zstandard.ZstdDecompressor().decompress(content[at:], max_output_size=size)
        for inner, packed in recorded.records(plain):
            if inner == recorded.MESSAGE:
                channel, sequence, log_time, _ = struct.unpack_from("<HIQQ", packed)
                messages.append((channel, sequence, log_time, packed[22:]))
            else:
                before += record(inner, packed)
    after = b"".join(record(recorded.MESSAGE, struct.pack("<HIQQ", channel, sequence, when, when) + text)
                     for channel, sequence, when, text in change(messages))
    footer = 2
    end = record(recorded.DATA_END, bytes(4)) + record(footer, bytes(20))
    return recorded.MAGIC + before + after + end + recorded.MAGIC


class WrittenAnew(View):
    """Pictures and pages are the same when another program has changed the order of messages or where times begin."""

    def setUp(self):
        super().setUp()
        data = (self.folder / "a.mcap").read_bytes()

        def reversed_since_1970(messages):
            return [(channel, sequence, when + 1_790_000_000_123_456_789, text)
                    for channel, sequence, when, text in reversed(messages)]

        (self.folder / "anew.mcap").write_bytes(written_anew(data, reversed_since_1970))

    def test_pictures(self):
        for at in ("0", "0:07", "14.35", "20", "1/0:05"):
            for robot in ((), ("--robot", "3"), ("--robot", "away/2")):
                self.succeed("view", "anew.mcap", "--at", at, *robot, "-o", "anew.svg", "--force")
                self.picture("--at", at, *robot)
                drawn, wanted = ((self.folder / name).read_text() for name in ("anew.svg", "a.svg"))
                self.assertEqual(drawn, wanted, (at, robot))

    def test_pages(self):
        self.install_viewer()
        self.succeed("view", "anew.mcap")
        page = (self.folder / "anew.html").read_text()
        self.assertIn('data-name="anew.mcap"', page)
        content = re.search(r">([A-Za-z0-9+/=]+)<", page)[1]
        def by_topic(recording):
            out = {}
            for topic, when, text in recording.logged:
                out.setdefault(topic, []).append((when, text))
            return out

        wanted = by_topic(recorded.read(self.folder / "a.mcap"))
        found = by_topic(recorded.Recording(base64.b64decode(content, validate=True)))
        self.assertEqual(found.keys(), wanted.keys())
        for topic in wanted.keys() - {"/heard"}:
            self.assertEqual(found[topic], wanted[topic], topic)
        # Robots write together what they heard in the last tenth of a second.
        self.assertEqual(sorted(found["/heard"]), sorted(wanted["/heard"]))

    def test_damage_is_named_by_its_cause(self):
        data = bytearray((self.folder / "a.mcap").read_bytes())
        places = []
        at = len(recorded.MAGIC)
        for opcode, content in recorded.records(bytes(data), at):
            if opcode == recorded.CHUNK:
                places.append(at)
                data[at + 9 + 24] ^= 1  # the checksum
            at += 9 + len(content)
        (self.folder / "damaged.mcap").write_bytes(data)
        for more in ((), ("--at", "1")):
            line = self.refused("view", "damaged.mcap", *more)
            self.assertIn(f"damaged.mcap: is damaged at byte {places[0]}: the checksum of a chunk is wrong", line)


class Drawings(View):
    def setUp(self):
        super().setUp()
        whose = {"side": "home", "robot": 3, "plugin": "voronoi"}

        def drawn(time, layer, *shapes):
            return "/draw", {"time": time, **whose, "layer": layer, "shapes": shapes}
        corners = [[-1, -1], [1, -1], [1, 1]]
        data = with_more((self.folder / "a.mcap").read_bytes(), [
            drawn(4.0, "cells", {"shape": "polygon", "at": corners}, {"shape": "text", "at": [[0, 0]], "text": "A < B"}),
            drawn(4.0, "gaps", {"shape": "points", "at": corners}),
            ("/log", {"time": 14.9, **whose, "level": "warning", "text": "two cells are empty"}),
            drawn(16.0, "gaps"),
        ])
        (self.folder / "drawn.mcap").write_bytes(data)

    def names_of_layers(self, *more):
        return [text for text in self.texts(self.picture(*more, file="drawn.mcap")) if text.startswith("voronoi: ")]

    def test_layers_and_log_of_a_robot(self):
        svg = self.picture("--at", "15", "--robot", "3", file="drawn.mcap")
        groups = [group for group in svg.iter(f"{SVG}g") if group.get("class") == "layer"]
        self.assertEqual([len(list(group)) for group in groups], [1, 3])
        texts = self.texts(svg)
        self.assertIn("A < B", texts)
        self.assertIn("0:14.9 warning voronoi: two cells are empty", texts)
        self.assertEqual(self.names_of_layers("--at", "15", "--robot", "3"), ["voronoi: cells", "voronoi: gaps"])
        self.assertEqual(self.names_of_layers("--at", "17", "--robot", "3"), ["voronoi: cells"])
        for other in ((), ("--robot", "2"), ("--robot", "away/3")):
            self.assertEqual(self.names_of_layers("--at", "15", *other), [])

    def test_chosen_layers(self):
        at = ("--at", "15", "--robot", "3")
        self.assertEqual(self.names_of_layers(*at, "--layer", "gaps"), ["voronoi: gaps"])
        self.assertEqual(self.names_of_layers(*at, "--layer", "voronoi: cells"), ["voronoi: cells"])
        self.assertEqual(self.names_of_layers(*at, "--layer", "gaps", "--layer", "cells"),
                         ["voronoi: cells", "voronoi: gaps"])
        self.assertEqual(self.names_of_layers("--at", "17", "--robot", "3", "--layer", "gaps"), [])

    def test_layers_that_are_none(self):
        line = self.refused("view", "drawn.mcap", "--at", "15", "--robot", "3", "--layer", "gap")
        self.assertIn('unknown layer "gap"', line)
        self.assertIn('nearest: "gaps"; known: cells, gaps', line)
        self.assertIn("has drawn anything", self.refused("view", "drawn.mcap", "--at", "15", "--robot", "2", "--layer", "gaps"))
        for more in ((), ("--at", "15")):
            self.assertIn("--layer belongs to", self.refused("view", "drawn.mcap", *more, "--layer", "gaps"))


if __name__ == "__main__":
    unittest.main()
