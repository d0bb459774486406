// SPDX-License-Identifier: MIT
#include "plugin/info.hpp"

#include <gtest/gtest.h>

#include "scene.hpp"

namespace regista::plugin::test {
namespace {

TEST(Declarations, SayWhatPluginsDeclare) {
  const std::vector<Found> plugins{open("sound"), open("sound", 1)};
  const std::vector<config::PluginDeclaration> all = declarations(plugins);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].id, "sound");
  EXPECT_EQ(all[0].kind, "predictor");
  EXPECT_EQ(all[1].id, "sound");
  EXPECT_EQ(all[1].kind, "utility");
  EXPECT_EQ(all[1].summary, "Does what it says");
  EXPECT_EQ(all[2].id, "negotiator");
  EXPECT_EQ(all[2].kind, "assigner");
  EXPECT_TRUE(all[2].parameters.empty());

  using Type = config::PluginParameter::Type;
  const std::vector<config::PluginParameter>& parameters = all[0].parameters;
  ASSERT_EQ(parameters.size(), 7u);
  EXPECT_EQ(parameters[0].name, "reach");
  EXPECT_EQ(parameters[0].type, Type::real);
  EXPECT_EQ(parameters[0].minimum, 0.5);
  EXPECT_EQ(parameters[0].maximum, 20.0);
  EXPECT_EQ(parameters[0].initial, 12.0);
  EXPECT_EQ(parameters[0].unit, "m");
  EXPECT_EQ(parameters[0].doc, "Ignore farther tasks");
  EXPECT_TRUE(parameters[0].tunable);
  EXPECT_EQ(parameters[2].type, Type::integer);
  EXPECT_FALSE(parameters[2].tunable);
  EXPECT_EQ(parameters[3].type, Type::boolean);
  EXPECT_EQ(parameters[4].type, Type::choice);
  EXPECT_EQ(parameters[4].choices, (std::vector<std::string>{"first", "best"}));
  EXPECT_EQ(parameters[4].initial, 1.0);
  EXPECT_EQ(parameters[5].type, Type::text);
  EXPECT_EQ(parameters[5].initial_text, "plain");
  EXPECT_EQ(parameters[6].type, Type::file);
  EXPECT_EQ(parameters[6].initial_text, "");
}

TEST(Declarations, TakeTheFirstOfSeveralWithOneName) {
  const std::vector<Found> plugins{open("same_id_first"), open("same_id_second")};
  EXPECT_EQ(declarations(plugins).size(), 1u);
}

}  // namespace
}  // namespace regista::plugin::test
