/* SPDX-License-Identifier: MIT
 *
 * When to spend a packet: soon on news, as long as the packets last, else after a while. */
#include <math.h>

#include <regista/c.h>

/* --- The idea: knows nothing of Regista, and test.c tests it alone --- */

/* since_own: s since this robot sent its last packet. packets_left: of the team. line: those that would be left if they
 * were spent evenly; both without the reserve. A team that has less is not hurried by news. */
static int due(double period, double after_news, double since_own, int news, int packets_left, double line) {
  return packets_left > 0 && since_own >= (news && packets_left >= line ? after_news : period);
}

/* --- The glue: the instance, the calls of its kind, what it is called and what can be set --- */

/* An instance works for one robot. */
typedef struct plugin {
  double period;     /* s */
  double after_news; /* s */
  int reserve;
} plugin;

/* Events that the others had better know of; all that there are stand in <regista/abi.h>. */
static int is_news(int32_t event) {
  return event == REGISTA_EVENT_BALL_KNOWN_AGAIN || event == REGISTA_EVENT_BALL_MOVED || event == REGISTA_EVENT_FELL;
}

/* The reserve of a game that has a share of a match's packets. */
static int reserve_of(const plugin* self, const regista_budget* budget) {
  return (int)ceil(self->reserve * budget->share - 1e-9);
}

static int32_t decide(void* instance, const regista_frame* frame, regista_span events, regista_span offers,
                      const regista_budget* budget, regista_send* out, regista_error* error) {
  const plugin* self = instance;
  (void)frame, (void)error;
  out->reason = REGISTA_EVENT_PERIOD;
  for (uint32_t i = 0; i < events.count; ++i) {
    const regista_event* event = regista_element(events, i);
    if (is_news(event->kind)) out->reason = event->kind;
  }
  const int news = out->reason != REGISTA_EVENT_PERIOD, kept = reserve_of(self, budget);
  out->send =
      due(self->period, self->after_news, budget->since_own, news, budget->packets_left - kept, budget->line - kept);
  if (!out->send) return REGISTA_OK;
  /* What other plugins want to send goes along as far as it fits. */
  for (uint32_t i = 0; i < offers.count; ++i) {
    const regista_offer* offer = regista_element(offers, i);
    out->granted[out->granted_count++] = offer->handle;
  }
  return REGISTA_OK;
}

static const regista_sender calls = {.size = sizeof(regista_sender), .decide = decide};

static const regista_parameter parameters[] = {
    {.size = sizeof(regista_parameter),
     .type = REGISTA_TYPE_REAL,
     .name = "period",
     .unit = "s",
     .doc = "Time between two packets of a robot that has no news",
     .minimum = 0.5,
     .maximum = 120.0,
     .initial = 10.0,
     .flags = REGISTA_PARAMETER_TUNABLE},
    {.size = sizeof(regista_parameter),
     .type = REGISTA_TYPE_REAL,
     .name = "after_news",
     .unit = "s",
     .doc = "Least time between two packets of a robot",
     .minimum = 0.1,
     .maximum = 60.0,
     .initial = 1.0,
     .flags = REGISTA_PARAMETER_TUNABLE},
    {.size = sizeof(regista_parameter),
     .type = REGISTA_TYPE_INTEGER,
     .name = "reserve",
     .unit = "1",
     .doc = "Packets of the team that are never spent: the count of them comes late",
     .minimum = 0.0,
     .maximum = 1000.0,
     .initial = 30.0}};

static void set(plugin* self, const regista_environment* environment, regista_span values) {
  (void)environment;
  self->period = regista_number(values, 0);
  self->after_news = regista_number(values, 1);
  self->reserve = (int)regista_number(values, 2);
}

/* The beginning of a match. */
static void begin(plugin* self, uint64_t seed) { (void)self, (void)seed; }

REGISTA_C_PLUGIN(plugin, REGISTA_KIND_SENDER, calls, parameters, set, begin, .id = "@NAME@", .version = "0.1.0",
                 .summary = "A packet on news, else after a while", .licence = "MIT", .reads = REGISTA_READS_NOTHING);
