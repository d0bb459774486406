// SPDX-License-Identifier: MIT
// The viewer of one match: its parts, put together.
import { Address, fragmentOf, readFragment } from "./app/fragment";
import { type Key, listenToKeys } from "./app/keys";
import { type Palette, readPalette } from "./app/palette";
import { Playback } from "./app/playback";
import { type PanelName, type Robot, State, type View, layerNames, panelNames, speeds } from "./app/state";
import { decisionStep, eventStep, goalStep, timeOf } from "./app/steps";
import type { Theme } from "./app/theme";
import { Field } from "./field/field";
import { FieldPart } from "./field/field_part";
import { Heat } from "./field/heat";
import { type Pair, pairAt, pairNow } from "./model/compare";
import { type Stretch, neighbour } from "./model/roles";
import { countSwitches } from "./model/switches";
import { shortened, timeText } from "./model/text";
import { AtBallPanel } from "./panels/at_ball";
import { ComparePanel } from "./panels/compare";
import { DrawingChoice, hasDrawings } from "./panels/drawing_choice";
import { byId, element, row, setText } from "./panels/elements";
import { GoalPanel } from "./panels/goals";
import { Head } from "./panels/head";
import { HeatChoice } from "./panels/heat_choice";
import { LayerChoice, layerKeys } from "./panels/layer_choice";
import { LogPanel, hasLines } from "./panels/log";
import { MatchPanel } from "./panels/match";
import { OverlapList } from "./panels/overlaps";
import { PlayPanel } from "./panels/plays";
import { RobotPanel } from "./panels/robot";
import { SegmentPanel, hasSegments } from "./panels/segments";
import type { Side } from "./recording/about";
import type { Match } from "./recording/match";
import { isGoal } from "./recording/messages";
import { stripLanes } from "./time/detail";
import { playLane } from "./time/plays";
import { Timeline } from "./time/timeline";

const panelTexts: Record<PanelName, string> = {
  overlaps: "Role overlaps",
  robot: "Robot",
  compare: "Compare",
  goals: "Goals",
  plays: "Actions",
  ball: "At the ball",
  segments: "Segments",
  log: "Log",
  match: "Match",
};
const mostLettersOfTeam = 18; // on the timeline's button
const panelMilliseconds = 100; // between two updates of the panels while time passes
const largestShare = 0.47; // of the width, for the field: two columns of a panel have room beside it
const highestShare = 0.6; // of the window, where the panel is below it

export class Viewer {
  readonly state: State;
  readonly playback: Playback;
  private palette: Palette;
  private readonly field: Field;
  private readonly part: FieldPart;
  private readonly timeline: Timeline;
  private readonly head: Head;
  private readonly list: OverlapList;
  private readonly robotPanel: RobotPanel;
  private readonly comparePanel: ComparePanel;
  private readonly goalPanel: GoalPanel;
  private readonly playPanel: PlayPanel;
  private readonly atBallPanel: AtBallPanel;
  private readonly segmentPanel: SegmentPanel;
  private readonly logPanel: LogPanel;
  private readonly matchPanel: MatchPanel;
  private readonly address: Address;
  private readonly layers: LayerChoice;
  private readonly drawings: DrawingChoice;
  private readonly heat: HeatChoice;
  private size = ""; // that the page was laid out for
  private panelsDrawn = 0;
  private panelsStale = true;

  constructor(
    private readonly match: Match,
    name: string,
    private readonly theme: Theme,
  ) {
    byId("viewer").style.setProperty("--rows", String(Math.max(...match.game.sizes)));
    const [over, under] = stripLanes(match);
    byId("viewer").style.setProperty("--lanes", String(over + under));
    byId("viewer").style.setProperty("--plays", String(playLane(match)));
    this.state = new State(match.game.begin, match.game.end);
    this.palette = readPalette();
    this.field = new Field(byId("field"), match, this.palette, new Heat(match, () => this.timeline.window));
    this.timeline = new Timeline(
      {
        box: byId("timeline"),
        overview: byId("overview"),
        budget: byId("budget"),
        detail: byId("detail"),
        wholeLine: byId("whole-line"),
        windowLine: byId("window-line"),
        tip: byId("tip"),
      },
      match,
      this.state,
      this.palette,
    );
    this.head = new Head(match);
    this.list = new OverlapList(byId("panel-overlaps"), match, (stretch) => this.jump(stretch));
    this.robotPanel = new RobotPanel(byId("panel-robot"), match, (knowledge) => this.state.set({ knowledge }));
    this.comparePanel = new ComparePanel(byId("panel-compare"), byId("tab-row"), match, (pair) =>
      this.state.set({ pair }),
    );
    const go = (time: number) => this.state.set({ time });
    this.goalPanel = new GoalPanel(byId("panel-goals"), match, go);
    this.playPanel = new PlayPanel(byId("panel-plays"), match, go);
    this.atBallPanel = new AtBallPanel(byId("panel-ball"), match);
    this.segmentPanel = new SegmentPanel(byId("panel-segments"), match, go);
    this.logPanel = new LogPanel(byId("panel-log"), match, go);
    this.matchPanel = new MatchPanel(byId("panel-match"), match, name);
    this.address = new Address(() => {
      const { time, robot, panel, pair } = this.state.view;
      return fragmentOf(time, robot, panel === "compare" ? pair : null);
    });
    this.playback = new Playback(this.state, (now) => this.draw(now));
    theme.changed = () => this.repaint();
    this.state.listen((changed) => this.changed(changed));
    this.part = new FieldPart(byId("field"), byId("part"), this.field.projection, this.state, (px, py) => {
      const robot = this.field.robotAt(px, py);
      if (robot === null) this.state.choose(null);
      else this.chooseRobot(robot);
    });
    this.layers = new LayerChoice(byId("layers"), match, this.state);
    this.buildControls();
    this.heat = new HeatChoice(byId("layers"), match, this.state);
    this.drawings = new DrawingChoice(byId("layers"), match, this.state);
    this.state.set({ time: match.game.kickOff });
    this.go(location.hash);
    this.address.listen((fragment) => this.go(fragment));
    const sizes = new ResizeObserver(() => this.resize());
    for (const id of ["viewer", "layers"]) sizes.observe(byId(id));
    this.resize();
    this.showControls(this.state.view);
    void countSwitches(match, () => new Promise((resolve) => setTimeout(resolve, 4))).then((switches) => {
      this.matchPanel.setSwitches(switches);
      document.body.dataset.counted = "true";
    });
  }

  private go(fragment: string): void {
    const { teams } = this.match.about;
    const { time, robot, pair } = readFragment(fragment, this.match.game.sizes, [
      teams[0].roles.length,
      teams[1].roles.length,
    ]);
    if (time !== null) this.state.set({ time });
    if (robot !== null) {
      this.state.choose(robot);
      this.state.set({ panel: "robot" });
    }
    if (pair !== null) this.state.set({ pair, panel: "compare", side: pair.side });
    this.address.touch(); // what names a moment that is none is put right
  }

  private resize(): void {
    const [viewer, layers, canvas] = [byId("viewer"), byId("layers"), byId("field")];
    // Where all parts are one below the other, the page is as long as its panel.
    const stacked = getComputedStyle(viewer).getPropertyValue("--stacked").trim() === "1";
    const size = [stacked, viewer.clientWidth, stacked ? window.innerHeight : viewer.clientHeight, layers.offsetHeight];
    if (size.join() === this.size) return;
    const { aspect } = this.field.projection;
    const widest = stacked ? viewer.clientWidth - 16 : byId("middle").clientWidth * largestShare;
    byId("stage").style.width = stacked ? "" : `${widest}px`;
    // Twice: buttons for which a narrower field leaves no room go on in a second line.
    for (let i = 0; i < 2; ++i) {
      const below = layers.offsetHeight + 6;
      const most = Math.max(200, stacked ? highestShare * window.innerHeight : byId("middle").clientHeight - below);
      const width = Math.floor(Math.min(most * aspect, widest));
      const height = Math.floor(Math.min(most, width / aspect));
      canvas.style.width = `${width}px`;
      canvas.style.height = `${height}px`;
      byId("stage").style.width = stacked ? "" : `${width + 8}px`;
      this.field.resize(width, height, this.part.box);
    }
    size[3] = layers.offsetHeight;
    this.size = size.join();
    const timeline = byId("timeline");
    for (const id of ["overview", "detail"]) byId(id).style.width = `${timeline.clientWidth}px`;
    byId("overview").style.height = "44px";
    byId("detail").style.height = `${timeline.clientHeight - 98}px`;
    this.timeline.resize();
    this.state.touch();
  }

  private repaint(): void {
    this.palette = readPalette();
    this.field.setPalette(this.palette);
    this.timeline.setPalette(this.palette);
    this.state.touch();
  }

  private changed(changed: ReadonlySet<keyof View>): void {
    const { view } = this.state;
    if (changed.has("panel") && view.panel === "compare" && view.pair === null) {
      const pair = pairNow(this.match, view.side, view.robot, view.time);
      if (pair !== null) this.state.set({ pair });
    }
    if (["robot", "side", "pair", "panel"].some((key) => changed.has(key as keyof View))) this.timeline.invalidate();
    if ([...changed].some((key) => key !== "time")) this.showControls(view);
    if (!view.playing || [...changed].some((key) => key !== "time")) this.panelsStale = true;
    if (["time", "robot", "pair", "panel"].some((key) => changed.has(key as keyof View))) this.address.touch();
  }

  private draw(now: number): void {
    this.field.draw(this.state);
    this.timeline.draw();
    if (!this.panelsStale && now - this.panelsDrawn < panelMilliseconds) return;
    this.panelsDrawn = now;
    this.panelsStale = false;
    const { view } = this.state;
    this.head.update(view.time);
    const time = byId<HTMLInputElement>("time");
    if (document.activeElement !== time) time.value = timeText(view.time);
    const scrub = byId<HTMLInputElement>("scrub");
    scrub.value = view.time.toFixed(1);
    scrub.setAttribute("aria-valuetext", timeText(view.time));
    if (view.panel === "overlaps") this.list.update(view.time, true);
    if (view.panel === "robot") this.robotPanel.update(view);
    if (view.panel === "goals") this.goalPanel.update(view.time);
    if (view.panel === "plays") this.playPanel.update(view.time);
    if (view.panel === "ball") this.atBallPanel.update(view.time);
    if (view.panel === "segments") this.segmentPanel.update(view.time);
    if (view.panel === "log") this.logPanel.update(view);
    if (view.panel === "compare") {
      this.followPair(view);
      this.comparePanel.update(this.state.view);
    }
  }

  // Of three robots that share a role one may leave: the pair compared is of those that still do.
  private followPair(view: View): void {
    if (view.pair === null || !view.playing) return;
    const robots = pairAt(this.match, view.pair, view.time);
    if (robots !== null && robots.join() !== view.pair.robots.join())
      this.state.set({ pair: { ...view.pair, robots } });
  }

  private jump(stretch: Stretch): void {
    const time = stretch.from;
    const change: Partial<View> = { time, playing: false, side: stretch.side };
    if (stretch.robots.length >= 2) {
      const robots = pairAt(this.match, stretch, time) ?? [stretch.robots[0]!, stretch.robots[1]!];
      const pair: Pair = { side: stretch.side, role: stretch.role, robots };
      Object.assign(change, { pair, panel: "compare", robot: { side: stretch.side, number: robots[0] } });
    }
    this.list.chosen = stretch;
    this.state.set(change);
    this.list.update(time, true);
  }

  private jumpBy(direction: 1 | -1): void {
    const stretch = neighbour(this.list.stretches, this.state.view.time, direction, this.list.chosen);
    if (stretch !== null) this.jump(stretch);
  }

  private stepDecision(direction: 1 | -1): void {
    const time = decisionStep(this.match, this.state.view, direction);
    if (time !== null) this.state.set({ time, playing: false });
  }

  private stepEvent(direction: 1 | -1): void {
    const time = eventStep(this.match, this.state.view, direction);
    if (time !== null) this.state.set({ time });
  }

  private stepGoal(direction: 1 | -1): void {
    const time = goalStep(this.match, this.state.view.time, direction);
    if (time !== null) this.state.set({ time, playing: false });
  }

  private by(seconds: number): void {
    this.state.set({ time: this.state.view.time + seconds });
  }

  private chooseNumber(number: number): void {
    const { side } = this.state.view;
    if (number > this.match.game.sizes[side]) return;
    this.chooseRobot({ side, number });
  }

  // Its panel comes with it; but the log stays, and shows its lines.
  private chooseRobot(robot: Robot): void {
    this.state.choose(robot);
    if (this.state.view.panel !== "log") this.state.set({ panel: "robot" });
  }

  private otherSide(): void {
    const { view } = this.state;
    const side: Side = view.side === 0 ? 1 : 0;
    const robot =
      view.robot !== null && view.robot.number <= this.match.game.sizes[side]
        ? { side, number: view.robot.number }
        : null;
    this.state.set({ side, robot, pair: null });
  }

  // From its beginning: its button at the foot has the focus.
  private help(): void {
    const help = byId<HTMLDialogElement>("help");
    help.showModal();
    help.scrollTop = 0;
  }

  private keys(): Key[] {
    const key = (keys: string[], shown: string, does: string, run: Key["run"]): Key => ({ keys, shown, does, run });
    const also = (keys: string[], run: Key["run"]) => key(keys, "", "", run); // in the row above
    return [
      key([" "], "Space", "play or pause", () => this.playback.toggle()),
      key(["ArrowLeft"], "\u2190 \u2192", "1 s back, on", () => this.by(-1)),
      also(["ArrowRight"], () => this.by(1)),
      key(["Shift+ArrowLeft"], "Shift \u2190 \u2192", "0.1 s back, on", () => this.by(-0.1)),
      also(["Shift+ArrowRight"], () => this.by(0.1)),
      key(["PageUp"], "Page \u2191 \u2193", "30 s back, on", () => this.by(-30)),
      also(["PageDown"], () => this.by(30)),
      key(["Home"], "Home, End", "to the beginning, to the end", () => this.state.set({ time: this.state.begin })),
      also(["End"], () => this.state.set({ time: this.state.end })),
      key([","], ", .", "previous, next decision", () => this.stepDecision(-1)),
      also(["."], () => this.stepDecision(1)),
      key(["[", "p"], "[ ] or p, n", "previous, next role overlap of the list", () => this.jumpBy(-1)),
      also(["]", "n"], () => this.jumpBy(1)),
      key(["e"], "e, Shift e", "next, previous event", () => this.stepEvent(1)),
      also(["E"], () => this.stepEvent(-1)),
      key(["g"], "g, Shift g", "next, previous goal", () => this.stepGoal(1)),
      also(["G"], () => this.stepGoal(-1)),
      key(["+"], "+ \u2212", "faster, slower", () => this.playback.change(1)),
      also(["-"], () => this.playback.change(-1)),
      key([..."123456789"], "1 \u2013 9", "choose a robot", (event) => this.chooseNumber(Number(event.key))),
      key(["0"], "0", "choose robot 10", () => this.chooseNumber(10)),
      key(
        [..."1234567890"].map((digit) => `Shift+Digit${digit}`),
        "Shift 1 \u2013 0",
        "choose robot 11 \u2013 20",
        (event) => this.chooseNumber(10 + (Number(event.code.slice(-1)) || 10)),
      ),
      key(["Escape"], "Esc", "choose none", () => this.state.choose(null)),
      key(["t"], "t", "the other team", () => this.otherSide()),
      key(["o"], "o", "list of role overlaps", () => this.state.set({ panel: "overlaps" })),
      key(["r"], "r", "the chosen robot", () => this.state.set({ panel: "robot" })),
      key(["c"], "c", "comparison", () => this.state.set({ panel: "compare" })),
      key(["q"], "q", "list of goals, or of all calls", () => this.state.set({ panel: "goals" })),
      key(["a"], "a", "actions with the ball: shots, passes, clearances, duels", () =>
        this.state.set({ panel: "plays" }),
      ),
      key(["f"], "f", "at the ball: who goes for it, and why nobody does", () => this.state.set({ panel: "ball" })),
      key(["s"], "s", "segments of packets, if there are any", () => {
        if (hasSegments(this.match)) this.state.set({ panel: "segments" });
      }),
      key(["k"], "k", "log of plugins, if there is any", () => {
        if (hasLines(this.match)) this.state.set({ panel: "log" });
      }),
      key(["m"], "m", "sums of the match, recording", () => this.state.set({ panel: "match" })),
      ...layerNames.map((layer) => {
        const { shown, does } = this.layers.keyOf(layer);
        return key([layerKeys[layer]], shown, does, () => this.layers.toggle(layer));
      }),
      key(["w"], "w", "drawings of plugins, if there are any: all or none", () => {
        if (hasDrawings(this.match)) this.drawings.toggle();
      }),
      key(["h"], "h", "heat map on or off", () => this.heat.toggle()),
      key(["z"], "z, Shift z", "less, more of the field (wheel; a drag moves it)", () => this.part.zoom(1.5)),
      also(["Z"], () => this.part.zoom(1 / 1.5)),
      key(["x"], "x", "the whole field (double click)", () => this.part.whole()),
      key(["y"], "y", "the field follows the chosen robot, or the ball", () => this.part.follow()),
      key(["="], "= _", "less, more time in the timeline", () => this.zoom(0.6)),
      also(["_"], () => this.zoom(1.7)),
      key(["d"], "d", "light or dark", () => this.theme.toggle()),
      key(["?"], "?", "this help", () => this.help()),
    ];
  }

  private zoom(factor: number): void {
    this.timeline.zoom(factor);
    this.state.touch();
  }

  private buildControls(): void {
    const click = (id: string, run: () => void) => byId(id).addEventListener("click", run);
    click("play", () => this.playback.toggle());
    click("previous-overlap", () => this.jumpBy(-1));
    click("next-overlap", () => this.jumpBy(1));
    click("previous-decision", () => this.stepDecision(-1));
    click("next-decision", () => this.stepDecision(1));
    click("previous-goal", () => this.stepGoal(-1));
    click("next-goal", () => this.stepGoal(1));
    for (const id of ["previous-goal", "next-goal"])
      byId<HTMLButtonElement>(id).disabled = !this.match.events.some(isGoal);
    click("side", () => this.otherSide());
    click("zoom-in", () => this.zoom(0.6));
    click("zoom-out", () => this.zoom(1.7));
    click("theme", () => this.theme.toggle());
    click("help-open", () => this.help());

    const speed = byId<HTMLSelectElement>("speed");
    for (const value of speeds) speed.append(element("option", { value: String(value) }, `${value}\u00d7`));
    speed.addEventListener("change", () => this.state.set({ speed: Number(speed.value) }));

    const scrub = byId<HTMLInputElement>("scrub");
    scrub.min = String(this.state.begin);
    scrub.max = String(this.state.end);
    scrub.addEventListener("input", () => this.state.set({ time: Number(scrub.value) }));
    setText(byId("end"), timeText(this.state.end));
    const time = byId<HTMLInputElement>("time");
    time.addEventListener("focus", () => time.select());
    time.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== "Escape") return;
      const typed = event.key === "Enter" ? timeOf(this.match.game, time.value) : this.state.view.time;
      time.classList.toggle("wrong", typed === null);
      if (typed === null) return;
      this.state.set({ time: typed });
      time.blur();
      this.state.touch();
    });
    time.addEventListener("blur", () => {
      time.classList.remove("wrong");
      time.value = timeText(this.state.view.time);
    });

    for (const panel of panelNames) {
      const tab = element(
        "button",
        { type: "button", role: "tab", id: `tab-${panel}`, "aria-controls": `panel-${panel}` },
        panelTexts[panel],
      );
      tab.addEventListener("click", () => this.state.set({ panel }));
      tab.hidden = (panel === "segments" && !hasSegments(this.match)) || (panel === "log" && !hasLines(this.match));
      byId("tabs").append(tab);
    }
    const keys = this.keys();
    listenToKeys(keys);
    byId("keys").append(
      element(
        "tbody",
        {},
        ...keys
          .filter(({ shown }) => shown !== "")
          .map(({ shown, does }) => row([element("td", {}, element("kbd", {}, shown)), does])),
      ),
    );
  }

  private showControls(view: View): void {
    const play = byId("play");
    setText(play, view.playing ? "Pause" : "Play");
    play.setAttribute("aria-pressed", String(view.playing));
    byId<HTMLSelectElement>("speed").value = String(view.speed);
    const { teams } = this.match.about;
    setText(byId("side"), `${shortened(teams[view.side].name, mostLettersOfTeam)} \u21c4`);
    const side = `Timeline of ${teams[view.side].name}; change to ${teams[view.side === 0 ? 1 : 0].name}`;
    byId("side").setAttribute("aria-label", side);
    byId("side").title = `${side} (t)`;
    for (const panel of panelNames) {
      const tab = byId(`tab-${panel}`);
      tab.setAttribute("aria-selected", String(view.panel === panel));
      byId(`panel-${panel}`).hidden = view.panel !== panel;
    }
    this.comparePanel.showBar(view);
    this.layers.update(view);
    this.part.update(view);
    this.drawings.update(view);
    this.heat.update(view);
  }
}
