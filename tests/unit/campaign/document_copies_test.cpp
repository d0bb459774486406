// SPDX-License-Identifier: MIT
#include "campaign/stored_setup.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "store_fixture.hpp"

namespace regista::campaign {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(DocumentCopies, NamesLeadToTheCopies) {
  const DocumentCopies copies(
      {{"/league/teams/a.yaml", "extends: ../base.yaml"}, {"/league/base.yaml", "team: base"}, {"/league/empty", ""}});
  Job job;
  job.teams = {"teams/a.yaml", "/league/base.yaml"};
  job.rules = "spl2023";
  job.opening = "../league/empty";
  job.robot = "/league/none.yaml";
  job.plugins = {"plugins", "/elsewhere"};
  const Job here = in_copies(job, copies.root(), "/league");
  const fs::path folder = copies.folder("/league");
  EXPECT_EQ(here.teams[0], "teams/a.yaml");
  EXPECT_EQ(content(folder / here.teams[0]), "extends: ../base.yaml");
  EXPECT_EQ(content((folder / here.teams[0]).parent_path() / "../base.yaml"), "team: base");
  EXPECT_EQ(content(here.teams[1]), "team: base");
  EXPECT_TRUE(fs::is_regular_file(folder / here.opening));
  EXPECT_EQ(here.rules, "spl2023");
  EXPECT_EQ(here.robot, "/league/none.yaml");
  EXPECT_THAT(here.plugins, ElementsAre("/league/plugins", "/elsewhere"));
  EXPECT_EQ(content(copies.folder("/league") / "base.yaml"), "team: base");
  EXPECT_TRUE(fs::is_directory(copies.folder("/another/folder")));
}

TEST(DocumentCopies, EveryDocumentOfAMatchIsACopy) {
  Job job;
  const std::vector<std::pair<std::string, std::string*>> names{{"/home", &job.teams[0]},
                                                                {"/away", &job.teams[1]},
                                                                {"/rules", &job.rules},
                                                                {"/robot", &job.robot},
                                                                {"/disturbance", &job.disturbance},
                                                                {"/home_disturbance", &job.home_disturbance},
                                                                {"/away_disturbance", &job.away_disturbance},
                                                                {"/opening", &job.opening}};
  std::vector<Document> documents;
  for (const auto& [path, name] : names) {
    *name = path;
    documents.push_back({path, "text of " + path});
  }
  const DocumentCopies copies(documents);
  job = in_copies(job, copies.root(), "/");
  for (const auto& [path, name] : names) EXPECT_EQ(content(*name), "text of " + path);
}

TEST(DocumentCopies, OfSharedObjectsThePathAlone) {
  const process::TemporaryFolder folder;
  const fs::path object = folder.path() / "plugin.so", text = folder.path() / "text";
  std::ofstream(object) << "\x7f"
                           "ELF and more";
  std::ofstream(text) << "words";
  const std::vector<fs::path> files{text, folder.path() / "x" / ".." / "plugin.so", text, folder.path() / "none"};
  fs::create_directory(folder.path() / "x");
  const std::vector<Document> found = documents_in(files);
  EXPECT_THAT(found, ElementsAre(Document{object.string(), std::nullopt}, Document{text.string(), "words"}));
  Job job;
  job.teams = {object.string(), text.string()};
  const DocumentCopies copies(found);
  const Job here = in_copies(job, copies.root(), "/");
  EXPECT_TRUE(fs::equivalent(here.teams[0], object));
  EXPECT_FALSE(fs::equivalent(here.teams[1], text));
}

// A file of results may come from anybody.
TEST(DocumentCopies, NothingIsWrittenElsewhere) {
  const auto refused = [](const std::vector<Document>& documents) {
    try {
      DocumentCopies{documents};
      return std::string("taken");
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
  };
  for (const char* const path : {"/../../tmp/out", "/a/../b", "relative", "", "/", "/a/", "//a/b", "/a/./b"}) {
    EXPECT_EQ(refused({{path, "text"}}), "no document has the path \"" + std::string(path) + '"');
  }
  EXPECT_EQ(refused({{"/a", std::nullopt}, {"/a/b", "text"}}), "no document has the path \"/a/b\"");
  EXPECT_EQ(refused({{"/a/b/c", "text"}, {"/a", "text"}}), "no document has the path \"/a/b/c\"");
  EXPECT_EQ(refused({{"/a/b", "text"}, {"/ab", "text"}}), "taken");
}

TEST(DocumentCopies, LeaveNothingBehind) {
  fs::path folder;
  {
    const DocumentCopies copies(std::vector<Document>{{"/a", "text"}});
    folder = copies.folder("/");
    EXPECT_EQ(content(folder / "a"), "text");
  }
  EXPECT_FALSE(fs::exists(folder));
}

using StoredDocumentsTest = StoreTest;

TEST_F(StoredDocumentsTest, AreGivenBack) {
  const std::vector<Document> documents{{"/a", std::string("\0\n", 2)}, {"/b", std::nullopt}, {"/c", ""}};
  {
    Store store(file, Mode::create, "1.0");
    EXPECT_THAT(store.documents(), IsEmpty());
    store.keep(documents);
  }
  {
    Store store(file, Mode::open, "1.0");
    const std::vector<Document> before{{"/d", "of a study that was killed before its first match"}};
    store.keep(before);
    store.keep(documents);
  }
  const Store store(file, Mode::read, "1.0");
  EXPECT_EQ(store.documents(), documents);
}

TEST_F(StoredDocumentsTest, DamageIsNoticed) {
  const std::vector<Document> documents{{"/a", "text"}};
  { Store(file, Mode::create, "1.0").keep(documents); }
  execute("UPDATE documents SET path='/b'");
  const Store store(file, Mode::read, "1.0");
  EXPECT_THAT([&] { (void)store.documents(); },
              testing::ThrowsMessage<StoreDamaged>("results in " + file.string() +
                                                   " are damaged: the checksum of the document /b does not fit"));
}

TEST_F(StoredDocumentsTest, NoneInAFileOfAProgramThatKeptNone) {
  { Store(file, Mode::create, "1.0"); }
  execute("DROP TABLE documents");
  const Store store(file, Mode::read, "1.0");
  EXPECT_THAT(store.documents(), IsEmpty());
}

}  // namespace
}  // namespace regista::campaign
