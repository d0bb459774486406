// SPDX-License-Identifier: MIT
// The Voronoi cells of what a positioner divides the field among, and the Delaunay edges between these sites.
import type { Palette } from "../app/palette";
import type { LayerName } from "../app/state";
import { delaunayEdges, voronoiCells } from "../model/voronoi";
import type { FieldSize } from "../recording/about";
import type { Point } from "../recording/messages";
import type { Projection } from "./projection";
import type { Context } from "./shapes";

export function drawDiagram(
  context: Context,
  to: Projection,
  sites: readonly Point[],
  field: FieldSize,
  palette: Palette,
  layers: Readonly<Record<LayerName, boolean>>,
): void {
  context.save();
  context.strokeStyle = palette.nodes;
  context.lineWidth = 1.25;
  if (layers.delaunay) {
    context.setLineDash([6, 4]);
    context.beginPath();
    for (const [from, into] of delaunayEdges(sites)) {
      context.moveTo(to.x(sites[from]![0]), to.y(sites[from]![1]));
      context.lineTo(to.x(sites[into]![0]), to.y(sites[into]![1]));
    }
    context.stroke();
    context.setLineDash([]);
  }
  context.beginPath(); // one for all cells: what two share is no darker
  if (layers.cells) {
    for (const cell of voronoiCells(sites, field.length / 2, field.width / 2)) {
      cell.forEach(([x, y], i) => (i === 0 ? context.moveTo(to.x(x), to.y(y)) : context.lineTo(to.x(x), to.y(y))));
      if (cell.length > 0) context.closePath();
    }
  }
  context.stroke();
  for (const [x, y] of sites) {
    context.beginPath();
    context.arc(to.x(x), to.y(y), 3.5, 0, 2 * Math.PI);
    context.stroke();
  }
  context.restore();
}
