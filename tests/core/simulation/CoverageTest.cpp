// SPDX-License-Identifier: Apache-2.0
// Nothing of a scenario is passed over in silence: elements and attributes that are not in effect are told,
// once each.
#include "simulation/parser/Coverage.h"

#include <algorithm>
#include <set>

#include <foundation/NearestWord.h>
#include <gtest/gtest.h>

#include "ScenarioText.h"
#include "simulation/parser/ParseScenario.h"

namespace simulation
{
namespace
{

std::vector<Problem> problemsOf(const std::string& text)
{
    const auto parsed = parseScenario(text, "test.xosc", {.tolerant = true, .parameters = {}});
    EXPECT_TRUE(parsed) << parsed.error().message();
    return parsed ? parsed->problems : std::vector<Problem>();
}

std::string playedText()
{
    ScenarioText text;
    text.privates = teleport("<WorldPosition x=\"1\" y=\"2\"/>") + speedAction(10.0);
    text.stories = story(event("a", speedAction(1.0), timeCondition(2.0)));
    text.stop = stopAt(9.0);
    return text.text();
}

TEST(Coverage, NamesEachElementOnce)
{
    std::set<std::string_view> names;
    for (const ElementCoverage& row : elementCoverage())
    {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_EQ(row.instead.empty(), row.support == Support::played) << row.name;
    }
    EXPECT_GT(names.size(), 200u);
}

TEST(Coverage, SaysNothingOfWhatIsPlayed)
{
    for (const Problem& problem : problemsOf(playedText()))
        ADD_FAILURE() << problem.error.message();
}

struct Added
{
    const char* name;
    const char* before; ///< where it is put
    const char* text;
    Problem::Kind kind;
    const char* expected;
};

class WhatIsNotInEffect : public testing::TestWithParam<Added>
{
};

TEST_P(WhatIsNotInEffect, IsToldOnceWithItsLine)
{
    std::string text = playedText();
    const std::size_t at = text.find(GetParam().before);
    ASSERT_NE(at, std::string::npos);
    text.insert(at, GetParam().text);
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    const std::vector<Problem> problems = problemsOf(text);
    ASSERT_EQ(problems.size(), 1u) << (problems.empty() ? "" : problems.back().error.message());
    EXPECT_EQ(problems[0].kind, GetParam().kind);
    EXPECT_EQ(problems[0].error.place, "test.xosc:" + std::to_string(line));
    EXPECT_NE(problems[0].error.message().find(GetParam().expected), std::string::npos)
        << problems[0].error.message();
}

using ProblemKind = Problem::Kind;

INSTANTIATE_TEST_SUITE_P(
    Table, WhatIsNotInEffect,
    testing::Values(Added{"Element", "<Init>", "<Prologue a=\"1\"><Deep/></Prologue>", ProblemKind::unknown,
                          "no element of OpenSCENARIO"},
                    Added{"Misspelt", "<Init>", "<StopTriger/>", ProblemKind::unknown,
                          "did you mean StopTrigger?"},
                    Added{"Misplaced", "<Init>", "<Vehicle name=\"v\"/>", ProblemKind::unknown,
                          "does not belong in Storyboard"},
                    Added{"SecondAction", "</PrivateAction>", "<SpeedAction/>", ProblemKind::unknown,
                          "does not belong in PrivateAction"},
                    Added{"Deep", "<AbsoluteTargetSpeed", "<AbsoluteTargetSpeeed value=\"3\"/>",
                          ProblemKind::unknown, "did you mean AbsoluteTargetSpeed?"},
                    Added{"Attribute", "value=\"9.000000\"", "tolerance=\"3\" ", ProblemKind::unsupported,
                          "the attribute tolerance of SimulationTimeCondition is not read"}),
    [](const testing::TestParamInfo<Added>& test) { return std::string(test.param.name); });

TEST(Coverage, TellsEveryElementThatIsNotInEffect)
{
    for (const ElementCoverage& row : elementCoverage())
    {
        if (row.support != Support::reported) continue;
        std::string text = playedText();
        text.insert(text.find("<Init>"), "<" + std::string(row.name) + "/>");
        const std::vector<Problem> problems = problemsOf(text);
        ASSERT_EQ(problems.size(), 1u) << row.name;
        EXPECT_EQ(problems[0].kind, Problem::Kind::unsupported);
        EXPECT_NE(problems[0].error.remedy.find(row.instead), std::string::npos)
            << problems[0].error.message();
    }
}

TEST(NearestWord, CountsLettersThatDiffer)
{
    using foundation::wordDistance;
    EXPECT_EQ(wordDistance("", "abc"), 3u);
    EXPECT_EQ(wordDistance("speed", "speed"), 0u);
    EXPECT_EQ(wordDistance("Speed", "speed"), 0u);
    EXPECT_EQ(wordDistance("spede", "speed"), 1u) << "neighbours swapped";
    EXPECT_EQ(wordDistance("sped", "speed"), 1u);
    EXPECT_EQ(wordDistance("spxxd", "speed"), 2u);
    EXPECT_EQ(foundation::didYouMean("masKg", "xM massKg yM", "remove it"), "did you mean massKg?");
    EXPECT_EQ(foundation::didYouMean("colour", "xM massKg yM", "remove it"), "remove it");
    EXPECT_FALSE(likeElement("Quetzalcoatl"));
    EXPECT_EQ(likeElement("TeleportActoin"), "TeleportAction");
}

} // namespace
} // namespace simulation
