// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/vehicle/DynamicVehicle.h"
#include "simulation/vehicle/EarthFrame.h"
#include "simulation/vehicle/jsbsim/JsbsimRow.h"

namespace simulation
{

/// How JSBSim's Earth lies in a scene: turned and moved so that its level at one place is the scene's there.
///
/// Debian's JSBSim measures heights over a sphere of the equator's radius and levels across the line to its
/// middle; newer ones have the ellipsoid. Laid on at the begin, either fits: 50 km away the levels differ by
/// 1e-4 rad at most, and the height over the ground is handed over as such, so that wheels do not notice.
/// Frames: JSBSim's is Earth-fixed with x to 0° of longitude, z north; the scene's is east-north-up. Units:
/// metres.
class JsbsimFrame
{
public:
    /// Lays the place of `row` onto `position` of the scene. `isGeodetic`: JSBSim levels by the ellipsoid.
    JsbsimFrame(const JsbsimRow& row, bool isGeodetic, const EarthFrame& earth, const glm::dvec3& position);

    /// The motion of a row; time and contact are left.
    VehicleState stateOf(const JsbsimRow& row) const;

    /// JSBSim's level at a row, in the scene's axes. The geodetic position is left.
    EarthFrame::Place levelOf(const JsbsimRow& row) const;

    /// A vector of the scene as north, east, down of JSBSim's level at a row.
    glm::dvec3 northEastDown(const JsbsimRow& row, const glm::dvec3& vector) const;

private:
    bool _isGeodetic;
    glm::dmat3 _toScene{1.0};
    glm::dvec3 _startEarth{0.0}, _startScene{0.0};
};

/// Whether JSBSim's heights at a row are those over the ellipsoid.
bool isJsbsimGeodetic(const JsbsimRow& row);

} // namespace simulation
