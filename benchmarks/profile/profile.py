#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Instructions of a match by stage, in open play: counted by callgrind, they repeat to the last one on one machine, however
busy it is. Only what runs inside of match::play() counts, of the seconds from --from to --limit: what the whole costs less
what the same match costs that ends at --from. In the first 50 s of a match robots walk to their places.

    profile.py REGISTA HOME AWAY [--from SECONDS] [--limit SECONDS] [--seed N] [--set PATH=VALUE]... [--json]
    profile.py REGISTA --compare FILE [--write]

--compare: counts each pairing of FILE (home, away and a number a line), two at once, and fails where instructions per decision
are more than 3 % above the number; --write: writes the numbers anew instead. Needs valgrind.
"""
import argparse
import collections
import concurrent.futures
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
    ("  hear", r"TeamModel::absorb\(", "decision"),
    ("  read teammates' models", r"TeamModel::refresh\(", "decision"),
    ("  fuse balls", r"fuse_ball\(", "decision"),
    ("  fuse opponents", r"WorldModel::fuse_opponents\(", "decision"),
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


class Window:
    """The difference of two profiles of one match: that of all of it, and that of its beginning."""

    def __init__(self, whole, beginning):
        self.whole, self.beginning = whole, beginning
        self.own = whole.own.copy()
        self.own.subtract(beginning.own)
        self.total = sum(self.own.values())
        self.decisions = self.calls(r"^regista::mind::Mind::think\(")
        self.steps = self.calls(r"^b2World::Step\(")
        if not self.decisions or not self.steps:
            sys.exit("profile.py: the program has no symbols, or played nothing")

    def calls(self, pattern):
        return sum(profile.calls[each] * sign for profile, sign in ((self.whole, 1), (self.beginning, -1))
                   for each in profile.calls if re.search(pattern, each))

    def of(self, stage, pattern):
        if not any(re.search(pattern, each) for each in self.whole.inclusive):
            sys.exit(f"profile.py: no function is the stage \"{stage.strip()}\": {pattern}")
        return self.whole.of(pattern) - self.beginning.of(pattern)

    def per_decision(self):
        return self.total / self.decisions


def profile_of(options, home, away, limit):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "callgrind"
        subprocess.run(["valgrind", "--quiet", "--tool=callgrind", f"--callgrind-out-file={file}", "--compress-pos=no",
                        "--toggle-collect=regista::match::play(regista::match::Setup const&*", options.regista, "match",
                        home, away, "--in-process", "--quiet", "--seed", str(options.seed), "--limit", str(limit),
                        *(word for each in options.set for word in ("--set", each))],
                       check=True, stdout=subprocess.DEVNULL)
        return Profile(file)


def window_of(options, home, away):
    return Window(profile_of(options, home, away, options.limit), profile_of(options, home, away, getattr(options, "from")))


def compare(options):
    """The committed numbers of all pairings; whether none has grown."""
    lines = [line for line in options.compare.read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
    heads = [line for line in options.compare.read_text(encoding="utf-8").splitlines() if line.startswith("#")]
    pairings = [line.split() for line in lines]
    with concurrent.futures.ThreadPoolExecutor(2) as both:
        counted = [window.per_decision() for window in
                   both.map(lambda pairing: window_of(options, f"configs/teams/{pairing[0]}.yaml",
                                                      f"configs/teams/{pairing[1]}.yaml"), pairings)]
    grown = []
    for (home, away, committed), now in zip(pairings, counted):
        change = 100 * (now / float(committed) - 1)
        print(f"{home} {away}: {now:.0f} instructions per decision, {change:+.1f} % of {committed}")
        if now > (1 + TOLERANCE) * float(committed):
            grown.append(f"{home}/{away}")
    if options.write:
        options.compare.write_text("\n".join(heads + [f"{home} {away} {now:.0f}" for (home, away, _), now in
                                                      zip(pairings, counted)]) + "\n", encoding="utf-8")
        grown = []
    print(f"{len(pairings)} pairings in seconds {getattr(options, 'from'):.0f} to {options.limit:.0f}; more than "
          f"{100 * TOLERANCE:.0f} % dearer: {', '.join(grown) or 'none'}")
    return 1 if grown else 0


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("regista")
    parser.add_argument("home", nargs="?")
    parser.add_argument("away", nargs="?")
    parser.add_argument("--from", type=float, default=60, help="simulated seconds; 60")
    parser.add_argument("--limit", type=float, default=300, help="simulated seconds; 300")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="as of regista match")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--compare", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    if options.write and not options.compare:
        parser.error("--write: needs --compare FILE")
    if options.compare:
        return compare(options)
    if not options.away:
        parser.error("which teams? HOME AWAY, or --compare FILE")
    window = window_of(options, options.home, options.away)
    counts = {"decision": window.decisions, "step": window.steps}
    rows = [("everything, Box2D included", window.total, "decision"),
            *((name, window.of(name, pattern), per) for name, pattern, per in STAGES)]
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
    for name, cost in window.own.most_common(25):
        print(f"  {cost / counts['decision']:>8,.0f}  {name[:120]}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
