# SPDX-License-Identifier: MIT
"""At the whistle of each half the shipped teams have agreed on who does what, and everybody does something."""

import collections
import json
import unittest

import program

TEAMS = program.SOURCE / "configs" / "teams"

# Matches of two short halves, with as many packets for their length as a whole match has. They begin as those do.
SHORT = ("--set", "rules.durations.half=60", "--set", "rules.messages.budget=203")


class KickOff(program.ShippedCase):
    def roles_at_the_whistle(self, team, seed):
        """For each half and side, the roles of the robots that play."""
        self.succeed("match", TEAMS / f"{team}.yaml", TEAMS / f"{team}.yaml", "--seed", seed, *SHORT, "--decisions",
                     "decisions.jsonl")
        role, out_of_play, waited_for, out = {}, set(), False, []
        with open(self.folder / "decisions.jsonl", encoding="utf-8") as file:
            for line in map(json.loads, file):
                who = (line.get("side"), line.get("robot"))
                if line["kind"] == "decision":
                    role[who] = line["role"]
                elif line["kind"] != "event":
                    continue
                elif line["event"] == "half_begins":
                    out_of_play, waited_for = set(), True
                elif line["event"] == "penalty":
                    out_of_play.add(who)
                elif line["event"] == "returned":
                    out_of_play.discard(who)
                elif line["event"] == "kick_off" and waited_for:
                    waited_for = False
                    for side in ("home", "away"):
                        playing = [each for each in role if each[0] == side and each not in out_of_play]
                        out.append([role[each] for each in playing])
        return out

    def test_nobody_does_what_another_does(self):
        twice = collections.Counter()
        for team in ("paper", "events_only", "fixed_rate", "formation", "regista", "scram"):
            for seed in (1,) if program.SANITIZED else (1, 2):
                found = self.roles_at_the_whistle(team, seed)
                self.assertEqual(len(found), 4)
                for roles in found:
                    self.assertGreaterEqual(len(roles), 5)
                    self.assertNotIn(None, roles, (team, seed))
                    twice[team, seed] += len(roles) - len(set(roles))
        # A packet that is on its way at the whistle may still change a mind.
        self.assertLessEqual(sum(twice.values()), 1, twice)


if __name__ == "__main__":
    unittest.main()
