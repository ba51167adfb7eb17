// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include <glm/glm.hpp>

#include "simulation/vehicle/Ground.h"

namespace simulation
{

/// Where a round wheel touches the ground. Frame: the scene's.
struct WheelContact
{
    double depthM = 0.0; ///< how far the tyre is pressed in; 0 or less: it does not touch
    glm::dvec3 place{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};
};

/// The ground below one wheel during a step: heights along its way, from behind the wheel to ahead of where
/// the step takes it, and the slope across it. A kerb is a steep piece of that line, so that a wheel meets
/// its edge and not a jump, however fast.
class WheelGround
{
public:
    static constexpr std::size_t kMostPoints = 14;

    /// The points that must be asked for: heights along `forward` (horizontal, of length 1), then one on each
    /// side. `travelM`: how far the hub moves in the step, along it.
    std::span<const glm::dvec3> pointsFor(const glm::dvec3& hub, const glm::dvec3& forward, double radiusM,
                                          double widthM, double travelM);

    /// Takes the answers to these points, and adds the roughness of each kind of ground.
    void take(std::span<const GroundPoint> answers);

    /// False where any point lies outside the data: then nothing is touched.
    bool isKnown() const { return _isKnown; }
    GroundKind kind() const { return _kind; }

    /// The friction of the ground over that of dry asphalt.
    double grip() const { return frictionOf(_kind).gripFactor * _gripScale; }

    /// How the wheel stands with its hub at a place.
    WheelContact contactOf(const glm::dvec3& hub, double radiusM) const;

private:
    std::size_t heights() const { return _count - 2; }

    std::array<glm::dvec3, kMostPoints> _points;
    std::array<double, kMostPoints> _along{}, _heightM{};
    std::size_t _count = 0;
    glm::dvec3 _origin{0.0}, _forward{1.0, 0.0, 0.0};
    double _slopeAcross = 0.0, _widthM = 0.2;
    bool _isKnown = false;
    GroundKind _kind = GroundKind::asphalt;
    double _gripScale = 1.0;
};

} // namespace simulation
