// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include <osgTerrainROAM/core/cover/CoverTable.h>

namespace osgTerrainROAM::core
{

/// What a kind of ground is made of where one stands on it, each a share; what is left has no detail of its
/// own.
struct GroundMakeup
{
    float grass = 0.0f, stones = 0.0f, earth = 0.0f, rock = 0.0f;
    float litter = 0.0f; ///< leaves and twigs of the floor of a wood
};

/// By GroundKind. What is drawn on the ground and what grows on it go by this table.
constexpr std::array<GroundMakeup, kGroundKinds> kGroundMakeup{{
    {},                             // unknown
    {0.0f, 0.2f, 0.0f, 0.8f, 0.0f}, // rock
    {0.0f, 0.2f, 0.8f, 0.0f, 0.0f}, // soil
    {0.6f, 0.0f, 0.4f, 0.0f, 0.0f}, // dry grass
    {1.0f, 0.0f, 0.0f, 0.0f, 0.0f}, // meadow
    {0.6f, 0.0f, 0.2f, 0.0f, 0.2f}, // shrub
    {0.0f, 0.0f, 0.0f, 0.0f, 1.0f}, // forest
    {0.0f, 0.0f, 0.4f, 0.0f, 0.0f}, // sand
    {},                             // snow
    {},                             // water
    {0.3f, 0.0f, 0.7f, 0.0f, 0.0f}, // crop
    {0.4f, 0.4f, 0.2f, 0.0f, 0.0f}, // urban
    {0.9f, 0.0f, 0.1f, 0.0f, 0.0f}, // wetland
    {0.9f, 0.0f, 0.1f, 0.0f, 0.0f}, // garden
    {0.2f, 0.4f, 0.4f, 0.0f, 0.0f}, // yard
}};

} // namespace osgTerrainROAM::core
