// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "simulation/geodesy/LocalFrame.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// Something that one who shows a country flies past: a town, a village, a runway, a stretch of shore.
/// Frame: the scene's. Units: metres.
struct Sight
{
    glm::dvec2 place{0.0}; ///< its middle
    double radiusM = 100.0;
    double weight = 1.0; ///< about 1: a town
};

/// A terrain as the tour and the drive need it.
/// Frame: the scene's east-north-up. Units: metres.
struct TourTerrain
{
    double westM = 0.0;
    double southM = 0.0;
    double eastM = 0.0;
    double northM = 0.0;

    /// Returns z of the surface inside the extent and slightly outside, where it returns the nearest height.
    std::function<double(double eastM, double northM)> heightM;

    double sampleSpacingM = 1.0;
    std::optional<Geodetic> origin; ///< of the frame; absent without georeference
    std::string sceneFile;          ///< becomes RoadNetwork/SceneGraphFile

    /// Tells whether the ground was measured, not filled in where the data have a void. Empty: all of it was.
    std::function<bool(double eastM, double northM)> isMeasured{};

    std::vector<Sight> sights{}; ///< what the country has to show; empty: relief alone

    double widthM() const { return eastM - westM; }
    double depthM() const { return northM - southM; }

    /// The name for messages: the scene file without its folders.
    std::string name() const { return std::filesystem::path(sceneFile).filename().string(); }
};

/// A path over a terrain as a scenario, with the values chosen for it.
struct Tour
{
    Scenario scenario;
    double speedMps = 0.0;
    double lowestM = 0.0;      ///< smallest height above the ground on the way
    double highestM = 0.0;     ///< largest
    glm::dvec3 highlight{0.0}; ///< the point of interest that a flight faces at its end
    double filledShare = 0.0;  ///< share of the ground ahead of a flight that was not measured, 0…1
};

} // namespace simulation
