// SPDX-License-Identifier: MIT
// Two hundred messages by chance, and what becomes of an own one.
#include <regista/testkit/kind_checks.hpp>

#include <string>
#include <vector>

#include <regista/testkit/dice.hpp>

namespace regista::testkit {

namespace {

EnvironmentBuilder environment_for(std::uint32_t subject) {
  return EnvironmentBuilder{}.team_size(7).own(2).subject(subject);
}

// A message may be refused; what else a call does wrong is a finding.
template <class Call>
void attempt(Findings& findings, Call&& call) {
  try {
    call();
  } catch (const CallFailed& failure) {
    const std::string text = failure.what();
    for (const char* broken : {"across the boundary", "did not say why", "more than one line", "returned ", "capacity",
                               "says another thing", "wrote to the "}) {
      if (text.find(broken) != std::string::npos) findings.say(text);
    }
  }
}

void hear_and_see_off(Instance& instance, const Options& options, Findings& f) {
  Dice dice = Dice::with(options.seed, 5);
  for (int k = 0; k < 200; ++k) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(dice.integer(0, 120)));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(dice.bits());
    const int sender = dice.integer(0, 1) == 0 ? 1 : dice.integer(3, 7);
    attempt(f, [&] { instance.receive(sender, bytes, 0.1 * k, 0.1 * k + 0.05); });
    attempt(f, [&] {
      if (instance.describe(bytes) != instance.describe(bytes)) {
        throw CallFailed("describe: says another thing of the same bytes");
      }
    });
  }
  const auto handle = instance.host().offers.empty() ? 1 : instance.host().offers.front().handle;
  attempt(f, [&] { instance.transmitted(handle); });
  attempt(f, [&] { instance.dropped(handle); });
}

}  // namespace

Findings check_mailbox(const Loaded& plugin, const Options& options, std::uint32_t subject) {
  Scenario scenario;
  scenario.environment = environment_for(subject);
  return detail::everywhere(plugin, options, {scenario}, [&](const Corner& corner, const Scenario& r, Findings& f) {
    Instance instance(plugin, r.environment, corner.values);
    hear_and_see_off(instance, options, f);
  });
}

void play_messages_guarded(const Loaded& plugin, const Options& options, std::uint32_t subject) {
  Findings elsewhere(options.underway);
  elsewhere.where("", "messages");
  Values values(plugin);
  options.base(values);
  Instance instance(plugin, environment_for(subject), values, Layout{0, true});
  hear_and_see_off(instance, options, elsewhere);
}

}  // namespace regista::testkit
