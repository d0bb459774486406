#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures what docs/realism.md sets beside figures of real games and robots, and writes the table of that page: plays
whole matches between shipped teams, records them, counts in the recordings and in the numbers of the matches, and asks
benchmark_senses for what no match can show. ROWS is the one place of the real figures and their sources.

    realism.py BIN CONFIGS [--matches 5] [--page docs/realism.md]

BIN: the folder of the programs regista and benchmark_senses. --matches: of each pair of teams. --page: the table between
its two marks is replaced; without it the table is printed. Needs python3-zstandard."""

import argparse
import collections
import concurrent.futures
import datetime
import itertools
import json
import math
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from typing import Callable

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "end_to_end"))
os.environ.setdefault("REGISTA_PROGRAM", "")
import recorded  # noqa: E402

PAIRS = (("paper", "fixed_rate"), ("spqr2023", "events_only"), ("regista", "scram"), ("formation", "spqr2023"))
SIDES = ("home", "away")
BEGIN, END = "<!-- realism: begin -->", "<!-- realism: end -->"
STEP = 0.1        # s between two messages of a recording
KICK_SPEED = 0.5  # m/s: a ball that is faster within a step of the recording was kicked
PLAYED = 0.15     # m in a second: a robot that comes farther is walking
SECTOR = math.radians(20)    # to either side of a direction: walking that way
STRAIGHT = math.radians(15)  # a robot that turns by less in a second walks straight on
TURNING = math.radians(20)   # in a second: one that turns by more is turning
LEAST_RATE = 0.05  # a minute: less is not told
ALONE = 0.5        # m: with another robot nearer, what the ball does is not the kick's alone
CONFIGURATIONS, DESCRIPTIONS = "configurations of teams", "teams' descriptions"
NONE = "none published"


def spread(sample, digits=2, unit="", of_mean=None):
    """Mean, and from the 5 % to the 95 % quantile. of_mean: its digits, where they are not those of the quantiles."""
    ordered = sorted(sample)
    if not ordered:
        return "none seen"
    at = lambda share: f"{ordered[min(len(ordered) - 1, int(share * len(ordered)))]:.{digits}f}"  # noqa: E731
    return f"{mean(ordered):.{digits if of_mean is None else of_mean}f}{unit} ({at(0.05)} to {at(0.95)})"


def mean(sample):
    return statistics.mean(sample) if sample else math.nan


class Seen:
    """What recordings tell."""

    def __init__(self):
        self.events = collections.Counter()
        self.samples = collections.defaultdict(list)

    def add(self, other):
        self.events += other.events
        for name, sample in other.samples.items():
            self.samples[name] += sample

    def count(self, recording):
        past, lying = [], {}
        for topic, message in recording.messages:
            if topic == "/event":
                self.events[message.get("offence", message["event"])] += 1
                past = []
            if topic != "/game":
                continue
            self.lying(message, lying)
            if message["phase"] != "playing":
                past = []
                continue
            if len(past) == 10:
                self.ball(past[-1], message)
                self.robots(past[0], message)
            past = [*past[-9:], message]
        return self

    def lying(self, message, since):
        """How long robots lie until they stand again, unless they are taken away meanwhile."""
        for side in (0, 1):
            for number in range(1, len(message[SIDES[side]]) + 1):
                key = side, number
                if number in message["penalised"][side]:
                    since.pop(key, None)
                elif number in message["fallen"][side]:
                    since.setdefault(key, message["time"])
                elif key in since:
                    self.samples["lying"].append(message["time"] - since.pop(key))

    def ball(self, before, now):
        speed, old_speed = math.hypot(*now["ball"][2:]), math.hypot(*before["ball"][2:])
        kickers = [(side, number) for side in (0, 1) for number in now["kicks"][side]]
        if speed > KICK_SPEED and speed > old_speed + 0.3 and kickers:
            self.samples["kick_speed"].append(speed)
            # Whose kick it was: the nearest of those that kick.
            own = min((before[SIDES[side]][number - 1] for side, number in kickers),
                      key=lambda pose: math.dist(pose[:2], before["ball"][:2]))
            near = [pose for side in SIDES for pose in before[side] if math.dist(pose[:2], before["ball"][:2]) < ALONE]
            if near == [own]:
                off = wrapped(math.atan2(now["ball"][3], now["ball"][2]) - own[2])
                self.samples["kick_off_heading"].append(math.degrees(abs(off)))
        elif 0.2 < speed < old_speed and old_speed - speed < 0.06:
            self.samples["deceleration"].append((old_speed - speed) / STEP)

    def robots(self, then, now):
        """What each did within the last second."""
        for side in SIDES:
            for old, new in zip(then[side], now[side]):
                way, turn = math.dist(old[:2], new[:2]), wrapped(new[2] - old[2])
                if way > 1.0:
                    continue  # it was placed anew
                if abs(turn) > TURNING and way < PLAYED:
                    self.samples["turning"].append(math.degrees(abs(turn)))
                if way < PLAYED:
                    continue
                self.samples["walking"].append(way)
                bearing = abs(wrapped(math.atan2(new[1] - old[1], new[0] - old[0]) - old[2] - turn / 2))
                if abs(turn) < STRAIGHT:
                    for name, middle in (("ahead", 0.0), ("sideways", math.pi / 2), ("back", math.pi)):
                        if abs(bearing - middle) < SECTOR:
                            self.samples[name].append(way)


def wrapped(angle):
    return math.remainder(angle, math.tau)


class Measured:
    """All that rows are made of: the numbers of matches, what was seen, what benchmark_senses prints."""

    def __init__(self, matches, seen, senses):
        self.matches, self.seen, self.senses = matches, seen, senses
        self.minutes = [match["simulated_seconds"] / 60 for match in matches]

    def of_teams(self, name):
        return [value for match in self.matches for value in match[name]]

    def a_team(self, name, digits=1):
        return f"{mean(self.of_teams(name)):.{digits}f}"

    def error(self, part):
        return f"{mean([world[part]['rmse_metres'] for world in self.of_teams('world_model')]):.2f} m"

    def packets(self):
        return [number / minutes for match, minutes in zip(self.matches, self.minutes) for number in match["packets"]]

    def reasons(self, team):
        """Packets a minute, those of the largest number first."""
        sums, played = collections.Counter(), 0.0
        for match, minutes in zip(self.matches, self.minutes):
            for name, reasons in zip(match["teams"], match["packets_by_reason"]):
                if name == team:
                    sums.update(reasons)
                    played += minutes
        return {reason: number / played for reason, number in sums.most_common() if number / played >= LEAST_RATE}

    def events(self, *names):
        """A match."""
        return ", ".join(f"{name.replace('_', ' ')} {self.seen.events[name] / len(self.matches):.2g}" for name in names)

    def kick(self, kind, asked):
        found = re.search(rf"^kick {kind} +asked {asked:.1f} m: rolls ([\d.]+) m \(5 to 95 %: ([\d.]+) to ([\d.]+)\), "
                          r"direction \S+ \+- ([\d.]+) deg$", self.senses, re.MULTILINE)
        return found.groups()

    def kick_distance(self, kind, asked):
        rolled, low, high, _ = self.kick(kind, asked)
        return f"{rolled} m ({low} to {high})"

    def detection(self, what):
        """Shares of images, by distance: whole metres, those with the same share together."""
        bins = [(int(metre), f"{float(seen):.2f}") for metre, seen in
                re.findall(rf"^{what} +(\d+) to \d+ m: seen in ([\d.]+) of", self.senses, re.MULTILINE)]
        grouped = [(share, [metre for metre, _ in group]) for share, group in itertools.groupby(bins, lambda each: each[1])]
        return ", ".join(f"{share} at {metres[0]} to {metres[-1] + 1} m" for share, metres in grouped)

    def false_balls(self):
        return f"{float(re.search(r'false balls: ([0-9.]+) a frame', self.senses)[1]):.4f} an image"


@dataclass(frozen=True)
class Row:
    quantity: str
    simulated: Callable
    real: str = NONE
    source: str = ""


def by_events(reasons):
    events = {reason: rate for reason, rate in reasons.items() if reason != "period"}
    return (f"{sum(events.values()):.1f} a minute: " + ", ".join(f"{name.replace('_', ' ')} {rate:.1f}"
            for name, rate in events.items()) + f"; period {reasons.get('period', 0.0):.0f}")


def goals(measured):
    sample = [sum(match["score"]) for match in measured.matches]
    deviation = f", standard deviation {statistics.stdev(sample):.1f}" if len(sample) > 1 else ""
    return spread(sample, 0, deviation, of_mean=2)


ROWS = (
    Row("goals of a match", goals,
        "RoboCup 2023: mean 5.4, standard deviation 3.1 (64 matches); 2022: 4.2; 2024: 4.8. German Open 3.9 to 5.6",
        "results collected by the league (RoboCup-SPL/Ratings)"),
    Row("ball in play", lambda m: spread([100 * x["in_play_seconds"] / 1200 for x in m.matches], 0, " % of the clock")),
    Row("ball seen by a robot of the team", lambda m: spread([100 * x for x in m.of_teams("ball_seen_share")], 0,
                                                             " % of play")),
    Row("packets of a team", lambda m: spread(m.packets(), 0, " a minute"),
        "at most 55 a minute over a match of 1302 s: the budget of 1200", "rule book 2023"),
    Row("of them by events (paper)", lambda m: by_events(m.reasons("paper"))),
    Row("falls", lambda m: spread(m.of_teams("falls"), 0, " a team and match"), "none published: assumption"),
    Row("lying after a fall", lambda m: spread(m.seen.samples["lying"], 1, " s"),
        "5 s; how often it fails is not published", CONFIGURATIONS),
    Row("penalties", lambda m: f"{m.a_team('penalties')} a team and match; of both: " + m.events(
        "pushing", "illegal_position", "illegal_position_in_set", "motion_in_set", "ball_holding", "fallen", "inactive",
        "local_game_stuck", "leaving_the_field")),
    Row("set plays of a match", lambda m: m.events("kick_in", "goal_kick", "corner_kick", "pushing_free_kick",
                                                   "penalty_kick", "game_stuck", "goal_not_counted")),
    Row("passes, shots, kicks of a team", lambda m: ", ".join(m.a_team(name) for name in ("passes", "shots", "kicks"))),
    Row("speed of a ball just kicked", lambda m: spread(m.seen.samples["kick_speed"], 2, " m/s"),
        "kicks 0.98 to 1.64 m/s (fast), 1.8 (long); in-walk 0.5 to 0.8 by their distances", CONFIGURATIONS),
    Row("kick distance (500 lone kicks each)", lambda m: "fast, asked for 1.6 / 4.5 m: "
        f"{m.kick_distance('fast', 1.6)} / {m.kick_distance('fast', 4.5)}; long {m.kick_distance('long', 5.4)}; "
        f"in-walk, asked for 0.4 / 1.0 m: {m.kick_distance('in_walk', 0.4)} / {m.kick_distance('in_walk', 1.0)}",
        "fast 1.6 to 4.5 m, long 5.4 m, in-walk 0.4 to 1.0 m, triangular 7 %", CONFIGURATIONS),
    Row("kick direction", lambda m: f"standard deviation {m.kick('fast', 4.5)[3]} degrees", "7 degrees", CONFIGURATIONS),
    Row("angle between kick and heading", lambda m: spread(m.seen.samples["kick_off_heading"], 0, " degrees"),
        NONE + "; see below"),
    Row("deceleration of a rolling ball", lambda m: spread(m.seen.samples["deceleration"], 2, " m/s^2"), "0.30 to 0.35",
        CONFIGURATIONS),
    Row("walking, metres in a second", lambda m: "; ".join(
        f"{name}{spread(m.seen.samples[key])}" for name, key in (("", "walking"), ("ahead ", "ahead"),
                                                                 ("sideways ", "sideways"), ("back ", "back"))),
        "0.25 ahead, up to 0.30; 0.18 sideways; 0.20 back", CONFIGURATIONS),
    Row("turning on the spot, degrees in a second", lambda m: spread(m.seen.samples["turning"], 0),
        "at most 70 to 120", CONFIGURATIONS),
    Row("distance walked", lambda m: f"{mean(m.of_teams('distance_walked_metres')):.0f} m a team and match, about "
        f"{mean(m.of_teams('distance_walked_metres')) / 7:.0f} m a robot"),
    Row("a ball in view and unhidden is seen", lambda m: m.detection("ball"), "5 m at 0.9 (SPQR: 3 m)", CONFIGURATIONS),
    Row("a robot in view and unhidden is seen", lambda m: m.detection("robot") + " (told by place, so neighbours count)",
        "4 m at 0.6", CONFIGURATIONS),
    Row("false balls", Measured.false_balls, "0.0005", CONFIGURATIONS),
    Row("error of the own place", lambda m: m.error("self") + " (root mean square)", '"a few centimetres most of the time"',
        DESCRIPTIONS),
    Row("mirrored and mislocalised robots", lambda m: "none, unless a [disturbance](disturbances.md) says so",
        "happen, and hurt most", DESCRIPTIONS + "; no rate published"),
    Row("error of teammates, ball", lambda m: f"{m.error('teammates')}, {m.error('ball')} (root mean square)"),
)


def table(measured, matches):
    month = datetime.date.today().strftime("%B %Y")
    lines = [f"Measured in {month} on {len(measured.matches)} whole matches between shipped teams ({len(PAIRS)} pairs of "
             f"teams, {matches} seeds each); in brackets the 5 % and 95 % quantiles:", "", "| quantity | simulated | real | source |", "|---|---|---|---|"]
    return lines + [f"| {row.quantity} | {row.simulated(measured)} | {row.real} | {row.source} |".replace("|  |", "| |")
                    for row in ROWS]


def with_table(page, lines):
    """The page, with these lines between its marks."""
    before, _, rest = page.partition(BEGIN)
    _, _, after = rest.partition(END)
    assert after, f"the page lacks the lines {BEGIN} and {END}"
    return "\n".join((before + BEGIN, "", *lines, "", END + after))


def play(program, configs, folder, home, away, seed):
    """The numbers of a match, and what its recording tells."""
    file = pathlib.Path(folder) / f"{home}_{away}_{seed}.mcap"
    teams = [str(configs / "teams" / f"{name}.yaml") for name in (home, away)]
    done = subprocess.run([program, "match", *teams, "--seed", str(seed), "--json", "--quiet", "--record", str(file)],
                          capture_output=True, text=True, check=True)
    seen = Seen().count(recorded.Recording(file.read_bytes()))
    file.unlink()
    return json.loads(done.stdout), seen


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("bin", type=pathlib.Path)
    words.add_argument("configs", type=pathlib.Path)
    words.add_argument("--matches", type=int, default=5)
    words.add_argument("--page", type=pathlib.Path)
    asked = words.parse_args()
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        senses = pool.submit(subprocess.run, [asked.bin / "benchmark_senses"], capture_output=True, text=True, check=True)
        jobs = [pool.submit(play, asked.bin / "regista", asked.configs, folder, *pair, seed)
                for pair in PAIRS for seed in range(1, asked.matches + 1)]
        results = [job.result() for job in jobs]
        seen = Seen()
        for _, each in results:
            seen.add(each)
        measured = Measured([match for match, _ in results], seen, senses.result().stdout)
    lines = table(measured, asked.matches)
    if asked.page is None:
        print("\n".join(lines))
    else:
        asked.page.write_text(with_table(asked.page.read_text(), lines))


if __name__ == "__main__":
    main()
