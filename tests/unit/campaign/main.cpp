// SPDX-License-Identifier: MIT
// The tests of this room, and the worker that the engine starts them as: this program once more, which answers at once
// that the home team has scored the seed.
#include <gmock/gmock.h>
#include <unistd.h>

#include <iostream>
#include <iterator>
#include <string>

#include "campaign/job.hpp"
#include "campaign/match_encoding.hpp"
#include "campaign/worker.hpp"

using namespace regista::campaign;

static int answer() {
  const Job job = job_from_json({std::istreambuf_iterator<char>(std::cin), {}});
  Answer out;
  out.kind = Answer::Kind::played;
  out.decided = {{static_cast<int>(job.seed), 0}, "full_time", "h", metrics_from_json("{}"), std::nullopt, 0.0};
  const std::string text = std::string(answer_mark) + to_json(out) + '\n';
  return write(answer_descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1;
}

int main(int count, char** arguments) {
  if (count > 1 && std::string(arguments[1]) == worker_command) return answer();
  testing::InitGoogleMock(&count, arguments);
  return RUN_ALL_TESTS();
}
