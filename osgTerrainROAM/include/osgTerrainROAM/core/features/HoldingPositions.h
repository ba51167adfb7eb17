// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <osgTerrainROAM/core/features/GroundFeature.h>

namespace osgTerrainROAM::core
{

/// A place on a paved taxiway where one waits before a runway. Frame: the features'. Units: metres.
struct HoldingPosition
{
    glm::dvec2 place{0.0};     ///< on the middle of the taxiway
    glm::dvec2 away{1.0, 0.0}; ///< unit vector along the taxiway, from the runway
    double taxiwayM = 15.0;    ///< width
    double runwayM = 0.0;      ///< length
    std::string runways; ///< "09-27", as who waits has the ends to the left and right; "09": at that end
};

/// Returns the holding positions of features, where their lines are painted.
///
/// One lies 30, 40 or 75 m from a runway's centre line, by the runway's length. Where the taxiway ends
/// before, as one beside the runway, it lies 12 m before that end, or there is none where that is within 15 m
/// of the runway's edge.
/// Source: ICAO Annex 14, 8th edition, table 3-2 (distances, runways without instruments), 5.4.2.14 (what a
/// sign tells).
std::vector<HoldingPosition> holdingPositions(const std::vector<GroundFeature>& features);

} // namespace osgTerrainROAM::core
