// SPDX-License-Identifier: Apache-2.0
#include "input/DeviceFile.h"

#include <array>
#include <random>

#include <gtest/gtest.h>

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using namespace trainer;

TEST(DeviceFile, TellsAxesAndButtonsOfEachDevice)
{
    const auto maps =
        parseDevices("osgtrainer-devices 1\ndevice G29 Racing # a wheel\naxis 0 steering inverted dead 0.1 "
                     "curve 2\nbutton 4 PageUp\ndevice *\naxis 2 throttle\n",
                     "devices");
    ASSERT_TRUE(maps) << maps.error().message();
    ASSERT_EQ(maps->size(), 2U);
    EXPECT_EQ(mapFor(*maps, "Logitech g29 racing wheel"), &(*maps)[0]);
    EXPECT_EQ(mapFor(*maps, "anything"), &(*maps)[1]);
    const DeviceAxis& axis = (*maps)[0].axes[0];
    EXPECT_TRUE(axis.isInverted);
    EXPECT_EQ(axis.dead, 0.1);
    EXPECT_EQ(axis.curve, 2.0);
    EXPECT_EQ((*maps)[0].buttons[0].button, 4);
}

TEST(DeviceFile, OfTheTreeIsSound)
{
    const auto maps = readDevices(OSGTRAINER_SOURCE_DIR "/data/devices.txt");
    ASSERT_TRUE(maps) << maps.error().message();
    EXPECT_NE(mapFor(*maps, "Some Joystick"), nullptr);
}

TEST(DeviceAxis, GoesFromItsRestByDeadZoneAndCurve)
{
    const DeviceAxis plain{0, "elevator"};
    const DeviceAxis bent{0, "elevator", true, 0.2, 2.0};
    EXPECT_EQ(inputOf(plain, -0.25, -1.0, 1.0), -0.25);
    EXPECT_EQ(inputOf(bent, 0.2, -1.0, 1.0), 0.0);
    EXPECT_NEAR(inputOf(bent, 0.6, -1.0, 1.0), -0.25, 1e-12); // half of what is left, squared
    EXPECT_NEAR(inputOf(bent, -1.0, -1.0, 1.0), 1.0, 1e-12);
    // A pedal rests at its end.
    EXPECT_EQ(inputOf(plain, -1.0, 0.0, 1.0), 0.0);
    EXPECT_EQ(inputOf(plain, 0.0, 0.0, 1.0), 0.5);
    EXPECT_NEAR(inputOf(bent, 0.6, 0.0, 1.0), 0.0, 1e-12);
    EXPECT_EQ(inputOf(bent, -1.0, 0.0, 1.0), 1.0);
}

struct DeviceMistake
{
    const char* lines;
    const char* place;
    const char* what;
};

class DeviceMistakes : public testing::TestWithParam<DeviceMistake>
{
};

TEST_P(DeviceMistakes, AreToldWithTheirLine)
{
    const auto maps = parseDevices("osgtrainer-devices 1\n" + std::string(GetParam().lines), "devices");
    ASSERT_FALSE(maps);
    EXPECT_EQ(maps.error().place, GetParam().place);
    EXPECT_NE(maps.error().what.find(GetParam().what), std::string::npos) << maps.error().message();
}

INSTANTIATE_TEST_SUITE_P(
    All, DeviceMistakes,
    testing::Values(DeviceMistake{"axis 0 x\n", "devices:2", "before any device"},
                    DeviceMistake{"device\n", "devices:2", "without a name"},
                    DeviceMistake{"device *\naxis x y\n", "devices:3", "no axis"},
                    DeviceMistake{"device *\naxis 1.5 y\n", "devices:3", "no axis"},
                    DeviceMistake{"device *\naxis 0 y dead 1\n", "devices:3", "'dead'"},
                    DeviceMistake{"device *\naxis 0 y curve\n", "devices:3", "'curve'"},
                    DeviceMistake{"device *\naxis 0 stearing\n", "devices:3", "no input 'stearing'"},
                    DeviceMistake{"device *\nbutton 1 Foo\n", "devices:3", "no key 'Foo'"},
                    DeviceMistake{"device *\nhat 1 Up\n", "devices:3", "no word"}));

TEST(DeviceFile, AMisspeltInputIsAsked)
{
    const auto maps = parseDevices("osgtrainer-devices 1\ndevice *\naxis 0 stearing\n", "devices");
    ASSERT_FALSE(maps);
    EXPECT_EQ(maps.error().remedy, "did you mean steering?");
    EXPECT_TRUE(parseDevices(
        "osgtrainer-devices 1\ndevice *\naxis 0 brakes\naxis 1 clutch\naxis 2 fcs/hook\n", "devices"));
}

TEST(DeviceFile, MutationsAreRefusedOrWithinTheirRanges)
{
    constexpr std::array kPieces{"\n",       " ",        "-1",       "1e9",        "nan",
                                 "dead 0.9", "curve 10", "inverted", "device *\n", "#"};
    const std::string sound =
        "osgtrainer-devices 1\ndevice *\naxis 0 steering inverted dead 0.1 curve 2\nbutton 4 PageUp\n";
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i)
    {
        std::string text = sound;
        for (unsigned edits = random() % 4U; edits > 0; --edits)
            text.replace(random() % text.size(), random() % 4U, kPieces[random() % kPieces.size()]);
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    }
}

} // namespace
