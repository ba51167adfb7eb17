// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/RunwayClearance.h"

#include <algorithm>
#include <array>

namespace simulation
{
namespace
{

constexpr double kSightM = 50.0, kAcrossM = 30.0;
constexpr double kClimbGradient = 0.08, kLiftOffM = 400.0, kClimbClearM = 5.0, kClimbLookM = 1500.0;
constexpr double kFinalGlide = 0.0524, kAimsM = 150.0, kFinalClearM = 10.0, kFinalLookM = 3000.0,
                 kShortM = 100.0;

/// The highest ground across the centre line at a place along it, above the threshold; -1e9: not known.
double groundAt(const RunwayStrip& runway, const Ground& ground, double alongM)
{
    const glm::dvec2 along = runway.centreLine().along(), left(-along.y, along.x);
    std::array<glm::dvec3, 3> places;
    std::array<GroundPoint, 3> answers;
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = {glm::dvec2(runway.threshold) + alongM * along +
                         kAcrossM * (static_cast<double>(i) - 1.0) * left,
                     1e4};
    ground.heightsBelow(places, answers);
    double highest = -1e9;
    for (const GroundPoint& answer : answers)
        if (answer.isKnown) highest = std::max(highest, answer.heightM - runway.threshold.z);
    return highest;
}

} // namespace

double aboveClimbOutM(const RunwayStrip& runway, const Ground& ground)
{
    double above = -1e9;
    for (double at = runway.lengthM + kSightM; at < runway.lengthM + kClimbLookM; at += kSightM)
        above =
            std::max(above, groundAt(runway, ground, at) - kClimbGradient * (at - kLiftOffM) + kClimbClearM);
    return above;
}

double aboveFinalM(const RunwayStrip& runway, const Ground& ground, double fromM)
{
    double above = -1e9;
    for (double before = kShortM; before < std::min(fromM, kFinalLookM); before += kSightM)
        above = std::max(above,
                         groundAt(runway, ground, -before) - kFinalGlide * (before + kAimsM) + kFinalClearM);
    return above;
}

} // namespace simulation
