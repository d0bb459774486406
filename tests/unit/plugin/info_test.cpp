// SPDX-License-Identifier: MIT
#include "plugin/info.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "scene.hpp"

namespace regista::plugin::test {
namespace {

TEST(Info, IsAPageAboutAPlugin) {
  const Found sound = open("sound");
  const std::string expected =
      "sound 1.2.0: Does what it says\n"
      "kind:      predictor, utility, mailbox\n"
      "models:    ball, opponents\n"
      "file:      " +
      sound.file.string() +
      "\n"
      "build:     " +
      sound.descriptor->build_tag +
      "\n"
      "interface: 0.2\n"
      "licence:   Apache-2.0\n"
      "parameters:\n"
      "  reach: real, 0.5 to 20 m; default: 12; tunable\n"
      "      Ignore farther tasks\n"
      "  decay: real, 1e-06 to 1; default: 0.01; tunable on a logarithmic scale\n"
      "      Share lost per second\n"
      "  rounds: integer, 1 to 10; default: 3\n"
      "      Rounds of bidding\n"
      "  eager: boolean; default: true\n"
      "      Begin at once\n"
      "  order: choice of first, best; default: best\n"
      "      Who chooses first\n"
      "  title: text; default: \"plain\"\n"
      "      Name on the scoreboard\n"
      "  formation: file; default: none\n"
      "      Formation to play\n";
  EXPECT_EQ(info_text(sound), expected);
}

TEST(Info, TellsNegotiatorsFromOthers) {
  EXPECT_TRUE(negotiates(open("sound", 1)));
  EXPECT_FALSE(negotiates(open("throws")));
  EXPECT_EQ(subject_names(open("sound", 1).description->subjects()), "");
  EXPECT_NE(info_text(open("sound", 1)).find("parameters: none\n"), std::string::npos);
}

TEST(Info, ListsByKindAndNamesWhatWasRefused) {
  const Folder folder;
  fs::copy_file(shared_object("sound"), folder / "sound.so");
  fs::copy_file(shared_object("assigns_twice"), folder / "twice.so");
  std::ofstream(folder / "x.so") << "text";
  const std::string at = folder.path().string();
  EXPECT_EQ(list_text(Catalogue({folder.path(), at + "/no"})),
            "predictor   sound          1.2.0  Does what it says  (" + at +
                "/sound.so)\n"
                "utility     sound          1.2.0  Does what it says  (" +
                at +
                "/sound.so)\n"
                "assigner    negotiator     0.1.0  Lets robots disagree for a while  (" +
                at +
                "/sound.so)\n"
                "assigner    assigns_twice  1.0.0  Gives one task to two robots  (" +
                at +
                "/twice.so)\n"
                "refused: " +
                at +
                "/x.so: is not a shared object\n"
                "searched: " +
                at +
                "\n"
                "searched: " +
                at + "/no (does not exist)\n");
  EXPECT_EQ(list_text(Catalogue({})), "no plugins\n");
}

}  // namespace
}  // namespace regista::plugin::test
