// SPDX-License-Identifier: MIT
#include "plugin/instance.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>

#include "plugin/kinds.hpp"
#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

class InstanceTest : public PuppetTest {
 protected:
  // What ends the creation of this plugin.
  static std::string created(const std::string& name, const config::Node& params = {}) {
    return message_of([&] { instance_of(open(name), 0, params); });
  }
  // What ends a call that fails as `holds` does.
  static std::string called(decltype(regista_context::holds) holds) {
    Puppet::context.holds = holds;
    return message_of([] { Context(Puppet::instance()).holds(Scene().frame); });
  }
};

TEST_F(InstanceTest, SaysWhyItCouldNotBeCreated) {
  EXPECT_EQ(created("returns_null"), failure("returns_null", "create: failed without saying why"));
  EXPECT_EQ(created("returns_null", map({{"speaks", scalar("true")}})),
            failure("returns_null", "create: the field is\\ntoo small"));
  EXPECT_EQ(created("throws", map({{"in_create", scalar("true")}})), failure("throws", "create: fell in create"));
  EXPECT_EQ(created("throws", map({{"in_reset", scalar("true")}})), failure("throws", "reset: fell in reset"));
  EXPECT_EQ(created("crosses_the_boundary", map({{"at_once", scalar("true")}})),
            failure("crosses_the_boundary", "create: let an exception cross the plugin's boundary"));
}

TEST_F(InstanceTest, NamesNobodyWithoutACaller) {
  const Found throws = open("throws");
  const Parameters parameters = resolve(*throws.descriptor, use("throws"));
  Context context(std::make_shared<Instance>(throws, parameters, environment(), nullptr, nullptr));
  EXPECT_EQ(message_of([&] { context.holds(Scene().frame); }),
            "plugin throws (" + throws.file.string() + "): holds: fell in holds");
}

TEST_F(InstanceTest, FailuresCarryTheirParts) {
  Context context(instance_of(open("throws")));
  try {
    context.holds(Scene().frame);
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.id(), "throws");
    EXPECT_EQ(failure.file(), shared_object("throws"));
    EXPECT_EQ(failure.call(), "holds");
    EXPECT_EQ(failure.message(), "fell in holds");
    ASSERT_TRUE(failure.caller().has_value());
    EXPECT_EQ(failure.caller()->team, "paper");
    EXPECT_EQ(failure.caller()->robot, 3);
    EXPECT_EQ(failure.caller()->tick, 417u);
  }
}

TEST_F(InstanceTest, NamesTheTickAtWhichItFailed) {
  Caller caller{"paper", 3, 1};
  const Found throws = open("throws");
  const Parameters parameters = resolve(*throws.descriptor, use("throws"));
  Context context(std::make_shared<Instance>(throws, parameters, environment(), nullptr, &caller));
  caller.tick = 2;
  EXPECT_NE(message_of([&] { context.holds(Scene().frame); }).find("tick 2:"), std::string::npos);
}

TEST_F(InstanceTest, NotesWhichCallIsUnderWay) {
  CallNote note;
  static CallNote* noted;
  static CallNote during;
  noted = &note;
  Caller caller{"paper", 3, 417, {&note, 1}};
  Puppet::context.holds = [](void*, const regista_frame*, std::int32_t* out, regista_error*) -> std::int32_t {
    during = *noted;
    *out = 1;
    return REGISTA_OK;
  };
  static const regista_descriptor puppet = Puppet::descriptor();
  {
    const auto instance = std::make_shared<Instance>(Found{"puppet.so", &puppet}, resolve(puppet, use("puppet")),
                                                     environment(), nullptr, &caller);
    EXPECT_STREQ(note.plugin.data(), "puppet");
    EXPECT_STREQ(note.call.data(), "create");
    EXPECT_EQ(note.inside, 0u);
    caller.tick = 418;
    caller.begin_decision();
    Context context(instance);
    EXPECT_TRUE(context.holds(Scene().frame));
    EXPECT_STREQ(during.call.data(), "holds");
    EXPECT_EQ(during.robot, 3);
    EXPECT_EQ(during.side, 1);
    EXPECT_EQ(during.tick, 418u);
    EXPECT_EQ(during.inside, 1u);
    EXPECT_EQ(note.inside, 0u);
  }
  EXPECT_STREQ(note.call.data(), "destroy");
}

TEST_F(InstanceTest, ReadsErrorsThatAreNotWhatTheyShouldBe) {
  EXPECT_EQ(called([](void*, const regista_frame*, std::int32_t*, regista_error*) -> std::int32_t { return 7; }),
            Puppet::failure("holds: returned 7, which means nothing"));
  EXPECT_EQ(called([](void*, const regista_frame*, std::int32_t*, regista_error* error) -> std::int32_t {
              std::memset(error->text, 'a', sizeof error->text);
              return REGISTA_FAILED;
            }),
            Puppet::failure("holds: " + std::string(512, 'a')));
  EXPECT_EQ(called([](void*, const regista_frame*, std::int32_t*, regista_error* error) -> std::int32_t {
              std::strcpy(error->text, "one\ntwo");
              return REGISTA_FAILED;
            }),
            Puppet::failure("holds: one\\ntwo"));
  EXPECT_EQ(called([](void*, const regista_frame*, std::int32_t*, regista_error* error) -> std::int32_t {
              std::strcpy(error->text, "\x1b[2J\xff\u202e\u009b");
              return REGISTA_FAILED;
            }),
            Puppet::failure("holds: \\x1b[2J\xef\xbf\xbd\\u202e\\x9b"));
  EXPECT_EQ(
      called([](void*, const regista_frame*, std::int32_t*, regista_error*) -> std::int32_t {
        throw std::runtime_error("\x1b[2J" + std::string(1000, 'a'));
      }),
      Puppet::failure("holds: let an exception cross the plugin's boundary: \\x1b[2J" + std::string(496, 'a') + "..."));
}

// Reports and tables are given the message alone.
TEST_F(InstanceTest, TheMessageAloneIsCleanToo) {
  Puppet::context.holds = [](void*, const regista_frame*, std::int32_t*, regista_error* error) -> std::int32_t {
    std::strcpy(error->text, "a\x1b\nb");
    return REGISTA_FAILED;
  };
  try {
    Context(Puppet::instance()).holds(Scene().frame);
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.message(), "a\\x1b\\nb");
  }
}

TEST_F(InstanceTest, ForgetsOldErrors) {
  static bool speak;
  Puppet::context.holds = [](void*, const regista_frame*, std::int32_t*, regista_error* error) -> std::int32_t {
    if (speak) std::strcpy(error->text, "old");
    return REGISTA_FAILED;
  };
  Context context(Puppet::instance());
  speak = true;
  EXPECT_EQ(message_of([&] { context.holds(Scene().frame); }), Puppet::failure("holds: old"));
  speak = false;
  EXPECT_EQ(message_of([&] { context.holds(Scene().frame); }), Puppet::failure("holds: failed without saying why"));
}

TEST_F(InstanceTest, KnowsItsKinds) {
  const auto sound = instance_of(open("sound"));
  EXPECT_TRUE(sound->implements(REGISTA_KIND_PREDICTOR));
  EXPECT_TRUE(sound->implements(REGISTA_KIND_MAILBOX));
  EXPECT_FALSE(sound->implements(REGISTA_KIND_ASSIGNER));
  EXPECT_EQ(message_of([&] { Context context(sound); }), failure("sound", "table: is not a context"));
}

TEST_F(InstanceTest, IsCreatedResetAndDestroyedInThisOrder) {
  static std::string order;
  static const regista_environment* seen;
  order.clear();
  regista_descriptor descriptor = Puppet::descriptor();
  descriptor.create = [](const regista_environment* environment, const regista_host* host, regista_span,
                         regista_error*) -> void* {
    order += "create ";
    seen = environment;
    EXPECT_EQ(environment->size, sizeof(regista_environment));
    EXPECT_EQ(environment->own_number, 3);
    // Without a radio every offer is refused.
    EXPECT_EQ(host->offer(host->context, nullptr, 0, 0.5, 1.0, REGISTA_MEDIUM_RADIO, 0), 0u);
    EXPECT_EQ(host->bytes_free(host->context), 0u);
    host->withdraw(host->context, 3);
    return &order;
  };
  descriptor.reset = [](void* instance, std::uint64_t seed, regista_error*) {
    EXPECT_EQ(instance, &order);
    order += "reset" + std::to_string(seed) + " ";
    return Puppet::ok;
  };
  descriptor.destroy = [](void* instance) {
    EXPECT_EQ(instance, &order);
    order += "destroy";
  };
  {
    Instance instance({"puppet.so", &descriptor}, resolve(descriptor, use("puppet")), environment(), nullptr, nullptr);
    instance.reset(7);
    instance.reset(18446744073709551615u);
  }
  EXPECT_EQ(order, "create reset7 reset18446744073709551615 destroy");
  EXPECT_NE(seen, nullptr);
}

TEST_F(InstanceTest, DestroysNothingThatWasNotCreated) {
  static bool destroyed;
  destroyed = false;
  regista_descriptor descriptor = Puppet::descriptor();
  descriptor.create = [](const regista_environment*, const regista_host*, regista_span, regista_error*) -> void* {
    return nullptr;
  };
  descriptor.destroy = [](void*) { destroyed = true; };
  EXPECT_THROW(
      Instance({"puppet.so", &descriptor}, resolve(descriptor, use("puppet")), environment(), nullptr, nullptr),
      Failure);
  EXPECT_FALSE(destroyed);
}

}  // namespace
}  // namespace regista::plugin::test
