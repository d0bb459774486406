// SPDX-License-Identifier: MIT
// Moments and robots as people type them; the expected values follow from the clock's arithmetic.
#include "recording/moment_svg.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "config/errors.hpp"

namespace regista::recording {
namespace {

using config::BadInput;
using testing::HasSubstr;

std::string refusal(const auto& parse) {
  try {
    parse();
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(TypedMoment, SecondsSinceTheMatchBegan) {
  EXPECT_EQ(parse_moment("462.3").seconds, 462.3);
  EXPECT_EQ(parse_moment("7:42").seconds, 7 * 60 + 42);
  EXPECT_EQ(parse_moment("7:04.5").seconds, 7 * 60 + 4.5);
  EXPECT_EQ(parse_moment("0:00").seconds, 0.0);
  EXPECT_EQ(parse_moment("7:42").half, 0);
}

TEST(TypedMoment, TheClockOfAHalf) {
  const Moment moment = parse_moment("2/3:10");
  EXPECT_EQ(moment.half, 2);
  EXPECT_EQ(moment.seconds, 190.0);
  EXPECT_EQ(moment.typed, "2/3:10");
}

TEST(TypedMoment, WhatMayMeanTwoThingsOrNothing) {
  for (const char* text :
       {"7:4", "7:60", "-1", "nan", "inf", "", "x", "7:", ":30", "0/1:00", "100/1:00", "1/2/3", "7:42x"}) {
    EXPECT_THAT(refusal([&] { parse_moment(text); }), HasSubstr("--at: \"")) << text;
  }
}

TEST(TypedRobot, OfBothTeams) {
  const auto robot = [](const char* text) { return parse_robot(text, 7); };
  EXPECT_EQ(robot("3").side, 0);
  EXPECT_EQ(robot("3").number, 3);
  EXPECT_EQ(robot("home/7").side, 0);
  EXPECT_EQ(robot("away/5").side, 1);
  EXPECT_EQ(robot("away/5").number, 5);
  for (const char* text : {"0", "8", "away/8", "away/", "Away/1", "3x", ""}) {
    EXPECT_EQ(refusal([&] { robot(text); }),
              "--robot: \"" + std::string(text) + "\"; expected 1 to 7, home/1 to home/7 or away/1 to away/7");
  }
}

}  // namespace
}  // namespace regista::recording
