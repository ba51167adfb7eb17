// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <foundation/Heights.h>

#include "scenery/lights/LightPoint.h"

namespace scenery
{

/// A runway in the plan, from end to end. Frame: the scene's.
struct RunwayPlan
{
    glm::dvec2 from{0.0}, to{0.0};
    double widthM = 30.0;
    bool isPaved = true;
};

/// What a runway is lit for.
enum class RunwayClass
{
    unlit,        ///< grass and gravel
    visual,       ///< edges, thresholds and ends of medium intensity
    nonPrecision, ///< edges of high intensity and the simple approach lights of 420 m
    precision,    ///< approach lights of category I of 900 m
    precisionTwo, ///< the same with centre line and touchdown zone
};

/// Returns the class that a runway's size suggests, since maps do not tell it: unpaved or shorter than 600 m;
/// below 1200 m; below 1800 m; below 2400 m or narrower than 45 m; all others.
RunwayClass classOf(const RunwayPlan& runway);

/// Returns the lamps of a runway at both ends: edges every 60 m (yellow over the last 600 m or third),
/// threshold green, end red; the approach by its class; centre line every 15 m, red and white from 900 m
/// before the end and red over the last 300 m; barrettes of the touchdown zone over 900 m. Approach lights
/// stand on the ground but not below a fall of 1 in 66 from the threshold.
/// `ground`: heights; where it has none lamps are left out.
/// Source: ICAO, *Annex 14*, volume I, 5.3.4 (approach), 5.3.9 (edges), 5.3.10 (threshold), 5.3.11 (end),
/// 5.3.12 (centre line), 5.3.13 (touchdown zone). We have no wing bars and no displaced thresholds.
std::vector<LightPoint> runwayLights(const RunwayPlan& runway, const foundation::HeightInPlan& ground);

/// Returns the blue lamps along both edges of a taxiway, 60 m apart at most, where they stand on no runway.
/// Source: the same, 5.3.18.
std::vector<LightPoint> taxiwayLights(std::span<const glm::dvec2> middle, double widthM,
                                      std::span<const RunwayPlan> runways,
                                      const foundation::HeightInPlan& ground);

/// Returns the beacon of an airfield: white and green in turn, 12 flashes of each a minute. Source: the same,
/// 5.3.3.
std::vector<LightPoint> beaconLights(const glm::dvec3& place);

/// Returns the steady red lamp of low intensity (type B, 32 cd) on top of what stands in the way of aircraft.
/// Source: the same, 6.2.2.
LightPoint obstacleLight(const glm::dvec3& place);

} // namespace scenery
