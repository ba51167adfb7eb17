// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "measurement/light/LightFigure.h"
#include "scenery/lights/Allard.h"
#include "scenery/lights/LightPoint.h"
#include "scenery/lights/LightSteps.h"
#include "scenery/lights/PapiUnits.h"

namespace measurement
{

/// The three position lamps of an aircraft, in its frame.
struct PositionLamps
{
    scenery::LightPoint left, right, rear;
};

/// Returns position lamps of the intensities that 14 CFR 23.1391 asks for, with the beams of this project.
PositionLamps defaultPositionLamps();

/// Returns a dipped head lamp of 13 000 cd with the beam of this project.
scenery::LightPoint defaultLowBeam();

/// How far a lamp is seen, in metres.
using LampRange = std::function<double(double candela, double visibilityM, double leastLx)>;

/// What is measured of lamps: the functions that draw them, or others that stand in for them.
struct LampParts
{
    LampRange rangeM = scenery::visibleRangeM;
    std::function<double(scenery::LightGroup, int step)> shareOfStep = scenery::shareOfStep;
    std::function<double(const scenery::LightPoint&, const glm::dvec3& eye, double timeS)> candelaTowards =
        scenery::candelaTowards;
    std::function<std::vector<scenery::PapiUnit>(const glm::dvec2& threshold, const glm::dvec2& landing,
                                                 double lengthM, double widthM)>
        papi = scenery::papiUnits;
    PositionLamps position = defaultPositionLamps();
    scenery::LightPoint lowBeam = defaultLowBeam();
};

/// A lamp, an eye's threshold, the visibility and how far the lamp is seen.
struct KnownRange
{
    double candela, leastLx, visibilityKm, rangeKm;
};

/// Returns the largest deviation from ranges worked out from Allard's law by another program, as a share.
double worstRange(const LampRange& rangeM);

/// Measures the ranges of lamps, their steps, the sectors of position lamps, what a dipped head lamp sends to
/// the points of UN R112 and the settings of PAPI.
/// Cost: some milliseconds.
LightFigures lampFigures(const LampParts& parts = {});

} // namespace measurement
