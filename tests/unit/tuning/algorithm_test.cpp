// SPDX-License-Identifier: MIT
#include "study/tuning/search.hpp"

#include <gmock/gmock.h>

#include "landscape.hpp"

namespace regista::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Optional;

TEST(Algorithms, AreNamed) {
  EXPECT_THAT(algorithm_names(), ElementsAre("sbplx", "bobyqa", "nelder_mead", "cobyla", "crs2_lm", "direct_l", "isres",
                                             "esch", "spsa", "sep_cma_es", "random_search"));
  for (const Algorithm each : all_algorithms) {
    EXPECT_THAT(algorithm_named(name(each)), Optional(each));
    EXPECT_FALSE(std::string(summary(each)).empty());
    EXPECT_EQ(why_unsuitable(name(each)), std::nullopt) << name(each);
  }
}

TEST(Algorithms, AreKnownByTheNamesOfNlopt) {
  EXPECT_THAT(algorithm_named("SBPLX"), Optional(Algorithm::sbplx));
  EXPECT_THAT(algorithm_named("LN_NELDERMEAD"), Optional(Algorithm::nelder_mead));
  EXPECT_THAT(algorithm_named("NLOPT_GN_CRS2_LM"), Optional(Algorithm::crs2_lm));
  EXPECT_THAT(algorithm_named("gn_direct_l"), Optional(Algorithm::direct_l));
  EXPECT_THAT(algorithm_named("sep-cma-es"), Optional(Algorithm::sep_cma_es));
  EXPECT_EQ(algorithm_named("sblx"), std::nullopt);
  EXPECT_EQ(algorithm_named(""), std::nullopt);
  EXPECT_EQ(algorithm_named("NLOPT_"), std::nullopt);
  EXPECT_EQ(algorithm_named("LN_"), std::nullopt);
}

TEST(Algorithms, UnsuitableOnesAreRefusedWithTheReason) {
  EXPECT_THAT(why_unsuitable("NLOPT_LD_LBFGS"), Optional(HasSubstr("gradients")));
  EXPECT_THAT(why_unsuitable("ld_slsqp"), Optional(HasSubstr("gradients")));
  EXPECT_THAT(why_unsuitable("GD_STOGO"), Optional(HasSubstr("gradients")));
  EXPECT_THAT(why_unsuitable("LD_SBPLX"), Optional(HasSubstr("gradients"))) << "whatever comes after LD_";
  EXPECT_THAT(why_unsuitable("LN_NEWUOA"), Optional(HasSubstr("hang")));
  EXPECT_THAT(why_unsuitable("newuoa_bound"), Optional(HasSubstr("hang")));
  EXPECT_THAT(why_unsuitable("LN_PRAXIS"), Optional(HasSubstr("early")));
  EXPECT_THAT(why_unsuitable("GN_MLSL_LDS"), Optional(HasSubstr("tolerances")));
  EXPECT_THAT(why_unsuitable("G_MLSL"), Optional(HasSubstr("tolerances")));
  EXPECT_THAT(why_unsuitable("GD_MLSL"), Optional(HasSubstr("gradients")));
  EXPECT_THAT(why_unsuitable("LD_AUGLAG"), Optional(HasSubstr("gradients")));
  EXPECT_THAT(why_unsuitable("AUGLAG"), Optional(HasSubstr("tolerances")));
  for (const char* each : {"GN_DIRECT", "GN_DIRECT_NOSCAL", "gn_direct_l_rand", "GN_ORIG_DIRECT", "orig_direct_l"}) {
    EXPECT_THAT(why_unsuitable(each), Optional(HasSubstr("direct_l"))) << each;
  }
  for (const char* each : {"gn_ags", "GN_AGS", "slsqp", "lbfgs", "GN_STOGO", "simulated_annealing", "LN_", "GD"}) {
    EXPECT_EQ(why_unsuitable(each), std::nullopt) << each;
    EXPECT_EQ(algorithm_named(each), std::nullopt) << each << " is an unknown one";
  }
  EXPECT_EQ(why_unsuitable(""), std::nullopt);
}

TEST(Algorithms, LocalOnesWantReplication) {
  for (const Algorithm each : {Algorithm::sbplx, Algorithm::bobyqa, Algorithm::nelder_mead, Algorithm::cobyla,
                               Algorithm::direct_l, Algorithm::random_search}) {
    EXPECT_TRUE(wants_replication(each)) << name(each);
    EXPECT_FALSE(has_population(each)) << name(each);
  }
  for (const Algorithm each : {Algorithm::crs2_lm, Algorithm::isres, Algorithm::esch, Algorithm::sep_cma_es}) {
    EXPECT_FALSE(wants_replication(each)) << name(each);
    EXPECT_TRUE(has_population(each)) << name(each);
  }
  EXPECT_FALSE(wants_replication(Algorithm::spsa));
}

TEST(Algorithms, GenerationsOfNlopt) {
  EXPECT_EQ(first_generation(Algorithm::crs2_lm, 4, 0), 50u);
  EXPECT_EQ(first_generation(Algorithm::crs2_lm, 4, 3), 5u) << "a simplex in four dimensions";
  EXPECT_EQ(first_generation(Algorithm::isres, 4, 0), 100u);
  EXPECT_EQ(first_generation(Algorithm::esch, 4, 0), 40u);
  EXPECT_EQ(later_generation(Algorithm::esch, 4, 0), 60u);
  EXPECT_EQ(later_generation(Algorithm::esch, 4, 1), 1u);
}

}  // namespace
}  // namespace regista::study
