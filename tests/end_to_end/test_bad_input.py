# SPDX-License-Identifier: MIT
"""Input that cannot be used: one line says what is wrong and what there is instead, at once, with exit code 2."""

import resource
import unittest

import program

OPTIONS = ("--help, --seed, --rules, --robot, --disturbance, --home-disturbance, --away-disturbance, --opening, --set, --limit, --from, --row, --plugins, --json, --decisions, --record, --metrics, --force, "
           "--quiet, --log, --processor-seconds, --wall-seconds, --in-process, --verbose")


def processor_seconds():
    """Of all commands so far: unlike time on the clock it does not depend on what else the machine does."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


class BadInput(program.Case):
    def refused_at_once(self, *arguments, **options):
        began = processor_seconds()
        line = self.refused(*arguments, **options)
        self.assertLess(processor_seconds() - began, program.AT_ONCE, arguments)
        return line

    def assert_refused(self, arguments, line):
        self.assertEqual(self.refused_at_once(*arguments), line)

    def assert_match_refused(self, arguments, line):
        self.assert_refused(("match", "small.yaml", "small.yaml", *arguments), line)

    def assert_team_refused(self, old, new, line):
        """A team with one text replaced is refused with `bad.yaml:` and the place of `new`, then `line`."""
        text = program.TEAM.format(name="bad")
        self.assertEqual(text.count(old), 1, old)
        before = text[:text.index(old)]
        self.write("bad.yaml", text.replace(old, new))
        place = f"bad.yaml:{before.count(chr(10)) + 1}:{len(before) - (before.rfind(chr(10)) + 1) + 1}: "
        self.assert_refused(("match", "small.yaml", "bad.yaml"), place + line)
        # The same line from the command that checks.
        self.assertEqual(self.refused("config", "check", "bad.yaml"), place + line)


class CommandLine(BadInput):
    def test_no_command(self):
        self.assert_refused((), "which command? There are: match, view, tournament, experiment, tune, run, resume, report, results, gather, status, stop, power, sprt, rank, evaluate-predictor, metrics, completion, plugin, config, help; see: regista --help")
        self.assert_refused(("plugin",), "which command? There are: list, info, new, check, reference; see: regista plugin --help")

    def test_unknown_command(self):
        self.assert_refused(("mtach", "a.yaml"),
                            'unknown command "mtach" in regista; nearest: "match"; known: match, view, tournament, experiment, tune, run, resume, report, results, gather, status, stop, power, sprt, rank, evaluate-predictor, metrics, completion, plugin, config, help')
        self.assert_refused(("plugin", "lits"),
                            'unknown command "lits" in regista plugin; nearest: "list"; known: list, info, new, check, reference')
        # Planned, not there: no nearest name that misleads.
        self.assert_refused(("season",), 'unknown command "season" in regista; known: match, view, tournament, experiment, tune, run, resume, report, results, gather, status, stop, power, sprt, rank, evaluate-predictor, metrics, completion, plugin, config, help')

    def test_unknown_option(self):
        self.assert_match_refused(("--sede", "3"),
                                  f'unknown option "--sede" in regista match; nearest: "--seed"; known: {OPTIONS}')
        self.assert_match_refused(("--overlap=x",), f'unknown option "--overlap" in regista match; known: {OPTIONS}')

    def test_too_few_and_too_many_words(self):
        see = "see: regista match --help"
        self.assert_refused(("match",), f"match: expected two files of teams, 0 given; {see}")
        self.assert_refused(("match", "small.yaml"), f"match: expected two files of teams, 1 given; {see}")
        self.assert_match_refused(("small.yaml",), f"match: expected two files of teams, 3 given; {see}")
        self.assert_refused(("plugin", "list", "x"), 'unexpected argument "x"; see: regista plugin list --help')
        self.assert_refused(("plugin", "info"),
                            "plugin info: expected one id of a plugin, 0 given; see: regista plugin list")
        self.assert_refused(("config", "show", "a", "b"), "config show: expected one file, 2 given")
        self.assert_refused(("config", "check"), "config check: expected at least one file")

    def test_options_without_value_or_with_two(self):
        self.assert_match_refused(("--seed",), "--seed needs a value")
        self.assert_match_refused(("--seed", "1", "--seed", "2"), "--seed is given more than once")
        for option in ("--seed", "--limit", "--rules", "--opening", "--decisions", "--set", "--from", "--plugins"):
            self.assert_match_refused((option, ""), f"{option} needs a value")
        self.assert_match_refused(("--decisions", "--json"), '--decisions needs a value, and "--json" is an option')
        self.assert_match_refused(("--json=maybe",), "--json takes no value")

    def test_seed(self):
        for text in ("-1", "1.5", "abc", "18446744073709551616"):
            self.assert_match_refused(
                ("--seed", text), f'--seed: "{text}"; expected a whole number from 0 to 18446744073709551615')

    def test_limit(self):
        for text in ("0", "-3", "nan", "soon", "1e300"):
            self.assert_match_refused(("--limit", text),
                                      f'--limit: "{text}"; expected seconds above 0, up to 1000000')

    def test_plugin_folder(self):
        self.assert_match_refused(("--plugins", "nowhere"), "--plugins nowhere: there is no such folder")
        self.assert_match_refused(("--plugins", "small.yaml"), "--plugins small.yaml: is not a folder")
        self.assert_refused(("config", "check", "small.yaml", "--plugins", "nowhere"),
                            "--plugins nowhere: there is no such folder")

    def test_decisions_that_cannot_be_written(self):
        self.assert_match_refused(("--decisions", "nowhere/x"),
                                  "--decisions nowhere/x: cannot be written there: No such file or directory")
        self.assert_match_refused(("--decisions", "."), "--decisions .: cannot be written there: Is a directory")

    def test_kind_of_schema(self):
        self.assert_refused(("config", "schema", "robots"),
                            'config schema: unknown kind of document "robots"; nearest: "robot"; '
                            "known: rules, robot, disturbance, opening, team, predictor_study, tournament, experiment, tuning")

    def test_control_characters_stay_in_one_line(self):
        self.assert_refused(("match\n\x1b[31m",), r'unknown command "match\n\x1b[31m" in regista; '
                                                  "known: match, view, tournament, experiment, tune, run, resume, report, results, gather, status, stop, power, sprt, rank, evaluate-predictor, metrics, completion, plugin, config, help")


class BuiltInProfiles(BadInput):
    def test_named_like_a_file(self):
        names = ("--rules", "spl2023", "--robot", "nao", "--disturbance", "none")
        done = self.run_program("match", "small.yaml", "small.yaml", "--limit", "1", "--json", *names)
        self.assertEqual(done.returncode, 0, done.stderr)


class UnplayableRules(BadInput):
    def refusal(self, text):
        self.write("rules.yaml", "rules: odd\n" + text)
        done = self.run_program("match", "small.yaml", "small.yaml", "--rules", "rules.yaml")
        self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), done.stderr)
        return done.stderr

    def test_are_refused_with_line_and_reason(self):
        for text, place, reason in (
                ("durations: {half: -1}\n", "rules.yaml:2:", "durations.half"),
                ("team_size: 0\n", "rules.yaml:2:", "team_size"),
                ("messages:\n  budget: -5\n", "rules.yaml:3:", "budget"),
                ("field:\n  goal_width: 7\n", "rules.yaml:3:", "wider than the field"),
                ("ball:\n  diameter: 0.3\n", "regista: built-in robot nao", "could never be kicked; --robot names another robot, such as "
                 "--robot humanoid\n"),
                ("penalties: {removal: .nan}\n", "rules.yaml:2:", "removal")):
            with self.subTest(text):
                said = self.refusal(text)
                self.assertIn(place, said)
                self.assertIn(reason, said)


class Overrides(BadInput):
    def test_path_that_is_not_there(self):
        self.assert_match_refused(
            ("--set", "rules.durations.haf=3"),
            '--set rules.durations.haf=3: unknown key "haf" in durations; nearest: "half"; known: half, halves, ready, '
            "set, kick_off_free_after, set_play, penalty_kick_ready, penalty_kick, state_delay, game_stuck")
        self.assert_match_refused(
            ("--set", "utility.terms.near.params.scael=3"),
            '--set utility.terms.near.params.scael=3: home team: unknown parameter "scael" in plugin nearness; nearest: "scale"; '
            "known: scale, squared")

    def test_element_that_is_not_there(self):
        override = "b.roles.playing.strike.offset=false"
        line = self.refused_at_once("match", "small.yaml", "small.yaml", "--set", override)
        self.assertTrue(line.startswith(f"--set {override}: "), line)
        self.assertIn('nearest: "striker"', line)

    def test_value_of_the_wrong_kind(self):
        self.assert_match_refused(("--set", "robot.walk.forward=fast"),
                                  '--set robot.walk.forward=fast: walk.forward: "fast" is not a number')
        self.assert_match_refused(("--set", "rules.team_size=70"),
                                  "--set rules.team_size=70: team_size: 70 is outside 1 to 22 robots")

    def test_no_value(self):
        self.assert_match_refused(("--set", "rules.team_size"), "--set rules.team_size: expected path=value")
        self.assert_match_refused(("--set", "=3"), "--set =3: expected path=value")
        self.assert_match_refused(("--set", "rules.team_size="),
                                  "--set rules.team_size=: expected a value; ~ takes an entry away, '' is an empty text")


class Files(BadInput):
    def test_missing(self):
        self.assert_refused(("match", "small.yaml", "missing.yaml"), "missing.yaml: no such file")
        self.assert_match_refused(("--rules", "none.yaml"), "none.yaml: no such file")

    def test_of_another_kind(self):
        self.assert_match_refused(("--rules", "small.yaml"),
                                  "small.yaml:1:1: this is a team document; expected a rules document")

    def test_no_yaml(self):
        self.write("bad.yaml", "\x7fELF\x01\x02")
        self.assertTrue(self.refused_at_once("match", "bad.yaml", "small.yaml").startswith("bad.yaml:"))
        self.write("bad.yaml", "team: [unclosed\n")
        self.assertTrue(self.refused_at_once("match", "bad.yaml", "small.yaml").startswith("bad.yaml:"))
        self.write("bad.yaml", "")
        self.assertTrue(self.refused_at_once("match", "bad.yaml", "small.yaml").startswith("bad.yaml: "))

    def test_a_folder(self):
        self.assertTrue(self.refused_at_once("match", "bin", "small.yaml").startswith("bin: "))


class Teams(BadInput):
    def assigners(self):
        return ", ".join(sorted(self.ids("assigner")))

    def test_plugin_that_is_not_there(self):
        self.assert_team_refused(
            "{plugin: first_free}", "{plugin: frist_free}",
            f'unknown assigner "frist_free"; nearest: "first_free"; known: {self.assigners()}; '
            f"searched: {self.plugin_folder}")

    def test_plugin_of_another_kind(self):
        self.assert_team_refused("{plugin: first_free}", "{plugin: nearness}",
                                 'plugin "nearness" is a utility, not an assigner; '
                                 f"known: {self.assigners()}; "
                                 f"searched: {self.plugin_folder}")

    def test_parameter_that_is_not_there(self):
        self.assert_team_refused("scale: 2", "scael: 2", 'unknown parameter "scael" in plugin nearness; '
                                                         'nearest: "scale"; known: scale, squared')

    def test_parameter_out_of_range(self):
        self.assert_team_refused("2}}}}", "20}}}}", 'parameter "scale" of plugin nearness: 20 is outside 0.1 to 10 m')

    def test_unknown_key(self):
        self.assert_team_refused("assigner:", "asigner:",
                                 'unknown key "asigner"; nearest: "assigner"; known: team, title, predictors, contexts, '
                                 "positioner, tasks, utility, assigner, sender, roles, behaviours, behaviour_without_role, "
                                 "teammates_forgotten_after")


if __name__ == "__main__":
    unittest.main()
