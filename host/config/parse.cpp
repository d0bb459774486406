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

#include "config/document_files.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

// Throws Error at the first byte that a file must not have: a file is UTF-8 text without byte order mark or control
// characters, indented by spaces. yaml-cpp misreads other bytes without an error (0x04 ends its input). place(line,
// column) returns the Location of a byte; line and column count from 1.
template <class Place>
void check_encoding(std::string_view text, Place place) {
  constexpr std::size_t longest_line = 65536;  // bytes; yaml-cpp may look ahead to the end of a line
  if (text.starts_with("\xef\xbb\xbf")) {
    throw Error(place(1, 1), "begins with a byte order mark; save it as UTF-8 without one");
  }
  if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) {
    throw Error(place(1, 1), "is UTF-16 text; save it as UTF-8");
  }
  int line = 1;
  std::size_t line_start = 0;
  bool indenting = true;
  for (std::size_t i = 0; i < text.size();) {
    const auto flaw = [&](const std::string& message) {
      return Error(place(line, static_cast<int>(i - line_start) + 1), message);
    };
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte == '\n') {
      ++line;
      line_start = ++i;
      indenting = true;
      continue;
    }
    if (i - line_start >= longest_line) throw flaw(fmt::format("line is longer than {} bytes", longest_line));
    if (byte == '\t' && indenting) throw flaw("tab in the indentation; use spaces");
    if (byte == '\r' && (i + 1 == text.size() || text[i + 1] != '\n')) throw flaw("carriage return inside a line");
    if ((byte < 0x20 && byte != '\t' && byte != '\r') || byte == 0x7f) {
      throw flaw(fmt::format("byte 0x{:02x} is not text; is this a binary file?", byte));
    }
    if (byte != ' ') indenting = false;
    const std::size_t length = texts::first_character(text.substr(i)).bytes;
    if (length == 0) throw flaw(fmt::format("byte 0x{:02x} is not UTF-8", byte));
    i += length;
  }
}

// The number of nodes and the depth of nesting of a value, including the value itself.
struct Extent {
  std::size_t nodes = 1;
  int depth = 0;
};

// Builds the tree from the events of yaml-cpp. Throws Error at the first event of unsupported YAML.
class Builder : public YAML::EventHandler {
 public:
  // If `fixed`, every value gets the Location `place`. Otherwise it gets its line and column in the file of `place`.
  Builder(std::string_view text, Location place, bool fixed) : text_(text), place_(std::move(place)), fixed_(fixed) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\n') line_starts_.push_back(i + 1);
    }
  }

  Node take() { return std::move(root_); }  // absent if the text holds no document

  Location at(const YAML::Mark& mark) const {
    if (fixed_ || mark.is_null()) return place_;
    return {place_.file, mark.line + 1, mark.column + 1};
  }

  // The innermost bracket that is not closed yet.
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

  // Returns the last non-empty line above `line`, without indentation and dashes; empty if there is no such line.
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
    add_leaf(mark, anchor, Node::null(null_place(mark)));
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
    add_leaf(mark, anchor, Node::scalar(value, quoted, at(mark)));
  }

  using Style = YAML::EmitterStyle::value;
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, Style) override {
    start(mark, tag, anchor, false);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, Style) override {
    start(mark, tag, anchor, true);
  }
  void OnSequenceEnd() override { finish(); }
  void OnMapEnd() override { finish(); }

 private:
  struct Anchored {
    Node node;
    Extent extent;
  };
  // A map or sequence whose end has not been read yet.
  struct Open {
    bool map;
    Location where;
    YAML::Mark mark;
    YAML::anchor_t anchor;
    Extent extent;
    std::vector<Node> elements;
    std::vector<Node::Entry> entries;
    std::optional<Node::Entry> key;    // key whose value has not been read yet
    std::map<std::string, int> lines;  // line of each key that has been read
  };

  // Returns the text from a mark on; empty if the mark is outside of the text. Uses line and column of the mark,
  // because the mark's byte position is wrong: yaml-cpp removes carriage returns.
  std::string_view from(const YAML::Mark& mark) const {
    if (mark.is_null() || static_cast<std::size_t>(mark.line) >= line_starts_.size()) return {};
    const std::size_t position =
        line_starts_[static_cast<std::size_t>(mark.line)] + static_cast<std::size_t>(mark.column);
    return position < text_.size() ? text_.substr(position) : std::string_view{};
  }

  bool key_wanted() const { return !open_.empty() && open_.back().map && !open_.back().key; }

  // yaml-cpp puts the mark of a missing value at the next token. So a missing value gets the Location of its key.
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

  // Throws Error for a quoted text without a closing quote. yaml-cpp would accept this text without an error.
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
    add(done.map ? Node::map(std::move(done.entries), done.where)
                 : Node::sequence(std::move(done.elements), done.where),
        done.extent, done.anchor);
  }

  void add_leaf(const YAML::Mark& mark, YAML::anchor_t anchor, Node node) {
    count(mark);
    add(std::move(node), {}, anchor);
  }

  // Adds a complete value to the innermost open map or sequence. anchor: 0 for a value without an anchor.
  void add(Node node, Extent extent, YAML::anchor_t anchor = 0) {
    if (anchor != 0) anchors_.emplace(anchor, Anchored{node, extent});
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& into = open_.back();
    into.extent.nodes += extent.nodes;
    into.extent.depth = std::max(into.extent.depth, extent.depth + 1);
    if (!into.map) return into.elements.push_back(std::move(node));
    into.key->value = std::move(node);
    into.entries.push_back(std::move(*into.key));
    into.key.reset();
  }

  std::string_view text_;
  Location place_;
  bool fixed_;
  std::vector<std::size_t> line_starts_{0};
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Anchored> anchors_;  // values with an anchor, stored when they are complete
  std::size_t nodes_ = 0;
  int documents_ = 0;
  Node root_;
};

// Translates a message of yaml-cpp, which describes its scanner, into a message about the document.
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

// Returns whether no space follows the colon, as in `key:value`. YAML then joins the line with the next line.
bool runs_together(std::string_view line) {
  const std::size_t colon = line.find(':');
  return colon != line.npos && colon + 1 < line.size() &&
         std::string_view(" \t\r\n").find(line[colon + 1]) == line.npos;
}

bool leaves_bracket_open(std::string_view line) {
  const auto count = [&](char c) { return std::ranges::count(line, c); };
  return count('{') > count('}') || count('[') > count(']');
}

// Returns an Error at the cause of a mistake, if the cause is known: yaml-cpp reports a mistake behind its cause.
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
  return builder.take();
}

}  // namespace

Node parse(const std::filesystem::path& file, const Location& asked_by) {
  return parse_text(read_file(file, asked_by, yaml_file), file.string());
}

Node parse_text(std::string_view text, const std::string& name) {
  if (text.size() > largest_file) throw Error({name}, fmt::format("larger than {} bytes", largest_file));
  check_encoding(text, [&name](int line, int column) { return Location{name, line, column}; });
  Node document = build(text, {name}, false);
  if (!document) throw Error({name}, "is empty");
  if (document.kind() == Node::Kind::null) throw Error(document.where(), "is empty");
  if (document.kind() == Node::Kind::map) return document;
  const bool list = document.kind() == Node::Kind::sequence;
  throw Error(document.where(), fmt::format("expected a map at the top, not {}", list ? "a list" : "text"));
}

Node parse_value(std::string_view text, const Location& where) {
  check_encoding(text, [&where](int, int) { return where; });
  Node value = build(text, where, true);
  return value ? value : Node::null(where);
}

}  // namespace regista::config
