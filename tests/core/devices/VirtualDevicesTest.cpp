// SPDX-License-Identifier: Apache-2.0
// A joystick that SDL makes up: it moves the hands, goes, is told, and is taken up again.
#include <array>

#include <SDL.h>
#include <gtest/gtest.h>

#include "StillVehicle.h"
#include "input/DeviceInputs.h"

namespace
{

using namespace trainer;

constexpr std::array<std::string_view, 2> kInputs{"elevator", "throttle"};

class PressedKeys : public KeyTarget
{
public:
    void holdInput(std::string_view input, double direction) override
    {
        last = std::string(input);
        held = direction;
    }
    void addToInput(std::string_view /*input*/, double /*amount*/) override {}
    void flipInput(std::string_view /*input*/) override {}
    void act(KeyAction /*action*/, double /*amount*/) override {}

    std::string last;
    double held = 0.0;
};

/// A virtual joystick with four axes and four buttons.
class MadeJoystick
{
public:
    MadeJoystick() : _index(SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_FLIGHT_STICK, 4, 4, 0))
    {
        EXPECT_GE(_index, 0) << SDL_GetError();
        _joystick = SDL_JoystickOpen(_index);
        EXPECT_NE(_joystick, nullptr);
    }

    void setAxis(int axis, double place) const
    {
        SDL_JoystickSetVirtualAxis(_joystick, axis, static_cast<Sint16>(place * 32767.0));
    }
    void setButton(int button, bool isPressed) const
    {
        SDL_JoystickSetVirtualButton(_joystick, button, isPressed ? 1 : 0);
    }

    void unplug()
    {
        SDL_JoystickClose(_joystick);
        SDL_JoystickDetachVirtual(_index);
    }

private:
    int _index;
    SDL_Joystick* _joystick = nullptr;
};

TEST(VirtualJoystick, MovesHandsIsToldWhenItGoesAndTakenUpAgain)
{
    Devices devices;
    ASSERT_EQ(devices.fault(), "");
    devices.update();
    const std::size_t before = devices.states().size();
    MadeJoystick stick;
    const auto came = devices.update();
    ASSERT_EQ(came.size(), 1U);
    EXPECT_NE(came[0].find("is there"), std::string::npos);
    ASSERT_EQ(devices.states().size(), before + 1);
    EXPECT_EQ(devices.states().back().axes.size(), 4U);

    const auto maps = parseDevices(
        "osgtrainer-devices 1\ndevice *\naxis 1 elevator inverted\naxis 2 throttle\nbutton 3 Space\n",
        "devices");
    ASSERT_TRUE(maps);
    DeviceInputs deviceInputs(*maps);
    const testsupport::StillVehicle vehicle(kInputs);
    auto manual = simulation::ManualController::create({{"elevator"}, {"throttle", 0.0, 1.0}}, vehicle);
    ASSERT_TRUE(manual);
    PressedKeys target;
    SeatKeys keys(KeyScope::flight, target);
    deviceInputs.apply(devices.states(), &*manual, keys);
    EXPECT_EQ(manual->value(0), 0.0); // at rest it takes nothing

    stick.setAxis(1, 0.5);
    stick.setAxis(2, 1.0);
    stick.setButton(3, true);
    devices.update();
    deviceInputs.apply(devices.states(), &*manual, keys);
    EXPECT_NEAR(manual->value(0), -0.5, 1e-3);
    EXPECT_NEAR(manual->value(1), 1.0, 1e-3);
    EXPECT_EQ(target.last, "brakes");
    EXPECT_EQ(target.held, 1.0);

    stick.unplug();
    const auto gone = devices.update();
    ASSERT_EQ(gone.size(), 1U);
    EXPECT_NE(gone[0].find("is gone"), std::string::npos);
    deviceInputs.apply(devices.states(), &*manual, keys);
    EXPECT_EQ(target.held, 0.0) << "a button of a device that is gone is let go";
    EXPECT_NEAR(manual->value(0), -0.5, 1e-3);

    MadeJoystick again;
    EXPECT_EQ(devices.update().size(), 1U);
    again.setAxis(1, -1.0);
    devices.update();
    deviceInputs.apply(devices.states(), &*manual, keys);
    EXPECT_NEAR(manual->value(0), 1.0, 1e-3);
    again.unplug();
}

} // namespace
