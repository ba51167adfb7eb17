// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include <glm/glm.hpp>

namespace osgTerrainROAM::core
{

/// A volume in which the ground is neither drawn nor stood on: the inside of a tunnel. An upright
/// cross-section, symmetric about its middle, swept along a line. The ground itself stays as it is.
/// Frame: the tile's. Units: metres; heights of the cross-section are above the line.
struct GroundOpening
{
    static constexpr double kKneeShare = 0.6; ///< of the half width, where the roof bends

    struct Section
    {
        glm::dvec3 middle{0.0};
        double halfM = 0.0; ///< half the width
    };

    std::vector<Section> line; ///< two or more; between them the cross-section changes linearly
    double lowM = 0.0;         ///< where the volume begins
    double wallM = 0.0, kneeM = 0.0, crownM = 0.0; ///< its roof at the sides, at the knee, in the middle
    double beyondM = 0.0;                          ///< by how much it goes on beyond both ends

    /// Returns the roof at a share of the half width from the middle.
    double roofM(double aside) const
    {
        return aside < kKneeShare ? std::lerp(crownM, kneeM, aside / kKneeShare)
                                  : std::lerp(kneeM, wallM, (aside - kKneeShare) / (1.0 - kKneeShare));
    }
};

} // namespace osgTerrainROAM::core
