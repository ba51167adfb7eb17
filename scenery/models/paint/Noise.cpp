// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/paint/Noise.h"

#include <cmath>

#include <glm/common.hpp>

namespace scenery::models
{

namespace
{

float latticeValue(const glm::ivec2& cell, const glm::ivec2& cells, std::uint32_t seed)
{
    const auto wrapped = [](int i, int n) { return static_cast<std::uint32_t>((i % n + n) % n); };
    std::uint32_t h =
        seed * 0x9e3779b9U + wrapped(cell.x, cells.x) * 0x85ebca6bU + wrapped(cell.y, cells.y) * 0xc2b2ae35U;
    h = (h ^ (h >> 16)) * 0x7feb352dU;
    h = (h ^ (h >> 15)) * 0x846ca68bU;
    return static_cast<float>((h ^ (h >> 16)) >> 8) * 0x1p-24F;
}

} // namespace

float tiledNoise(const glm::vec2& uv, const glm::ivec2& cells, std::uint32_t seed)
{
    const glm::vec2 place = uv * glm::vec2(cells);
    const glm::vec2 low = glm::floor(place);
    const glm::ivec2 cell(low);
    const glm::vec2 t = place - low;
    const glm::vec2 s = glm::smoothstep(0.0F, 1.0F, t);
    const auto value = [&](int x, int y) { return latticeValue(cell + glm::ivec2(x, y), cells, seed); };
    return glm::mix(glm::mix(value(0, 0), value(1, 0), s.x), glm::mix(value(0, 1), value(1, 1), s.x), s.y);
}

float tiledCloud(const glm::vec2& uv, const glm::ivec2& cells, int octaves, std::uint32_t seed)
{
    float sum = 0.0F;
    float weight = 1.0F;
    float weights = 0.0F;
    glm::ivec2 lattice = cells;
    for (int octave = 0; octave < octaves; ++octave)
    {
        sum += weight * tiledNoise(uv, lattice, seed + static_cast<std::uint32_t>(octave));
        weights += weight;
        weight *= 0.5F;
        lattice *= 2;
    }
    return sum / weights;
}

} // namespace scenery::models
