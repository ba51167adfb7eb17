// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>

#include <osgPMObjects/core/bake/AtlasCheck.h>

#include "TexelOwners.h"

namespace osgPMObjects::core
{

namespace
{

constexpr std::uint32_t kNoFace = ~0u;
/// The least distance of a texel's centre from a triangle's sides, inwards, in texels: common sides of faces
/// pass through centres.
constexpr double kInside = 1e-6;

/// The texels of an atlas, each with the chart that touches it and the face that contains its centre.
struct Texels
{
    int size;
    std::vector<std::uint32_t> charts, faces;

    explicit Texels(int sizePx)
        : size(sizePx),
          charts(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), kNoFace),
          faces(charts)
    {
    }

    std::size_t at(int x, int y) const
    {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x);
    }
};

bool isInside(const FlatTriangle& t, const glm::dvec2& p)
{
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec2 &from = t[i], to = t[(i + 1) % 3];
        if (doubleArea(from, to, p) <= kInside * glm::length(to - from)) return false;
    }
    return true;
}

bool touches(const FlatTriangle& t, int x, int y)
{
    const FlatTriangle low{glm::dvec2(x, y), glm::dvec2(x + 1, y), glm::dvec2(x + 1, y + 1)};
    const FlatTriangle high{glm::dvec2(x, y), glm::dvec2(x + 1, y + 1), glm::dvec2(x, y + 1)};
    return overlap(t, low, kInside) || overlap(t, high, kInside);
}

std::string addFace(Texels& texels, const FlatTriangle& t, std::uint32_t face, std::uint32_t chart)
{
    const glm::dvec2 low = glm::floor(glm::min(glm::min(t[0], t[1]), t[2]));
    const glm::dvec2 high = glm::floor(glm::max(glm::max(t[0], t[1]), t[2]));
    const std::string name = "face " + std::to_string(face);
    if (!(low.x >= 0.0 && low.y >= 0.0 && high.x < texels.size && high.y < texels.size))
        return name + " lies outside";
    for (int y = static_cast<int>(low.y); y <= static_cast<int>(high.y); ++y)
        for (int x = static_cast<int>(low.x); x <= static_cast<int>(high.x); ++x)
        {
            if (!touches(t, x, y)) continue;
            texels.charts[texels.at(x, y)] = chart;
            if (!isInside(t, glm::dvec2(x, y) + 0.5)) continue;
            std::uint32_t& owner = texels.faces[texels.at(x, y)];
            if (owner != kNoFace) return name + " lies over face " + std::to_string(owner);
            owner = face;
        }
    return "";
}

std::string nearChart(const Texels& texels, int x, int y, int gutter)
{
    const std::uint32_t chart = texels.charts[texels.at(x, y)];
    if (chart == kNoFace) return "";
    const std::string name = "chart " + std::to_string(chart);
    if (std::min(x, y) < gutter || std::max(x, y) >= texels.size - gutter)
        return name + " has no gutter at the border";
    const int last = texels.size - 1;
    for (int v = std::max(0, y - 2 * gutter); v <= std::min(last, y + 2 * gutter); ++v)
        for (int u = std::max(0, x - 2 * gutter); u <= std::min(last, x + 2 * gutter); ++u)
            if (const std::uint32_t other = texels.charts[texels.at(u, v)];
                other != kNoFace && other != chart)
                return name + " lies too near to chart " + std::to_string(other);
    return "";
}

} // namespace

std::string defectOf(const Mesh& mesh, const Atlas& atlas, int gutterPx)
{
    if (!coversFacesOnce(atlas.charts, mesh.faces.size())) return "faces are not in one chart each";
    Texels texels(atlas.sizePx);
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
        if (std::string defect = addFace(texels, inAtlas(mesh, atlas, f), f, atlas.charts.chartOfFace[f]);
            !defect.empty())
            return defect;
    for (int y = 0; y < texels.size; ++y)
        for (int x = 0; x < texels.size; ++x)
            if (std::string defect = nearChart(texels, x, y, gutterPx); !defect.empty()) return defect;
    return "";
}

} // namespace osgPMObjects::core
