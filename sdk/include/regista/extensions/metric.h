/* SPDX-License-Identifier: MIT
 *
 * Extension "regista.metric/0", a draft: numbers of a plugin about a match. The plugin's side declares them, the host's
 * side takes them. Both are found by the same name. A host that has none gives null, and a plugin does without. C++:
 * <regista/metric.hpp>.
 *
 * They become rows of the table of metrics, for each side of a match: "plugin_totals.<id>.<name>" of what is summed,
 * "plugin_values.<id>.<name>" of all others. So they stand in JSON, CSV and reports, and can be the objective of a
 * tuning. Reports of all robots of the team, and of all instances of the plugin, make one number. Like all that a
 * plugin answers, they must follow from what it was given: a measured time, say, makes a match one that cannot be
 * repeated.
 */
/* clang-format off */
#ifndef REGISTA_EXTENSIONS_METRIC_H
#define REGISTA_EXTENSIONS_METRIC_H

#include <stdint.h>

#define REGISTA_METRIC_EXTENSION "regista.metric/0"

enum { REGISTA_METRIC_MOST = 64 };   /* metrics of one plugin */

/* How all that was reported becomes the number of a match. Without a report a sum is 0, and all others are missing. */
enum {
  REGISTA_METRIC_SUM = 1,
  REGISTA_METRIC_MEAN = 2,           /* of all reports */
  REGISTA_METRIC_LEAST = 3,
  REGISTA_METRIC_GREATEST = 4,
  REGISTA_METRIC_OVER_TIME = 5       /* a state: what was reported holds until the same instance reports again, or its
                                        robot crashes. The mean over the time of phase Playing, and over the instances
                                        that have reported, penalised robots too */
};

typedef struct regista_metric {
  uint32_t size;
  int32_t combine;                   /* REGISTA_METRIC_* */
  const char* name;                  /* lower_snake_case, unique in the plugin */
  const char* unit;                  /* SI symbol, "1" for a plain number */
  const char* doc;                   /* one sentence */
} regista_metric;

/* The plugin's side: what regista_descriptor.extension gives. Lives as long as the shared object. */
typedef struct regista_metrics {
  uint32_t size;
  uint32_t count;                    /* at most REGISTA_METRIC_MOST */
  const regista_metric* metrics;     /* `count` elements, each `stride` bytes after the last */
  uint32_t stride;
  uint32_t reserved;
} regista_metrics;

/* The host's side: what regista_host.extension gives. Lives as long as the instance that asked for it. */
typedef struct regista_metric_reports {
  uint32_t size;
  uint32_t reserved;
  void* context;                     /* first argument of the call below */
  /* `metric`: index into the declared ones. `value`: finite, at most 1e9 in size; else the match ends with an error, as
   * for any other answer that breaks a promise. Only from within the instance's own calls, but nothing is
   * taken in `describe`. */
  void (*report)(void* context, uint32_t metric, double value);
} regista_metric_reports;

#endif /* REGISTA_EXTENSIONS_METRIC_H */
