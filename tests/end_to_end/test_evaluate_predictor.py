# SPDX-License-Identifier: MIT
"""`regista evaluate-predictor`: results for people and programs, and one line for every recording that cannot be used."""
import gzip
import json
import subprocess
import unittest
from pathlib import Path
from tempfile import TemporaryDirectory

import program

STUDIES = program.SOURCE / "configs/studies"
STUDY = str(STUDIES / "ssl_ball.yaml")


def run(*arguments):
    """The program as it was built, with the plugins that are shipped."""
    return subprocess.run([program.PROGRAM, *arguments], capture_output=True, text=True, timeout=60)


def rolling_ball():
    """A ball that rolls at 1 m/s and loses 0.3 m/s each second, seen 70 times a second for 3 s."""
    lines = ["event,t,x_mm,y_mm"]
    for i in range(210):
        t = i / 70
        lines.append(f"1,{t:.4f},{1000 * (t - 0.15 * t * t):.3f},0")
    return "\n".join(lines) + "\n"


class EvaluatePredictor(unittest.TestCase):
    def setUp(self):
        self.folder = TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.data = self.write("m_ball_raw.csv", rolling_ball())
        self.write("m_referee.csv", "event,t,state\n1,0,GameRunning\n")

    def write(self, name, text):
        path = Path(self.folder.name) / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return str(path)

    def evaluate(self, *arguments, data=None):
        return run("evaluate-predictor", STUDY, "--data", self.data if data is None else data, *arguments)

    def refused(self, words, *arguments, data=None):
        result = self.evaluate(*arguments, data=data)
        self.assertEqual(result.returncode, 2, result)
        self.assertEqual(result.stdout, "")
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertIn(words, result.stderr)

    def test_text_and_json_tell_the_same(self):
        text, data = self.evaluate(), self.evaluate("--json")
        self.assertEqual((text.returncode, data.returncode), (0, 0), text.stderr + data.stderr)
        for words in ("kalman_ball", "hold last", "constant velocity", "decayed velocity", "NEES", "90 %"):
            self.assertIn(words, text.stdout)
        result = json.loads(data.stdout)
        self.assertEqual(result["detections"], 210)
        last = result["horizons"][3]
        self.assertEqual(last["seconds"], 1)
        self.assertAlmostEqual(last["error_m"]["decayed"]["median"], 0, delta=0.03)
        self.assertLess(last["error_m"]["predictor"]["median"], 0.03)
        self.assertGreater(last["error_m"]["hold"]["median"], 0.2)
        self.assertEqual(data.stdout, self.evaluate("--json").stdout, "the same every time")

    def test_what_must_not_be_overlooked_is_noted(self):
        held = self.evaluate("--set", "predictor={plugin: hold_last}")
        self.assertIn("note: 1 s ahead: median error", held.stdout)
        self.assertIn("of that of decayed velocity", held.stdout)
        good = json.loads(self.evaluate("--json").stdout)
        self.assertFalse([note for note in good["notes"] if "decayed" in note], good["notes"])
        # A ball that is forgotten at once gets no answer.
        forgotten = json.loads(self.evaluate("--json", "--set", "predictor={plugin: hold_last, params: {forget_after: 0.5}}").stdout)
        self.assertTrue(any(note.startswith("1 s ahead") and "no track" in note for note in forgotten["notes"]), forgotten["notes"])

    def test_dropping_observations(self):
        result = self.evaluate("--json", "--set", "observations={every: 0.1, drop: 0.3, seed: 1}",
                               "--set", "baselines.window=1", "--set", "baselines.least=2")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertLess(json.loads(result.stdout)["observations"], 31)

    def test_help_has_an_example(self):
        result = run("evaluate-predictor", "--help")
        self.assertEqual(result.returncode, 0)
        self.assertIn("--data zjunlict_ball_raw.csv.gz", result.stdout)

    def test_recordings_that_cannot_be_used(self):
        self.refused("none.csv: cannot be opened", data=self.folder.name + "/none.csv")
        self.refused("is a folder", data=self.folder.name)
        self.refused("is empty", data=self.write("e_ball_raw.csv", ""))
        self.refused("e_ball_raw.csv:1:1: byte 0x89 is not UTF-8", data=self.write("e_ball_raw.csv", b"\x89PNG\r\n\x1a\n\0\0IHDR"))
        self.refused("cannot be read on", data=self.write("e_ball_raw.csv.gz", b"\x1f\x8b\x08" + 200 * b"x"))
        cut = gzip.compress(rolling_ball().encode())[:-500]
        self.refused("unexpected end of file", data=self.write("e_ball_raw.csv.gz", cut))
        self.refused("3:5: x_mm: \"nan\" is not finite",
                     data=self.write("e_ball_raw.csv", "event,t,x_mm,y_mm\n1,1,0,0\n1,2,nan,0\n"))
        self.refused("3:3: t: \"0\" runs backwards",
                     data=self.write("e_ball_raw.csv", "event,t,x_mm,y_mm\n1,1,0,0\n1,0,0,0\n"))
        self.refused("is not a regular file", data="/dev/zero")

    def test_studies_that_cannot_be_used(self):
        self.refused("--set predictor.plugin=kalman_bal", "--set", "predictor.plugin=kalman_bal")
        self.refused("gaussian_mixture", "--set", "predictor.plugin=gaussian_mixture")
        self.refused("questions.evry", "--set", "questions.evry=3")
        self.refused("--data", "--set", "questions.every=3", data="")
        result = run("evaluate-predictor", str(program.SOURCE / "configs/teams/paper.yaml"), "--data", self.data)
        self.assertEqual(result.returncode, 2)
        self.assertIn("this is a team document; expected a predictor_study document", result.stderr)

    def test_shipped_studies_are_sound(self):
        studies = sorted(map(str, STUDIES.glob("*.yaml")))
        self.assertGreaterEqual(len(studies), 4)
        for study in studies:
            result = run("config", "check", study)
            self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    unittest.main()
