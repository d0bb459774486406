# SPDX-License-Identifier: MIT
# schema_test.py PRINT_SCHEMA PROJECT: holds the generated schemas against their meta-schema, our documents, and
# documents that are wrong in one place each.
import copy
import json
import pathlib
import subprocess
import sys

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

program, project = sys.argv[1], pathlib.Path(sys.argv[2])
failures = []


def validator(*arguments):
    text = subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout
    schema = json.loads(text)
    jsonschema.Draft202012Validator.check_schema(schema)
    return jsonschema.Draft202012Validator(schema)


def load(path):
    return yaml.safe_load((project / path).read_text(encoding="utf-8"))


def expect(valid, schema, document, what):
    if schema.is_valid(document) != valid:
        reasons = "; ".join(error.message for error in schema.iter_errors(document))
        failures.append(f"{what}: {'refused: ' + reasons if valid else 'accepted'}")


def changed(document, path, value):
    """The document with the value at a path of keys and indices; None as value removes."""
    result = copy.deepcopy(document)
    place = result
    for key in path[:-1]:
        place = place[key]
    if value is None:
        del place[path[-1]]
    else:
        place[path[-1]] = value
    return result


rules, robot, disturbance = validator("rules"), validator("robot"), validator("disturbance")
opening = validator("opening")
tuning, tournament = validator("tuning"), validator("tournament")
team, team_with_plugins = validator("team"), validator("team", "plugins")
documents = {
    "rules": load("configs/rules/spl2023.yaml"),
    "robot": load("configs/robots/nao.yaml"),
    "disturbance": load("configs/disturbances/none.yaml"),
    "opening": load("configs/openings/cross_from_the_right.yaml"),
    "team": load("tests/fixtures/config/team.yaml"),
    "tuning": load("configs/studies/tune_paper.yaml"),
    "tournament": load("configs/studies/rivals.yaml"),
}
schemas = {"rules": [rules], "robot": [robot], "disturbance": [disturbance], "opening": [opening],
           "team": [team, team_with_plugins], "tuning": [tuning], "tournament": [tournament]}

for kind, document in documents.items():
    for other, choices in schemas.items():
        for schema in choices:
            expect(kind == other, schema, document, f"{kind} as {other}")

for folder, kind in [("rules", "rules"), ("robots", "robot"), ("disturbances", "disturbance"), ("openings", "opening"),
                     ("teams", "team")]:
    for path in sorted((project / "configs" / folder).rglob("*.yaml")):
        expect(True, schemas[kind][0], load(path.relative_to(project)), path.name)

broken = {
    "rules": [
        (["rules"], None), (["rules"], "a b"), (["team_size"], 0), (["team_size"], 5.5), (["field", "lenght"], 9),
        (["field", "length"], "9 m"), (["field", "length"], 1000), (["durations", "half"], -1),
        (["messages", "size"], 63), (["messages", "budget"], -1), (["messages"], [1]), (["extra"], {}),
    ],
    "robot": [
        (["kicks"], []), (["kicks", 0, "name"], None), (["kicks", 0, "power"], 1), (["kicks", 0, "impact"], -1),
        (["walk", "turn"], 1.5), (["camera", "ball_probability"], 1.5), (["decision_period"], 0.01),
    ],
    "disturbance": [(["radio", "loss"], 1.1), (["radio", "los"], 0.1), (["disturbance"], None), (["incidents"], [{"kind": "crash"}]),
                    (["incidents"], [{"kind": "crash", "at": -1}]), (["incidents"], [{"kind": "crush", "at": 1}]),
                    (["incidents"], [{"kind": "crash", "at": 1, "robots": 0}])],
    "opening": [
        (["opening"], None), (["length"], None), (["length"], 0), (["summary"], "two\nlines"), (["summary"], 7),
        (["ball"], None), (["ball", "at"], None), (["ball", "at"], [0]), (["ball", "velocity"], [0, 30]),
        (["ball", "position"], [0, 0]), (["home"], None), (["away"], []), (["away", 0], [1, 2, 3]),
        (["home", 0, "at"], None), (["home", 0, "at"], [200, 0]), (["home", 0, "heading_deg"], 400),
        (["home", 0, "heading"], 1),
    ],
    "team": [
        (["assigner"], None), (["assigner", "plugin"], None), (["assigner", "weight"], 1),
        (["predictors", "self"], None), (["contexts"], []), (["contexts", 0, "name"], None),
        (["contexts", 1, "use", "rolls"], "x"), (["contexts", 1, "use", "roles.playing"], "x"),
        (["contexts", 1, "priority"], "high"), (["roles"], {}), (["roles", "playing"], []),
        (["roles", "playing", 0, "target", "at"], "ball"), (["roles", "playing", 1, "target"], {}),
        (["roles", "playing", 1, "target", "at"], "moon"), (["roles", "playing", 1, "target", "at"], [1, 2, 3]),
        (["roles", "playing", 1, "target", "from_goal"], 0.4), (["roles", "playing", 1, "target", "shift"], [1]),
        (["roles", "playing", 0, "target", "on_line"], ["ball"]), (["roles", "playing", 1, "behaviour"], "2nd"),
        (["roles", "playing", 3, "target", "on_circle", "centre"], None), (["roles", "play ing"], [{}]),
        (["utility", "terms", "distance", "weight"], -0.1), (["utility", "terms", "distance", "tune"], [0]),
        (["tasks", "keep"], "some"), (["tasks", "offset"], 0.5), (["teammates_forgotten_after"], 0),
    ],
    "tuning": [
        (["team"], None), (["opponents"], None), (["opponents"], []), (["opponents", 0, "team"], None),
        (["opponents", 0, "weight"], 0), (["parameters"], None), (["parameters"], []), (["parameters"], "a.b"),
        (["parameters", 0], 1), (["parameters", 0], {"range": [0, 1]}), (["parameters", 0], {"path": "a", "range": [0]}),
        (["parameters", 0], {"path": "a", "ranges": [0, 1]}), (["objective"], {}), (["objective"], "points"),
        (["objective"], {"maximise": "a", "minimise": "b"}), (["objective"], {"maximise": {}}),
        (["objective"], {"maximise": {"a": "b"}}), (["seed"], -1), (["search", "matches"], 1),
        (["search", "algoritm"], "spsa"), (["selection", "finalists"], 0), (["verification", "candidates"], 0),
        (["verification", "confidence"], 1), (["verification", "against"], "team"), (["slices"], {"points": -1}),
        (["openings"], []), (["limit"], 0), (["set"], [1]),
    ],
    "tournament": [
        (["tournament"], None), (["teams"], None), (["teams"], []), (["teams"], [{"team": "a.yaml"}]),
        (["teams", 0], "a.yaml"), (["teams", 0, "team"], None), (["format"], "round-robin"), (["pairs"], 0),
        (["test"], {}), (["test"], {"elo": [0, 20], "metric": "goals"}), (["test"], {"elo": [0]}),
        (["test"], {"metric": "goals", "alpha": 1}), (["seed"], -1), (["openings"], []), (["set"], [1]),
        (["failures_in_a_row"], -1), (["isolation"], "never"),
    ],
}
# What the reader accepts.
for path, value in [
    (["parameters"], ["a.b", {"path": "c.*", "range": [0.5, 2]}, {"path": "d"}]),
    (["objective"], {"minimise": {"striker.overlap_seconds": 1, "packets": -0.01}}), (["objective"], None),
    (["openings"], "scenes"), (["openings"], ["a", "b"]), (["limit"], 120.5), (["set"], {"tasks.keep": "all"}),
    (["search"], {"algorithm": "spsa", "matches": 500, "minutes": 2.5, "pairs": 3, "population": 20}),
    (["verification"], {"candidates": 2, "against": "base", "confidence": 0.99}), (["slices"], {"points": 0}),
    (["opponents", 0, "weight"], 2.5), (["question"], None), (["extends"], "other.yaml"),
]:
    expect(True, tuning, changed(documents["tuning"], path, value), f"tuning with {path} = {value}")
for path, value in [(["test"], {"elo": [0, 20], "model": "logistic", "beta": 0.1}), (["test"], {"metric": "goals"}),
                    (["format"], "gauntlet"), (["set"], {"a.sender.params.reserve": 20}), (["openings"], None)]:
    expect(True, tournament, changed(documents["tournament"], path, value), f"tournament with {path} = {value}")
for kind, changes in broken.items():
    for path, value in changes:
        for schema in schemas[kind]:
            expect(False, schema, changed(documents[kind], path, value), f"{kind} with {path} = {value}")

# What plugins declare: wrong only where they are known.
for path, value in [
    (["assigner", "plugin"], "gredy"), (["assigner", "plugin"], "voronoi"), (["assigner", "params"], {"x": 1}),
    (["sender", "params", "reserve"], 1.5), (["sender", "params", "reserve"], -1),
    (["sender", "params", "period"], "4 s"),
    (["sender", "params", "whistle"], 1), (["utility", "terms", "persistence", "params", "for_robots"], "none"),
    (["contexts", 1, "params", "after"], 61),
]:
    document = changed(documents["team"], path, value)
    expect(True, team, document, f"team with {path} = {value}, plugins not known")
    expect(False, team_with_plugins, document, f"team with {path} = {value}, plugins known")

# Variants: nothing is required, null removes, the rest holds.
for schema in (team, team_with_plugins):
    expect(True, schema, {"extends": "paper.yaml"}, "bare variant")
    expect(True, schema, {"extends": "paper.yaml", "positioner": None, "sender": {"params": {"period": 4}}}, "variant")
    expect(True, schema, {"extends": "paper.yaml", "utility": {"terms": {"waypoint": None}}}, "variant without a term")
    expect(True, schema, {"extends": "paper.yaml", "roles": {"playing": {"striker": {"required": False}, "sweeper": None}}},
           "roles changed by their names")
    expect(True, schema, {"extends": "paper.yaml", "contexts": {"corner": {"plugin": "always", "after": "playing"}}},
           "a context added by its name")
    expect(False, schema, {"extends": "paper.yaml", "roles": {"playing": {"striker": {"requires": False}}}},
           "an unknown key of a role that is changed by its name")
    expect(False, schema, {"team": "x", "roles": {"playing": {"striker": {}}}}, "roles by their names without extends")
    expect(False, schema, {"extends": "paper.yaml", "senders": None}, "variant with an unknown key")
    expect(False, schema, {"extends": "paper.yaml", "roles": {"playing": [{"name": "a"}]}}, "incomplete list element")
    expect(False, schema, {"team": "x", "positioner": None}, "null without extends")
expect(False, team_with_plugins, {"extends": "p.yaml", "sender": {"plugin": "event_based", "params": {"x": 1}}},
       "variant with an unknown parameter")

print("\n".join(failures) if failures else "all documents judged as expected")
sys.exit(1 if failures else 0)
