// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace osgPMObjects::core
{

/// What a chart takes of the columns of an atlas, its gutter with it. Units: texels, from the lower left corner of its box.
struct Silhouette
{
    std::vector<int> bottom; ///< by column
    std::vector<int> top;    ///< by column, above the last texel
    int height = 0;
};

/// The silhouette of lines in a plane; `gutter` texels more on all sides. All coordinates at least 0.
Silhouette silhouetteOf(std::span<const std::array<glm::dvec2, 2>> lines, int gutter);

/// The upper border of what has been packed, column by column.
class Skyline
{
public:
    explicit Skyline(int size) : _heights(static_cast<std::size_t>(size), 0), _size(size) {}

    /// Lets a chart down where its top comes lowest, and gives the lower left corner of its box; x below 0: it fits nowhere.
    glm::ivec2 place(const Silhouette& chart);

private:
    int restsAt(const Silhouette& chart, int x, int most) const;

    std::vector<int> _heights;
    int _size;
};

} // namespace osgPMObjects::core
