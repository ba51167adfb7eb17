// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <osgPMObjects/core/order/TriangleOrders.h>

namespace osgPMObjects::core
{

namespace
{

constexpr int kBits = 21;           ///< of each coordinate, so that three make a key of 63 bits
constexpr double kFlatShare = 1e-3; ///< share of the largest extent below which an axis counts as flat

/// Returns the position of a cell along the curve; its coordinates have kBits each. From the highest bit down
/// it rotates the coordinates into the curve's local frame; the result is a Gray code, which is decoded.
std::uint64_t alongCurve(std::array<std::uint32_t, 3> x, int dimensions)
{
    for (std::uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1)
        for (int i = 0; i < dimensions; ++i)
        {
            const std::uint32_t below = bit - 1;
            if (x[i] & bit)
                x[0] ^= below;
            else
            {
                const std::uint32_t differing = (x[0] ^ x[i]) & below;
                x[0] ^= differing;
                x[i] ^= differing;
            }
        }
    for (int i = 1; i < dimensions; ++i)
        x[i] ^= x[i - 1];
    std::uint32_t turned = 0;
    for (std::uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1)
        if (x[dimensions - 1] & bit) turned ^= bit - 1;
    std::uint64_t key = 0;
    for (int bit = kBits - 1; bit >= 0; --bit)
        for (int i = 0; i < dimensions; ++i)
            key = key << 1 | (((x[i] ^ turned) >> bit) & 1u);
    return key;
}

/// The axes along which the mesh is not flat, and the scale from its box to cells.
struct Cells
{
    glm::dvec3 low{0.0};
    double perUnit = 0.0;
    std::array<int, 3> axes{};
    int dimensions = 0;
};

Cells cellsOf(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions)
{
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const Triangle& t : triangles)
        for (const std::uint32_t vertex : t)
        {
            low = glm::min(low, positions[vertex]);
            high = glm::max(high, positions[vertex]);
        }
    const glm::dvec3 extent = high - low;
    const double largest = std::max({extent.x, extent.y, extent.z});
    Cells cells{low, 0.0, {}, 0};
    if (!(largest > 0.0)) return cells;
    cells.perUnit = ((1u << kBits) - 1) / largest;
    for (int axis = 0; axis < 3; ++axis)
        if (extent[axis] > kFlatShare * largest) cells.axes[cells.dimensions++] = axis;
    return cells;
}

} // namespace

std::vector<std::uint32_t> hilbertOrder(std::span<const Triangle> triangles,
                                        std::span<const glm::dvec3> positions)
{
    const Cells cells = cellsOf(triangles, positions);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    keys.reserve(triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
    {
        glm::dvec3 centre(0.0);
        for (const std::uint32_t vertex : triangles[t])
            centre += (positions[vertex] - cells.low) / 3.0;
        std::array<std::uint32_t, 3> cell{};
        for (int i = 0; i < cells.dimensions; ++i)
            cell[i] = static_cast<std::uint32_t>(
                std::clamp(centre[cells.axes[i]] * cells.perUnit, 0.0, double((1u << kBits) - 1)));
        keys.emplace_back(cells.dimensions > 0 ? alongCurve(cell, cells.dimensions) : 0, t);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> order;
    order.reserve(keys.size());
    for (const auto& [key, t] : keys)
        order.push_back(t);
    return order;
}

} // namespace osgPMObjects::core
