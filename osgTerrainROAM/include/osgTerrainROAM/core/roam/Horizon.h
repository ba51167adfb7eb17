// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// Bounds of what lifts a field's samples above the ellipsoid.
double lowestGeoidM(const HeightField& field);
double highestGeoidM(const HeightField& field);

/// What of a tile surely hides what is behind it: the ground below its lowest sample, within four upright planes.
/// A place inside of all four, not higher than kHighestM nor deeper than kDeepestM, is above or below the data; and since
/// they bound a convex body, so is all of the line between two such places.
/// Frame: the tile's. Units: metres. A planar tile hides nothing: exists is false.
struct HidingGround
{
    static constexpr double kHighestM = 20e3, kDeepestM = 3e3;

    explicit HidingGround(const PlacedTile& tile);

    /// Another height that a sample of the tile has now.
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

/// Which parts of a curved tile lie below the horizon of an eye.
/// The ball that touches the ellipsoid from within at the eye's foot, with its smallest radius of curvature ρ = b²/a, lies
/// within it (Blaschke's rolling theorem); with radius R = ρ − d it is nowhere less than d below. With −d under all that is
/// drawn near the eye, the ball is under ground wherever there is data. A line from the eye (h above the ellipsoid) that
/// meets the ball does so within the tangent's length t = √((ρ + h)² − R²): if it is over the data that far, it has gone
/// through the drawn ground before. A place x at distance ℓ from the ball's centre is behind the ball exactly when
/// |x − eye| ≥ t + √(ℓ² − R²). And since the ellipsoid lies within the ball of its largest radius of curvature, a²/b, that
/// touches it at the foot, a place H above it whose foot is s away has ℓ ≤ √(ρ² + s²·(1 − ρ·b/a²)) + H.
/// What is drawn is off by at most q = τ/K of its distance (RoamMesh), so d = −lowest + q·(t + two cells)/(1 − q); t depends
/// on d in turn, which makes a quadratic equation.
/// Precondition: the eye is above what is drawn. Frame: the tile's. Units: metres.
class Horizon
{
public:
    /// None where nothing is certain: planar tiles, eyes that are not above the data or too high, coarse drawing.
    /// `errorPerM`: by how much of its distance from the eye, or of `nearM`, what is drawn may be off.
    static std::optional<Horizon> around(const PlacedTile& tile, const HidingGround& ground,
                                         const glm::dvec3& eye, double errorPerM, double nearM);

    /// Whether nothing within a sphere that is at most `highestM` above the ellipsoid can be seen. Cost: 30 flops, two roots.
    bool hides(const glm::dvec3& centre, double radiusM, double highestM) const;

    /// Whether a sphere lies wholly nearer than the horizon: nothing within it can be hidden.
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
