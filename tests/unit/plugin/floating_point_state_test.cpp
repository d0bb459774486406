// SPDX-License-Identifier: MIT
#include "plugin/process_state.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <cstring>
#include <limits>

#include "plugin/kinds.hpp"
#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

constexpr const char* rounding = "changed the rounding mode";
constexpr const char* small_numbers = "changed how small numbers are treated (flush to zero)";
constexpr const char* exceptions = "unmasked floating-point exceptions";

// Independent of the code under test: what arithmetic does.
bool rounds_to_nearest() {
  volatile double third = 1.0, three = 3.0, minus = -1.0;
  const double up = third / three, down = minus / three;
  return up == 0x1.5555555555555p-2 && down == -0x1.5555555555555p-2 && std::fegetround() == FE_TONEAREST;
}
bool keeps_small_numbers() {
  volatile double least = std::numeric_limits<double>::min();
  volatile double half = least / 2;
  return half != 0.0 && half + half == least;
}

class FloatingPointStateTest : public PuppetTest {
 protected:
  using Change = void (*)();
  void TearDown() override { before_.restore(); }

  // What a call ends in that changes the state so, however closely it is looked at; the state is what it was then.
  std::string called(Change change) {
    Puppet::looks_closely = false;
    const std::string as_usual = called_once(change);
    Puppet::looks_closely = true;
    EXPECT_EQ(called_once(change), as_usual);
    return as_usual;
  }
  std::string called_once(Change change) {
    change_ = change;
    Puppet::context.holds = [](void*, const regista_frame*, std::int32_t*, regista_error*) -> std::int32_t {
      change_();
      return REGISTA_OK;
    };
    const std::string message = message_of([&] { Context(Puppet::instance()).holds(Scene().frame); });
    expect_usual();
    return message;
  }
  void expect_usual() const {
    EXPECT_TRUE(rounds_to_nearest());
    EXPECT_TRUE(keeps_small_numbers());
    EXPECT_EQ(FloatingPointState::now(), before_);
    EXPECT_EQ(FloatingPointState::difference_for_numbers(), 0u);
  }

  static inline Change change_;
  FloatingPointState before_ = FloatingPointState::now();
};

TEST_F(FloatingPointStateTest, NamesEachRoundingMode) {
  EXPECT_EQ(called([] { std::fesetround(FE_UPWARD); }), Puppet::failure(std::string("holds: ") + rounding));
  EXPECT_EQ(called([] { std::fesetround(FE_DOWNWARD); }), Puppet::failure(std::string("holds: ") + rounding));
  EXPECT_EQ(called([] { std::fesetround(FE_TOWARDZERO); }), Puppet::failure(std::string("holds: ") + rounding));
  EXPECT_EQ(called([] {}), "");
}

#if defined(__x86_64__)
TEST_F(FloatingPointStateTest, NamesFlushingEitherWay) {
  EXPECT_EQ(called([] { _mm_setcsr(_mm_getcsr() | 0x8000); }), Puppet::failure(std::string("holds: ") + small_numbers));
  EXPECT_EQ(called([] { _mm_setcsr(_mm_getcsr() | 0x0040); }), Puppet::failure(std::string("holds: ") + small_numbers));
  EXPECT_EQ(called([] { _mm_setcsr(_mm_getcsr() | 0x8040); }), Puppet::failure(std::string("holds: ") + small_numbers));
}

TEST_F(FloatingPointStateTest, SaysWhatChangedInTheStateOfLongDouble) {
  const auto with = [](std::uint16_t bits, std::uint16_t value) {
    std::uint16_t word = 0;
    __asm__ volatile("fnstcw %0" : "=m"(word));
    word = static_cast<std::uint16_t>((word & ~bits) | value);
    __asm__ volatile("fldcw %0" : : "m"(word));
  };
  with(0x0c00, 0x0400);
  EXPECT_EQ(FloatingPointState::now().changed_from(before_), rounding);
  before_.restore();
  with(0x0300, 0x0000);
  EXPECT_EQ(FloatingPointState::now().changed_from(before_), "changed the precision of floating-point arithmetic");
  before_.restore();
  with(0x0004, 0x0000);
  EXPECT_EQ(FloatingPointState::now().changed_from(before_), exceptions);
  before_.restore();
  EXPECT_EQ(FloatingPointState::now().changed_from(before_), "");
}
#endif

#if defined(__GLIBC__)
// Masks change no number, and reading them is dear: the calls of one decision of 127 are looked at.
TEST_F(FloatingPointStateTest, FindsUnmaskedExceptionsWithin127Decisions) {
  Puppet::context.holds = [](void*, const regista_frame*, std::int32_t*, regista_error*) -> std::int32_t {
    feenableexcept(FE_DIVBYZERO);
    return REGISTA_OK;
  };
  AnswerBuffers rooms;
  Caller caller{"paper", 3, 1, {}, &rooms};
  const regista_descriptor puppet = Puppet::descriptor();
  Context context(std::make_shared<Instance>(Found{"puppet.so", &puppet}, resolve(puppet, use("puppet")), environment(),
                                             nullptr, &caller));
  std::string message;
  for (; caller.tick < 200 && message.empty(); ++caller.tick) {
    caller.begin_decision();
    message = message_of([&] { context.holds(Scene().frame); });
  }
  EXPECT_EQ(message, std::string("plugin puppet (puppet.so) of team paper, robot 3, tick 127: holds: ") + exceptions);
  expect_usual();
}

// Who comes after is not blamed for it.
TEST_F(FloatingPointStateTest, TheNextOneDoesNotPay) {
  Context context(Puppet::instance());
  feenableexcept(FE_DIVBYZERO);
  EXPECT_EQ(message_of([&] { context.holds(Scene().frame); }), "");
  expect_usual();
}
#endif

TEST_F(FloatingPointStateTest, LooksAtCreateResetAndDestroyToo) {
  static regista_descriptor descriptor;
  static bool destroyed;
  const auto instance = [] { instance_of({"puppet.so", &descriptor}); };
  destroyed = false;
  descriptor = Puppet::descriptor();
  descriptor.create = [](const regista_environment*, const regista_host*, regista_span, regista_error*) -> void* {
    std::fesetround(FE_UPWARD);
    return &descriptor;
  };
  descriptor.destroy = [](void*) { destroyed = true; };
  EXPECT_EQ(message_of(instance), Puppet::failure(std::string("create: ") + rounding));
  EXPECT_TRUE(destroyed);
  expect_usual();

  descriptor = Puppet::descriptor();
  descriptor.reset = [](void*, std::uint64_t, regista_error*) {
    std::fesetround(FE_UPWARD);
    return Puppet::ok;
  };
  EXPECT_EQ(message_of(instance), Puppet::failure(std::string("reset: ") + rounding));
  expect_usual();

  descriptor = Puppet::descriptor();
  descriptor.destroy = [](void*) { std::fesetround(FE_UPWARD); };
  EXPECT_EQ(message_of(instance), "");
  expect_usual();
}

TEST_F(FloatingPointStateTest, IsRestoredWhenTheCallFailsOrThrows) {
  Puppet::context.holds = [](void*, const regista_frame*, std::int32_t*, regista_error* error) -> std::int32_t {
    std::fesetround(FE_UPWARD);
    std::strcpy(error->text, "no ball");
    return REGISTA_FAILED;
  };
  EXPECT_EQ(message_of([] { Context(Puppet::instance()).holds(Scene().frame); }),
            Puppet::failure(std::string("holds: ") + rounding));
  expect_usual();
  Puppet::context.holds = [](void*, const regista_frame*, std::int32_t*, regista_error*) -> std::int32_t {
    std::fesetround(FE_UPWARD);
    throw 3;
  };
  EXPECT_EQ(message_of([] { Context(Puppet::instance()).holds(Scene().frame); }),
            Puppet::failure(std::string("holds: ") + rounding));
  expect_usual();
}

}  // namespace
}  // namespace regista::plugin::test
