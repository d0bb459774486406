/* SPDX-License-Identifier: MIT
 *
 * Extension "regista.draw/0", a draft: points, lines, polygons and texts that a plugin draws in the field. The host's
 * side alone; a host that has none gives null, and a plugin does without. C++: <regista/draw.hpp>.
 *
 * Drawings go into recordings, and from there into the viewer and `regista view --at`. Each decision begins with an
 * empty field: what is drawn in it stays until the robot's next decision. All instances of a plugin in a robot share
 * its layers. What is drawn changes no match.
 */
/* clang-format off */
#ifndef REGISTA_EXTENSIONS_DRAW_H
#define REGISTA_EXTENSIONS_DRAW_H

#include <stdint.h>

#include <regista/abi.h>

#define REGISTA_DRAW_EXTENSION "regista.draw/0"

enum {
  REGISTA_DRAW_MOST_POINTS = 512,    /* of one shape */
  REGISTA_DRAW_MOST_SHAPES = 256,    /* of one instance in one decision, */
  REGISTA_DRAW_MOST_POINTS_OF_ALL = 4096, /* and the points of all of them */
  REGISTA_DRAW_MOST_LAYERS = 32,     /* of one instance in one match: a layer is a subject, not a moment */
  REGISTA_DRAW_MOST_BYTES = 200      /* of a text, and of the name of a layer; what is longer is cut */
};

enum {
  REGISTA_SHAPE_POINTS = 1,
  REGISTA_SHAPE_LINE = 2,            /* through all points, open */
  REGISTA_SHAPE_POLYGON = 3,         /* closed */
  REGISTA_SHAPE_TEXT = 4             /* at the first point */
};

enum { REGISTA_SHAPE_FILLED = 1 };   /* a polygon */

/* Field frame of the own team, metres. */
typedef struct regista_shape {
  uint32_t size;
  int32_t shape;                     /* REGISTA_SHAPE_* */
  uint32_t flags;                    /* REGISTA_SHAPE_FILLED */
  uint32_t colour;                   /* 0xRRGGBBAA; 0: as the viewer likes, one colour for each layer */
  double width;                      /* of lines, or the diameter of points, at most 10 m; 0: as the
                                        viewer likes */
  const char* layer;                 /* what people switch on and off: "cells" */
  const char* text;                  /* UTF-8, of a text; else null */
  const regista_point* points;       /* |x|, |y| <= 1e4; a point does not grow */
  uint32_t count;
  uint32_t reserved;
} regista_shape;

/* Lives as long as the instance that asked for it. */
typedef struct regista_draw {
  uint32_t size;
  uint32_t reserved;
  void* context;                     /* first argument of the calls below */
  /* 0 when nobody records drawings: a plugin may leave the drawing out then, and nothing else. A match is the same
   * whether it is recorded or not. */
  int32_t (*wanted)(void* context);
  /* Copied. Only from within the instance's own calls, but nothing is taken in `describe`. A shape that breaks a rule
   * of this header is left out; the host logs the first one, where drawings are wanted. */
  void (*draw)(void* context, const regista_shape* shape);
} regista_draw;

#endif /* REGISTA_EXTENSIONS_DRAW_H */
