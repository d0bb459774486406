// SPDX-License-Identifier: MIT
// JSON Schemas of the messages, in every recording, for readers. docs/recordings.md describes the messages in words.
#pragma once

#include <string>
#include <string_view>

namespace regista::recording::schema {

inline const std::string number = R"({"type":"number"})";
inline const std::string integer = R"({"type":"integer"})";
inline const std::string text = R"({"type":"string"})";
inline const std::string boolean = R"({"type":"boolean"})";
inline const std::string side = R"({"type":"string","enum":["home","away"]})";

inline std::string list(const std::string& of, int least = 0, int most = -1) {
  std::string out = R"({"type":"array","items":)" + of;
  if (least > 0) out += R"(,"minItems":)" + std::to_string(least);
  if (most >= 0) out += R"(,"maxItems":)" + std::to_string(most);
  return out + '}';
}
inline std::string described(const std::string& schema, std::string_view what) {
  return schema.substr(0, schema.size() - 1) + R"(,"description":")" + std::string(what) + "\"}";
}
inline std::string one_of(const std::string& words) { return R"({"type":"string","enum":[)" + words + "]}"; }
inline std::string or_null(const std::string& schema) { return R"({"anyOf":[)" + schema + R"(,{"type":"null"}]})"; }

// Returns whether a property may be under "properties". Foxglove refuses a topic with lists of lists or alternatives
// there. Such properties are under "allOf", which validators read and Foxglove does not.
inline bool is_plain(std::string_view schema) {
  return schema.starts_with(R"({"type":)") && !schema.starts_with(R"({"type":"array","items":{"type":"array")") &&
         !schema.starts_with(R"({"type":"array","items":{"anyOf")");
}

// A property is required unless `optional` is true. Later versions may add properties.
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
inline const std::string sets = list(list(integer), 2, 2);
inline const std::string both_sets = described(sets, "home, away: numbers of robots");
inline const std::string role = described(integer, "row of the table of roles; -1 none, -2 not known yet");
inline const std::string matrix = list(list(or_null(number)));
inline const std::string decision_time = described(number, "s since the match began, of the decision that it is of");
inline const std::string mind_of = described(integer, "whose mind it is of");

inline std::string game() {
  return object({{"time", time},
                 {"half", integer},
                 {"clock", described(number, "s played of this half")},
                 {"phase", one_of(R"("initial","ready","set","playing","finished")")},
                 {"set_play", text},
                 {"kicking", described(side, "whose set play or last kick-off it is")},
                 {"score", both_counts},
                 {"packets_left", both_counts},
                 {"penalised", both_sets},
                 {"fallen", both_sets},
                 {"kicks", described(sets, "home, away: robots that are kicking")},
                 {"chases", described(sets, "home, away: able robots that go for the ball, in Playing"), true},
                 {"ball", described(list(number, 4, 4), "x, y in m, velocity in m/s, world frame")},
                 {"home", list(pose)},
                 {"away", list(pose)},
                 {"roles", described(list(list(role), 2, 2), "home, away: the role that each robot holds")}},
                "game");
}

inline std::string event() {
  return object({{"time", time},
                 {"event", text},
                 {"side", described(side, "whom it concerns")},
                 {"robot", described(integer, "0 where there is none")},
                 {"offence", R"({"type":"string","description":"of a penalty"})", true},
                 {"score", both_counts}},
                "event");
}

// Only a pass has a receiver. Only a duel has opponent and duration. A clearance has no outcome.
inline std::string play() {
  return object(
      {{"time", described(number, "s since the match began: when it was decided what became of it")},
       {"kind", one_of(R"("shot","pass","clearance","duel")")},
       {"side", described(side, "whose shot, pass or clearance; in a duel, whose robot was nearer to the ball")},
       {"robot", integer},
       {"began", described(number, "s since the match began")},
       {"at", described(list(number, 2, 2), "x, y of the ball in m when it began, world frame")},
       {"outcome", one_of(R"("goal","saved","missed","arrived","intercepted","lost","won","undecided")"), true},
       {"receiver", described(integer, "of a pass: whom it was meant for"), true},
       {"opponent", described(integer, "of a duel: the robot of the other side"), true},
       {"duration", described(number, "s, of a duel"), true}},
      "play");
}

inline std::string packet() {
  return object({{"time", time}, {"side", side}, {"robot", integer}, {"reason", text}, {"bytes", integer}}, "packet");
}

inline std::string heard() {
  return object({{"time", time},
                 {"side", side},
                 {"robot", described(integer, "who heard it")},
                 {"sender", integer},
                 {"sent", described(number, "s, when it was sent")}},
                "heard");
}

inline std::string segment() {
  return object(
      {{"time", decision_time},
       {"side", side},
       {"robot", mind_of},
       {"segment", one_of(R"("offered","refused","sent","dropped","heard","undelivered")")},
       {"why",
        described(one_of(R"("senseless","too_long","too_many_places","too_many_pending","expired","replaced",)"
                         R"("withdrawn","unknown_place","no_mailbox","wrong_length")"),
                  "it is refused, dropped or not delivered"),
        true},
       {"place", described(integer, "of the plugin among those of the mind, from 0"), true},
       {"plugin", described(text, "its id; empty where the place is not known"), true},
       {"handle", described(integer, "of the offer: one number for each robot that offers"), true},
       {"length", described(integer, "bytes that were offered"), true},
       {"bytes", described(text, "two hexadecimal digits each"), true},
       {"text", described(text, "what the plugin says that they say"), true},
       {"urgency", described(or_null(number), "0 to 1; 1 is worth a packet of its own"), true},
       {"expires", described(or_null(number), "s since the match began"), true},
       {"by", described(integer, "handle of the offer that replaced it"), true},
       {"at", described(integer, "which segment of its packet, from 0"), true},
       {"left", described(boolean, "of what is sent: the packet left the robot"), true},
       {"sender", described(integer, "who sent what is heard or not delivered"), true},
       {"sent", described(number, "s since the match began"), true},
       {"heard", described(number, "s since the match began: when it arrived"), true}},
      "segment");
}

inline std::string log() {
  return object({{"time", decision_time},
                 {"side", side},
                 {"robot", mind_of},
                 {"plugin", described(text, "its id")},
                 {"place", described(integer, "of the plugin's instance in the mind")},
                 {"tick", described(integer, "decisions of the robot before")},
                 {"level", one_of(R"("debug","info","warning","error")")},
                 {"text", described(text, "one line")}},
                "log");
}

// New shapes of a layer replace the layer's earlier shapes; an empty list removes them.
inline std::string draw() {
  const std::string shape = object(
      {{"shape", one_of(R"("points","line","polygon","text")")},
       {"at", described(list(point), "dots, the way of a line, the corners of a polygon, or the place of a text")},
       {"colour", R"({"type":"string","pattern":"^#[0-9a-fA-F]{8}$","description":"red, green, blue, opacity"})", true},
       {"width", described(number, "m, of a line, or the diameter of a dot"), true},
       {"filled", described(boolean, "of a polygon"), true},
       {"text", text, true}});
  return object(
      {{"time", decision_time},
       {"side", side},
       {"robot", mind_of},
       {"plugin", described(text, "its id")},
       {"layer", text},
       {"shapes", described(list(shape), "all of the layer until the next message about it; empty: nothing")}},
      "draw");
}

inline std::string decision() {
  const std::string task = object({{"role", role}, {"before", pose}, {"after", or_null(pose)}});
  return object({{"time", time},
                 {"context", described(integer, "index into the team's contexts; -1 none holds")},
                 {"knowledge", described(one_of(R"("mine","common")"), "the world that utilities are of")},
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
  return object({{"time", time}, {"pose", pose}, {"sees_ball", boolean}, {"mine", world}, {"common", world, true}},
                "belief");
}

}  // namespace regista::recording::schema
