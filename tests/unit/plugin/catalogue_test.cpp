// SPDX-License-Identifier: MIT
#include "plugin/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "config/node.hpp"
#include "scene.hpp"

namespace regista::plugin::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> names(const Catalogue& catalogue) {
  std::vector<std::string> out;
  for (const Found& plugin : catalogue.plugins()) {
    out.push_back(std::string(plugin.descriptor->id) + " " + plugin.descriptor->version);
  }
  return out;
}

std::vector<std::string> refusals(const Catalogue& catalogue) {
  std::vector<std::string> out;
  for (const Refused& refused : catalogue.refused()) {
    out.push_back(to_string({refused.file.filename(), refused.reason}));
  }
  return out;
}

// Two empty folders, to be filled.
class CatalogueTest : public ::testing::Test {
 protected:
  CatalogueTest() {
    fs::create_directory(here);
    fs::create_directory(there);
  }
  static void put(const std::string& plugin, const fs::path& as) { fs::copy_file(shared_object(plugin), as); }
  static std::string tag() { return open("sound").descriptor->build_tag; }

  Folder root;
  fs::path here = root / "here", there = root / "there";
};

TEST_F(CatalogueTest, SearchPathIsOptionsThenEnvironmentThenBuiltIn) {
  EXPECT_THAT(Catalogue::search_path({}, nullptr, "/usr/lib/regista"), ElementsAre("/usr/lib/regista"));
  EXPECT_THAT(Catalogue::search_path(std::vector<fs::path>{here, there}, "a:b::/c:", "/usr/lib/regista"),
              ElementsAre(here, there, "a", "b", "/c", "/usr/lib/regista"));
  EXPECT_THAT(Catalogue::search_path({}, "", ""), IsEmpty());
}

TEST_F(CatalogueTest, AnOptionMustNameAFolder) {
  const auto said = [](const fs::path& option) {
    return message_of([&] { Catalogue::search_path(std::vector{option}, nullptr, ""); });
  };
  EXPECT_EQ(said(here), "");
  EXPECT_EQ(said(root / "nowhere"), "--plugins " + (root / "nowhere").string() + ": there is no such folder");
  std::ofstream(here / "file") << "text";
  EXPECT_EQ(said(here / "file"), "--plugins " + (here / "file").string() + ": is not a folder");
}

TEST_F(CatalogueTest, OpensAllByFolderAndName) {
  put("throws", here / "b.so");
  put("sound", here / "a.so");
  put("returns_nan", there / "a.so");
  std::ofstream(here / "c.txt") << "no shared object by its name";
  const Catalogue catalogue({there, root / "nowhere", here});
  EXPECT_THAT(names(catalogue), ElementsAre("returns_nan 1.0.0", "sound 1.2.0", "negotiator 0.1.0", "throws 1.0.0"));
  EXPECT_THAT(refusals(catalogue), IsEmpty());
  EXPECT_THAT(catalogue.folders(), ElementsAre(there, root / "nowhere", here));
  EXPECT_EQ(catalogue.plugins()[3].file, here / "b.so");
}

TEST_F(CatalogueTest, CountsAFileOnce) {
  put("sound", here / "a.so");
  fs::create_symlink(here / "a.so", here / "link.so");
  fs::create_hard_link(here / "a.so", there / "hard.so");
  fs::create_directory_symlink(here, root / "again");
  const Catalogue catalogue({here, root / "again", there, here});
  EXPECT_THAT(names(catalogue), ElementsAre("sound 1.2.0", "negotiator 0.1.0"));
  EXPECT_EQ(catalogue.plugins()[0].file, here / "a.so");
}

TEST_F(CatalogueTest, RemembersWhatItRefused) {
  put("wrong_major", here / "old.so");
  put("sound", here / "sound.so");
  put("no_entry", here / "no_entry.so");
  std::ofstream(here / "x.so") << "text";
  std::ofstream(here / "empty.so").close();
  fs::create_directory(here / "y.so");
  fs::create_symlink("nothing", here / "z.so");
  fs::copy_file(shared_object("sound"), here / "truncated.so");
  fs::resize_file(here / "truncated.so", fs::file_size(here / "truncated.so") / 2);
  const Catalogue catalogue({here});
  EXPECT_THAT(names(catalogue), ElementsAre("sound 1.2.0", "negotiator 0.1.0"));
  EXPECT_THAT(
      refusals(catalogue),
      ElementsAre("empty.so: is empty", "no_entry.so: is no Regista plugin: it does not export regista_plugin_entry",
                  "old.so: built for Regista plugin interface 1.0; this host speaks 0.2, whose number is lower because "
                  "the interface was opened again before it is frozen: build it anew",
                  "truncated.so: is damaged: it ends too early", "x.so: is not a shared object",
                  "y.so: is a folder, not a shared object", "z.so: does not exist"));
}

TEST_F(CatalogueTest, SaysWhichFolderItCouldNotSearch) {
  std::ofstream(here / "file") << "text";
  EXPECT_THAT(refusals(Catalogue({here / "file"})), ElementsAre("file: cannot be searched: Not a directory"));
}

TEST_F(CatalogueTest, FindsByIdAndKind) {
  put("sound", here / "sound.so");
  const Catalogue catalogue({here});
  const Found& found = catalogue.find(use("sound"), REGISTA_KIND_UTILITY);
  EXPECT_EQ(&found, &catalogue.plugins()[0]);
  EXPECT_EQ(&catalogue.find(use("sound"), REGISTA_KIND_PREDICTOR, REGISTA_SUBJECT_BALL), &found);
}

TEST_F(CatalogueTest, SaysWhatExistsAndWhatIsNearest) {
  put("sound", here / "sound.so");
  put("throws", here / "throws.so");
  put("wrong_major", here / "old.so");
  const Catalogue catalogue({here, root / "nowhere"});
  EXPECT_EQ(message_of([&] { catalogue.find(use("negotiater"), REGISTA_KIND_ASSIGNER); }),
            "team.yaml:2:13: unknown assigner \"negotiater\"; nearest: \"negotiator\"; known: negotiator, throws; "
            "searched: " +
                here.string() + ", " + (root / "nowhere").string() +
                " (does not exist); refused: " + (here / "old.so").string() +
                ": built for Regista plugin interface 1.0; this host speaks 0.2, whose number is lower because the "
                "interface was opened again before it is frozen: build it anew");
  EXPECT_EQ(message_of([] { Catalogue({}).find(use("greedy"), REGISTA_KIND_ASSIGNER); }),
            "team.yaml:2:13: unknown assigner \"greedy\"; there is none at all; searched: no folder");
}

TEST_F(CatalogueTest, SaysWhichKindAPluginIsInstead) {
  put("sound", here / "sound.so");
  const Catalogue catalogue({here});
  EXPECT_EQ(message_of([&] { catalogue.find(use("sound"), REGISTA_KIND_ASSIGNER); }),
            "team.yaml:2:13: plugin \"sound\" is a predictor and a utility, not an assigner; known: negotiator; "
            "searched: " +
                here.string());
  EXPECT_EQ(message_of([&] { catalogue.find(use("sound"), REGISTA_KIND_PREDICTOR, REGISTA_SUBJECT_TEAMMATES); }),
            "team.yaml:2:13: predictor \"sound\" models ball, opponents, not teammates");
}

TEST_F(CatalogueTest, RefusesToGuessBetweenTwoFiles) {
  put("same_id_first", here / "x.so");
  put("same_id_second", there / "x.so");
  const Catalogue catalogue({here, there});
  EXPECT_EQ(message_of([&] { catalogue.find(use("same_id"), REGISTA_KIND_CONTEXT); }),
            "team.yaml:2:13: plugin \"same_id\" exists 2 times: " + (here / "x.so").string() + " (1.0.0, " + tag() +
                "), " + (there / "x.so").string() + " (1.1.0, " + tag() +
                "); pin one by its file: {plugin: same_id, file: " + (here / "x.so").string() + "}");
  for (const auto& [folder, version] : {std::pair{here, "1.0.0"}, {there, "1.1.0"}}) {
    const Found& found = catalogue.find(use("same_id", {}, folder / "x.so"), REGISTA_KIND_CONTEXT);
    EXPECT_STREQ(found.descriptor->version, version);
    EXPECT_EQ(found.file, folder / "x.so");
  }
}

TEST_F(CatalogueTest, OpensPinnedFilesOnDemand) {
  const Catalogue catalogue({here});
  const config::PluginUse pinned = use("sound", {}, shared_object("sound"));
  const Found& found = catalogue.find(pinned, REGISTA_KIND_UTILITY);
  EXPECT_STREQ(found.descriptor->id, "sound");
  for (const std::string other : {"throws", "returns_nan"}) {
    catalogue.find(use(other, {}, shared_object(other)), REGISTA_KIND_UTILITY);
  }
  EXPECT_EQ(&catalogue.find(pinned, REGISTA_KIND_UTILITY), &found);
  EXPECT_THAT(names(catalogue), IsEmpty());
}

TEST_F(CatalogueTest, RefusesPinnedFilesThatDoNotServe) {
  const Catalogue catalogue({here});
  const auto said = [&](const std::string& id, const fs::path& file, int kind = REGISTA_KIND_ASSIGNER) {
    return message_of([&] { catalogue.find(use(id, {}, file), kind); });
  };
  const std::string sound = shared_object("sound"), old = shared_object("wrong_major");
  EXPECT_EQ(said("sound", here / "no.so"), "team.yaml:2:13: " + (here / "no.so").string() + ": does not exist");
  EXPECT_EQ(said("sound", old), "team.yaml:2:13: " + old +
                                    ": built for Regista plugin interface 1.0; this host speaks 0.2, whose number is "
                                    "lower because the interface was opened again before it is frozen: build it anew");
  EXPECT_EQ(said("negotiater", sound), "team.yaml:2:13: " + sound +
                                           ": unknown assigner \"negotiater\"; nearest: \"negotiator\"; known: "
                                           "negotiator");
  EXPECT_EQ(said("greedy", sound, REGISTA_KIND_SENDER),
            "team.yaml:2:13: " + sound + ": unknown sender \"greedy\"; there is none at all");
  EXPECT_EQ(said("sound", sound),
            "team.yaml:2:13: " + sound + ": plugin \"sound\" is a predictor and a utility, not an assigner");
}

}  // namespace
}  // namespace regista::plugin::test
