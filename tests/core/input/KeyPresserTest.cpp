// SPDX-License-Identifier: Apache-2.0
// The simulated hand: which keys it presses for a wish.
#include "input/KeyPresser.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "StillVehicle.h"
#include "input/KeyInputs.h"
#include "input/Keys.h"

namespace
{

using namespace trainer;

constexpr std::array<std::string_view, 4> kWished{"elevator", "elevator_trim", "flaps", "throttle"};

simulation::ManualController handsOf(const testsupport::StillVehicle& vehicle)
{
    auto manual = simulation::ManualController::create({{"elevator", -1.0, 1.0, 0.4, 0.8},
                                                        {"elevator_trim", -1.0, 1.0, 0.1},
                                                        {"flaps", 0.0, 1.0, 0.5},
                                                        {"throttle", 0.0, 1.0, 0.5}},
                                                       vehicle);
    EXPECT_TRUE(manual);
    return std::move(*manual);
}

std::string wordsOf(const std::vector<KeyStroke>& strokes)
{
    std::string words;
    for (const KeyStroke& stroke : strokes)
        words += (stroke.isDown ? "+" : "-") + keyName(stroke.key) + " ";
    return words;
}

TEST(KeyPresser, PressesWhatLeadsThereAndLetsGoThere)
{
    const testsupport::StillVehicle vehicle(kWished);
    simulation::ManualController manual = handsOf(vehicle);
    KeyPresser hand(KeyScope::flight);
    const auto decide = [&](double throttle)
    {
        const std::array wishes{0.0, 0.0, 0.0, throttle};
        return wordsOf(hand.decide(manual, wishes, kWished, 0.1));
    };
    EXPECT_EQ(decide(0.5), "+PageUp ");
    EXPECT_EQ(decide(0.5), "") << "a key that is down is not pressed again";
    manual.add(3, 0.5);
    EXPECT_EQ(decide(0.5), "-PageUp ");
    EXPECT_EQ(decide(0.2), "+PageDown ");
    EXPECT_EQ(decide(0.9), "+PageUp -PageDown ") << "in the order of the table";
}

TEST(KeyPresser, TapsFlapsAndTrimsAway)
{
    const testsupport::StillVehicle vehicle(kWished);
    simulation::ManualController manual = handsOf(vehicle);
    KeyPresser hand(KeyScope::flight);
    EXPECT_EQ(wordsOf(hand.decide(manual, std::array{0.0, 0.0, 0.6, 0.0}, kWished, 0.1)), "+f -f ");
    addToInput(manual, "flaps", 1.0 / 3.0);
    EXPECT_EQ(wordsOf(hand.decide(manual, std::array{0.0, 0.0, 0.4, 0.0}, kWished, 0.1)), "");
    std::string words;
    for (int i = 0; i < 20; ++i) // an elevator that would be held for two seconds
        words += wordsOf(hand.decide(manual, std::array{-0.2, 0.0, 1.0 / 3.0, 0.0}, kWished, 0.1));
    EXPECT_NE(words.find("+s "), std::string::npos) << words;
    EXPECT_NE(words.find("+Down "), std::string::npos) << words;
    EXPECT_EQ(words.find("+w "), std::string::npos) << words;
}

/// The elevator in the mean of 20 s in which hands obey what is pressed, for a wish that is less than a push:
/// 0.1 s of it are 0.04.
double meanElevator(double wish)
{
    const testsupport::StillVehicle vehicle(kWished);
    simulation::ManualController manual = handsOf(vehicle);
    KeyPresser hand(KeyScope::flight);
    double sum = 0.0, direction = 0.0;
    for (int i = 0; i < 200; ++i)
    {
        for (const KeyStroke& stroke : hand.decide(manual, std::array{wish, 0.0, 0.0, 0.0}, kWished, 0.1))
            if (const std::string key = keyName(stroke.key); key == "Up" || key == "Down")
                direction += (key == "Up" ? 1.0 : -1.0) * (stroke.isDown ? 1.0 : -1.0);
        const double value = manual.value(0);
        addToInput(manual, "elevator", direction != 0.0 ? 0.04 * direction : std::clamp(-value, -0.08, 0.08));
        sum += manual.value(0);
    }
    return sum / 200.0;
}

TEST(KeyPresser, IsRightInTheMeanWhereAPushIsTooCoarse)
{
    EXPECT_NEAR(meanElevator(-0.013), -0.013, 0.004);
    EXPECT_NEAR(meanElevator(0.029), 0.029, 0.004);
}

TEST(KeyPresser, WaitsWithoutWishes)
{
    const testsupport::StillVehicle vehicle(kWished);
    KeyPresser hand(KeyScope::flight);
    EXPECT_TRUE(hand.decide(handsOf(vehicle), {}, kWished, 0.1).empty());
}

} // namespace
