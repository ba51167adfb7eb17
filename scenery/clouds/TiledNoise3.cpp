// SPDX-License-Identifier: Apache-2.0
#include "scenery/clouds/TiledNoise3.h"

#include <cmath>

namespace scenery::clouds
{

namespace
{

std::uint32_t hashOf(int x, int y, int z, std::uint32_t seed)
{
    std::uint32_t h = static_cast<std::uint32_t>(x) * 0x8da6b343U ^
                      static_cast<std::uint32_t>(y) * 0xd8163841U ^
                      static_cast<std::uint32_t>(z) * 0xcb1ab31fU ^ seed * 0x9e3779b9U;
    h = (h ^ (h >> 16U)) * 0x7feb352dU;
    h = (h ^ (h >> 15U)) * 0x846ca68bU;
    return h ^ (h >> 16U);
}

/// The gradient of a corner (to the middle of an edge of a cube) times the way from it.
float slope(std::uint32_t hash, float x, float y, float z)
{
    const std::uint32_t h = hash & 15U;
    const float u = h < 8U ? x : y;
    const float v = h < 4U ? y : (h == 12U || h == 14U ? x : z);
    return ((h & 1U) ? -u : u) + ((h & 2U) ? -v : v);
}

float eased(float t)
{
    return t * t * t * (t * (t * 6.0F - 15.0F) + 10.0F);
}

int wrapped(int i, int cells)
{
    if (cells <= 0) return i;
    const int rest = i % cells;
    return rest < 0 ? rest + cells : rest;
}

} // namespace

float tiledNoise3(const glm::vec3& at, const glm::ivec3& cells, std::uint32_t seed)
{
    const float fx = std::floor(at.x), fy = std::floor(at.y), fz = std::floor(at.z);
    const float x = at.x - fx, y = at.y - fy, z = at.z - fz;
    const int x0 = wrapped(static_cast<int>(fx), cells.x), x1 = wrapped(x0 + 1, cells.x);
    const int y0 = wrapped(static_cast<int>(fy), cells.y), y1 = wrapped(y0 + 1, cells.y);
    const int z0 = wrapped(static_cast<int>(fz), cells.z), z1 = wrapped(z0 + 1, cells.z);
    const auto corner = [&](int cx, int cy, int cz, float dx, float dy, float dz)
    { return slope(hashOf(cx, cy, cz, seed), dx, dy, dz); };
    const float u = eased(x), v = eased(y), w = eased(z);
    const auto mixed = [](float a, float b, float t) { return a + t * (b - a); };
    const float low =
        mixed(mixed(corner(x0, y0, z0, x, y, z), corner(x1, y0, z0, x - 1, y, z), u),
              mixed(corner(x0, y1, z0, x, y - 1, z), corner(x1, y1, z0, x - 1, y - 1, z), u), v);
    const float high =
        mixed(mixed(corner(x0, y0, z1, x, y, z - 1), corner(x1, y0, z1, x - 1, y, z - 1), u),
              mixed(corner(x0, y1, z1, x, y - 1, z - 1), corner(x1, y1, z1, x - 1, y - 1, z - 1), u), v);
    return mixed(low, high, w);
}

float tiledSum3(glm::vec3 at, glm::ivec3 cells, int octaves, std::uint32_t seed)
{
    float sum = 0.0F, weight = 0.5F;
    for (int i = 0; i < octaves; ++i)
    {
        sum += weight * tiledNoise3(at, cells, seed + static_cast<std::uint32_t>(i));
        at *= 2.0F;
        cells *= 2;
        weight *= 0.5F;
    }
    return sum;
}

} // namespace scenery::clouds
