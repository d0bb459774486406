// SPDX-License-Identifier: MIT
// What documents of studies say of how their matches are played: the same keys in both kinds.
#include <gtest/gtest.h>

#include "config/documents.hpp"
#include "config/parse.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

class IsolationKeys : public InFolder {
 protected:
  void SetUp() override {
    InFolder::SetUp();
    write("a.yaml", "x: 1\n");
  }

  // Both kinds of documents, with these lines at their ends.
  static std::string experiment(const std::string& more) {
    return "experiment: e\narms: [{name: one, team: a.yaml}]\nopponent: a.yaml\nmatches: 4\n" + more;
  }
  static std::string tuning(const std::string& more) {
    return "tuning: t\nteam: a.yaml\nopponents: [{team: a.yaml}]\nparameters: [a.b]\n" + more;
  }

  template <class Study>
  static void expect(const Study& study, Isolation isolation, bool play_twice) {
    EXPECT_EQ(study.settings.isolation, isolation);
    EXPECT_EQ(study.settings.play_twice, play_twice);
  }
};

TEST_F(IsolationKeys, AreReadAndShown) {
  struct Case {
    const char* text;
    Isolation isolation;
    bool play_twice;
  };
  for (const Case& each : {Case{"", Isolation::after_death, true}, Case{"isolation: always\n", Isolation::always, true},
                           Case{"isolation: after-death\n", Isolation::after_death, true},
                           Case{"play_twice: false\n", Isolation::after_death, false},
                           Case{"isolation: always\nplay_twice: false\n", Isolation::always, false}}) {
    SCOPED_TRACE(each.text);
    for (const std::string& text : {experiment(each.text), tuning(each.text)}) {
      write("s.yaml", text);
      const Node document = load("s.yaml");
      const Node shown = parse_text(show(document), "shown.yaml");
      EXPECT_EQ(shown["isolation"].text(), each.isolation == Isolation::always ? "always" : "after-death");
      EXPECT_EQ(shown["play_twice"].text(), each.play_twice ? "true" : "false");
      for (const Node& read : {document, shown}) {
        if (read["experiment"]) expect(read_document<Experiment>(read), each.isolation, each.play_twice);
        if (read["tuning"]) expect(read_document<Tuning>(read), each.isolation, each.play_twice);
      }
    }
  }
}

TEST_F(IsolationKeys, AnotherWordIsRefusedWithTheNearest) {
  for (const std::string& text : {experiment("isolation: alway\n"), tuning("isolation: alway\n")}) {
    write("s.yaml", text);
    const Node document = load("s.yaml");
    std::string says;
    try {
      document["tuning"] ? static_cast<void>(read_document<Tuning>(document))
                         : static_cast<void>(read_document<Experiment>(document));
    } catch (const Error& error) {
      says = error.what();
    }
    EXPECT_EQ(says, "s.yaml:5:12: isolation: unknown value \"alway\"; nearest: \"always\"; known: after-death, always");
  }
}

}  // namespace
}  // namespace regista::config
