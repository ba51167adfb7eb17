// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include "ScenarioText.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/player/TriggerWatch.h"

namespace simulation
{
namespace
{

using State = StoryboardElementState;

std::unique_ptr<ScenarioPlayer> playing(const ScenarioText& text)
{
    auto parsed = parseScenario(text.text(), "test.xosc");
    EXPECT_TRUE(parsed) << parsed.error().message();
    PlayerOptions options;
    options.clock = FixedClock(10);
    auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    return player ? std::move(*player) : nullptr;
}

/// Times at which an element of that name made a transition.
std::vector<double> times(const ScenarioPlayer& player, const std::string& name, State transition)
{
    std::vector<double> found;
    for (const StoryboardLogEntry& entry : player.log())
        if (entry.path.ends_with("::" + name) && entry.transition == transition) found.push_back(entry.timeS);
    return found;
}

int lineOf(const ScenarioText& text, const std::string& content)
{
    const std::string all = text.text();
    return 1 + static_cast<int>(std::count(
                   all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.find(content)), '\n'));
}

std::string afterEvent(const std::string& name, const std::string& state)
{
    return "<ConditionGroup><Condition name=\"c\" delay=\"0\" conditionEdge=\"none\"><ByValueCondition>"
           "<StoryboardElementStateCondition storyboardElementType=\"event\" storyboardElementRef=\"" +
           name + "\" state=\"" + state + "\"/></ByValueCondition></Condition></ConditionGroup>";
}

/// A condition that is true from 1 to 2 s, looked at every tenth of a second.
std::vector<double> firings(ConditionEdge edge, double delayS)
{
    Trigger trigger{{}, {ConditionGroup{{Condition{{}, "c", delayS, edge, SimulationTimeCondition{}}}}}};
    std::vector<double> fired;
    TriggerWatch watch(trigger);
    for (int i = 0; i <= 50; ++i)
    {
        const double time = i / 10.0;
        auto& condition = std::get<SimulationTimeCondition>(trigger.groups[0].conditions[0].content);
        condition = time >= 1.0 && time < 2.0 ? SimulationTimeCondition{-1.0, Rule::greaterThan}
                                              : SimulationTimeCondition{1e9, Rule::greaterThan};
        if (watch.update({time, {}})) fired.push_back(time);
    }
    return fired;
}

TEST(TriggerWatch, EdgesAndDelays)
{
    EXPECT_EQ(firings(ConditionEdge::none, 0.0).size(), 10u);
    EXPECT_EQ(firings(ConditionEdge::rising, 0.0), std::vector<double>({1.0}));
    EXPECT_EQ(firings(ConditionEdge::falling, 0.0), std::vector<double>({2.0}));
    EXPECT_EQ(firings(ConditionEdge::risingOrFalling, 0.0), std::vector<double>({1.0, 2.0}));
    EXPECT_EQ(firings(ConditionEdge::rising, 0.5), std::vector<double>({1.5}));
    EXPECT_EQ(firings(ConditionEdge::falling, 1.2), std::vector<double>({3.2}));
    EXPECT_EQ(firings(ConditionEdge::none, 2.0).front(), 3.0);
    EXPECT_EQ(firings(ConditionEdge::none, 2.0).size(), 10u);
}

TEST(Storyboard, AConditionAlreadyTrueAtTheFirstLookIsNoEdge)
{
    ScenarioText text;
    text.stories = story(event("a", speedAction(1.0), timeCondition(0.0, "greaterOrEqual", "rising")));
    const auto player = playing(text);
    for (int i = 0; i < 20; ++i)
        player->step();
    EXPECT_TRUE(times(*player, "a", State::startTransition).empty());
}

TEST(Storyboard, GroupsAreOrConditionsAreAnd)
{
    ScenarioText text;
    std::string both = timeCondition(1.0, "greaterThan");
    const std::string second = timeCondition(1.5, "lessThan");
    both.insert(both.find("</ConditionGroup>"), second.substr(16, second.size() - 33));
    text.stories = story(event("a", speedAction(1.0), timeCondition(9.0) + both));
    const auto player = playing(text);
    for (int i = 0; i < 30; ++i)
        player->step();
    EXPECT_EQ(times(*player, "a", State::startTransition), std::vector<double>({1.1}));
}

TEST(Storyboard, EventsFollowOneAnotherByTheirStates)
{
    ScenarioText text;
    text.stories = story(event("a", speedAction(10.0, "linear", "time", 1.0), timeCondition(1.0)) +
                         event("b", speedAction(0.0), afterEvent("a", "endTransition")) +
                         event("c", speedAction(5.0), afterEvent("group::maneuver::b", "completeState")));
    const auto player = playing(text);
    while (player->timeS() < 4.0 && !player->isFinished())
        player->step();
    EXPECT_EQ(times(*player, "a", State::startTransition), std::vector<double>({1.0}));
    EXPECT_EQ(times(*player, "a", State::endTransition), std::vector<double>({2.0}));
    EXPECT_EQ(times(*player, "b", State::startTransition), std::vector<double>({2.0}));
    EXPECT_EQ(times(*player, "c", State::startTransition).size(), 1u);
    EXPECT_EQ(player->entities().at(0).speedMps, 5.0);
    EXPECT_TRUE(player->isFinished()) << "all stories are over and no trigger could stop it";
    EXPECT_EQ(player->log().front().line, lineOf(text, "<Story "));
}

TEST(Storyboard, OverwriteStopsSkipWaitsParallelJoins)
{
    for (const auto& [priority, running] :
         {std::pair("overwrite", 1), std::pair("skip", 1), std::pair("parallel", 2)})
    {
        ScenarioText text;
        text.stories =
            story(event("a", speedAction(10.0, "linear", "time", 3.0), timeCondition(1.0)) +
                  event("b", speedAction(20.0, "linear", "time", 3.0), timeCondition(2.0), priority));
        text.stop = stopAt(9.0);
        const auto player = playing(text);
        while (player->timeS() < 2.5)
            player->step();
        const bool stopped = !times(*player, "a", State::stopTransition).empty();
        const bool skipped = !times(*player, "b", State::skipTransition).empty();
        EXPECT_EQ(stopped, std::string(priority) == "overwrite");
        EXPECT_EQ(skipped, std::string(priority) == "skip");
        while (player->timeS() < 8.0)
            player->step();
        EXPECT_EQ(player->entities().at(0).speedMps, 20.0) << priority;
    }
}

TEST(Storyboard, AnEventRunsAsOftenAsItMay)
{
    ScenarioText text;
    text.stories = story(event("a", speedAction(1.0), timeCondition(1.0), "parallel", 3));
    text.stop = stopAt(3.0);
    const auto player = playing(text);
    while (!player->isFinished())
        player->step();
    EXPECT_EQ(times(*player, "a", State::startTransition).size(), 3u);
}

TEST(Storyboard, StopTriggerEndsThePlay)
{
    ScenarioText text;
    text.privates = speedAction(10.0);
    text.stop = stopAt(2.0);
    const auto player = playing(text);
    for (int i = 0; i < 100; ++i)
        player->step();
    EXPECT_TRUE(player->isFinished());
    EXPECT_EQ(player->timeS(), 2.0);
    EXPECT_NEAR(player->entities().at(0).position.x, 20.0, 1e-9);
}

TEST(Storyboard, AReferenceToNothingIsToldWithItsLine)
{
    ScenarioText text;
    text.stories = story(event("a", speedAction(1.0), afterEvent("nobody", "endTransition")));
    const auto parsed = parseScenario(text.text(), "test.xosc");
    ASSERT_TRUE(parsed);
    const auto player = ScenarioPlayer::create(parsed->scenario, {});
    ASSERT_TRUE(player);
    ASSERT_EQ((*player)->warnings().size(), 1u);
    EXPECT_EQ((*player)->warnings()[0].message(),
              "scenario:" + std::to_string(lineOf(text, "\"nobody\"")) +
                  ": the storyboard element nobody does not exist; instead: the condition is never true; "
                  "correct the reference");
}

} // namespace
} // namespace simulation
