// SPDX-License-Identifier: MIT
// Two hundred messages by chance, and what becomes of an own one.
#include <regista/testkit/check_mailbox.hpp>

#include <string>
#include <vector>

#include <regista/testkit/dice.hpp>

namespace regista::testkit {

Findings check_mailbox(const Loaded& plugin, const Options& options, std::uint32_t subject) {
  Course course;
  course.environment = EnvironmentBuilder{}.team_size(7).own(2).subject(subject);
  return detail::everywhere(
      plugin, options, {course}, [&plugin, &options](const Corner& corner, const Course& r, Findings& f) {
        Instance instance(plugin, r.environment, corner.values);
        Dice dice = Dice::with(options.seed, 5);
        const auto attempt = [&f](auto&& call) {
          try {
            call();
          } catch (const CallFailed& failure) {
            const std::string text = failure.what();
            for (const char* broken : {"across the boundary", "did not say why", "more than one line", "returned ",
                                       "capacity", "says another thing"}) {
              if (text.find(broken) != std::string::npos) f.say(text);
            }
          }
        };
        for (int k = 0; k < 200; ++k) {
          std::vector<std::uint8_t> bytes(static_cast<std::size_t>(dice.integer(0, 120)));
          for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(dice.bits());
          const int sender = dice.integer(0, 1) == 0 ? 1 : dice.integer(3, 7);
          attempt([&] { instance.receive(sender, bytes, 0.1 * k, 0.1 * k + 0.05); });
          attempt([&] {
            if (instance.describe(bytes) != instance.describe(bytes)) {
              throw CallFailed("describe: says another thing of the same bytes");
            }
          });
        }
        const auto handle = instance.host().offers.empty() ? 1 : instance.host().offers.front().handle;
        attempt([&] { instance.transmitted(handle); });
        attempt([&] { instance.dropped(handle); });
      });
}

}  // namespace regista::testkit
