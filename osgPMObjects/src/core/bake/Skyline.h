// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace osgPMObjects::core
{

/// The outline of a chart in columns of texels, with its gutter. Units: texels, from the lower left corner of
/// its box.
struct Silhouette
{
    std::vector<int> bottom; ///< by column
    std::vector<int> top;    ///< by column: above the last texel
    int height = 0;
};

/// Computes the silhouette of lines in the plane, enlarged by `gutter` texels on all sides. All coordinates
/// must be at least 0.
Silhouette silhouetteOf(std::span<const std::array<glm::dvec2, 2>> lines, int gutter);

/// The upper border of the packed charts, column by column.
class Skyline
{
public:
    explicit Skyline(int size) : _heights(static_cast<std::size_t>(size), 0), _size(size) {}

    /// Places a chart where its top is lowest; returns the lower left corner of its box, with x below 0 when
    /// it fits nowhere.
    glm::ivec2 place(const Silhouette& chart);

private:
    int restsAt(const Silhouette& chart, int x, int most) const;

    std::vector<int> _heights;
    int _size;
};

} // namespace osgPMObjects::core
