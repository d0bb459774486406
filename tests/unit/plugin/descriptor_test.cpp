// SPDX-License-Identifier: MIT
#include "plugin/description.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <string_view>

#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

class DescriptorTest : public PuppetTest {
 protected:
  // What is wrong with a sound descriptor after `spoil`.
  std::string wrong(const std::function<void(regista_descriptor&)>& spoil) {
    regista_descriptor descriptor = Puppet::descriptor();
    spoil(descriptor);
    return what_is_wrong(descriptor, 0);
  }

  // What is wrong with its one parameter after `spoil`; without "plugin "puppet": ".
  std::string wrong_parameter(const std::function<void(regista_parameter&)>& spoil) {
    regista_parameter reach{
        sizeof(regista_parameter), REGISTA_TYPE_REAL, "reach", "m", "Far", 0.5, 20.0, 12.0, nullptr, nullptr, 0, 0};
    spoil(reach);
    const std::string said = wrong([&](regista_descriptor& d) {
      d.parameter_count = 1;
      d.parameters = &reach;
    });
    const std::string prefix = "plugin \"puppet\": ";
    if (said.empty()) return said;
    EXPECT_EQ(said.substr(0, prefix.size()), prefix);
    return said.substr(prefix.size());
  }
};

TEST_F(DescriptorTest, TakesASoundOne) {
  EXPECT_EQ(wrong([](regista_descriptor&) {}), "");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.size += 16; }), "");  // grown at its end
  EXPECT_EQ(wrong_parameter([](regista_parameter&) {}), "");
}

TEST_F(DescriptorTest, NamesBothVersions) {
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.abi_major = 2; }),
            "built for Regista plugin interface 2.2; this host speaks 0.2: build it anew");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.abi_minor = 3; }),
            "built for Regista plugin interface 0.3; this host speaks 0.2: build it anew");
}

TEST_F(DescriptorTest, BeforeTheFreezeAnOlderMinorIsRefusedToo) {
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.abi_minor = 1; }),
            "built for Regista plugin interface 0.1; this host speaks 0.2: build it anew");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.abi_minor = 0; }),
            "built for Regista plugin interface 0.0; this host speaks 0.2: build it anew");
  // `minimum` counts from 1.0 on.
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.minimum_minor = 0; }), "");
}

TEST_F(DescriptorTest, SaysWhyTheHostsNumberIsLower) {
  EXPECT_EQ(wrong([](regista_descriptor& d) {
              d.abi_major = 1;
              d.abi_minor = 0;
            }),
            "built for Regista plugin interface 1.0; this host speaks 0.2, whose number is lower because the interface "
            "was opened again before it is frozen: build it anew");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.abi_major = 1; }),
            "built for Regista plugin interface 1.2; this host speaks 0.2: build it anew");
}

TEST_F(DescriptorTest, RefusesWhatIsMissing) {
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.size = 24; }), "descriptor 0 is 24 bytes; the interface needs 128");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.id = nullptr; }), "descriptor 0: id is null");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.version = nullptr; }), "plugin \"puppet\": version is null");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.summary = nullptr; }), "plugin \"puppet\": summary is null");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.licence = nullptr; }), "plugin \"puppet\": licence is null");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.build_tag = nullptr; }), "plugin \"puppet\": build tag is null");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.summary = "two\nlines"; }),
            "plugin \"puppet\": summary is not one line");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.id = "Puppet"; }), "plugin \"Puppet\": id is not lower_snake_case");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.id = ""; }), "plugin \"\": id is not lower_snake_case");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.reset = nullptr; }),
            "plugin \"puppet\": lacks one of table, create, reset, destroy");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.parameter_count = 1; }), "plugin \"puppet\": parameters are null");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.parameter_count = 4000000; }),
            "plugin \"puppet\": declares 4000000 parameters");
}

// What a plugin says reaches terminals, tables and pages.
TEST_F(DescriptorTest, RefusesTextsThatCannotBeShown) {
  static const std::string long_id = "p" + std::string(63, 'q'), longer_id = long_id + "q", endless(1001, 'a');
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.id = long_id.c_str(); }), "");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.id = longer_id.c_str(); }),
            "plugin \"" + longer_id.substr(0, 40) + "...\": id is 65 characters long; at most 64 are taken");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.id = "a\x1b[31m"; }),
            "plugin \"a\\x1b[31m\": id is not lower_snake_case");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.summary = "Far\x1b[2J"; }),
            "plugin \"puppet\": summary is no plain UTF-8 text: \"Far\\x1b[2J\"");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.version = "1.\xff"; }),
            "plugin \"puppet\": version is no plain UTF-8 text: \"1.\xef\xbf\xbd\"");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.licence = "MIT\u202e"; }),
            "plugin \"puppet\": licence is no plain UTF-8 text: \"MIT\\u202e\"");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.build_tag = "\u009b2J"; }),
            "plugin \"puppet\": build tag is no plain UTF-8 text: \"\\x9b2J\"");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.summary = endless.c_str(); }),
            "plugin \"puppet\": summary is longer than 1000 bytes");
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.summary = "Größe, 日本"; }), "");
  const auto said = [](const std::string& what) { return "parameter \"reach\": " + what; };
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.doc = "a\nb"; }), said("doc is not one line"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.unit = "m\a"; }),
            said("unit is no plain UTF-8 text: \"m\\x07\""));
  static const char* const choices[] = {"first", "b\x1b"};
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) {
              p.type = REGISTA_TYPE_CHOICE;
              p.choices = choices;
              p.choice_count = 2;
            }),
            said("choice 1 is no plain UTF-8 text: \"b\\x1b\""));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) {
              p.type = REGISTA_TYPE_TEXT;
              p.initial_text = "two\nlines\tand a tab";
            }),
            "");
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) {
              p.type = REGISTA_TYPE_TEXT;
              p.initial_text = "\x1b]0;title\a";
            }),
            said("default is no plain UTF-8 text"));
}

TEST_F(DescriptorTest, RefusesTablesThatAreTooSmallOrHaveHoles) {
  EXPECT_EQ(wrong([](regista_descriptor& d) { d.table = [](std::int32_t) -> const void* { return nullptr; }; }),
            "plugin \"puppet\": implements no kind of plugin");
  EXPECT_EQ(wrong([](regista_descriptor& d) {
              d.table = [](std::int32_t kind) -> const void* {
                return kind == REGISTA_KIND_MAILBOX ? &Puppet::mailbox : nullptr;
              };
            }),
            "plugin \"puppet\": implements no kind of plugin");
  Puppet::assigner.size = 8;
  EXPECT_EQ(wrong([](regista_descriptor&) {}),
            "plugin \"puppet\": table of the assigner is 8 bytes; the interface needs 16");
  Puppet::rest();
  Puppet::predictor.absorb = nullptr;
  EXPECT_EQ(wrong([](regista_descriptor&) {}), "plugin \"puppet\": table of the predictor lacks a call");
  Puppet::rest();
  Puppet::predictor.subjects = 0;
  EXPECT_EQ(wrong([](regista_descriptor&) {}), "plugin \"puppet\": is a predictor of nothing");
}

TEST_F(DescriptorTest, WantsReasonsOfSendersToHaveNames) {
  static const char* const names[] = {"lost_bid", "Found", "lost_bid", nullptr};
  const auto said = [this](std::uint32_t count, const char* const* reasons) {
    Puppet::sender.reason_count = count;
    Puppet::sender.reasons = reasons;
    return wrong([](regista_descriptor&) {});
  };
  EXPECT_EQ(said(1, names), "");
  EXPECT_EQ(said(1, nullptr), "plugin \"puppet\": its reasons are null");
  EXPECT_EQ(said(2, names), "plugin \"puppet\": reason \"Found\" is not lower_snake_case");
  const char* const twice[] = {"lost_bid", "lost_bid"};
  EXPECT_EQ(said(2, twice), "plugin \"puppet\": names the reason \"lost_bid\" twice");
  EXPECT_EQ(said(1, names + 3), "plugin \"puppet\": reason 0 is null");
  EXPECT_EQ(said(65, names), "plugin \"puppet\": names 65 reasons; at most 64 are taken");
}

TEST_F(DescriptorTest, WantsMetricsToHaveNamesOfTheirOwn) {
  static std::array<regista_metric, 2> declared;
  static regista_metrics table;
  const auto said = [this](auto spoil) {
    declared.fill({sizeof(regista_metric), REGISTA_METRIC_SUM, "hits", "1", "How often"});
    declared[1].name = "reach";
    table = {sizeof table, 2, declared.data(), sizeof(regista_metric), 0};
    spoil();
    const std::string out = wrong([](regista_descriptor& d) {
      d.extension = [](const char* id) -> const void* {
        return std::string_view(id) == REGISTA_METRIC_EXTENSION ? &table : nullptr;
      };
    });
    const std::string head = "plugin \"puppet\": ";
    return out.starts_with(head) ? out.substr(head.size()) : out;
  };
  EXPECT_EQ(said([] {}), "");
  EXPECT_EQ(said([] { declared[1].name = "hits"; }), "declares the metric \"hits\" twice");
  EXPECT_EQ(said([] { declared[1].name = "Reach"; }), "metric \"Reach\" is not lower_snake_case");
  EXPECT_EQ(said([] { declared[1].name = nullptr; }), "metric 1 has a null name");
  EXPECT_EQ(said([] { declared[1].unit = nullptr; }), "metric \"reach\": unit is null");
  EXPECT_EQ(said([] { declared[1].doc = "a\nb"; }), "metric \"reach\": doc is not one line");
  EXPECT_EQ(said([] { declared[0].combine = 6; }), "metric \"hits\": there is no way 6 to combine reports");
  EXPECT_EQ(said([] { declared[0].size = 8; }), "metric 0 is 8 bytes; regista.metric/0 needs 32");
  EXPECT_EQ(said([] { table.count = 65; }), "declares 65 metrics; at most 64 are taken");
  EXPECT_EQ(said([] { table.metrics = nullptr; }), "its metrics are null");
  EXPECT_EQ(said([] { table.stride = 8; }), "metrics are 8 bytes apart; regista.metric/0 needs 32");
  EXPECT_EQ(said([] { table.size = 4; }), "table of its metrics is 4 bytes; regista.metric/0 needs 24");
}

TEST_F(DescriptorTest, RefusesNumbersThatContradictThemselves) {
  const auto said = [](const std::string& what) { return "parameter \"reach\": " + what; };
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.initial = 25.0; }),
            said("default 25 is outside its range 0.5 to 20 m"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.initial = std::numeric_limits<double>::quiet_NaN(); }),
            said("default nan is outside its range 0.5 to 20 m"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.minimum = 30.0; }), said("30 to 20 is no range"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.maximum = std::numeric_limits<double>::infinity(); }),
            said("0.5 to inf is no range"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) {
              p.type = REGISTA_TYPE_INTEGER;
              p.initial = 1.5;
            }),
            said("default 1.5 is not an integer"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) {
              p.minimum = 0.0;
              p.flags = REGISTA_PARAMETER_TUNABLE | REGISTA_PARAMETER_LOG_SCALE;
            }),
            said("has a logarithmic scale, but its range begins at 0"));
}

TEST_F(DescriptorTest, RefusesOtherTypesThatContradictThemselves) {
  const auto said = [](const std::string& what) { return "parameter \"reach\": " + what; };
  static const char* const twice[] = {"first", "best", "first"};
  static const char* const holed[] = {"first", nullptr};
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.type = 7; }), said("type 7 is unknown"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.type = REGISTA_TYPE_BOOLEAN; }),
            said("default 12 is neither 0 nor 1"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.type = REGISTA_TYPE_CHOICE; }), said("has no choices"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) {
              p.type = REGISTA_TYPE_CHOICE;
              p.choices = twice;
              p.choice_count = 3;
            }),
            said("offers the choice \"first\" twice"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) {
              p.type = REGISTA_TYPE_CHOICE;
              p.choices = holed;
              p.choice_count = 2;
            }),
            said("choice 1 is null"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) {
              p.type = REGISTA_TYPE_CHOICE;
              p.choices = twice;
              p.choice_count = 2;
            }),
            said("default 12 is not the index of one of its 2 choices"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.type = REGISTA_TYPE_TEXT; }), said("default is null"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) {
              p.type = REGISTA_TYPE_FILE;
              p.initial_text = "formation.conf";
            }),
            said("a file has no default"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.unit = nullptr; }), said("unit is null"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.doc = nullptr; }), said("doc is null"));
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.name = "Reach"; }),
            "parameter \"Reach\" is not lower_snake_case");
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.name = nullptr; }), "parameter 0 has a null name");
  EXPECT_EQ(wrong_parameter([](regista_parameter& p) { p.size = 8; }),
            "parameter 0 is 8 bytes; the interface needs 80");
}

// Elements that a later version made larger are stepped over by their stride.
TEST_F(DescriptorTest, StepsOverParametersByTheirStride) {
  struct Grown {
    regista_parameter known;
    double later;
  };
  regista_parameter known{sizeof(Grown), REGISTA_TYPE_REAL, "a", "m", "Far", 0.5, 20.0, 12.0, nullptr, nullptr, 0, 0};
  std::array<Grown, 3> parameters{{{known, 1.0}, {known, 1.0}, {known, 1.0}}};
  parameters[1].known.name = "b";
  parameters[2].known.name = "c";
  regista_descriptor descriptor = Puppet::descriptor();
  descriptor.parameter_count = 3;
  descriptor.parameters = &parameters[0].known;
  descriptor.parameter_stride = sizeof(Grown);
  EXPECT_EQ(what_is_wrong(descriptor, 0), "");
  EXPECT_STREQ(parameter(descriptor, 2).name, "c");
  parameters[2].known.name = "a";
  EXPECT_EQ(what_is_wrong(descriptor, 0), "plugin \"puppet\": parameter \"a\" is declared twice");
  descriptor.parameter_stride = sizeof(regista_parameter) - 8;
  EXPECT_EQ(what_is_wrong(descriptor, 0), "plugin \"puppet\": parameters are 72 bytes apart; the interface needs 80");
}

TEST_F(DescriptorTest, NamesKindsAndSubjects) {
  EXPECT_EQ(Description(Puppet::descriptor()).kinds(), (std::vector<int>{1, 2, 3, 4, 5, 6, 7}));
  EXPECT_EQ(texts::with_article(kind_name(REGISTA_KIND_ASSIGNER)), "an assigner");
  EXPECT_EQ(subject_names(REGISTA_SUBJECT_BALL), "ball");
  EXPECT_EQ(subject_names(REGISTA_SUBJECT_SELF | REGISTA_SUBJECT_TEAMMATES), "self, teammates");
}

}  // namespace
}  // namespace regista::plugin::test
