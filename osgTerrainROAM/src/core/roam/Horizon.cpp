// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <GeographicLib/Constants.hpp>

#include <osgTerrainROAM/core/heightfield/SampleRaster.h>
#include <osgTerrainROAM/core/roam/Horizon.h>

namespace osgTerrainROAM::core
{

namespace
{

const double kEquatorM = GeographicLib::Constants::WGS84_a();
const double kPoleM = kEquatorM * (1.0 - GeographicLib::Constants::WGS84_f());
const double kBallM = kPoleM * kPoleM / kEquatorM; ///< ρ
const double kFlattening = 1.0 - kBallM * kPoleM / (kEquatorM * kEquatorM);
constexpr double kSlackM = 1.0;   ///< for what positions between the net's nodes are off
constexpr double kCoarsest = 0.1; ///< q beyond which nothing is claimed

/// The plane through an edge of the data that has all of the edge on its outer side.
template<class PlaceAt>
glm::dvec4 wall(int samples, const glm::dvec3& inwards, const PlaceAt& placeAt)
{
    double farthestM = -1e30;
    for (int i = 0; i < samples; ++i)
        for (const double heightM : {-HidingGround::kDeepestM, HidingGround::kHighestM})
            farthestM = std::max(farthestM, glm::dot(inwards, placeAt(i, heightM)));
    return {inwards, -farthestM - kSlackM};
}

bool hasLowerGeoid(const GeodeticNet::Node& a, const GeodeticNet::Node& b)
{
    return a.geoidM < b.geoidM;
}

} // namespace

double lowestGeoidM(const HeightField& field)
{
    if (!field.net) return 0.0;
    return std::min_element(field.net->nodes.begin(), field.net->nodes.end(), hasLowerGeoid)->geoidM -
           kSlackM;
}

double highestGeoidM(const HeightField& field)
{
    if (!field.net) return 0.0;
    return std::max_element(field.net->nodes.begin(), field.net->nodes.end(), hasLowerGeoid)->geoidM +
           kSlackM;
}

HidingGround::HidingGround(const PlacedTile& placed)
{
    if (placed.frame().placement() != Placement::curved || placed.samples().hasHoles())
        return; // one looks through holes
    const SampleRaster tile(placed);
    exists = true;
    const int columns = tile.dataColumns(), rows = tile.dataRows();
    const double east = columns - 1, north = rows - 1;
    cellM = 1.5 * (placed.field().spacingEastM + placed.field().spacingNorthM);
    lowestM = 1e30;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            lowestM = std::min(lowestM, static_cast<double>(tile.heightM(column, row)));
    belowM = lowestGeoidM(placed.field()) - cellM * cellM / (8.0 * kBallM);
    lowestM += belowM;
    const glm::dvec3 eastwards =
        glm::normalize(tile.positionAt(east, 0.5 * north, 0.0) - tile.positionAt(0.0, 0.5 * north, 0.0));
    const glm::dvec3 northwards =
        glm::normalize(tile.positionAt(0.5 * east, north, 0.0) - tile.positionAt(0.5 * east, 0.0, 0.0));
    walls = {wall(rows, eastwards, [&](int i, double h) { return tile.positionAt(0.0, i, h); }),
             wall(rows, -eastwards, [&](int i, double h) { return tile.positionAt(east, i, h); }),
             wall(columns, northwards, [&](int i, double h) { return tile.positionAt(i, 0.0, h); }),
             wall(columns, -northwards, [&](int i, double h) { return tile.positionAt(i, north, h); })};
}

std::optional<Horizon> Horizon::around(const PlacedTile& tile, const HidingGround& ground,
                                       const glm::dvec3& eye, double errorPerM, double nearM)
{
    if (!ground.exists || !(errorPerM < kCoarsest)) return std::nullopt;
    Horizon horizon;
    horizon._ground = &ground;
    horizon._eye = eye;
    for (std::size_t i = 0; i < ground.walls.size(); ++i)
    {
        horizon._insideM[i] = glm::dot(ground.walls[i], glm::dvec4(eye, 1.0));
        if (!(horizon._insideM[i] > 0.0)) return std::nullopt;
    }
    const double h = horizon._heightM = tile.frame().geodeticFromLocal(eye).heightM;
    if (h > HidingGround::kHighestM) return std::nullopt;

    // t² = (ρ + h)² − (ρ − d)² ≤ 2ρ(h + d) + h², d = depth + q·t.
    const double q = errorPerM / (1.0 - errorPerM);
    const double depthM = -ground.lowestM + q * (2.0 * ground.cellM + nearM);
    const double square = q * q * kBallM * kBallM + 2.0 * kBallM * (h + depthM) + h * h;
    if (h + depthM <= 0.0) return std::nullopt; // below all that could hide
    horizon._tangentM = q * kBallM + std::sqrt(square);
    horizon._depthM = depthM + q * horizon._tangentM;
    if (std::max(horizon._depthM, -ground.lowestM) > HidingGround::kDeepestM) return std::nullopt;
    return horizon;
}

bool Horizon::hides(const glm::dvec3& centre, double radiusM, double highestM) const
{
    const double awayM = glm::distance(centre, _eye), nearestM = awayM - radiusM;
    if (nearestM <= _tangentM) return false;
    const double mostM = std::max(std::abs(highestM), std::abs(_ground->lowestM));
    const double footM = awayM + radiusM + std::abs(_heightM) + mostM;
    // A point below the ellipsoid is nearer to the ball's centre, by nearly its depth.
    const double aboveM = highestM < 0.0 ? 0.98 * highestM : highestM;
    const double flatM2 = kFlattening * footM * footM;
    const double reachM2 = flatM2 + aboveM * (2.0 * std::sqrt(kBallM * kBallM + flatM2) + aboveM) +
                           _depthM * (2.0 * kBallM - _depthM);
    const double beyondM = nearestM - _tangentM;
    if (reachM2 > 0.0 && beyondM * beyondM < reachM2) return false;
    // The line enters the ground after this share of its length, at most: up to there it has to be over the
    // data.
    const double share = _tangentM / nearestM;
    for (std::size_t i = 0; i < _insideM.size(); ++i)
    {
        const double there = glm::dot(_ground->walls[i], glm::dvec4(centre, 1.0)) - radiusM;
        if (_insideM[i] + share * (there - _insideM[i]) < 0.0) return false;
    }
    return true;
}

} // namespace osgTerrainROAM::core
