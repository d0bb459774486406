// SPDX-License-Identifier: MIT
#include "plugin/shared_object.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <iterator>

#include "plugin/process_state.hpp"
#include "scene.hpp"

namespace regista::plugin::test {
namespace {

std::string refusal(const std::string& name) { return open_shared_object(shared_object(name)).refusal; }

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class BrokenFile : public ::testing::Test {
 protected:
  fs::path write(const std::string& content) {
    std::ofstream(path_, std::ios::binary) << content;
    return path_;
  }
  std::string refusal_of(const std::string& content) { return open_shared_object(write(content)).refusal; }

  Folder folder_;
  fs::path path_ = folder_ / "x.so";
};

TEST(SharedObject, OpensPluginsInTheirOrder) {
  const SharedObject object = open_shared_object(shared_object("sound"));
  EXPECT_EQ(object.refusal, "");
  ASSERT_EQ(object.descriptors.size(), 2u);
  EXPECT_STREQ(object.descriptors[0]->id, "sound");
  EXPECT_STREQ(object.descriptors[1]->id, "negotiator");
}

// Of the process that opens it, not only of a child that looks at unknown files.
TEST(SharedObject, ChangesNoFloatingPointState) {
  const FloatingPointState before = FloatingPointState::now();
  const SharedObject object =
      open_shared_object(fs::path(TEST_PLUGINS) / "when_opened_round_upward" / "round_upward.so");
  const FloatingPointState after = FloatingPointState::now();
  before.restore();  // lest other tests suffer
  EXPECT_EQ(after, before);
  EXPECT_EQ(object.refusal, "");
  EXPECT_NE(object.remark.find("; that was undone"), std::string::npos) << object.remark;
}

TEST(SharedObject, RefusesPluginsThatCannotBeServed) {
  EXPECT_EQ(refusal("wrong_major"),
            "built for Regista plugin interface 1.0; this host speaks 0.2, whose number is lower because the interface "
            "was opened again before it is frozen: build it anew");
  EXPECT_EQ(refusal("older_minor"), "built for Regista plugin interface 0.1; this host speaks 0.2: build it anew");
  EXPECT_EQ(refusal("newer_minor"), "built for Regista plugin interface 0.3; this host speaks 0.2: build it anew");
  EXPECT_EQ(refusal("empty_list"), "contains no plugin");
  EXPECT_EQ(refusal("default_out_of_range"),
            "plugin \"default_out_of_range\": parameter \"reach\": default 25 is outside its range 0.5 to 20 m");
  EXPECT_EQ(refusal("duplicate_parameter"), "plugin \"duplicate_parameter\": parameter \"reach\" is declared twice");
}

// Its constructor would end this process.
TEST(SharedObject, DoesNotRunWhatIsNoPlugin) {
  EXPECT_EQ(refusal("no_entry"), "is no Regista plugin: it does not export regista_plugin_entry");
}

TEST(SharedObject, SaysWhatTheLoaderMisses) {
  EXPECT_EQ(refusal("missing_library"), "cannot be opened: undefined symbol: defined_nowhere");
}

TEST_F(BrokenFile, IsRefused) {
  EXPECT_EQ(open_shared_object(path_).refusal, "does not exist");
  EXPECT_EQ(refusal_of(""), "is empty");
  EXPECT_EQ(refusal_of("a text file\n"), "is not a shared object");
  EXPECT_EQ(refusal_of("\x7f"
                       "ELF"),
            "is not a shared object");
  EXPECT_EQ(open_shared_object(folder_.path()).refusal, "is a folder, not a shared object");
}

TEST_F(BrokenFile, MayEndAnywhere) {
  const std::string whole = bytes_of(shared_object("sound"));
  ASSERT_GT(whole.size(), 1000u);
  for (std::size_t size = 1; size < whole.size(); size += 1 + whole.size() / 100) {
    const std::string said = refusal_of(whole.substr(0, size));
    EXPECT_TRUE(said == "is damaged: it ends too early" || said == "is not a shared object") << size << ": " << said;
  }
  EXPECT_EQ(refusal_of(whole.substr(0, whole.size() - 1)), "is damaged: it ends too early");
  EXPECT_EQ(refusal_of(whole), "");
}

// A program exports nothing that the host asks for, and an archive is no ELF file.
TEST_F(BrokenFile, MayBeAnotherKindOfFile) {
  EXPECT_EQ(refusal_of(bytes_of("/proc/self/exe")), "is no Regista plugin: it does not export regista_plugin_entry");
  EXPECT_EQ(refusal_of("!<arch>\n"), "is not a shared object");
}

TEST_F(BrokenFile, MayBeAPipe) {
  ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
  EXPECT_EQ(open_shared_object(path_).refusal, "is not a regular file");
}

TEST_F(BrokenFile, MayBeForbidden) {
  write(bytes_of(shared_object("sound")));
  fs::permissions(path_, fs::perms::none);
  fs::permissions(folder_.path(), fs::perms::others_exec, fs::perm_options::add);
  constexpr uid_t nobody = 65534;
  const uid_t before = ::geteuid();
  if (before == 0) {  // root may read everything
    ASSERT_EQ(::seteuid(nobody), 0);
  }
  const std::string said = open_shared_object(path_).refusal;
  if (before == 0) {
    ASSERT_EQ(::seteuid(before), 0);
  }
  EXPECT_EQ(said, "cannot be read: Permission denied");
}

}  // namespace
}  // namespace regista::plugin::test
