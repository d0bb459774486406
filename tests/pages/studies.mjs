// SPDX-License-Identifier: MIT
// Short studies whose pages are measured, one of each kind. Names are as long as users make them.
import { spawnSync } from "node:child_process";
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const soon = "set: {rules.durations.ready: 3, rules.durations.set: 1}";
const long = "late events, nobody sends before the last minute";

function documents(teams) {
  const team = (name) => join(teams, `${name}.yaml`);
  const head = (name) => `experiment: ${name}
question: Does it matter to the coordination of the team how often a robot may speak, and how many of its words get lost?
opponent: ${team("spqr2023")}
matches: 4
limit: 30
${soon}
`;
  const arms = `arms:
  - {name: fixed rate, team: ${team("fixed_rate")}}
  - {name: "${long}", team: ${team("events_only")}, set: {sender.params.reserve: 60}}
  - {name: paper, team: ${team("paper")}}
`;
  return {
    "arms.yaml": head("arms") + arms + "primary: {measure: overlap_seconds}\n",
    "measures.yaml": head("measures") + arms +
      "measures: [packets, agreement, goal_difference, striker.switches]\nprimary: {measure: packets}\n",
    "sweep.yaml": head("sweep") + arms + "measures: [overlap_seconds, packets]\n" +
      "primary: {measure: packets, compare: [[fixed rate, paper]]}\n" +
      "sweep: {path: a_disturbance.radio.loss, values: [0, 0.3, 0.6]}\n",
    "named_values.yaml": head("named_values") + arms + "measures: [overlap_seconds, packets]\n" +
      "sweep: {path: assigner.plugin, values: [greedy, hungarian]}\n",
    "tuning.yaml": `tuning: tuning
question: Are other weights better?
team: ${team("paper")}
opponents: [{team: ${team("fixed_rate")}, weight: 2}, {team: ${team("spqr2023")}}]
parameters: [utility.terms.distance.weight, utility.terms.bearing.weight, utility.terms.persistence.weight]
objective: {minimise: uncovered_seconds}
limit: 20
${soon}
seed: 7
search: {algorithm: spsa, matches: 24}
selection: {finalists: 2, matches: 8}
verification: {candidates: 1, matches: 24, against: base}
slices: {points: 3, pairs: 2}
`,
    // The base team is so bad that something else comes first and is verified.
    "verified.yaml": `tuning: verified
team: ${team("paper")}
set: {utility.terms.distance.weight: 0.02, utility.terms.bearing.weight: 1, rules.durations.ready: 3, rules.durations.set: 1}
opponents: [{team: ${team("spqr2023")}}]
parameters: [utility.terms.distance.weight, utility.terms.bearing.weight]
objective: {minimise: uncovered_seconds}
limit: 30
seed: 3
search: {algorithm: random_search, matches: 24}
selection: {finalists: 3, matches: 12}
verification: {candidates: 2, matches: 90}
slices: {points: 0}
`,
  };
}

// The studies by name: what plays each, and how many figures its page has at least.
const commands = (teams, openings) => {
  const entrants = (...names) => names.flatMap((name) => ["--team", join(teams, `${name}.yaml`)]);
  // Scenes in which goals fall.
  const short = ["--openings", openings, "--limit", "30", "--set", "rules.durations.ready=3", "--set", "rules.durations.set=1"];
  const experiment = (name, figures) => ({ words: ["experiment", `${name}.yaml`], figures });
  return {
    two_teams: { words: ["tournament", ...entrants("paper", "spqr2023"), "--pairs", "6", ...short], figures: 5 },
    four_teams: {
      words: ["tournament", ...entrants("paper", "spqr2023", "fixed_rate", "events_only"), "--pairs", "2", ...short],
      figures: 2,
    },
    arms: experiment("arms", 4),
    measures: experiment("measures", 3),
    sweep: experiment("sweep", 2),
    named_values: experiment("named_values", 2),
    tuning: { words: ["tune", "tuning.yaml"], figures: 6 },
    verified: { words: ["tune", "verified.yaml"], figures: 4 },
  };
};

// Plays them in the folder and returns their pages.
export function playStudies(program, source, folder) {
  const teams = join(source, "configs/teams");
  mkdirSync(folder, { recursive: true });
  for (const [name, text] of Object.entries(documents(teams))) writeFileSync(join(folder, name), text);
  return Object.entries(commands(teams, join(source, "configs/openings"))).map(([name, { words, figures }]) => {
    const { status, stderr } = spawnSync(program, [...words, "--results", `${name}.db`, "--quiet"],
                                         { cwd: folder, encoding: "utf8" });
    if (status !== 0) throw new Error(`${name}: status ${status}: ${stderr}`);
    return { name, file: join(folder, `${name}.html`), figures };
  });
}
