// SPDX-License-Identifier: MIT
#include <regista/testkit/check_life.hpp>

#include <algorithm>
#include <memory>

namespace regista::testkit {

Findings check_life(const Loaded& plugin, const Options& options, const std::vector<Course>& courses) {
  return detail::everywhere(
      plugin, options, courses, [&](const Corner& corner, const Course& course, Findings& findings) {
        findings.where(corner.name, "no call");
        const auto create = [&] { return std::make_unique<Instance>(plugin, course.environment, corner.values); };
        create();
        std::vector<std::unique_ptr<Instance>> team;
        constexpr std::size_t robots = 7;
        for (std::size_t i = 0; i < robots; ++i) team.push_back(create());
        for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}}) {
          for (auto& each : team) each->reset(seed);
        }
        // A match of one step, in which every other robot takes part, and another match after it.
        const auto play = [&](Instance& instance) {
          Trail trail;
          Findings elsewhere;
          if (course.steps == 0) return;
          findings.where(corner.name, course.name(0));
          course.play(instance, 0, {}, elsewhere, trail);
        };
        for (std::size_t i = 0; i < robots; i += 2) {
          play(*team[i]);
          team[i]->reset(2);
          play(*team[i]);
        }
        std::rotate(team.begin(), team.begin() + 3, team.end());
        team.clear();
      });
}

}  // namespace regista::testkit
