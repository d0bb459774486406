// SPDX-License-Identifier: MIT
// Formats texts of users, counts and durations for messages: in one line, short, without invisible characters.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace regista::texts {

std::string one_line(std::string_view text);  // same as visible()

// Returns `"text"` in double quotes in one line. "..." replaces everything after the first 40 bytes.
std::string in_quotes(std::string_view text);

// Joins names to "a, b, c".
std::string join(std::span<const std::string> names);

// Returns the count with its noun: "1 pair", "3 pairs".
std::string plural(std::uint64_t count, std::string_view one, std::string_view many);

// Returns a noun with its article: "a team", "an opening". A noun that begins with u gets "a", as in "a utility".
std::string with_article(std::string_view noun);

// Returns the text with a backslash before each of these characters.
std::string with_backslashes(std::string_view text, std::string_view before);

// Formats a duration: "45 s", "12 min", "3.5 h".
std::string duration(double seconds);

// `unknown key "a" in b; nearest: "c"; known: c, d`: the message for an unknown name. `what` is the kind of name
// ("key"); `where` is the searched place, "" if it is obvious.
std::string unknown(std::string_view what, std::string_view asked, std::string_view where,
                    std::span<const std::string> known);

// Returns the names of things for join() and unknown(): `names_of(team.roles, &Role::name)`.
template <class Things, class Name>
std::vector<std::string> names_of(const Things& things, Name name) {
  std::vector<std::string> names;
  for (const auto& each : things) names.emplace_back(std::invoke(name, each));
  return names;
}

// Appends a value that the list does not contain.
template <class Value>
void add_once(std::vector<Value>& list, const std::type_identity_t<Value>& value) {
  if (std::ranges::find(list, value) == list.end()) list.push_back(value);
}

// --- "Did you mean": finds the known name with the fewest edits to an unknown name. The distance is the optimal string
// alignment distance: insertions, deletions, substitutions and swaps of neighbours, the errors that Damerau counted (A
// technique for computer detection and correction of spelling errors, Communications of the ACM 7(3), 1964).

std::string lower(std::string text);  // only ASCII letters change

// Returns the number of edits between two texts. Upper and lower case of ASCII letters are equal.
std::size_t edit_distance(std::string_view a, std::string_view b);

// Returns the known name with the fewest edits to `asked`; of several such names, the first. Returns an empty view if
// the number of edits exceeds a third of the length of `asked`, rounded up. The result views an element of `known`.
std::string_view nearest(std::string_view asked, std::span<const std::string> known);

// --- Texts from files and plugins in a form that is safe to show. The result is always well-formed UTF-8 (RFC 3629).
// Escapes replace characters that are invisible, or that change the place or the direction of other characters. Unicode
// Standard Annex #9, "Unicode Bidirectional Algorithm", lists the characters that change the direction.

struct Character {
  char32_t code;
  std::size_t bytes;  // 0: invalid bytes
};

// Returns the first character of a text that is not empty, by table 3-7 of Unicode 15.
Character first_character(std::string_view text);

// Returns one line: a line break becomes the two characters \ and n. Invalid UTF-8 bytes become U+FFFD.
std::string visible(std::string_view text);

// Converts like visible(), but keeps line ends.
std::string visible_lines(std::string_view text);

// Converts like visible() to at most `characters` characters; "..." replaces the rest.
std::string visible_at_most(std::string_view text, std::size_t characters);

}  // namespace regista::texts
