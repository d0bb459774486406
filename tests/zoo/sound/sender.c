/* SPDX-License-Identifier: MIT
 *
 * A sender: a packet a second, with every offer. It makes offers itself, so that there is room for handles. */
#include "zoo.h"

static int32_t decide(void* instance, const regista_frame* frame, regista_span events, regista_span offers,
                      const regista_budget* budget, regista_send* out, regista_error* error) {
  static const uint8_t said[2] = {1, 2};
  zoo_instance* self = (zoo_instance*)instance;
  zoo_moment now = zoo_now(self, frame, error);
  (void)events;
  if (budget->packets_left > 0 && budget->since_own >= 1.0) {
    for (uint32_t i = 0; i < offers.count; ++i) {
      const char* const offer = (const char*)offers.data + (size_t)i * offers.stride;
      out->granted[out->granted_count++] = ((const regista_offer*)offer)->handle;
    }
    out->send = 1;
    out->reason = REGISTA_EVENT_PERIOD;
  }
  if (self->asked % 10 == 1) {
    (void)self->host->offer(self->host->context, said, sizeof said, 0.5, frame->time + 5.0, REGISTA_MEDIUM_RADIO, 0);
  }
  now.answer = out->granted;
  now.past[ZOO_ANSWER] = out->granted == NULL ? NULL : out->granted + offers.count;
  now.past[ZOO_STRUCTURE] = (unsigned char*)out + out->size;
  ZOO_FAULT(&now);
  return now.status;
}

static const regista_sender calls = {sizeof(regista_sender), 0, decide, NULL};
const int32_t zoo_kind = REGISTA_KIND_SENDER;
const void* const zoo_calls = &calls;
