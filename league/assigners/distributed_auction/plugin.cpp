// SPDX-License-Identifier: MIT
// Assigner plugin around algorithm.hpp.
#include <span>
#include <string>

#include <regista/assigner.hpp>
#include <regista/host.hpp>
#include <regista/mailbox.hpp>

#include "algorithm.hpp"
#include "desk.hpp"

namespace {

struct DistributedAuction {
  static constexpr auto id = "distributed_auction", version = "1.0.0",
                        summary = "Robots bid for tasks and raise their prices until nobody is outbid (Bertsekas)";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr bool negotiates = true;

  auction::Settings settings;
  static constexpr std::tuple parameters{regista::within(&DistributedAuction::settings, auction::shared_parameters)};

  auction::Auctioneer<auction::OneTask> desk;

  void setup(const regista::Environment& environment, const regista::Host& host) {
    desk.setup(environment, host, settings);
  }
  void reset(std::uint64_t) { desk.reset(); }
  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    desk.assign(frame, utilities, out, {desk.epsilon()});
  }
  void receive(const regista::Message& message) { desk.receive(message); }
  void transmitted(std::uint64_t handle) { desk.transmitted(handle); }
  void dropped(std::uint64_t handle) { desk.dropped(handle); }
  std::string describe(std::span<const std::uint8_t> bytes) const { return desk.describe(bytes); }
};

}  // namespace

REGISTA_PLUGIN(DistributedAuction, regista::assigner)
