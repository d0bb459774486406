#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Instructions of a match by stage, counted by callgrind: they repeat to the last one on one machine, however busy it
is. Only what runs inside of match::play() counts.

    profile.py REGISTA HOME AWAY [--limit SECONDS] [--seed N] [--set PATH=VALUE]... [--json]
    profile.py REGISTA HOME AWAY --compare FILE [--write]

--compare: holds instructions per decision against the number in FILE and fails when it is more than 3 % larger; --write:
writes FILE instead. Needs valgrind.
"""
import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile

TOLERANCE = 0.03

# Stages by the functions whose inclusive cost they are: name, pattern, denominator.
STAGES = (
    ("a mind", r"mind::Mind::think\(", "decision"),
    ("  predict and correct own models", r"LocalModel::update\(", "decision"),
    ("  predict teammates' models", r"TeamModel::predict\(", "decision"),
    ("  hear", r"WorldModel::hear\(|TeamModel::hear\(", "decision"),
    ("  read teammates' models", r"TeamModel::refresh\(", "decision"),
    ("  fuse balls", r"fuse_ball\(", "decision"),
    ("  fuse opponents", r"fuse_opponents\(", "decision"),
    ("  list tasks", r"list_tasks\(", "decision"),
    ("  place", r"plugin::Positioner::place\(", "decision"),
    ("  utilities", r"UtilityEstimationMatrix::", "decision"),
    ("  assign", r"plugin::Assigner::assign\(", "decision"),
    ("  act", r"plugin::Behaviour::act\(", "decision"),
    ("  send", r"plugin::Sender::", "decision"),
    ("sensing", r"match::Sensing::|match::sense\(", "decision"),
    ("Box2D", r"b2World::Step\(", "step"),
    ("referee", r"match::Referee::", "step"),
    ("metrics", r"match::Metrics::", "step"),
)


class Profile:
    """Of a file of callgrind: own and inclusive cost and number of calls by function."""

    def __init__(self, path):
        self.own, self.inclusive, self.calls = (collections.Counter() for _ in range(3))
        self.outer = collections.defaultdict(collections.Counter)  # callee -> caller -> cost
        names = {}

        def name(text):
            number, _, spelled = text.partition(" ")
            if spelled:
                names[number] = spelled
            return names[number]

        function = callee = None
        count, called = 0, False
        for line in open(path, encoding="utf-8"):
            if line.startswith("fn="):
                function = name(line[3:].strip())
            elif line.startswith("cfn="):
                callee = name(line[4:].strip())
            elif line.startswith("calls="):
                count, called = int(line[6:].split()[0]), True
            elif line[0].isdigit() or line[0] in "+-*":
                cost = int(line.split()[1])
                if called:
                    called = False
                    self.calls[callee] += count
                    self.outer[callee][function] += cost
                    if callee != function:
                        self.inclusive[function] += cost
                else:
                    self.own[function] += cost
                    self.inclusive[function] += cost

    def of(self, pattern):
        """Inclusive cost of the functions that match, without what one of them costs within another."""
        found = {each for each in self.inclusive if re.search(pattern, each)}
        return sum(self.inclusive[each] - sum(self.outer[each][outer] for outer in found if outer != each)
                   for each in found)


def measured(options):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "callgrind"
        subprocess.run(["valgrind", "--quiet", "--tool=callgrind", f"--callgrind-out-file={file}", "--compress-pos=no",
                        "--toggle-collect=regista::match::play(regista::match::Setup const&*", *match_of(options)],
                       check=True, stdout=subprocess.DEVNULL)
        return Profile(file)


def match_of(options):
    return [options.regista, "match", options.home, options.away, "--in-process", "--quiet", "--seed", str(options.seed),
            "--limit", str(options.limit), *(word for each in options.set for word in ("--set", each))]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("regista")
    parser.add_argument("home")
    parser.add_argument("away")
    parser.add_argument("--limit", type=float, default=60, help="simulated seconds; 60")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="as of regista match")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--compare", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    if options.write and not options.compare:
        parser.error("--write: needs --compare FILE")
    profile = measured(options)
    total = sum(profile.own.values())
    counts = {"decision": sum(n for each, n in profile.calls.items() if re.search(r"^regista::mind::Mind::think\(", each)),
              "step": sum(n for each, n in profile.calls.items() if re.search(r"^b2World::Step\(", each))}
    if not all(counts.values()):
        sys.exit("profile.py: the program has no symbols, or played nothing")
    per_decision = total / counts["decision"]
    if options.compare:
        if options.write:
            options.compare.write_text(f"{per_decision:.0f}\n", encoding="utf-8")
        committed = float(options.compare.read_text(encoding="utf-8"))
        print(f"{per_decision:.0f} instructions per decision, {100 * (per_decision / committed - 1):+.1f} % of "
              f"{committed:.0f} ({options.compare})")
        return 1 if per_decision > (1 + TOLERANCE) * committed else 0
    rows = [("everything, Box2D included", total, "decision"),
            *((name, profile.of(pattern), per) for name, pattern, per in STAGES)]
    if options.json:
        print(json.dumps({"decisions": counts["decision"], "steps": counts["step"],
                          "instructions": {name.strip(): {"per": per, "instructions": cost / counts[per]}
                                           for name, cost, per in rows}}))
        return 0
    print(f"{counts['decision']} decisions, {counts['step']} physics steps; instructions per decision, of physics per "
          "step")
    for name, cost, per in rows:
        print(f"{name:40}{cost / counts[per]:>10,.0f}")
    print("most of their own:")
    for name, cost in profile.own.most_common(25):
        print(f"  {cost / counts['decision']:>8,.0f}  {name[:120]}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
