// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace flights
{

/// The coherent straight flights that terrain engines are compared on: 240 frames over a square tile with planar
/// placement, the head swaying. 1280×1024 pixels, horizontal field 60°.
struct AnchorFlight
{
    double cellsPerFrame = 0.5;
    double aboveGroundM = 300.0;
    static constexpr int kFrames = 240;

    viewlod::ViewState view(const osgTerrainROAM::core::PlacedTile& tile, int frame) const
    {
        constexpr int kWidth = 1280, kHeight = 1024;
        const double last = tile.dataColumns() - 1, s = cellsPerFrame * frame;
        const double column = 0.12 * last + 0.8 * s, row = 0.15 * last + 0.6 * s;
        const glm::dvec3 eye = tile.positionAt(column, row, groundM(tile, column, row) + aboveGroundM);
        const double yaw = std::atan2(0.6, 0.8) + 0.6 * std::sin(2.0 * std::numbers::pi * frame / kFrames),
                     pitch = -0.12;
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
        return (1 - v) * ((1 - u) * tile.heightM(c, r) + u * tile.heightM(c + 1, r)) +
               v * ((1 - u) * tile.heightM(c, r + 1) + u * tile.heightM(c + 1, r + 1));
    }
};

} // namespace flights
