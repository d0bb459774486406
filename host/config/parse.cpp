// SPDX-License-Identifier: MIT
#include "config/parse.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "config/encoding.hpp"
#include "config/file.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

// How much of the two limits a value uses, itself included.
struct Extent {
  std::size_t nodes = 1;
  int depth = 0;
};

// Builds the tree from yaml-cpp's events, and refuses what this room does not accept as soon as it is seen.
class Builder : public YAML::EventHandler {
 public:
  // Values stand where their marks say, in the file of `place`; or, when `fixed`, all at `place`.
  Builder(std::string_view text, Location place, bool fixed) : text_(text), place_(std::move(place)), fixed_(fixed) {
    line_starts_.push_back(0);
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') line_starts_.push_back(i + 1);
    }
  }

  Node take() { return std::move(root_); }
  bool seen() const { return documents_ > 0; }

  Location at(const YAML::Mark& mark) const {
    if (fixed_ || mark.is_null()) return place_;
    return {place_.file, mark.line + 1, mark.column + 1};
  }

  // A bracket that was opened and not closed, the innermost.
  struct Bracket {
    Location where;
    char closed_by;
  };
  std::optional<Bracket> open_bracket() const {
    if (open_.empty() || fixed_) return std::nullopt;
    const std::string_view rest = from(open_.back().mark);
    if (!rest.starts_with('{') && !rest.starts_with('[')) return std::nullopt;
    return Bracket{open_.back().where, rest[0] == '{' ? '}' : ']'};
  }

  // The last line above this one that says something, without its indentation and dashes; empty when none does.
  std::string_view line_above(int line) const {
    const int last = std::min(line - 2, static_cast<int>(line_starts_.size()) - 2);
    for (int above = last; above >= 0; --above) {
      const std::size_t begin = line_starts_[static_cast<std::size_t>(above)];
      const std::size_t end = line_starts_[static_cast<std::size_t>(above) + 1];
      const std::size_t first = text_.find_first_not_of(" -\t\r", begin);
      if (first < end && text_[first] != '\n' && text_[first] != '#') return text_.substr(first, end - first);
    }
    return {};
  }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ == 1) return;
    const bool separated = from(mark).starts_with("---");
    throw Error(at(mark), separated ? "second document; a file holds one" : "text after the end of the document");
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (key_wanted()) throw Error(at(mark), "a key is missing before the ':'");
    count(mark);
    Node node = Node::null(null_place(mark));
    remember(anchor, {node, {}});
    add(std::move(node), {});
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (key_wanted()) throw Error(at(mark), "an alias cannot be a key");
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end()) throw Error(at(mark), "alias of a value that contains it");
    count(mark, found->second.extent);
    add(found->second.node, found->second.extent);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_tag(mark, tag);
    const bool quoted = tag == "!";
    if (quoted) refuse_open_quote(mark);
    if (key_wanted()) {
      if (anchor != 0) throw Error(at(mark), "a key cannot have an anchor");
      if (value == "<<" && !quoted) {
        throw Error(at(mark), "merge key \"<<\" is not supported; use `extends: FILE` for variants of a file");
      }
      begin_entry(value, at(mark));
      return;
    }
    count(mark);
    Node node = Node::scalar(value, quoted, at(mark));
    remember(anchor, {node, {}});
    add(std::move(node), {});
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    start(mark, tag, anchor, false);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    start(mark, tag, anchor, true);
  }
  void OnSequenceEnd() override { finish(); }
  void OnMapEnd() override { finish(); }

 private:
  struct Anchored {
    Node node;
    Extent extent;
  };
  // A map or sequence whose end has not been seen.
  struct Open {
    bool map;
    Location where;
    YAML::Mark mark;
    YAML::anchor_t anchor;
    Extent extent;
    std::vector<Node> elements;
    std::vector<Node::Entry> entries;
    std::optional<Node::Entry> key;    // waits for its value
    std::map<std::string, int> lines;  // of the keys so far
  };

  // The text from a mark on; empty where the mark is outside. Marks count lines like the text does, but not bytes
  // (carriage returns are missing).
  std::string_view from(const YAML::Mark& mark) const {
    if (mark.is_null() || static_cast<std::size_t>(mark.line) >= line_starts_.size()) return {};
    const std::size_t position =
        line_starts_[static_cast<std::size_t>(mark.line)] + static_cast<std::size_t>(mark.column);
    return position < text_.size() ? text_.substr(position) : std::string_view{};
  }

  bool key_wanted() const { return !open_.empty() && open_.back().map && !open_.back().key; }

  // A value that was left out has its mark at whatever comes next; it stands where its key does.
  Location null_place(const YAML::Mark& mark) const {
    const Location here = at(mark);
    if (open_.empty() || !open_.back().key) return here;
    const Location& key = open_.back().key->key_where;
    const std::string_view rest = from(mark);
    const bool written = here.line == key.line && !rest.empty() && std::string_view("~nN").find(rest[0]) != rest.npos;
    return written ? here : key;
  }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (!tag.empty() && tag != "?" && tag != "!") {
      throw Error(at(mark), fmt::format("tag {}; tags are not supported", texts::in_quotes(tag)));
    }
  }

  // yaml-cpp takes a quote that is never closed as closed at the end of the file.
  void refuse_open_quote(const YAML::Mark& mark) const {
    const std::string_view rest = from(mark);
    if (rest.empty() || (rest[0] != '"' && rest[0] != '\'')) return;
    for (std::size_t i = 1; i < rest.size(); ++i) {
      if (rest[0] == '"' && rest[i] == '\\') {
        ++i;
      } else if (rest[i] == rest[0]) {
        if (rest[0] == '"' || i + 1 == rest.size() || rest[i + 1] != '\'') return;
        ++i;
      }
    }
    throw Error(at(mark), fmt::format("quote {} is never closed", rest[0]));
  }

  void count(const YAML::Mark& mark, Extent extent = {}) {
    nodes_ += extent.nodes;
    if (nodes_ > most_nodes) {
      throw Error(at(mark), fmt::format("more than {} values (aliases count as what they stand for)", most_nodes));
    }
    if (static_cast<int>(open_.size()) + extent.depth > deepest) {
      throw Error(at(mark), fmt::format("nested deeper than {} levels", deepest));
    }
  }

  void begin_entry(const std::string& key, Location where) {
    const auto [first, added] = open_.back().lines.emplace(key, where.line);
    if (!added) {
      std::string message = fmt::format("duplicate key {}", texts::in_quotes(key));
      if (!fixed_) message += fmt::format("; first in line {}", first->second);
      throw Error(std::move(where), message);
    }
    open_.back().key = {key, std::move(where), {}};
  }

  void start(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, bool map) {
    refuse_tag(mark, tag);
    if (key_wanted()) throw Error(at(mark), "a key must be plain text; is a bracket not closed?");
    count(mark, {1, 1});
    open_.push_back({map, at(mark), mark, anchor, {1, 1}, {}, {}, {}, {}});
  }

  void finish() {
    Open done = std::move(open_.back());
    open_.pop_back();
    Node node = done.map ? Node::map(std::move(done.entries), done.where)
                         : Node::sequence(std::move(done.elements), done.where);
    remember(done.anchor, {node, done.extent});
    add(std::move(node), done.extent);
  }

  void remember(YAML::anchor_t anchor, Anchored value) {
    if (anchor != 0) anchors_.emplace(anchor, std::move(value));
  }

  void add(Node node, Extent extent) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& into = open_.back();
    into.extent.nodes += extent.nodes;
    into.extent.depth = std::max(into.extent.depth, extent.depth + 1);
    if (!into.map) {
      into.elements.push_back(std::move(node));
      return;
    }
    into.key->value = std::move(node);
    into.entries.push_back(std::move(*into.key));
    into.key.reset();
  }

  std::string_view text_;
  Location place_;
  bool fixed_;
  std::vector<std::size_t> line_starts_;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Anchored> anchors_;  // of complete values only
  std::size_t nodes_ = 0;
  int documents_ = 0;
  Node root_;
};

// yaml-cpp speaks of its scanner; this is what the writer of the file did.
std::string reworded(const std::string& message) {
  static const std::array<std::pair<std::string_view, std::string_view>, 17> words{{
      {YAML::ErrorMsg::END_OF_MAP_FLOW, "',' or '}' expected to continue or end the map"},
      {YAML::ErrorMsg::END_OF_SEQ_FLOW, "',' or ']' expected to continue or end the list"},
      {YAML::ErrorMsg::END_OF_MAP, "this does not continue the map above; check the indentation"},
      {YAML::ErrorMsg::END_OF_SEQ, "this does not continue the list above; check the indentation and the '- '"},
      {YAML::ErrorMsg::MAP_VALUE, "':' where no value can begin; check the indentation, or quote the text"},
      {YAML::ErrorMsg::MAP_KEY, "'?' where no key can begin"},
      {YAML::ErrorMsg::BLOCK_ENTRY, "'- ' where no list can begin; check the indentation"},
      {YAML::ErrorMsg::FLOW_END, "closing bracket without an opening one"},
      {YAML::ErrorMsg::EOF_IN_SCALAR, "quote is never closed"},
      {YAML::ErrorMsg::DOC_IN_SCALAR, "quote is not closed before the end of the document"},
      {YAML::ErrorMsg::UNKNOWN_TOKEN, "this character cannot begin a value; quote the text"},
      {YAML::ErrorMsg::UNKNOWN_ANCHOR, "alias without an anchor before it"},
      {YAML::ErrorMsg::ALIAS_CONTENT, "an alias cannot have a value of its own"},
      {YAML::ErrorMsg::TAB_IN_INDENTATION, "tab in the indentation; use spaces"},
      {YAML::ErrorMsg::MULTIPLE_ANCHORS, "two anchors on one value"},
      {YAML::ErrorMsg::MULTIPLE_TAGS, "two tags on one value"},
      {YAML::ErrorMsg::BAD_FILE, "nested too deeply"},
  }};
  for (const auto& [theirs, ours] : words) {
    if (std::string_view(message).starts_with(theirs)) return std::string(ours);
  }
  return "not YAML: " + message;
}

// `key:value`, without the space that makes it key and value: YAML reads that as text, which goes on in the next line.
bool runs_together(std::string_view line) {
  const std::size_t colon = line.find(':');
  return colon != line.npos && colon + 1 < line.size() &&
         std::string_view(" \t\r\n").find(line[colon + 1]) == line.npos;
}

bool leaves_bracket_open(std::string_view line) {
  const auto count = [&](char c) { return std::ranges::count(line, c); };
  return count('{') > count('}') || count('[') > count(']');
}

// A mistake of YAML is found after what it comes from: this says what that is, where it can be told.
Error explained(const YAML::ParserException& error, const Builder& builder) {
  namespace They = YAML::ErrorMsg;
  const Location found = builder.at(error.mark);
  if (error.msg == They::END_OF_MAP_FLOW || error.msg == They::END_OF_SEQ_FLOW) {
    if (const auto open = builder.open_bracket(); open && open->where.line < found.line) {
      return {open->where, fmt::format("the {} that begins here is not closed: expected ',' or '{}' before line {}",
                                       open->closed_by == '}' ? "map" : "list", open->closed_by, found.line)};
    }
  }
  const std::string_view above = builder.line_above(found.line);
  if (error.msg == They::BLOCK_ENTRY && leaves_bracket_open(above)) {
    return {found, "'- ' where no list can begin; is a bracket not closed in the line above?"};
  }
  if (error.msg == They::MAP_VALUE && runs_together(above)) {
    return {found, "':' where no value can begin; is a space missing after ':' in the line above?"};
  }
  if (error.msg == They::END_OF_MAP && runs_together(above)) {
    return {found, "this does not continue the map above; is a space missing after ':' in the line above?"};
  }
  return {found, reworded(error.msg)};
}

Node build(std::string_view text, const Location& place, bool fixed) {
  Builder builder(text, place, fixed);
  std::istringstream stream{std::string(text)};
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::ParserException& error) {
    throw explained(error, builder);
  } catch (const YAML::Exception& error) {
    throw Error(place, "not YAML: " + error.msg);
  }
  return builder.seen() ? builder.take() : Node();
}

}  // namespace

Node parse(const std::filesystem::path& file, const Location& asked_by) {
  return parse_text(read_file(file, asked_by, "a YAML file"), file.string());
}

Node parse_text(std::string_view text, const std::string& name) {
  if (text.size() > largest_file) {
    throw Error({name, 0, 0}, fmt::format("larger than {} bytes", largest_file));
  }
  if (const auto flaw = encoding_flaw(text)) throw Error({name, flaw->line, flaw->column}, flaw->message);
  Node document = build(text, {name, 0, 0}, false);
  if (!document) throw Error({name, 0, 0}, "is empty");
  if (document.kind() == Node::Kind::null) throw Error(document.where(), "is empty");
  if (document.kind() == Node::Kind::sequence) throw Error(document.where(), "expected a map at the top, not a list");
  if (document.kind() == Node::Kind::scalar) throw Error(document.where(), "expected a map at the top, not text");
  return document;
}

Node parse_value(std::string_view text, const Location& where) {
  if (const auto flaw = encoding_flaw(text)) throw Error(where, flaw->message);
  Node value = build(text, where, true);
  return value ? value : Node::null(where);
}

}  // namespace regista::config
