// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// Return a lower and an upper bound of the geoid's height above the ellipsoid over a field, with a metre of
/// slack; 0 without geodetic positions. Units: metres.
double lowestGeoidM(const HeightField& field);
double highestGeoidM(const HeightField& field);

/// A body below the ground that hides everything behind it: all below the tile's lowest sample, within four
/// upright planes. A point within all four planes, between kDeepestM and kHighestM, is above or below the
/// data. The body is convex, so the line between two such points is, too.
/// Frame: the tile's. Units: metres. A planar tile hides nothing: exists is false.
struct HidingGround
{
    static constexpr double kHighestM = 20e3, kDeepestM = 3e3;

    explicit HidingGround(const PlacedTile& tile);

    /// Lowers the body if the changed height of a sample is below it.
    void include(double heightM)
    {
        if (exists) lowestM = std::min(lowestM, heightM + belowM);
    }

    bool exists = false;
    double lowestM =
        0.0; ///< of the samples above the ellipsoid, and of the flat triangles between them, or less
    double belowM = 0.0;               ///< from a sample's height to what lies under the triangles beside it
    double cellM = 0.0;                ///< diagonal of a cell, or more
    std::array<glm::dvec4, 4> walls{}; ///< inside is where the product with (x, y, z, 1) is positive
};

/// The horizon of an eye over a curved tile: it tells which parts of the tile lie below.
/// The ball that touches the ellipsoid from within at the eye's foot, with the smallest radius of curvature ρ
/// = b²/a, lies within it (Blaschke's rolling theorem); with radius R = ρ − d it is at least d below. When
/// everything drawn near the eye is above −d, this ball is below ground wherever there is data. A line from
/// the eye (h above the ellipsoid) that meets the ball does so within the length of the tangent, t = √((ρ +
/// h)² − R²): if that part of it is over the data, it has passed through the drawn ground. A point x at
/// distance ℓ from the ball's centre is behind the ball exactly when |x − eye| ≥ t + √(ℓ² − R²). The
/// ellipsoid lies within the ball of its largest radius of curvature, a²/b, that touches it at the foot. So a
/// point H above it, whose foot is s away, has ℓ ≤ √(ρ² + s²·(1 − ρ·b/a²)) + H. The drawn surface is off by
/// at most q = τ/K of its distance (RoamMesh), so d = −lowest + q·(t + two cells)/(1 − q); t depends on d, so
/// this is a quadratic equation.
/// Precondition: the eye is above the drawn surface. Frame: the tile's. Units: metres.
class Horizon
{
public:
    /// Returns the horizon of an eye; none where nothing is certain: planar tiles, eyes below the drawn
    /// surface or too high, coarse drawing.
    /// `errorPerM`: the drawn surface is off by at most this share of its distance from the eye, or of
    /// `nearM`.
    static std::optional<Horizon> around(const PlacedTile& tile, const HidingGround& ground,
                                         const glm::dvec3& eye, double errorPerM, double nearM);

    /// Tells whether a sphere that reaches at most `highestM` above the ellipsoid is hidden. Cost: 30 flops,
    /// two roots.
    bool hides(const glm::dvec3& centre, double radiusM, double highestM) const;

    /// Tells whether a sphere lies wholly nearer than the horizon, so that it cannot be hidden.
    bool isNearer(const glm::dvec3& centre, double radiusM) const
    {
        return glm::distance(centre, _eye) + radiusM <= _tangentM;
    }

    double distanceM() const { return _tangentM; } ///< to the horizon, at most

private:
    Horizon() = default;

    const HidingGround* _ground = nullptr;
    glm::dvec3 _eye{0.0};
    double _heightM = 0.0;            ///< of the eye
    double _depthM = 0.0;             ///< d
    double _tangentM = 0.0;           ///< t
    std::array<double, 4> _insideM{}; ///< how far the eye is from the walls
};

} // namespace osgTerrainROAM::core
