// SPDX-License-Identifier: Apache-2.0
#include "measurement/light/UnmeasuredGoals.h"

namespace measurement
{

namespace
{

constexpr UnmeasuredGoal kGoals[]{
    {"N1", "luminance of the sky against a path integrator",
     "the colours of the sky are chosen by eye and have no unit"},
    {"N2", "a played day without steps; time after a jump of time or place",
     "the sky has no tables that could be late; times are no figures of this command"},
    {"N5", "time of a picture with 15 000 and 60 000 lamps", "times are no figures of this command"},
    {"N6", "head lamps at the points of UN R112 on a wall",
     "the light that they throw has a shape chosen by eye, and no unit"},
    {"N7", "shadow of a cloud on the sun's ray within a pixel",
     "it has texels of 80 m; a test holds it within some of them"},
    {"N9", "rain of 50 mm/h against a law of its extinction",
     "no source was found for the law; the drops are Marshall and Palmer's"},
    {"N9", "mirror of a wet road; each parameter in every view", "there is no measure of it yet"},
    {"N10", "a lit street; adaptation with a time constant",
     "pictures have no unit of luminance, and the exposure follows the light at once"},
};

} // namespace

std::span<const UnmeasuredGoal> unmeasuredGoals()
{
    return kGoals;
}

} // namespace measurement
