// SPDX-License-Identifier: MIT
// check_descriptor() reports everything that can be wrong in a descriptor. A sound one is copied and spoilt in one
// place.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string_view>

#include <regista/extensions/metric.h>
#include <regista/testkit/kind_checks.hpp>

namespace {

using namespace regista::testkit;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* colours[] = {"red", "green", "red"};

class Descriptor : public testing::Test {
 protected:
  Descriptor() {
    descriptor = Loaded(CONTRACT_GOOD, "nearness").descriptor();
    parameter = Loaded(descriptor).parameter(0);
    descriptor.parameters = &parameter;
    descriptor.parameter_count = 1;
  }
  std::vector<std::string> found() const { return check_descriptor(Loaded(descriptor)).lines(); }

  regista_descriptor descriptor{};
  regista_parameter parameter{};
};

TEST_F(Descriptor, SoundAsItIs) { EXPECT_THAT(found(), ElementsAre()); }

TEST_F(Descriptor, Texts) {
  const char* regista_descriptor::*const texts[] = {&regista_descriptor::version, &regista_descriptor::summary,
                                                    &regista_descriptor::licence, &regista_descriptor::build_tag};
  for (const char* regista_descriptor::*text : texts) {
    const char* sound = descriptor.*text;
    descriptor.*text = nullptr;
    EXPECT_THAT(found(), Contains(HasSubstr("is null")));
    descriptor.*text = "";
    EXPECT_THAT(found(), Contains(HasSubstr("is empty")));
    descriptor.*text = "1\n2";
    EXPECT_THAT(found(), Contains(HasSubstr("more than one line")));
    descriptor.*text = sound;
  }
  descriptor.version = "newest";
  EXPECT_THAT(found(), ElementsAre("descriptor: its version \"newest\" does not begin with a number"));
}

TEST_F(Descriptor, Ids) {
  for (const char* id : {"", "Nearness", "near-ness", "near__ness", "_near", "near_", "2near", "near ness"}) {
    descriptor.id = id;
    EXPECT_THAT(found(), ElementsAre("descriptor: its id is not in lower_snake_case")) << id;
  }
  descriptor.id = "near_2_ness";
  EXPECT_THAT(found(), ElementsAre());
}

TEST_F(Descriptor, SizesAndVersions) {
  descriptor.size -= 1;
  EXPECT_THAT(found(), ElementsAre(HasSubstr("descriptor: its size field says")));
  descriptor.size += 100;
  EXPECT_THAT(found(), ElementsAre());
  // Before 1.0 no two versions fit together.
  descriptor.abi_minor = REGISTA_ABI_MINOR + 1;
  EXPECT_THAT(found(), ElementsAre("descriptor: built for plugin interface 0.3"));
  descriptor.abi_minor = REGISTA_ABI_MINOR - 1;
  EXPECT_THAT(found(), ElementsAre("descriptor: built for plugin interface 0.1"));
  descriptor.abi_minor = REGISTA_ABI_MINOR;
  descriptor.abi_major = REGISTA_ABI_MAJOR + 1;
  EXPECT_THAT(found(), ElementsAre("descriptor: built for plugin interface 1.2"));
  descriptor.abi_major = REGISTA_ABI_MAJOR;
  parameter.size = 8;
  EXPECT_THAT(found(), ElementsAre("parameter scale: its size field says 8 bytes"));
  parameter.size = sizeof parameter;
  descriptor.parameter_stride = 8;
  EXPECT_THAT(found(), ElementsAre(HasSubstr("too small a stride")));
}

TEST_F(Descriptor, ReservedFieldsAreZero) {
  descriptor.reserved_too = 1;
  EXPECT_THAT(found(), ElementsAre("descriptor: a reserved field is not 0"));
}

TEST_F(Descriptor, Extensions) {
  descriptor.extension = [](const char*) -> const void* { return nullptr; };
  EXPECT_THAT(found(), ElementsAre());
  descriptor.extension = [](const char*) -> const void* {
    static constexpr regista_metrics none{sizeof(regista_metrics), 0, nullptr, 0, 0};
    return &none;
  };
  EXPECT_THAT(found(), ElementsAre("descriptor: has an extension for a name that nobody gave"));
}

TEST_F(Descriptor, Metrics) {
  static std::array<regista_metric, 2> declared;
  static regista_metrics table;
  declared.fill({sizeof(regista_metric), REGISTA_METRIC_SUM, "hits", "1", "How often"});
  declared[1].name = "reach";
  table = {sizeof table, 2, declared.data(), sizeof(regista_metric), 0};
  descriptor.extension = [](const char* name) -> const void* {
    return std::string_view(name) == REGISTA_METRIC_EXTENSION ? &table : nullptr;
  };
  EXPECT_THAT(found(), ElementsAre());
  declared[1].name = "hits";
  EXPECT_THAT(found(), ElementsAre("metric \"hits\": stands twice"));
  declared[1].name = "Hits";
  EXPECT_THAT(found(), ElementsAre("metric \"Hits\": its name is not in lower_snake_case"));
  declared[1] = {sizeof(regista_metric), 7, "reach", "", nullptr};
  EXPECT_THAT(found(), Contains("metric \"reach\": combines in a way that does not exist: 7"));
  EXPECT_THAT(found(), Contains(HasSubstr("its doc")));
  EXPECT_THAT(found(), Contains(HasSubstr("its unit")));
  table.count = 65;
  EXPECT_THAT(found(), ElementsAre("metrics: declares 65 of at most 64"));
}

TEST_F(Descriptor, ReasonsOfSenders) {
  static regista_sender sender{sizeof(regista_sender), 0, nullptr, nullptr};
  static const char* const names[] = {"lost_bid", "Lost", "lost_bid"};
  descriptor.table = [](std::int32_t kind) -> const void* { return kind == REGISTA_KIND_SENDER ? &sender : nullptr; };
  EXPECT_THAT(found(), ElementsAre());
  sender.reason_count = 1;
  EXPECT_THAT(found(), ElementsAre("sender: its reasons are null"));
  sender.reasons = names;
  EXPECT_THAT(found(), ElementsAre());
  sender.reason_count = 2;
  EXPECT_THAT(found(), ElementsAre("sender: its reason 1 is not in lower_snake_case"));
  sender.reason_count = 3;
  EXPECT_THAT(found(), Contains("sender: its reason \"lost_bid\" stands twice"));
  sender.reason_count = 65;
  EXPECT_THAT(found(), ElementsAre("sender: names 65 reasons of at most 64"));
}

TEST_F(Descriptor, Calls) {
  descriptor.reset = nullptr;
  EXPECT_THAT(found(), ElementsAre("descriptor: table, create, reset and destroy must not be null"));
}

TEST_F(Descriptor, Tables) {
  static const regista_utility sound{sizeof(regista_utility), 0, nullptr}, small{8, 0, nullptr};
  static int asked = 0;
  descriptor.table = [](std::int32_t) -> const void* { return nullptr; };
  EXPECT_THAT(found(), ElementsAre("descriptor: implements no kind"));
  descriptor.table = [](std::int32_t kind) -> const void* { return kind == REGISTA_KIND_UTILITY ? &small : nullptr; };
  EXPECT_THAT(found(), ElementsAre("utility: the size field of its table says 8 bytes"));
  descriptor.table = [](std::int32_t kind) -> const void* { return kind == REGISTA_KIND_BEHAVIOUR ? &small : nullptr; };
  EXPECT_THAT(found(), ElementsAre("behaviour: the size field of its table says 8 bytes"));
  descriptor.table = [](std::int32_t kind) -> const void* {
    if (kind != REGISTA_KIND_UTILITY) return nullptr;
    static const regista_utility other = sound;
    return ++asked % 2 == 0 ? &sound : &other;
  };
  EXPECT_THAT(found(), Contains("descriptor: its table of kind 4 changes from call to call"));
  descriptor.table = [](std::int32_t kind) -> const void* { return kind >= REGISTA_KIND_UTILITY ? &sound : nullptr; };
  EXPECT_THAT(found(), Contains("descriptor: has a table for kind 9, which does not exist"));
}

TEST_F(Descriptor, NamesAndDocsOfParameters) {
  parameter.name = "Scale";
  EXPECT_THAT(found(), ElementsAre("parameter Scale: its name is not in lower_snake_case"));
  parameter.name = nullptr;
  EXPECT_THAT(found(), ElementsAre("parameter 0: its name is not in lower_snake_case"));
  parameter.name = "scale";
  parameter.doc = "";
  EXPECT_THAT(found(), ElementsAre("parameter scale: its doc is empty"));
  parameter.doc = "d";
  parameter.unit = "";
  EXPECT_THAT(found(), ElementsAre("parameter scale: has no unit (\"1\" for a plain number)"));
  parameter.unit = nullptr;
  EXPECT_THAT(found(), ElementsAre("parameter scale: its unit is null"));
}

TEST_F(Descriptor, NamesThatStandTwice) {
  const regista_parameter both[] = {parameter, parameter};
  descriptor.parameters = both;
  descriptor.parameter_count = 2;
  EXPECT_THAT(found(), ElementsAre("parameter scale: stands twice"));
}

TEST_F(Descriptor, Ranges) {
  parameter.initial = 10.5;
  EXPECT_THAT(found(), ElementsAre("parameter scale: its default 10.5 is outside [0.1, 10]"));
  parameter.initial = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(found(), ElementsAre(HasSubstr("is outside [0.1, 10]")));
  parameter.initial = 1.0;
  parameter.maximum = std::numeric_limits<double>::infinity();
  EXPECT_THAT(found(), ElementsAre("parameter scale: its range is not finite"));
  parameter.minimum = 2.0;
  parameter.maximum = 1.0;
  EXPECT_THAT(found(), Contains("parameter scale: its range [2, 1] is empty"));
  parameter.minimum = 0.0;
  parameter.maximum = 4.0;
  parameter.initial = 1.5;
  parameter.type = REGISTA_TYPE_INTEGER;
  EXPECT_THAT(found(), ElementsAre("parameter scale: its default is no integer"));
  parameter.type = REGISTA_TYPE_REAL;
  parameter.flags = REGISTA_PARAMETER_LOG_SCALE;
  EXPECT_THAT(found(), ElementsAre("parameter scale: a logarithmic scale needs a positive range"));
}

TEST_F(Descriptor, OtherTypes) {
  parameter.type = REGISTA_TYPE_BOOLEAN;
  parameter.initial = 0.5;
  EXPECT_THAT(found(), ElementsAre("parameter scale: its default is neither 0 nor 1"));
  parameter.type = REGISTA_TYPE_CHOICE;
  EXPECT_THAT(found(), ElementsAre("parameter scale: has no choices"));
  parameter.choices = colours;
  parameter.choice_count = 2;
  parameter.initial = 2.0;
  EXPECT_THAT(found(), ElementsAre("parameter scale: its default is none of its choices"));
  parameter.initial = 1.0;
  parameter.choice_count = 3;
  EXPECT_THAT(found(), ElementsAre("parameter scale: choice \"red\" stands twice"));
  parameter.type = REGISTA_TYPE_TEXT;
  EXPECT_THAT(found(), ElementsAre("parameter scale: its default text is null"));
  parameter.type = REGISTA_TYPE_FILE;
  parameter.initial_text = "formation.conf";
  EXPECT_THAT(found(), ElementsAre("parameter scale: a file has no default"));
  parameter.type = 99;
  EXPECT_THAT(found(), ElementsAre("parameter scale: unknown type 99"));
}

}  // namespace
