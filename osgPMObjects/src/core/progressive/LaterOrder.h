// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// Inserts the triangles that an order leaves out; returns an order of all. The order given stays as it is.
/// Each triangle that was left out is drawn as soon as the cache holds its vertices, at the latest behind the
/// last triangle of the order at them. So an order for a coarser level becomes one for the present level.
/// Cost: linear. Source: the authors.
std::vector<std::uint32_t> withTrianglesLeftOut(std::span<const Triangle> triangles,
                                                std::uint32_t vertexCount,
                                                std::span<const std::uint32_t> order,
                                                std::uint32_t cacheSize);

} // namespace osgPMObjects::core
