// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace measurement
{

/// The motion of the camera.
enum class Path
{
    flight, ///< straight ahead, the heading oscillates
    drive,  ///< as flight, close to the ground
    still,  ///< no motion
    turn,   ///< the heading turns once around, the position stays
    uturn,  ///< as flight, and the heading reverses in every frame
    jump,   ///< as flight, and every second frame is `jumpM` aside, but no more than half the tile
};

inline constexpr Path kPaths[] = {Path::flight, Path::drive, Path::still,
                                  Path::turn,   Path::uturn, Path::jump};

constexpr std::string_view pathName(Path path)
{
    constexpr std::string_view kNames[] = {"flight", "drive", "still", "turn", "uturn", "jump"};
    return kNames[static_cast<int>(path)];
}

/// The coherent straight flight that ROAM engines are compared on: 240 frames over a square tile with planar
/// placement, 1280×1024 pixels, horizontal field of view 60°; and harder paths.
struct BenchmarkFlight
{
    double cellsPerFrame = 0.5;
    double aboveGroundM = 300.0;
    Path path = Path::flight;
    double jumpM = 1000.0;
    static constexpr int kFrames = 240;

    static BenchmarkFlight along(Path path) { return {0.5, path == Path::drive ? 2.0 : 300.0, path}; }

    viewlod::ViewState view(const osgTerrainROAM::core::PlacedTile& tile, int frame) const
    {
        constexpr int kWidth = 1280, kHeight = 1024;
        const bool stays = path == Path::still || path == Path::turn, away = frame % 2 == 1;
        const double last = tile.grid().dataColumns() - 1, s = stays ? 0.0 : cellsPerFrame * frame;
        double column = 0.12 * last + 0.8 * s;
        const double row = 0.15 * last + 0.6 * s;
        if (path == Path::jump && away) column += std::min(jumpM / tile.field().spacingEastM, 0.5 * last);
        const glm::dvec3 eye =
            tile.frame().positionAt(column, row, groundM(tile, column, row) + aboveGroundM);
        const double circle = 2.0 * std::numbers::pi * frame / kFrames;
        double yaw = std::atan2(0.6, 0.8);
        if (path == Path::turn) yaw += circle;
        if (path != Path::turn && path != Path::still) yaw += 0.6 * std::sin(circle);
        if (path == Path::uturn && away) yaw += std::numbers::pi;
        const double pitch = -0.12;
        const glm::dvec3 ahead(std::cos(yaw) * std::cos(pitch), std::sin(yaw) * std::cos(pitch),
                               std::sin(pitch));
        const double aspect = static_cast<double>(kWidth) / kHeight;
        const double fovY = 2.0 * std::atan(std::tan(std::numbers::pi / 6.0) / aspect);
        return viewlod::ViewState::fromMatrices(glm::lookAt(eye, eye + ahead, glm::dvec3(0, 0, 1)),
                                                glm::perspective(fovY, aspect, 1.0, 200000.0), kWidth,
                                                kHeight);
    }

private:
    static double groundM(const osgTerrainROAM::core::PlacedTile& tile, double column, double row)
    {
        const int c = static_cast<int>(column), r = static_cast<int>(row);
        const double u = column - c, v = row - r;
        return (1 - v) * ((1 - u) * tile.samples().heightM(c, r) + u * tile.samples().heightM(c + 1, r)) +
               v * ((1 - u) * tile.samples().heightM(c, r + 1) + u * tile.samples().heightM(c + 1, r + 1));
    }
};

} // namespace measurement
