// SPDX-License-Identifier: MIT
#include "config/overlay.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "config/parse.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

Node text(std::string_view yaml, const std::string& name = "t.yaml") { return parse_text(yaml, name); }

const char* const base =
    "a: 1\n"
    "map: {x: 1, y: {z: 2}}\n"
    "list: [1, 2, 3]\n"
    "people: [{name: ann, age: 5}, {name: bob}]\n"
    "positioner: {plugin: voronoi, file: v.so, weight: 2, params: {merge: 1}}\n";

TEST(Merge, MapsMergeAndTheRestReplaces) {
  const Node result = merge(text(base, "base.yaml"), text("map: {y: {w: 3}}\nlist: [9]\nb: 2\n", "over.yaml"));
  EXPECT_TRUE(same(result["map"], text("{x: 1, y: {z: 2, w: 3}}")));
  EXPECT_TRUE(same(result, text("a: 1\nmap: {x: 1, y: {z: 2, w: 3}}\nlist: [9]\nb: 2\n"
                                "people: [{name: ann, age: 5}, {name: bob}]\n"
                                "positioner: {plugin: voronoi, file: v.so, weight: 2, params: {merge: 1}}\n")));
  EXPECT_EQ(to_string(result["a"].where()), "base.yaml:1:4");
  EXPECT_EQ(to_string(result["map"]["y"]["z"].where()), "base.yaml:2:20");
  EXPECT_EQ(to_string(result["map"]["y"]["w"].where()), "over.yaml:1:14");
  EXPECT_EQ(to_string(result["list"].where()), "over.yaml:2:7");
}

TEST(Merge, NullRemoves) {
  const Node result = merge(text(base), text("map: {x: ~}\nlist:\n"));
  EXPECT_TRUE(same(result["map"], text("{y: {z: 2}}")));
  EXPECT_FALSE(result["list"]);
  EXPECT_EQ(error_of([] { merge(text(base), text("map: {xx: ~}", "over.yaml")); }),
            "over.yaml:1:7: nothing to remove: unknown key \"xx\"; nearest: \"x\"; known: x, y");
}

TEST(Merge, AnotherPluginDropsWhatBelongedToTheLast) {
  EXPECT_TRUE(same(merge(text(base), text("positioner: {plugin: formation}"))["positioner"],
                   text("{plugin: formation, weight: 2}")));
  EXPECT_TRUE(same(merge(text(base), text("positioner: {plugin: formation, params: {k: 1}}"))["positioner"],
                   text("{plugin: formation, weight: 2, params: {k: 1}}")));
  EXPECT_TRUE(same(merge(text(base), text("positioner: {plugin: voronoi, params: {k: 1}}"))["positioner"],
                   text("{plugin: voronoi, file: v.so, weight: 2, params: {merge: 1, k: 1}}")));
}

TEST(Merge, AListIsExtendedByTheNamesOfItsElements) {
  const auto people = [](const std::string& over) { return merge(text(base), text("people: " + over))["people"]; };
  const auto list = [](const std::string& yaml) { return text("l: " + yaml)["l"]; };
  EXPECT_TRUE(same(people("{ann: {age: 6}}"), list("[{name: ann, age: 6}, {name: bob}]")));
  EXPECT_TRUE(same(people("{ann: ~}"), list("[{name: bob}]")));
  EXPECT_TRUE(
      same(people("{eve: {before: ann, age: 1}}"), list("[{name: eve, age: 1}, {name: ann, age: 5}, {name: bob}]")));
  EXPECT_TRUE(same(people("{eve: {after: ann}, dan: {after: eve, name: dan}}"),
                   list("[{name: ann, age: 5}, {name: eve}, {name: dan}, {name: bob}]")));
  EXPECT_TRUE(same(people("{ann: {after: bob}}"), list("[{name: bob}, {name: ann, age: 5}]")));
  EXPECT_TRUE(same(people("{bob: {before: ann, age: 2}}"), list("[{name: bob, age: 2}, {name: ann, age: 5}]")));
  // A list still replaces, and a list without names is no such list.
  EXPECT_TRUE(same(people("[{name: eve}]"), list("[{name: eve}]")));
  EXPECT_TRUE(same(merge(text(base), text("list: {a: 1}"))["list"], text("{a: 1}")));
  const Node whole = merge(text(base, "base.yaml"), text("people: {eve: {after: bob, age: 3}}", "over.yaml"));
  EXPECT_EQ(to_string(whole["people"].elements()[0].where()), "base.yaml:4:10");
  EXPECT_EQ(to_string(whole["people"].elements()[2]["name"].where()), "over.yaml:1:10");
  EXPECT_EQ(to_string(whole["people"].elements()[2]["age"].where()), "over.yaml:1:33");
}

TEST(Merge, WhatIsRefusedOfAListExtendedByName) {
  const auto error = [](const std::string& over) {
    return error_of([&] { merge(text(base), text("people: " + over, "o.yaml")); });
  };
  EXPECT_EQ(error("{anne: {age: 6}}"),
            "o.yaml:1:10: unknown element \"anne\"; nearest: \"ann\"; known: ann, bob; a new one says where it goes, "
            "before: NAME or after: NAME");
  EXPECT_EQ(error("{anne: ~}"),
            "o.yaml:1:10: nothing to remove: unknown element \"anne\"; nearest: \"ann\"; known: ann, bob");
  EXPECT_EQ(error("{eve: {after: bop}}"),
            "o.yaml:1:23: unknown element \"bop\" in after; nearest: \"bob\"; known: ann, bob");
  EXPECT_EQ(error("{ann: {after: ann}}"), "o.yaml:1:23: unknown element \"ann\" in after; known: bob");
  EXPECT_EQ(error("{eve: {after: bob, before: ann}}"), "o.yaml:1:23: before and after: one of them");
  EXPECT_EQ(error("{eve: {before: [ann]}}"), "o.yaml:1:24: before: expected the name of an element, not a list");
  EXPECT_EQ(error("{eve: {before: ann, name: adam}}"), "o.yaml:1:35: \"adam\" stands under another name, eve");
  EXPECT_EQ(error("{ann: 3}"), "o.yaml:1:15: ann: expected a map, not \"3\"");
  EXPECT_EQ(error("{ann: {age: 1}, ann: {age: 2}}").substr(0, 12), "o.yaml:1:25:");  // found when it is read
}

TEST(Merge, LargeMapsTakeNoLong) {
  std::string many;
  for (int i = 0; i < 40000; ++i) many += fmt::format("k{}: 1\n", i);
  const Node a = text(many), b = text(many);
  EXPECT_LT(seconds_of([&] { EXPECT_EQ(merge(a, b).entries().size(), 40000u); }), 1.0);
}

TEST(Override, PathsLeadAnywhere) {
  const std::pair<std::string, std::string> cases[] = {
      {"a=2", "a: 2"},
      {"a=[1, {b: c}]", "a: [1, {b: c}]"},
      {"map.y.z=5", "map: {x: 1, y: {z: 5}}"},
      {"map.new.deep=5", "map: {x: 1, y: {z: 2}, new: {deep: 5}}"},
      {"map={y: {w: 1}}", "map: {x: 1, y: {z: 2, w: 1}}"},
      {"map.x=~", "map: {y: {z: 2}}"},
      {"list.1=7", "list: [1, 7, 3]"},
      {"list.0=~", "list: [2, 3]"},
      {"people.ann.age=6", "people: [{name: ann, age: 6}, {name: bob}]"},
      {"people.1.age=6", "people: [{name: ann, age: 5}, {name: bob, age: 6}]"},
      {"people.bob={age: 3}", "people: [{name: ann, age: 5}, {name: bob, age: 3}]"},
      {"people.bob=~", "people: [{name: ann, age: 5}]"},
      {"positioner.plugin=other", "positioner: {plugin: other, weight: 2}"},
      {"url=a=b", "url: a=b"},
  };
  for (const auto& [change, expected] : cases) {
    const Node result = override_with(text(base), {change}), want = text(expected);
    const std::string& key = want.entries()[0].key;
    EXPECT_TRUE(same(result[key], want[key])) << change;
    const Node before = text(base);
    for (const Node::Entry& entry : before.entries()) {
      EXPECT_TRUE(entry.key == key || same(result[entry.key], entry.value)) << change;
    }
  }
}

TEST(Override, StandsWhereItWasGiven) {
  const Node result = override_with(text(base), {"map.new.deep={a: [1]}"});
  const std::string where = "--set map.new.deep={a: [1]}";
  EXPECT_EQ(to_string(result["map"]["new"].where()), where);
  EXPECT_EQ(to_string(result["map"]["new"]["deep"]["a"].elements()[0].where()), where);
  EXPECT_EQ(to_string(result["map"]["x"].where()), "t.yaml:2:10");
}

TEST(Override, LaterOnesWin) {
  EXPECT_EQ(override_with(text(base), {"a=2", "a=3"})["a"].text(), "3");
  EXPECT_TRUE(same(override_with(text(base), {"positioner.plugin=p", "positioner.params.k=1"})["positioner"],
                   text("{plugin: p, weight: 2, params: {k: 1}}")));
}

TEST(Override, AKeyWithDotsIsFoundAsAWhole) {
  const Node document = text("use: {sender.params.period: 4, sender: {weight: 1}}");
  EXPECT_TRUE(same(override_with(document, {"use.sender.params.period=9"}),
                   text("use: {sender.params.period: 9, sender: {weight: 1}}")));
  EXPECT_TRUE(same(override_with(document, {"use.sender.weight=2"}),
                   text("use: {sender.params.period: 4, sender: {weight: 2}}")));
}

TEST(Override, WhatIsRefused) {
  const std::pair<std::string, std::string_view> cases[] = {
      {"a", "--set a: expected path=value"},
      {"=1", "--set =1: expected path=value"},
      {"a.b=1", "--set a.b=1: a is \"1\", which has no parts"},
      {"a..b=1", "--set a..b=1: a is \"1\", which has no parts"},
      {"map..b=1", "--set map..b=1: \"map..b\": empty name in the path"},
      {"map.=1", "--set map.=1: \"map.\": empty name in the path"},
      {".=1", "--set .=1: \".\": empty name in the path"},
      {"list.3=1", "--set list.3=1: list has 3 elements; there is no 3"},
      {"list.one=1", "--set list.one=1: unknown element \"one\" in list"},
      {"list.-1=1", "--set list.-1=1: unknown element \"-1\" in list"},
      {"people.anne.age=1",
       "--set people.anne.age=1: unknown element \"anne\" in people; nearest: \"ann\"; known: ann, bob"},
      {"map.z=~", "--set map.z=~: nothing to remove: unknown key \"z\"; known: x, y"},
      {"a=[1", "--set a=[1: a key must be plain text; is a bracket not closed?"},
      {"a={b: 1, b: 2}", "--set a={b: 1, b: 2}: duplicate key \"b\""},
      {"a=1\n---\n2", "--set a=1\\n---\\n2: second document; a file holds one"},
      {"a=\xff", "--set a=\uFFFD: byte 0xff is not UTF-8"},
      {"a=\x01", "--set a=\\x01: byte 0x01 is not text; is this a binary file?"},
      {"a=\"x", "--set a=\"x: quote is never closed"},
  };
  for (const auto& [change, expected] : cases) {
    EXPECT_EQ(error_of([&, given = change] { override_with(text(base), {given}); }), expected);
  }
}

using Extends = InFolder;

TEST_F(Extends, LaysFilesOverEachOther) {
  write("base/a.yaml", "x: 1\ny: {p: 1, q: 2}\nz: 5\n");
  write("base/b.yaml", "extends: a.yaml\ny: {q: 3}\n");
  write("c.yaml", "extends: base/b.yaml\nx: 9\nz: ~\n");
  const Node result = load("c.yaml", {"y.r=4"});
  EXPECT_TRUE(same(result, text("x: 9\ny: {p: 1, q: 3, r: 4}\n")));
  EXPECT_EQ(to_string(result["x"].where()), "c.yaml:2:4");
  EXPECT_EQ(to_string(result["y"]["p"].where()), "base/a.yaml:2:8");
  EXPECT_EQ(to_string(result["y"]["q"].where()), "base/b.yaml:2:8");
}

TEST_F(Extends, WhatIsRefused) {
  write("a.yaml", "extends: b.yaml\n");
  write("b.yaml", "extends: ./c.yaml\n");
  write("c.yaml", "x: 1\nextends: a.yaml\n");
  EXPECT_EQ(error_of([] { load("a.yaml"); }), "c.yaml:2:10: extends itself: a.yaml -> b.yaml -> c.yaml -> a.yaml");
  write("self.yaml", "extends: self.yaml\n");
  EXPECT_EQ(error_of([] { load("self.yaml"); }), "self.yaml:1:10: extends itself: self.yaml -> self.yaml");
  write("missing.yaml", "extends: papr.yaml\n");
  write("paper.yaml", "x: 1\n");
  EXPECT_EQ(error_of([] { load("missing.yaml"); }),
            "missing.yaml:1:10: papr.yaml: no such file; nearest: \"paper.yaml\"");
  // The ending that all have makes no two names alike.
  write("never.yaml", "extends: nothere.yaml\n");
  EXPECT_EQ(error_of([] { load("never.yaml"); }), "never.yaml:1:10: nothere.yaml: no such file");
  write("ending.yaml", "extends: paper.yml\n");
  EXPECT_EQ(error_of([] { load("ending.yaml"); }),
            "ending.yaml:1:10: paper.yml: no such file; nearest: \"paper.yaml\"");
  write("list.yaml", "extends: [a.yaml]\n");
  EXPECT_EQ(error_of([] { load("list.yaml"); }), "list.yaml:1:10: extends: a list; expected text");
  write("empty.yaml", "extends: ''\n");
  EXPECT_EQ(error_of([] { load("empty.yaml"); }), "empty.yaml:1:10: extends: empty; expected a path");
  write("null.yaml", "extends:\nx: 1\n");
  EXPECT_EQ(error_of([] { load("null.yaml"); }), "null.yaml:1:1: extends: nothing; expected text");
  write("broken_base.yaml", "x: [1\n");
  write("broken.yaml", "extends: broken_base.yaml\n");
  EXPECT_EQ(error_of([] { load("broken.yaml"); }),
            "broken_base.yaml:1:4: the list that begins here is not closed: expected ',' or ']' before line 2");
  for (int i = 0; i < 20; ++i) write(fmt::format("n{}.yaml", i), fmt::format("extends: n{}.yaml\n", i + 1));
  EXPECT_EQ(error_of([] { load("n0.yaml"); }), "n15.yaml:1:10: extends more than 15 files");
}

}  // namespace
}  // namespace regista::config
