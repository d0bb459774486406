// SPDX-License-Identifier: MIT
// Matrices of utilities that are hard on an assigner, and what its answers must be like.
#include <regista/testkit/kind_checks.hpp>

#include <regista/assigner.hpp>
#include <regista/testkit/dice.hpp>
#include <regista/testkit/scenes.hpp>

namespace regista::testkit {

namespace {

// Utilities for a scene: with ties, with forbidden pairs, rows and columns, all zero, very large.
Matrix utilities_for(const Scene& scene, std::size_t variant, std::uint64_t seed, const Layout& layout) {
  constexpr double forbidden = UtilityMatrix::forbidden;
  Matrix out(scene.rows(), scene.columns(), layout);
  Dice dice = Dice::with(seed, 1000 * variant + scene.data().tick);
  const std::size_t whole_row = static_cast<std::size_t>(dice.integer(0, 6));
  const std::size_t whole_column = static_cast<std::size_t>(dice.integer(0, 6));
  for (std::size_t i = 0; i < out.rows(); ++i) {
    for (std::size_t j = 0; j < out.columns(); ++j) {
      switch (variant) {
        case 0:
          out(i, j) = 0.0;
          break;
        case 1:
          out(i, j) = dice.real(0.0, 1.0);
          break;
        case 2:
          out(i, j) = dice.integer(0, 2);
          break;
        case 3:
          out(i, j) = dice.chance(0.5) ? forbidden : dice.integer(0, 2);
          break;
        case 4:
          out(i, j) = i == whole_row || j == whole_column ? forbidden : dice.real(0.0, 1.0);
          break;
        case 5:
          out(i, j) = forbidden;
          break;
        default:
          out(i, j) = dice.chance(0.3) ? dice.real(0.0, 1e-300) : dice.real(0.0, 1e12);
          break;
      }
      const std::int32_t only = scene.data().tasks[j].robot;
      if (only != 0 && only != scene.frame().world().active()[i]) out(i, j) = forbidden;
    }
  }
  return out;
}
constexpr std::size_t utility_variants = 7;

void check_assignment(const Matrix& u, const std::vector<std::int32_t>& columns, bool negotiates,
                      const Options& options, Findings& findings) {
  std::vector<int> holder(u.columns(), -1);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::int32_t column = columns[i];
    if (column == REGISTA_NO_TASK || column == REGISTA_UNKNOWN_TASK) continue;
    if (column < 0 || column >= static_cast<std::int32_t>(u.columns())) {
      findings.say("assign: row ", i, " got column ", column, " of ", u.columns());
      continue;
    }
    const auto j = static_cast<std::size_t>(column);
    if (u(i, j) == UtilityMatrix::forbidden) findings.say("assign: row ", i, " got column ", j, ", which is forbidden");
    if (holder[j] >= 0 && !negotiates) {
      findings.say("assign: column ", j, " given to rows ", holder[j], " and ", i);
    }
    holder[j] = static_cast<int>(i);
  }
  if (negotiates) return;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] == REGISTA_UNKNOWN_TASK) findings.say("assign: row ", i, " is unknown, but nothing is negotiated");
    if (columns[i] != REGISTA_NO_TASK || options.may_idle) continue;
    for (std::size_t j = 0; j < u.columns(); ++j) {
      if (holder[j] < 0 && u(i, j) != UtilityMatrix::forbidden) {
        if (options.doubts_idleness) {
          findings.doubt("assign: row ", i, " has no task although column ", j, " is free and allowed");
        } else {
          findings.say("assign: row ", i, " has no task although column ", j, " is free and allowed");
        }
        break;
      }
    }
  }
}

}  // namespace

std::vector<Scenario> assigner_scenarios(const Options& options) {
  std::vector<Scenario> out;
  for (const int size : team_sizes) {
    const std::vector<Scene> scenario = scenes(size, options.seed);
    Scenario r;
    r.environment = EnvironmentBuilder{}.team_size(static_cast<unsigned>(size)).own(own_number(size));
    r.steps = scenario.size() * utility_variants;
    r.name = [scenario](std::size_t i) {
      return scenario[i / utility_variants].name() + ", utilities " + std::to_string(i % utility_variants);
    };
    r.play = [scenario, options](Instance& instance, std::size_t i, const Showing& showing, Findings& findings,
                                 Trail& trail) {
      const Scene scene = scenario[i / utility_variants].shown(showing);
      const Matrix u = utilities_for(scene, i % utility_variants, options.seed, showing.layout);
      const std::vector<std::int32_t> columns = instance.assign(scene, u);
      trail.add_all(columns);
      check_assignment(u, columns, instance.negotiates(), options, findings);
      if (!scene.unchanged()) findings.say("assign: wrote to its input");
    };
    out.push_back(std::move(r));
  }
  return out;
}

}  // namespace regista::testkit
