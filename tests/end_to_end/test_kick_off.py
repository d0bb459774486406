# SPDX-License-Identifier: MIT
"""At the whistle of each half, and before a penalty kick, the shipped teams have agreed on who does what, and everybody
does something."""

import collections
import json
import unittest

import program

TEAMS = program.SOURCE / "configs" / "teams"

# Matches of two short halves, with as many packets for their length as a whole match has. They begin as those do.
SHORT = ("--set", "rules.durations.half=60", "--set", "rules.messages.budget=203")

# Matches in which a robot that touches an opponent pushes it, and most pushes cost a penalty kick. A match with so many
# set plays takes long, and a team without packets has no agreement: there are plenty.
PENALTIES = ("--set", "rules.field.penalty_area_length=4.4", "--set", "rules.field.penalty_area_width=5.9", "--set",
             "rules.offences.pushing_near_ball=3", "--set", "rules.offences.pushing_lasts=0.2", "--set",
             "rules.offences.pushing_speed=0.02", "--set", "rules.penalties.removal=15", "--set",
             "rules.penalties.removal_growth=0", "--set",
             "rules.durations.half=200", "--set", "rules.messages.budget=1200")


class KickOff(program.ShippedCase):
    def roles_when(self, team, seed, options, begins, events):
        """The roles of the robots of each side that play, at the first of each of these events after each that begins."""
        self.succeed("match", TEAMS / f"{team}.yaml", TEAMS / f"{team}.yaml", "--seed", seed, *options, "--decisions",
                     "decisions.jsonl")
        role, out_of_play, waited_for, out = {}, set(), [], []
        with open(self.folder / "decisions.jsonl", encoding="utf-8") as file:
            for line in map(json.loads, file):
                who = (line.get("side"), line.get("robot"))
                if line["kind"] == "decision":
                    role[who] = line["role"]
                elif line["kind"] != "event":
                    continue
                elif line["event"] == "penalty":
                    out_of_play.add(who)
                elif line["event"] == "returned":
                    out_of_play.discard(who)
                elif line["event"] in waited_for:
                    waited_for.remove(line["event"])
                    for side in ("home", "away"):
                        playing = [each for each in role if each[0] == side and each not in out_of_play]
                        out.append([role[each] for each in playing])
                elif line["event"] in ("half_begins", begins):
                    if line["event"] == "half_begins":
                        out_of_play = set()
                    waited_for = list(events) if line["event"] == begins else []
        return out

    def test_nobody_does_what_another_does(self):
        twice = collections.Counter()
        for team in ("paper", "events_only", "fixed_rate", "formation", "regista", "scram"):
            for seed in (1,) if program.SANITIZED else (1, 2):
                found = self.roles_when(team, seed, SHORT, "half_begins", ["kick_off"])
                self.assertEqual(len(found), 4)
                for roles in found:
                    self.assertGreaterEqual(len(roles), 5)
                    self.assertNotIn(None, roles, (team, seed))
                    twice[team, seed] += len(roles) - len(set(roles))
        # A packet that is on its way at the whistle may still change a mind.
        self.assertLessEqual(sum(twice.values()), 1, twice)

    @unittest.skipIf(program.SANITIZED, "plays several matches, which sanitizers slow down to minutes")
    def test_nobody_does_what_another_does_before_a_penalty_kick(self):
        """At the end of its Ready and of its Set, with the taker's team and the other."""
        twice, moments = collections.Counter(), 0
        for team in ("paper", "events_only", "fixed_rate", "formation", "regista", "scram"):
            for seed in (1, 2):
                for roles in self.roles_when(team, seed, PENALTIES, "penalty_kick", ["set", "whistle"]):
                    self.assertNotIn(None, roles, (team, seed))
                    twice[team, seed] += len(roles) - len(set(roles))
                    moments += len(roles) > 3  # others are off the field
        self.assertGreater(moments, 50)
        self.assertLessEqual(sum(twice.values()), 1, twice)


if __name__ == "__main__":
    unittest.main()
