# SPDX-License-Identifier: MIT
"""`regista sprt`: published numbers from counts, as text and as JSON, and one line for what cannot be used."""
import json
import math
import unittest

import program


class Sprt(program.Case):
    plugins = ()

    def result(self, *arguments):
        return json.loads(self.succeed("sprt", *arguments, "--json"))

    def test_published_ratios(self):
        for model, elo, counts, llr in (
                ("normalized", "0,2", "36027 68692 36433", 0.923293),
                ("normalized", "-1.75,0.25", "10650 20431 10871", 2.297500),
                ("normalized", "0,10", "0 0 4250", 120.548268),
                ("logistic", "0.5,2.5", "21184 40708 21404", -1.571889),
                ("normalized", "0,2", "365 16618 36229 16974 390", 2.250368),
                ("normalized", "0,5", "0 0 0 0 5550", 111.797555),
                ("logistic", "0,2", "871 26175 55983 26678 821", -4.978673)):
            result = self.result("--model", model, "--elo", elo, *counts.split())
            self.assertAlmostEqual(result["llr"], llr, delta=1e-6)
            self.assertEqual(result["llr_method"], "exact")

    def test_published_strengths(self):
        games = self.result("--elo", "0,10", "96", "111", "136")
        self.assertEqual(games["unit"], "games")
        self.assertAlmostEqual(games["elo"], 40.70, delta=0.005)
        self.assertAlmostEqual(games["nelo"], 49.77, delta=0.005)
        self.assertAlmostEqual(games["los"], 0.9960, delta=0.0005)
        self.assertIsNone(games["pair_ratio"])
        pairs = self.result("--elo", "0,10", "34", "54", "63", "64", "75")
        self.assertEqual(pairs["unit"], "pairs")
        self.assertAlmostEqual(pairs["elo"], 55.58, delta=0.005)
        low, high = pairs["elo_interval"]
        self.assertAlmostEqual((high - low) / 2, 27.65 * 1.968 / 1.960, delta=0.1)  # by Student
        low, high = pairs["nelo_interval"]
        self.assertAlmostEqual((high - low) / 2, 29.41, delta=0.005)  # 28.28 if the spread were known
        self.assertAlmostEqual(pairs["pair_ratio"], 139 / 88, delta=1e-12)

    def test_text(self):
        self.assertEqual(self.succeed("sprt", "--elo", "0,10", "34", "54", "63", "64", "75"),
                         "Pairs (LL, LD, WL+DD, WD, WW): 34, 54, 63, 64, 75\n"
                         "Elo: 55.58 +/- 27.82, nElo: 57.94 +/- 29.41\n"
                         "LOS: 100.00 %, pair ratio: 1.58\n"
                         "LLR: 2.484 (-2.944, 2.944) [0, 10] normalized\n"
                         "Verdict: INCONCLUSIVE\n")

    def test_verdicts(self):
        def verdict(*arguments):
            return self.result(*arguments)["verdict"]
        self.assertEqual(verdict("--elo", "0,10", "0", "0", "0", "0", "5550"), "H1")
        self.assertEqual(verdict("--model", "logistic", "--elo", "0,2", "871", "26175", "55983", "26678", "821"), "H0")
        self.assertEqual(verdict("--elo", "0,2", "365", "16618", "36229", "16974", "390"), "INCONCLUSIVE")
        self.assertEqual(verdict("--elo", "0,2", "--alpha", "0.2", "--beta", "0.2", "365", "16618", "36229", "16974",
                                 "390"), "H1")

    def test_bounds_out_of_reach(self):
        for counts, llr in (("20 0 0 0 0", -3.42), ("144 3 1 0 0", -228.67)):
            result = self.result("--elo", "-1500,-500", *counts.split())
            self.assertAlmostEqual(result["llr"], llr, delta=0.005)
            self.assertEqual((result["llr_method"], result["verdict"]), ("closed_form", "H0"))
        self.assertIn("approximation", self.succeed("sprt", "--elo", "-1500,-500", "20", "0", "0", "0", "0"))

    def test_even_pairs_speak_for_equal_strength(self):
        for model in ("normalized", "logistic"):
            result = self.result("--model", model, "--elo", "0,50", "0", "0", "9999", "0", "0")
            self.assertEqual((result["los"], result["verdict"]), (None, "H0"))
            self.assertEqual((result["elo_interval"], result["nelo_interval"]), ([None, None], [None, None]))
        # 28 even pairs of 30, and 30: the ratio does not jump.
        few = self.result("--elo", "0,20", "0", "1", "28", "1", "0")["llr"]
        none = self.result("--elo", "0,20", "0", "0", "30", "0", "0")["llr"]
        self.assertAlmostEqual(none, -30 * math.log(1 + 2 * (20 * math.log(10) / 800) ** 2), delta=0.01)
        self.assertLess(none, few)
        self.assertLess(few, 0)
        self.assertEqual(self.succeed("sprt", "--elo", "0,20", "0", "0", "30", "0", "0"),
                         "Pairs (LL, LD, WL+DD, WD, WW): 0, 0, 30, 0, 0\n"
                         "Elo: 0.00 (no interval), nElo: 0.00 (no interval)\n"
                         "LOS: -\n"
                         f"LLR: {none:.3f} (-2.944, 2.944) [0, 20] normalized\n"
                         "All 30 pairs were even: the test takes this for equal strength.\n"
                         "Verdict: INCONCLUSIVE\n")
        self.assertIn("The only game was even: the test takes this for equal strength.\n",
                      self.succeed("sprt", "--elo", "0,50", "0", "1", "0"))

    def test_what_has_no_interval_says_so(self):
        few = self.succeed("sprt", "--elo", "0,20", "0", "0", "28", "2", "0")
        self.assertIn("nElo: 65.46 (no interval)\n", few)
        self.assertIn("Fewer than 10 pairs were uneven, so Elo and nElo have no interval, and LOS is not known.\n"
                      "The test rests on 2 of 30 pairs that were uneven.\n", few)
        won = self.succeed("sprt", "--elo", "0,50", "0", "0", "0", "0", "11")
        self.assertIn("Elo: at least 159.86, nElo: ", won)
        self.assertIn("At least 71 % of the points, with 97.5 % confidence: Elo has this bound alone. One team won every "
                      "pair, so nElo has no interval.\n", won)
        # Less evidence never gives more certainty.
        for counts in ("0 0 0 3 1", "0 0 0 0 4", "0 0 0 1 3"):
            self.assertIsNone(self.result("--elo", "0,50", *counts.split())["los"])
        self.assertIn("One team won every pair, so nElo has no interval.\n",
                      self.succeed("sprt", "--elo", "0,20", "0", "0", "0", "10", "12"))
        self.assertEqual(self.result("--elo", "0,20", "0", "0", "0", "10", "12")["nelo_interval"], [None, None])

    def test_help(self):
        text = self.succeed("sprt", "--help")
        self.assertIn("regista sprt --elo 0,10 34 54 63 64 75", text)
        self.assertIn("from 0 to 1 in JSON", text)

    def assert_refused(self, words, line):
        self.assertEqual(self.refused("sprt", *words.split()), line)

    def test_counts_that_cannot_be_used(self):
        wanted = "expected a whole number from 0 to 1000000000"
        for word in ("1.5", "x", "1000000001", "99999999999999999999", "0x1", "nan"):
            self.assert_refused(f"--elo 0,10 1 {word} 2", f'sprt: count "{word}"; {wanted}')
        self.assert_refused("--elo 0,10 1 -2 3", f'sprt: count "-2"; {wanted}')
        self.assert_refused("--elo 0,10 -- 1 -2 3", f'sprt: count "-2"; {wanted}')
        of = "expected five of pairs (LL LD DD WD WW) or three of games (L D W)"
        self.assert_refused("--elo 0,10", f"sprt: 0 counts; {of}")
        self.assert_refused("--elo 0,10 1 2 3 4", f"sprt: 4 counts; {of}")
        self.assert_refused("--elo 0,10 1 2 3 4 5 6", f"sprt: 6 counts; {of}")
        self.assert_refused("--elo 0,10 0 0 0", "sprt: all counts are zero")

    def test_options_that_cannot_be_used(self):
        self.assert_refused("1 2 3", "sprt: which hypotheses? Say --elo ELO0,ELO1, for example --elo 0,10")
        for text in ("0", "0,", ",10", "0,10,20", "a,b", "0,nan", "0,1e9", "0;10"):
            self.assert_refused(f"--elo {text} 1 2 3",
                                f'--elo: "{text}"; expected two numbers from -4000 to 4000, as in 0,10')
        for text in ("10,0", "5,5"):
            self.assert_refused(f"--elo {text} 1 2 3", f'--elo: "{text}"; the first must be the smaller one')
        for option in ("--alpha", "--beta"):
            for text in ("0", "1", "-0.1", "nan", "some", "1e-400"):
                self.assert_refused(f"--elo 0,10 {option} {text} 1 2 3",
                                    f'{option}: "{text}"; expected a number above 0 and below 1')
        self.assert_refused("--elo 0,10 --alpha 0.5 --beta 0.5 1 2 3",
                            "--alpha 0.5 and --beta 0.5: their sum must be below 1")
        self.assert_refused("--elo 0,10 --model bayeselo 1 2 3",
                            'unknown model "bayeselo" in --model; known: normalized, logistic')
        self.assert_refused("--elo 0,10 --model logistics 1 2 3",
                            'unknown model "logistics" in --model; nearest: "logistic"; known: normalized, logistic')


if __name__ == "__main__":
    unittest.main()
