// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <GeographicLib/NormalGravity.hpp>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "simulation/geodesy/LocalFrame.h"

namespace simulation
{

/// The round, turning Earth below a scene: gravity, up and height anywhere in the scene's frame.
/// Frame: the scene's east-north-up about its origin, which turns with the Earth. Units: metres, m/s², rad/s.
/// Source: WGS84 by GeographicLib::NormalGravity (the gravity of the ellipsoid, exact in the ellipsoidal
/// model).
class EarthFrame
{
public:
    explicit EarthFrame(const Geodetic& origin);

    /// The place below or at a point.
    struct Place
    {
        Geodetic geodetic;
        glm::dvec3 up{0.0, 0.0, 1.0};
        glm::dvec3 north{0.0, 1.0, 0.0};
    };

    Place placeAt(const glm::dvec3& position) const;

    /// The same, level across the line to the middle of the Earth (up to 0.19° from the plumb line): the
    /// level of spherical models.
    Place geocentricPlaceAt(const glm::dvec3& position) const;

    /// Gravity with the centrifugal part of the turning Earth.
    glm::dvec3 gravityAt(const glm::dvec3& position) const;

    const LocalFrame& frame() const { return _frame; }

    /// The turning of the Earth, in the scene's axes.
    const glm::dvec3& earthRate() const { return _earthRate; }

private:
    LocalFrame _frame;
    glm::dmat3 _sceneToEarth; ///< columns: the scene's axes in the Earth's frame
    glm::dvec3 _originEarth;
    glm::dvec3 _earthRate;
    GeographicLib::NormalGravity _gravity;
};

/// Heading, pitch and roll about a level place. Radians; the heading 0…2π.
struct LevelAngles
{
    double heading = 0.0, pitch = 0.0, roll = 0.0;
};

/// The angles of body axes forward, right, down. The inverse of levelAttitude().
LevelAngles levelAngles(const EarthFrame::Place& place, const glm::dquat& attitude);

/// The attitude of body axes forward, right, down with a heading (from north, clockwise), pitch (nose up) and
/// roll (right wing down) about a level place. Radians.
glm::dquat levelAttitude(const EarthFrame::Place& place, double heading, double pitch, double roll);

} // namespace simulation
