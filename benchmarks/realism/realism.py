#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Measures what docs/realism.md sets beside figures of real games: plays whole matches between shipped teams, records
them, and counts in the recordings and in the numbers of the matches.

    python3 benchmarks/realism/realism.py build/release/bin/regista configs [MATCHES]

MATCHES: of each pair of teams, 5 unless given. Needs python3-zstandard."""

import collections
import concurrent.futures
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "end_to_end"))
os.environ.setdefault("REGISTA_PROGRAM", "")
import recorded  # noqa: E402

PAIRS = (("paper", "fixed_rate"), ("spqr2023", "events_only"), ("regista", "scram"), ("formation", "spqr2023"))
KICK_SPEED = 0.5  # m/s: a ball that is faster within a step of the recording was kicked
PLAYED = 0.15  # m/s: a robot that is faster is walking


def play(program, configs, folder, home, away, seed):
    """The numbers of a match, and what its recording tells."""
    file = pathlib.Path(folder) / f"{home}_{away}_{seed}.mcap"
    teams = [str(configs / "teams" / f"{name}.yaml") for name in (home, away)]
    done = subprocess.run([program, "match", *teams, "--seed", str(seed), "--json", "--quiet", "--record", str(file)],
                          capture_output=True, text=True, check=True)
    seen = count(recorded.Recording(file.read_bytes()))
    file.unlink()
    return json.loads(done.stdout), seen


def count(recording):
    out = {"events": collections.Counter(), "kick_speeds": [], "decelerations": [], "walking": [], "turning": []}
    before = []
    for topic, message in recording.messages:
        if topic == "/event":
            out["events"][message.get("offence", message["event"])] += 1
            before = []
        if topic != "/game" or message["phase"] != "playing":
            continue
        ball = message["ball"]
        speed = math.hypot(*ball[2:])
        if len(before) >= 10:
            old = before[-1]
            old_speed = math.hypot(*old["ball"][2:])
            if speed > KICK_SPEED and speed > old_speed + 0.3 and any(message["kicks"][0] + message["kicks"][1]):
                out["kick_speeds"].append(speed)
            elif 0.2 < speed < old_speed and old_speed - speed < 0.06:
                out["decelerations"].append((old_speed - speed) / 0.1)
            for side in ("home", "away"):
                for now, then in zip(message[side], before[-10][side]):
                    distance = math.hypot(now[0] - then[0], now[1] - then[1])
                    if PLAYED < distance < 1.0:
                        out["walking"].append(distance)
        before = [*before[-9:], message]
    return out


def row(name, values, digits=2):
    values = sorted(values)
    at = lambda share: values[min(len(values) - 1, int(share * len(values)))]  # noqa: E731
    print(f"{name:42s} mean {statistics.mean(values):8.{digits}f}   5 % {at(0.05):8.{digits}f}   "
          f"median {at(0.5):8.{digits}f}   95 % {at(0.95):8.{digits}f}   n {len(values)}")


def main():
    program, configs = sys.argv[1], pathlib.Path(sys.argv[2])
    seeds = range(1, 1 + int(sys.argv[3] if len(sys.argv) > 3 else 5))
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(play, program, configs, folder, *pair, seed) for pair in PAIRS for seed in seeds]
        results = [job.result() for job in jobs]
    matches = [match for match, _ in results]
    seen = [each for _, each in results]
    minutes = [match["simulated_seconds"] / 60 for match in matches]
    row("goals of a match", [sum(match["score"]) for match in matches])
    row("ball in play, share of the clock", [match["in_play_seconds"] / 1200 for match in matches])
    row("ball seen by a robot of the team", [x for match in matches for x in match["ball_seen_share"]], 3)
    for key in ("shots", "passes", "kicks", "falls", "penalties", "distance_walked_metres"):
        row(f"{key}, of a team", [x for match in matches for x in match[key]])
    row("packets per minute, of a team", [x / m for match, m in zip(matches, minutes) for x in match["packets"]])
    for part, key in (("self", "rmse_metres"), ("ball", "rmse_metres"), ("teammates", "rmse_metres"),
                      ("opponents", "ospa_metres")):
        row(f"{part}: {key}", [world[part][key] for match in matches for world in match["world_model"]])
    row("speed of a ball just kicked, m/s", [x for each in seen for x in each["kick_speeds"]])
    row("deceleration of a rolling ball, m/s^2", [x for each in seen for x in each["decelerations"]])
    row("metres walked within a second, if any", [x for each in seen for x in each["walking"]], 3)
    total = sum((each["events"] for each in seen), collections.Counter())
    for event, number in sorted(total.items()):
        print(f"{event:42s} {number / len(seen):8.2f} a match")
    reasons = collections.defaultdict(list)
    for match, m in zip(matches, minutes):
        for team, packets in zip(match["teams"], match["packets_by_reason"]):
            for reason, number in packets.items():
                reasons[team, reason].append(number / m)
    for (team, reason), values in sorted(reasons.items()):
        if sum(values) > 0:
            print(f"packets, {team}: {reason:25s} {statistics.mean(values):8.2f} a minute")


if __name__ == "__main__":
    main()
