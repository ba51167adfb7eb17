// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace measurement
{

/// A camera that moves as a vehicle does: 60 frames a second over a square tile with planar placement,
/// straight ahead at a constant speed, at a height above the smoothed ground; the heading oscillates by some
/// degrees in eight seconds. At speed 0 it does not move. BenchmarkFlight measures the largest changes, this
/// flight measures what a viewer sees.
/// Units: metres, seconds; the field of view is horizontal.
struct SteadyFlight
{
    double speedMps = 100.0;
    double aboveGroundM = 300.0;
    double startShare = 0.12; ///< of the tile's side: the start, in both axes
    static constexpr double kFramesPerSecond = 60.0;

    glm::dvec3 eye(const osgTerrainROAM::core::PlacedTile& tile, int frame) const
    {
        const double sideM = (tile.grid().dataColumns() - 1) * tile.field().spacingEastM;
        const glm::dvec2 place = glm::dvec2(startShare * sideM) + along() * metresAt(frame);
        return {place, smoothGroundM(tile, place) + aboveGroundM};
    }

    glm::dmat4 view(const osgTerrainROAM::core::PlacedTile& tile, int frame) const
    {
        const glm::dvec3 from = eye(tile, frame);
        const double swayS = 8.0, swayRad = speedMps > 0.0 ? 0.1 : 0.0;
        const double yaw = std::atan2(along().y, along().x) +
                           swayRad * std::sin(2.0 * std::numbers::pi * frame / (swayS * kFramesPerSecond));
        const double pitch = -0.08;
        const glm::dvec3 ahead(std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch),
                               std::sin(pitch));
        return glm::lookAt(from, from + ahead, glm::dvec3(0, 0, 1));
    }

    /// Returns the projection. The nearest drawn ground is about as far as the camera is high; depth has 24
    /// bits.
    glm::dmat4 projection(double aspect) const
    {
        const double fovY = 2.0 * std::atan(std::tan(std::numbers::pi / 6.0) / aspect);
        return glm::perspective(fovY, aspect, std::max(0.1 * aboveGroundM, 0.3), 200000.0);
    }

private:
    static glm::dvec2 along() { return {0.8, 0.6}; }
    double metresAt(int frame) const { return speedMps * frame / kFramesPerSecond; }

    /// Returns the mean height of the ground from two camera heights behind to two ahead, because a vehicle
    /// does not follow each bump.
    double smoothGroundM(const osgTerrainROAM::core::PlacedTile& tile, const glm::dvec2& place) const
    {
        constexpr int kHalf = 16;
        double sumM = 0.0;
        for (int i = -kHalf; i <= kHalf; ++i)
            sumM += groundM(tile, place + along() * (2.0 * aboveGroundM * i / kHalf));
        return sumM / (2 * kHalf + 1);
    }

    static double groundM(const osgTerrainROAM::core::PlacedTile& tile, const glm::dvec2& place)
    {
        const double column =
            std::clamp(place.x / tile.field().spacingEastM, 0.0, tile.grid().dataColumns() - 1.0);
        const double row =
            std::clamp(place.y / tile.field().spacingNorthM, 0.0, tile.grid().dataRows() - 1.0);
        const int c = static_cast<int>(column), r = static_cast<int>(row);
        const double u = column - c, v = row - r;
        return (1 - v) * ((1 - u) * tile.samples().heightM(c, r) + u * tile.samples().heightM(c + 1, r)) +
               v * ((1 - u) * tile.samples().heightM(c, r + 1) + u * tile.samples().heightM(c + 1, r + 1));
    }
};

} // namespace measurement
