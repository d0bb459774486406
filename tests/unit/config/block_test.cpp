// SPDX-License-Identifier: MIT
#include "config/node.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "config/overlay.hpp"
#include "config/parse.hpp"
#include "testing.hpp"

namespace regista::config {
namespace {

const Location nowhere;

Node scalar(const std::string& text, bool quoted = false) { return Node::scalar(text, quoted, nowhere); }

// Texts that a writer of YAML can get wrong.
const std::vector<std::string> awkward{
    "",      " ",    "~",       "null",      "Null",    "NULL",       "true",
    "no",    "1e3",  "-0.5",    "-",         "--",      "---",        "...",
    "?",     "? a",  ": ",      ":",         "a:",      "a: b",       "a:b",
    "#",     "a #b", "#b",      "'",         "it's",    "\"",         "\\",
    "\\n",   "\n",   "a\nb",    "a\n\n b\n", "\t",      " a",         "a ",
    "- a",   "[",    "]",       "[]",        "{}",      "{a: b",      "a, b",
    "*a",    "&a",   "!a",      "!!str",     "|",       ">",          "%",
    "%YAML", "@a",   "`",       "<<",        "=",       "2026-01-02", "0x1f",
    "1_000", ".5",   "+1",      ".nan",      "-.inf",   "\x01",       "\x7f",
    "\r",    "é",    "\u2028x", "\u0085x",   "\ufeffx", "a.b.c",      "sender.params.period",
    "\u00a0"};

TEST(Block, ALineForEachValue) {
  const Node document = parse_text(
      "b: {c: 1, d: {e: [1, 2], f: x y}}\na: [{n: 1, use: {s.p: 2}}, {n: 2}]\ng: [[1], {}]\nh: {}\ni: []\nj: ~\n", "t");
  EXPECT_EQ(block(document),
            "b:\n  c: 1\n  d:\n    e: [1, 2]\n    f: \"x y\"\n"
            "a:\n  - {n: 1, use: {s.p: 2}}\n  - {n: 2}\n"
            "g: [[1], {}]\nh: {}\ni: []\nj: ~\n");
}

TEST(Block, AwkwardTextsReadBackTheSameAsKeysAndValues) {
  for (const std::string& text : awkward) {
    for (const bool quoted : {false, true}) {
      const Node value = scalar(text, quoted);
      const Node inner = Node::map({{text, nowhere, value}}, nowhere);
      const Node document = Node::map({{"a", nowhere, value},
                                       {"b", nowhere, Node::sequence({value, value}, nowhere)},
                                       {"c", nowhere, inner},
                                       {"d", nowhere, Node::sequence({inner, inner}, nowhere)},
                                       {text, nowhere, value}},
                                      nowhere);
      const std::string written = block(document);
      const Node back = parse_text(written, "t");
      EXPECT_TRUE(same(back, document)) << written;
      // Also a text that looks like nothing stays a text.
      EXPECT_EQ(back["a"].kind(), Node::Kind::scalar) << written;
      EXPECT_TRUE(back["a"].quoted() || !quoted) << written;
    }
  }
}

class Trees {
 public:
  explicit Trees(unsigned seed) : random_(seed) {}

  Node map(int depth, int least) {
    std::vector<Node::Entry> entries;
    std::set<std::string> keys;
    const int wanted = least + pick(4);
    while (static_cast<int>(entries.size()) < wanted) {
      const std::string key = text();
      if (keys.insert(key).second) entries.push_back({key, nowhere, node(depth - 1)});
    }
    return Node::map(std::move(entries), nowhere);
  }

 private:
  int pick(int below) { return std::uniform_int_distribution(0, below - 1)(random_); }

  std::string text() {
    if (pick(3) == 0) return awkward[static_cast<std::size_t>(pick(static_cast<int>(awkward.size())))];
    static const std::vector<std::string> pieces{"a", "b", "key", ".", ":", " ", "\"", "'", "\\", "\n", "#", "-", "0",
                                                 "9", "e", "{",   "}", "[", "]", ",",  "~", "é",  "\t", "_", "?", "*"};
    std::string out;
    for (int i = pick(6) + 1; i > 0; --i)
      out += pieces[static_cast<std::size_t>(pick(static_cast<int>(pieces.size())))];
    return out;
  }

  Node node(int depth) {
    const int kind = depth <= 0 ? pick(2) * 3 : pick(5);
    if (kind == 3 && pick(3) == 0) return Node::null(nowhere);
    if (kind == 1) {
      std::vector<Node> elements;
      const bool maps = pick(2) == 0;
      for (int i = pick(4); i > 0; --i) elements.push_back(maps ? map(depth - 1, pick(2)) : node(depth - 1));
      return Node::sequence(std::move(elements), nowhere);
    }
    if (kind == 2 || kind == 4) return map(depth, 0);
    return scalar(text(), pick(2) == 0);
  }

  std::mt19937 random_;
};

// Kinds too: same() looks at texts.
bool same_kinds(const Node& a, const Node& b) {
  if (a.kind() != b.kind() || a.elements().size() != b.elements().size() || a.entries().size() != b.entries().size()) {
    return false;
  }
  for (std::size_t i = 0; i < a.elements().size(); ++i) {
    if (!same_kinds(a.elements()[i], b.elements()[i])) return false;
  }
  for (std::size_t i = 0; i < a.entries().size(); ++i) {
    if (a.entries()[i].key != b.entries()[i].key || !same_kinds(a.entries()[i].value, b.entries()[i].value))
      return false;
  }
  return true;
}

TEST(Block, RandomTreesReadBackTheSame) {
  for (unsigned seed = 0; seed < 3000; ++seed) {
    const Node tree = Trees(seed).map(4, 1);
    const std::string written = block(tree);
    const Node back = parse_text(written, "t");
    ASSERT_TRUE(same(back, tree) && same_kinds(back, tree)) << seed << '\n' << written;
    ASSERT_EQ(block(back), written) << seed;
  }
}

// --- value_at
// ---------------------------------------------------------------------------------------------------------

TEST(ValueAt, FollowsKeysNamesAndIndices) {
  const Node document = parse_text(
      "a: {b: 1, c.d: 2, c: {e: 3}}\nl: [{name: x, v: 4}, {name: y, v: {w: 5}}, 6]\nn: ~\nuse: {s.p: {q: 7}, s: 8}\n",
      "t");
  EXPECT_EQ(value_at(document, "a.b").text(), "1");
  EXPECT_EQ(value_at(document, "a.c.d").text(), "2");
  EXPECT_EQ(value_at(document, "a.c.e").text(), "3");
  EXPECT_EQ(value_at(document, "l.x.v").text(), "4");
  EXPECT_EQ(value_at(document, "l.y.v.w").text(), "5");
  EXPECT_EQ(value_at(document, "l.0.v").text(), "4");
  EXPECT_EQ(value_at(document, "l.2").text(), "6");
  EXPECT_EQ(value_at(document, "use.s.p.q").text(), "7");
  EXPECT_EQ(value_at(document, "use.s").text(), "8");
  EXPECT_EQ(value_at(document, "n").kind(), Node::Kind::null);
  EXPECT_TRUE(same(value_at(document, ""), document));
  for (const char* nothing : {"b", "a.b.c", "a.c.x", "l.z", "l.3", "l.x.w", "n.m", "use.s.p.r", "a.", ".a", ".", "l.-1",
                              "l.", "a..b", "l.99999999999999999999"}) {
    EXPECT_FALSE(value_at(document, nothing)) << nothing;
  }
}

// A name counts before an index, as it does for with().
TEST(ValueAt, ANameIsNotTakenForAnIndex) {
  const Node document = parse_text("l: [{name: '1', v: first}, {name: '0', v: second}]\n", "t");
  EXPECT_EQ(value_at(document, "l.0.v").text(), "second");
  EXPECT_EQ(value_at(document, "l.1.v").text(), "first");
  const Node changed = with(document, "l.0.v", scalar("x"), nowhere);
  EXPECT_EQ(value_at(changed, "l.0.v").text(), "x");
}

// Wherever a value can be laid, it is found again, and what is not on its way stays.
TEST(ValueAt, FindsWhatWithHasLaid) {
  std::mt19937 random(5);
  const std::vector<std::string> keys{"a", "b", "c", "a.b", "b.c", "a.b.c", "x", "y", "0", "1", "name"};
  const auto pick = [&](std::size_t below) { return std::uniform_int_distribution<std::size_t>(0, below - 1)(random); };
  const std::function<Node(int)> tree = [&](int depth) -> Node {
    const std::size_t kind = depth == 0 ? 0 : pick(4);
    if (kind == 0) return scalar(keys[pick(4)]);
    if (kind == 1) {
      std::vector<Node> elements;
      for (std::size_t i = pick(3) + 1; i > 0; --i) elements.push_back(tree(depth - 1));
      return Node::sequence(std::move(elements), nowhere);
    }
    std::vector<Node::Entry> entries;
    std::set<std::string> seen;
    for (std::size_t i = pick(4); i > 0; --i) {
      const std::string key = keys[pick(keys.size())];
      if (!seen.insert(key).second) continue;
      entries.push_back({key, nowhere, key == "name" ? scalar(keys[pick(keys.size())]) : tree(depth - 1)});
    }
    return Node::map(std::move(entries), nowhere);
  };
  int laid = 0;
  for (int round = 0; round < 20000; ++round) {
    Node document = tree(4);
    if (document.kind() != Node::Kind::map) continue;
    std::string path;
    for (std::size_t i = pick(4) + 1; i > 0; --i) path += (path.empty() ? "" : ".") + keys[pick(10)];
    // An element that is replaced as a whole loses its name.
    if (value_at(document, path)["name"]) continue;
    Node changed;
    try {
      changed = with(document, path, scalar("laid"), nowhere);
    } catch (const Error&) {
      continue;
    }
    ++laid;
    ASSERT_EQ(value_at(changed, path).text(), "laid") << path << '\n' << block(document) << '\n' << block(changed);
  }
  EXPECT_GT(laid, 5000);
}

}  // namespace
}  // namespace regista::config
