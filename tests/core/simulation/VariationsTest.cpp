// SPDX-License-Identifier: Apache-2.0
// Parameter-value distributions: the variations that a file asks for, worked by hand.
#include "simulation/parser/Variations.h"

#include <cmath>

#include <gmock/gmock.h>

#include "ScenarioText.h"
#include "simulation/parser/Expression.h"
#include "simulation/parser/RandomDraw.h"

namespace simulation
{
namespace
{

std::string fileWith(const std::string& distributions)
{
    return "<OpenSCENARIO>\n" + ScenarioText().header +
           "\n<ParameterValueDistribution><ScenarioFile filepath=\"cut-in.xosc\"/>\n" + distributions +
           "\n</ParameterValueDistribution></OpenSCENARIO>\n";
}

std::string exchanged(std::string text, const std::string& replaced, const std::string& by)
{
    return text.replace(text.find(replaced), replaced.size(), by);
}

std::string single(const std::string& parameter, const std::string& content)
{
    return "<DeterministicSingleParameterDistribution parameterName=\"" + parameter + "\">" + content +
           "</DeterministicSingleParameterDistribution>";
}

std::string stochastic(const std::string& content, int runs = 2000, int seed = 7)
{
    return "<Stochastic numberOfTestRuns=\"" + std::to_string(runs) + "\" randomSeed=\"" +
           std::to_string(seed) + "\"><StochasticDistribution parameterName=\"x\">" + content +
           "</StochasticDistribution></Stochastic>";
}

const std::string kSet = "<DistributionSet><Element value=\"4\"/><Element value=\"9\"/></DistributionSet>";
const std::string kRange =
    "<DistributionRange stepWidth=\"0.1\"><Range lowerLimit=\"0\" upperLimit=\"0.3\"/></DistributionRange>";

std::vector<Variation> variationsOf(const std::string& distributions, std::optional<std::uint64_t> seed = {})
{
    const auto read = parseVariations(fileWith(distributions), "d.xosc", {}, seed);
    EXPECT_TRUE(read) << read.error().message();
    if (!read || !*read) return {};
    EXPECT_EQ((*read)->scenario, "cut-in.xosc");
    return (*read)->variations;
}

std::vector<std::string> namesOf(const std::vector<Variation>& variations)
{
    std::vector<std::string> names;
    for (const Variation& variation : variations)
        names.push_back(variation.name);
    return names;
}

/// Mean and variance of the drawn values of x.
std::pair<double, double> moments(const std::vector<Variation>& variations)
{
    double sum = 0.0, squares = 0.0;
    for (const Variation& variation : variations)
    {
        const double value = parseNumber(variation.parameters.at("x")).value_or(NAN);
        sum += value;
        squares += value * value;
    }
    const double count = static_cast<double>(variations.size());
    return {sum / count, squares / count - sum * sum / (count * count)};
}

TEST(Variations, AreEveryCombinationOfDeterministicValues)
{
    const std::string text =
        "<Deterministic>" + single("v", kSet) + single("gap", kRange) + "</Deterministic>";
    EXPECT_THAT(namesOf(variationsOf(text)),
                testing::ElementsAre("gap=0, v=4", "gap=0.1, v=4", "gap=0.2, v=4",
                                     "gap=0.30000000000000004, v=4", "gap=0, v=9", "gap=0.1, v=9",
                                     "gap=0.2, v=9", "gap=0.30000000000000004, v=9"));
    EXPECT_EQ(variationsOf(text).size(), 8u);
    const std::string shorter = exchanged(text, "upperLimit=\"0.3\"", "upperLimit=\"0.29\"");
    EXPECT_EQ(variationsOf(shorter).size(), 6u) << "a limit that is not reached gives one value less";
}

TEST(Variations, KeepTheValuesOfASetTogether)
{
    const std::string text =
        "<Deterministic><DeterministicMultiParameterDistribution><ValueSetDistribution>"
        "<ParameterValueSet><ParameterAssignment parameterRef=\"v\" value=\"4\"/>"
        "<ParameterAssignment parameterRef=\"gap\" value=\"9\"/></ParameterValueSet>"
        "<ParameterValueSet><ParameterAssignment parameterRef=\"v\" value=\"5\"/>"
        "<ParameterAssignment parameterRef=\"gap\" value=\"8\"/></ParameterValueSet>"
        "</ValueSetDistribution></DeterministicMultiParameterDistribution></Deterministic>";
    EXPECT_THAT(namesOf(variationsOf(text)), testing::ElementsAre("gap=9, v=4", "gap=8, v=5"));
}

struct Moments
{
    const char* name;
    const char* distribution;
    double mean, variance;
};

class StochasticMoments : public testing::TestWithParam<Moments>
{
};

/// Five standard deviations of the mean of 2000 draws, and a tenth of the variance and more.
TEST_P(StochasticMoments, AreThoseOfTheDistribution)
{
    const Moments& wanted = GetParam();
    const auto [mean, variance] = moments(variationsOf(stochastic(wanted.distribution)));
    const double tolerance = 5.0 * std::sqrt(wanted.variance / 2000.0);
    EXPECT_NEAR(mean, wanted.mean, tolerance);
    EXPECT_NEAR(variance, wanted.variance, 0.2 * wanted.variance);
    EXPECT_GT(std::fabs(mean - 1.1 * wanted.mean), tolerance) << "a mean that is a tenth off would be seen";
}

INSTANTIATE_TEST_SUITE_P(
    Table, StochasticMoments,
    testing::Values(
        Moments{"Normal", "<NormalDistribution expectedValue=\"30\" variance=\"4\"/>", 30.0, 4.0},
        Moments{"LogNormal", "<LogNormalDistribution expectedValue=\"30\" variance=\"4\"/>", 30.0, 4.0},
        Moments{"Uniform",
                "<UniformDistribution><Range lowerLimit=\"10\" upperLimit=\"16\"/></UniformDistribution>",
                13.0, 3.0},
        Moments{"Poisson", "<PoissonDistribution expectedValue=\"20\"/>", 20.0, 20.0},
        // Bins 0…2 (weight 1) and 2…6 (weight 3): mean 1/4·1 + 3/4·4 = 3.25; E[x²] = 1/4·4/3 + 3/4·52/3 =
        // 13.3333.
        Moments{
            "Histogram",
            "<Histogram><Bin weight=\"1\"><Range lowerLimit=\"0\" upperLimit=\"2\"/></Bin><Bin weight=\"3\">"
            "<Range lowerLimit=\"2\" upperLimit=\"6\"/></Bin></Histogram>",
            3.25, 13.0 + 1.0 / 3.0 - 3.25 * 3.25},
        // 4 with weight 1 and 8 with weight 3: mean 7, variance 1/4·9 + 3/4·1 = 3.
        Moments{"ProbabilitySet",
                "<ProbabilityDistributionSet><Element value=\"4\" weight=\"1\"/><Element value=\"8\" "
                "weight=\"3\"/>"
                "</ProbabilityDistributionSet>",
                7.0, 3.0}),
    [](const testing::TestParamInfo<Moments>& test) { return std::string(test.param.name); });

TEST(Variations, OfARangeStayInIt)
{
    const std::string text = stochastic("<NormalDistribution expectedValue=\"30\" variance=\"4\"><Range "
                                        "lowerLimit=\"29\" upperLimit=\"31\"/></NormalDistribution>");
    for (const Variation& variation : variationsOf(text))
    {
        const double value = parseNumber(variation.parameters.at("x")).value_or(NAN);
        EXPECT_TRUE(value >= 29.0 && value <= 31.0) << variation.name;
    }
}

TEST(Variations, AreTheSameForASeedAndOthersForAnother)
{
    const std::string normal = "<NormalDistribution expectedValue=\"30\" variance=\"4\"/>";
    const auto first = variationsOf(stochastic(normal, 5));
    EXPECT_EQ(first, variationsOf(stochastic(normal, 5)));
    EXPECT_EQ(first, variationsOf(stochastic(normal, 5, 8), 7))
        << "the command line's seed goes before the file's";
    EXPECT_NE(first, variationsOf(stochastic(normal, 5, 8)));
    const auto longer = variationsOf(stochastic(normal, 9));
    EXPECT_TRUE(std::equal(first.begin(), first.end(), longer.begin()))
        << "a variation does not depend on how many there are";
}

TEST(Variations, OfAFixedSeedNeverChange)
{
    // Written down once: another machine, compiler or release must draw the same.
    EXPECT_DOUBLE_EQ(RandomDraw(7, "x", 0).uniform(0.0, 1.0), 0.15833518072539543);
    EXPECT_DOUBLE_EQ(RandomDraw(7, "x", 1).uniform(0.0, 1.0), 0.82879799597439652);
    EXPECT_DOUBLE_EQ(RandomDraw(8, "gap", 0).uniform(0.0, 1.0), 0.3139222837593777);
}

TEST(Variations, AreNothingForAScenario)
{
    const auto read = parseVariations(ScenarioText().text(), "s.xosc");
    ASSERT_TRUE(read);
    EXPECT_FALSE(*read);
}

struct DistributionCase
{
    const char* name;
    std::string text;
    const char* expected;
};

class DistributionFault : public testing::TestWithParam<DistributionCase>
{
};

TEST_P(DistributionFault, IsSaidWithItsLine)
{
    const auto read = parseVariations(fileWith(GetParam().text), "d.xosc");
    ASSERT_FALSE(read);
    EXPECT_TRUE(read.error().message().starts_with("d.xosc:4: ")) << read.error().message();
    EXPECT_NE(read.error().message().find(GetParam().expected), std::string::npos) << read.error().message();
    EXPECT_FALSE(read.error().remedy.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Table, DistributionFault,
    testing::Values(
        DistributionCase{"NoWidth",
                         "<Deterministic>" + single("v", exchanged(kRange, "0.1", "0")) + "</Deterministic>",
                         "not above 0"},
        DistributionCase{
            "TooMany", "<Deterministic>" + single("v", exchanged(kRange, "0.1", "1e-9")) + "</Deterministic>",
            "more than 100000"},
        DistributionCase{"LimitsSwapped",
                         "<Deterministic>" +
                             single("v", exchanged(kRange, "lowerLimit=\"0\"", "lowerLimit=\"1\"")) +
                             "</Deterministic>",
                         "upperLimit is below"},
        DistributionCase{"NoElement",
                         "<Deterministic>" + single("v", "<DistributionSet/>") + "</Deterministic>",
                         "has no Element"},
        DistributionCase{"NoWeight", stochastic("<Histogram/>"), "no weight above 0"},
        DistributionCase{"NoRuns", stochastic("<NormalDistribution expectedValue=\"3\" variance=\"4\"/>", 0),
                         "numberOfTestRuns"},
        DistributionCase{"NegativeVariance",
                         stochastic("<NormalDistribution expectedValue=\"3\" variance=\"-4\"/>"), "negative"},
        DistributionCase{"LogOfNothing",
                         stochastic("<LogNormalDistribution expectedValue=\"0\" variance=\"4\"/>"),
                         "not above 0"},
        DistributionCase{"LargePoisson", stochastic("<PoissonDistribution expectedValue=\"701\"/>"),
                         "above 700"},
        DistributionCase{"Unknown", stochastic("<GaussDistribution/>"), "is no element"},
        DistributionCase{"UserDefined", stochastic("<UserDefinedDistribution type=\"t\"/>"),
                         "keeps the value of the scenario"}),
    [](const testing::TestParamInfo<DistributionCase>& test) { return std::string(test.param.name); });

} // namespace
} // namespace simulation
