// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include <glm/common.hpp>

#include <osgPMObjects/core/bake/PackCharts.h>

#include "Skyline.h"

namespace osgPMObjects::core
{

namespace
{

constexpr int kTurnsTried = 24; ///< within a quarter turn
constexpr int kScalesTried = 9; ///< bisections after a scale that fits has been found
constexpr int kMostScaleHalvings = 40;

using Line = std::array<glm::dvec2, 2>;

/// The sides of a chart in its plane, moved to the corner of their box.
struct FlatChart
{
    std::vector<Line> lines;
    glm::dvec2 low, size;
};

FlatChart flatten(const Mesh& mesh, const Chart& chart)
{
    FlatChart flat;
    glm::dvec2 high(-1e300);
    flat.low = glm::dvec2(1e300);
    for (const std::uint32_t f : chart.faces)
        for (int corner = 0; corner < 3; ++corner)
        {
            const Face& face = mesh.faces[f];
            const glm::dvec2 from = chart.flat(mesh.at(face, corner));
            flat.lines.push_back({from, chart.flat(mesh.at(face, (corner + 1) % 3))});
            flat.low = glm::min(flat.low, from);
            high = glm::max(high, from);
        }
    flat.size = high - flat.low;
    for (Line& line : flat.lines)
        line = {line[0] - flat.low, line[1] - flat.low};
    return flat;
}

void turn(Chart& chart, double angle)
{
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dvec3 right = c * chart.right + s * chart.up;
    chart.up = c * chart.up - s * chart.right;
    chart.right = right;
}

/// Rotates a chart into its smallest rectangle, upright.
FlatChart turnUpright(const Mesh& mesh, Chart& chart)
{
    const double step = std::numbers::pi / 2.0 / kTurnsTried;
    double least = 1e300, best = 0.0;
    Chart turned = chart;
    for (int i = 0; i < kTurnsTried; ++i, turn(turned, step))
    {
        const glm::dvec2 size = flatten(mesh, turned).size;
        if (size.x * size.y >= least) continue;
        least = size.x * size.y;
        best = i * step;
    }
    turn(chart, best);
    FlatChart flat = flatten(mesh, chart);
    if (flat.size.x <= flat.size.y) return flat;
    turn(chart, std::numbers::pi / 2.0);
    return flatten(mesh, chart);
}

/// Returns the lower left corners by chart; empty where they do not fit at this scale.
std::vector<glm::ivec2> cornersAt(double scale, const std::vector<FlatChart>& flats,
                                  const std::vector<std::uint32_t>& order, const PackSettings& settings)
{
    Skyline skyline(settings.sizePx);
    std::vector<glm::ivec2> corners(flats.size());
    std::vector<Line> lines;
    for (const std::uint32_t c : order)
    {
        const int gutters = 2 * settings.gutterPx;
        if (scale * flats[c].size.x + gutters >= settings.sizePx ||
            scale * flats[c].size.y + gutters >= settings.sizePx)
            return {};
        lines.clear();
        for (const Line& line : flats[c].lines)
            lines.push_back({scale * line[0], scale * line[1]});
        corners[c] = skyline.place(silhouetteOf(lines, settings.gutterPx));
        if (corners[c].x < 0) return {};
    }
    return corners;
}

/// Returns the largest scale that was found to fit, with its corners; 0: none fits.
double largestScale(const std::vector<FlatChart>& flats, const PackSettings& settings,
                    std::vector<glm::ivec2>& corners)
{
    std::vector<std::uint32_t> order(flats.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return flats[a].size.y > flats[b].size.y; });
    double longest = 0.0;
    for (const FlatChart& flat : flats)
        longest = std::max(longest, flat.size.y);
    double tooLarge = longest > 0.0 ? settings.sizePx / longest : 1.0, fits = 0.0;
    for (int i = 0; i < kMostScaleHalvings && fits == 0.0; ++i)
    {
        corners = cornersAt(0.5 * tooLarge, flats, order, settings);
        (corners.empty() ? tooLarge : fits) = 0.5 * tooLarge;
    }
    for (int i = 0; i < kScalesTried && fits > 0.0; ++i)
    {
        const double scale = 0.5 * (fits + tooLarge);
        std::vector<glm::ivec2> found = cornersAt(scale, flats, order, settings);
        (found.empty() ? tooLarge : fits) = scale;
        if (!found.empty()) corners = std::move(found);
    }
    return fits;
}

} // namespace

foundation::Result<Atlas> packCharts(const Mesh& mesh, Charts charts, const PackSettings& settings)
{
    const int size = settings.sizePx;
    if (size < 16 || size > 8192 || (size & (size - 1)) != 0 || settings.gutterPx < 1 ||
        settings.gutterPx > 64)
        return foundation::Error{"atlas",
                                 "a size of " + std::to_string(size) + " with a gutter of " +
                                     std::to_string(settings.gutterPx) + " cannot be made",
                                 "use a power of two from 16 to 8192, and a gutter of 1 to 64"};
    if (charts.charts.empty())
        return foundation::Error{"atlas", "there are no faces", "give a mesh with faces"};
    std::vector<FlatChart> flats;
    for (Chart& chart : charts.charts)
        flats.push_back(turnUpright(mesh, chart));
    std::vector<glm::ivec2> corners;
    Atlas atlas;
    atlas.sizePx = size;
    atlas.texelsPerUnit = largestScale(flats, settings, corners);
    if (atlas.texelsPerUnit <= 0.0)
        return foundation::Error{"atlas",
                                 std::to_string(flats.size()) + " charts do not fit into " +
                                     std::to_string(size) + " texels a side",
                                 "use a larger size or fewer faces"};
    for (std::size_t c = 0; c < flats.size(); ++c)
        atlas.origin.push_back(glm::dvec2(corners[c]) + static_cast<double>(settings.gutterPx) -
                               atlas.texelsPerUnit * flats[c].low);
    atlas.charts = std::move(charts);
    return atlas;
}

} // namespace osgPMObjects::core
