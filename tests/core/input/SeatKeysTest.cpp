// SPDX-License-Identifier: Apache-2.0
#include "input/SeatKeys.h"

#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "input/Keys.h"
#include "simulation/control/driver/ManualDriver.h"
#include "simulation/vehicle/flight/FlightInputs.h"

namespace
{

using namespace trainer;

/// Notes what keys asked for.
class NotedTarget : public KeyTarget
{
public:
    void holdInput(std::string_view input, double direction) override
    {
        held[std::string(input)] = direction;
    }
    void addToInput(std::string_view input, double amount) override { added[std::string(input)] += amount; }
    void flipInput(std::string_view input) override { ++flipped[std::string(input)]; }
    void act(KeyAction action, double amount) override
    {
        ++acts[action];
        lastAmount = amount;
    }

    std::map<std::string, double> held, added;
    std::map<std::string, int> flipped;
    std::map<KeyAction, int> acts;
    double lastAmount = 0.0;
};

int code(std::string_view name)
{
    const auto key = keyOf(name);
    EXPECT_TRUE(key) << name;
    return key.value_or(0);
}

TEST(SeatKeys, HoldPushesUntilTheKeyComesUp)
{
    NotedTarget target;
    SeatKeys keys(KeyScope::flight, target);
    keys.press(code("Up"));
    keys.press(code("Up")); // a key that repeats
    EXPECT_EQ(target.held["elevator"], 1.0);
    keys.press(code("Down"));
    EXPECT_EQ(target.held["elevator"], 0.0);
    keys.release(code("Up"));
    EXPECT_EQ(target.held["elevator"], -1.0);
    keys.release(code("Down"));
    EXPECT_EQ(target.held["elevator"], 0.0);
    keys.press(code("a"));
    keys.press(code("Left"));
    keys.releaseAll();
    EXPECT_EQ(target.held["rudder"], 0.0);
    EXPECT_EQ(target.held["aileron"], 0.0);
}

TEST(SeatKeys, TheSameKeyDoesAnotherThingInACar)
{
    NotedTarget target;
    SeatKeys keys(KeyScope::drive, target);
    keys.press(code("Up"));
    EXPECT_EQ(target.held["throttle"], 1.0);
    EXPECT_EQ(target.held.count("elevator"), 0U);
    keys.press(code("PageDown"));
    EXPECT_EQ(target.added["gear"], -1.0);
    keys.press(code("f")); // flaps: not here
    EXPECT_EQ(target.added.count("flaps"), 0U);
}

TEST(SeatKeys, ActionsHappenOnceAPress)
{
    NotedTarget target;
    SeatKeys keys(KeyScope::all, target);
    keys.press(code("p"));
    keys.press(code("p"));
    EXPECT_EQ(target.acts[KeyAction::pause], 1);
    keys.release(code("p"));
    keys.press(code("p"));
    EXPECT_EQ(target.acts[KeyAction::pause], 2);
    keys.press(code("3"));
    EXPECT_EQ(target.lastAmount, 2.0);
    keys.press(code("Tab")); // nothing to take over
    EXPECT_EQ(target.acts.count(KeyAction::handOver), 0U);
    keys.press(123456);
    keys.release(654321);
}

TEST(KeyTable, HasEachKeyOnceForEachVehicleAndKnowsThemAll)
{
    for (const KeyScope vehicle : {KeyScope::all, KeyScope::flight, KeyScope::drive})
    {
        std::set<int> keys;
        for (const KeyBinding& binding : keyTable())
            if (isFor(binding, vehicle))
            {
                EXPECT_TRUE(keys.insert(code(binding.key)).second) << binding.key;
                EXPECT_EQ(keyName(code(binding.key)), binding.key);
            }
        EXPECT_GT(keys.size(), 15U);
    }
}

TEST(KeyTable, NamesInputsThatTheVehiclesHave)
{
    for (const KeyBinding& binding : keyTable())
    {
        if (binding.input.empty() || binding.input == "brakes") continue;
        const auto has = [&](const auto& names)
        { return std::find(names.begin(), names.end(), binding.input) != names.end(); };
        EXPECT_TRUE(binding.scope == KeyScope::flight ? has(simulation::kFlightInputNames)
                                                      : has(simulation::kRoadInputNames))
            << binding.input;
    }
}

/// The rows of the page that are no row of the table, and the other way round.
std::set<std::string> differences(std::string page)
{
    std::set<std::string> found;
    for (const KeyBinding& binding : keyTable())
    {
        const std::string row =
            "| `" + std::string(binding.key) + "` | " + std::string(binding.text) + " |\n";
        const std::size_t at = page.find(row);
        if (at == std::string::npos)
            found.insert("missing: " + row);
        else
            page.erase(at, row.size());
    }
    for (std::size_t at = page.find("\n| `"); at != std::string::npos; at = page.find("\n| `", at + 1))
        found.insert("stale: " + page.substr(at + 1, page.find('\n', at + 1) - at));
    return found;
}

TEST(KeyTable, IsThePageOfKeys)
{
    std::ifstream stream(OSGTRAINER_SOURCE_DIR "/docs/reference/keys.md");
    const std::string page{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    EXPECT_EQ(differences(page), std::set<std::string>());
    // The control: a row that is gone, and one too many.
    std::string changed = page;
    changed.replace(changed.find("| `F1` | this help |"), 20, "| `F1` | that help |");
    EXPECT_EQ(differences(changed).size(), 2U);
}

} // namespace
