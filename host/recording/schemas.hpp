// SPDX-License-Identifier: MIT
// What the messages of a recording look like, as JSON Schema: stands in every file, so that readers need nothing else.
// docs/recordings.md says the same in words.
#pragma once

#include <string>
#include <string_view>

namespace regista::recording::schema {

namespace part {

inline const std::string number = R"({"type":"number"})";
inline const std::string integer = R"({"type":"integer"})";
inline const std::string side = R"({"type":"string","enum":["home","away"]})";

inline std::string list(const std::string& of, int least = 0, int most = -1) {
  std::string out = R"({"type":"array","items":)" + of;
  if (least > 0) out += R"(,"minItems":)" + std::to_string(least);
  if (most >= 0) out += R"(,"maxItems":)" + std::to_string(most);
  return out + '}';
}
inline std::string described(const std::string& schema, std::string_view text) {
  return schema.substr(0, schema.size() - 1) + R"(,"description":")" + std::string(text) + "\"}";
}
inline std::string or_null(const std::string& schema) { return R"({"anyOf":[)" + schema + R"(,{"type":"null"}]})"; }

// Foxglove refuses a topic whose schema has, among its properties, lists of lists or alternatives. It reads no further
// than "properties", so these stand under "allOf", where validators find them.
inline bool is_plain(std::string_view schema) {
  return schema.starts_with(R"({"type":)") && !schema.starts_with(R"({"type":"array","items":{"type":"array")") &&
         !schema.starts_with(R"({"type":"array","items":{"anyOf")");
}

// All properties are required unless `optional` names one; more of them may come with later versions.
struct Property {
  std::string_view name;
  std::string schema;
  bool optional = false;
};
inline std::string object(std::initializer_list<Property> properties, std::string_view title = {}) {
  std::string out = R"({"type":"object",)", required, plain, others;
  const auto append = [](std::string& to, const std::string& item) { to += (to.empty() ? "" : ",") + item; };
  if (!title.empty()) {
    out += R"("$schema":"http://json-schema.org/draft-07/schema#","title":")" + std::string(title) + "\",";
  }
  for (const Property& property : properties) {
    const std::string name = '"' + std::string(property.name) + '"';
    append(is_plain(property.schema) ? plain : others, name + ':' + property.schema);
    if (!property.optional) append(required, name);
  }
  out += R"("properties":{)" + plain + R"(},"required":[)" + required + ']';
  if (!others.empty()) out += R"(,"allOf":[{"properties":{)" + others + "}}]";
  return out + '}';
}

inline const std::string time = described(number, "s since the match began");
inline const std::string point = described(list(number, 2, 2), "x, y in m, world frame");
inline const std::string pose = described(list(number, 3, 3), "x, y in m, heading in rad, world frame");
inline const std::string covariance = described(list(number, 3, 3), "xx, xy, yy in m^2");
inline const std::string both_counts = described(list(integer, 2, 2), "home, away");
inline const std::string both_sets = described(list(list(integer), 2, 2), "home, away: numbers of robots");
inline const std::string role = described(integer, "row of the table of roles; -1 none, -2 not known yet");
inline const std::string matrix = list(list(or_null(number)));

}  // namespace part

inline std::string game() {
  using namespace part;
  return object({{"time", time},
                 {"half", integer},
                 {"clock", described(number, "s played of this half")},
                 {"phase", R"({"type":"string","enum":["initial","ready","set","playing","finished"]})"},
                 {"set_play", R"({"type":"string"})"},
                 {"kicking", described(side, "whose set play or last kick-off it is")},
                 {"score", both_counts},
                 {"packets_left", both_counts},
                 {"penalised", both_sets},
                 {"fallen", both_sets},
                 {"kicks", described(both_sets, "robots that are kicking")},
                 {"chases", described(both_sets, "able robots that go for the ball, in Playing"), true},
                 {"ball", described(list(number, 4, 4), "x, y in m, velocity in m/s, world frame")},
                 {"home", list(pose)},
                 {"away", list(pose)},
                 {"roles", described(list(list(role), 2, 2), "home, away: the role that each robot holds")}},
                "game");
}

inline std::string event() {
  using namespace part;
  return object({{"time", time},
                 {"event", R"({"type":"string"})"},
                 {"side", described(side, "whom it concerns")},
                 {"robot", described(integer, "0 where there is none")},
                 {"offence", R"({"type":"string","description":"of a penalty"})", true},
                 {"score", both_counts}},
                "event");
}

// receiver: of a pass; opponent and duration: of a duel. A clearance has no outcome.
inline std::string play() {
  using namespace part;
  return object(
      {{"time", described(number, "s since the match began: when it was decided what became of it")},
       {"kind", R"({"type":"string","enum":["shot","pass","clearance","duel"]})"},
       {"side", described(side, "whose shot, pass or clearance; in a duel, whose robot was nearer to the ball")},
       {"robot", integer},
       {"began", described(number, "s since the match began")},
       {"at", described(list(number, 2, 2), "x, y of the ball in m when it began, world frame")},
       {"outcome",
        R"({"type":"string","enum":["goal","saved","missed","arrived","intercepted","lost","won","undecided"]})", true},
       {"receiver", described(integer, "of a pass: whom it was meant for"), true},
       {"opponent", described(integer, "of a duel: the robot of the other side"), true},
       {"duration", described(number, "s, of a duel"), true}},
      "play");
}

inline std::string packet() {
  using namespace part;
  return object(
      {{"time", time}, {"side", side}, {"robot", integer}, {"reason", R"({"type":"string"})"}, {"bytes", integer}},
      "packet");
}

inline std::string heard() {
  using namespace part;
  return object({{"time", time},
                 {"side", side},
                 {"robot", described(integer, "who heard it")},
                 {"sender", integer},
                 {"sent", described(number, "s, when it was sent")}},
                "heard");
}

inline std::string segment() {
  using namespace part;
  const auto one_of = [](std::string_view words) { return R"({"type":"string","enum":[)" + std::string(words) + "]}"; };
  return object(
      {{"time", described(number, "s since the match began, of the decision that it is of")},
       {"side", side},
       {"robot", described(integer, "whose mind it is of")},
       {"segment", one_of(R"("offered","refused","sent","dropped","heard","undelivered")")},
       {"why",
        described(one_of(R"("senseless","too_long","too_many_places","too_many_pending","expired","replaced",)"
                         R"("withdrawn","unknown_place","no_mailbox","wrong_length")"),
                  "it is refused, dropped or not delivered"),
        true},
       {"place", described(integer, "of the plugin among those of the mind, from 0"), true},
       {"plugin", described(R"({"type":"string"})", "its id; empty where the place is not known"), true},
       {"handle", described(integer, "of the offer: one number for each robot that offers"), true},
       {"length", described(integer, "bytes that were offered"), true},
       {"bytes", described(R"({"type":"string"})", "two hexadecimal digits each"), true},
       {"text", described(R"({"type":"string"})", "what the plugin says that they say"), true},
       {"urgency", described(or_null(number), "0 to 1; 1 is worth a packet of its own"), true},
       {"expires", described(or_null(number), "s since the match began"), true},
       {"by", described(integer, "handle of the offer that replaced it"), true},
       {"at", described(integer, "which segment of its packet, from 0"), true},
       {"left", described(R"({"type":"boolean"})", "of what is sent: the packet left the robot"), true},
       {"sender", described(integer, "who sent what is heard or not delivered"), true},
       {"sent", described(number, "s since the match began"), true},
       {"heard", described(number, "s since the match began: when it arrived"), true}},
      "segment");
}

inline std::string log() {
  using namespace part;
  return object({{"time", described(number, "s since the match began, of the decision that it is of")},
                 {"side", side},
                 {"robot", described(integer, "whose mind it is of")},
                 {"plugin", described(R"({"type":"string"})", "its id")},
                 {"place", described(integer, "of the plugin's instance in the mind")},
                 {"tick", described(integer, "decisions of the robot before")},
                 {"level", R"({"type":"string","enum":["debug","info","warning","error"]})"},
                 {"text", described(R"({"type":"string"})", "one line")}},
                "log");
}

// What a plugin draws in a layer replaces what it drew there before; an empty list takes it away.
inline std::string draw() {
  using namespace part;
  const std::string shape = object(
      {{"shape", R"({"type":"string","enum":["points","line","polygon","text"]})"},
       {"at", described(list(point), "dots, the way of a line, the corners of a polygon, or the place of a text")},
       {"colour", R"({"type":"string","pattern":"^#[0-9a-fA-F]{8}$","description":"red, green, blue, opacity"})", true},
       {"width", described(number, "m, of a line, or the diameter of a dot"), true},
       {"filled", described(R"({"type":"boolean"})", "of a polygon"), true},
       {"text", R"({"type":"string"})", true}});
  return object(
      {{"time", described(number, "s since the match began, of the decision that it is of")},
       {"side", side},
       {"robot", described(integer, "whose mind it is of")},
       {"plugin", described(R"({"type":"string"})", "its id")},
       {"layer", R"({"type":"string"})"},
       {"shapes", described(list(shape), "all of the layer until the next message about it; empty: nothing")}},
      "draw");
}

inline std::string decision() {
  using namespace part;
  const std::string task = object({{"role", role}, {"before", pose}, {"after", or_null(pose)}});
  return object(
      {{"time", time},
       {"context", described(integer, "index into the team's contexts; -1 none holds")},
       {"knowledge", described(R"({"type":"string","enum":["mine","common"]})", "the world that utilities are of")},
       {"waypoints", described(list(list(number, 3, 3)), "x, y in m, score")},
       {"edges", described(list(list(integer, 2, 2)), "indices of waypoints")},
       {"tasks", described(list(task), "before the offset, and after it where the task was kept")},
       {"columns", described(list(role), "the kept tasks: columns of the matrices")},
       {"rows", described(list(integer), "the active robots: rows of the matrices")},
       {"utility", described(matrix, "weighted sum of the terms; null where forbidden")},
       {"terms", described(list(matrix), "unweighted, in the order of the context's terms")},
       {"assigned", described(list(role), "the role of each robot of the team, as this one believes")},
       {"role", role},
       {"since", described(number, "s since the match began: when it took its role")}},
      "decision");
}

inline std::string belief() {
  using namespace part;
  const std::string ball = object({{"at", point}, {"velocity", point}, {"covariance", covariance}, {"age", number}});
  const std::string teammates = object({{"number", list(integer)},
                                        {"pose", list(pose)},
                                        {"covariance", list(covariance)},
                                        {"age", described(list(number), "s since there was news")},
                                        {"role", list(role)},
                                        {"active", described(list(integer), "numbers of those that play")}});
  const std::string opponents = object({{"at", list(point)},
                                        {"covariance", list(covariance)},
                                        {"age", list(number)},
                                        {"weight", described(list(number), "probability that it is there")}});
  const std::string world = object({{"ball", or_null(ball)},
                                    {"teammates", described(teammates, "columns: one entry for each robot known")},
                                    {"opponents", described(opponents, "columns: one entry for each opponent")}});
  return object({{"time", time},
                 {"pose", pose},
                 {"sees_ball", R"({"type":"boolean"})"},
                 {"mine", world},
                 {"common", world, true}},
                "belief");
}

}  // namespace regista::recording::schema
