// SPDX-License-Identifier: MIT
// Example of the extension log: a context that always holds, and says when this robot loses the ball and finds it
// again.
//
//   contexts: {playing: {plugin: log_ball}}      regista match a.yaml b.yaml --plugins build --log info
#include <array>
#include <cstdio>

#include <regista/context.hpp>
#include <regista/log.hpp>

namespace {

struct LogBall {
  static constexpr auto id = "log_ball", version = "1.0.0",
                        summary = "Always holds, and says when the robot loses and finds the ball";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  regista::Log log;
  bool known = false, seen = false;
  double lost_at = 0.0;

  void setup(const regista::Environment&, const regista::Host& host) { log = regista::Log(host); }
  void reset(std::uint64_t) { known = seen = false; }

  bool holds(const regista::Frame& frame) {
    const bool knows = frame.mine().ball_known();
    if (knows && !seen) log.info("sees the ball");
    if (knows && !known && seen) {
      std::array<char, 40> line{};
      std::snprintf(line.data(), line.size(), "found the ball after %.1f s", frame.time() - lost_at);
      log.info(line.data());
    }
    if (!knows && known) {
      log.warning("lost the ball");
      lost_at = frame.time();
    }
    known = knows;
    seen = seen || knows;
    return true;
  }
};

}  // namespace

REGISTA_PLUGIN(LogBall, regista::context)
