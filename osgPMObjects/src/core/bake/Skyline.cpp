// SPDX-License-Identifier: Apache-2.0
#include "Skyline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgPMObjects::core
{

namespace
{

/// Adds the columns that a line crosses, each from its lowest texel to above its highest.
void addLine(Silhouette& outline, glm::dvec2 a, glm::dvec2 b)
{
    if (a.x > b.x) std::swap(a, b);
    const auto columns = static_cast<int>(outline.bottom.size());
    const int first = std::clamp(static_cast<int>(std::floor(a.x)), 0, columns - 1);
    const int last = std::clamp(static_cast<int>(std::floor(b.x)), first, columns - 1);
    const auto heightAt = [&](double x)
    { return b.x > a.x ? a.y + (b.y - a.y) * std::clamp((x - a.x) / (b.x - a.x), 0.0, 1.0) : a.y; };
    for (int x = first; x <= last; ++x)
    {
        double low = heightAt(x), high = heightAt(x + 1.0);
        if (first == last) low = a.y, high = b.y;
        const auto column = static_cast<std::size_t>(x);
        outline.bottom[column] =
            std::min(outline.bottom[column], static_cast<int>(std::floor(std::min(low, high))));
        outline.top[column] =
            std::max(outline.top[column], static_cast<int>(std::floor(std::max(low, high))) + 1);
    }
}

} // namespace

Silhouette silhouetteOf(std::span<const std::array<glm::dvec2, 2>> lines, int gutter)
{
    double width = 0.0;
    for (const auto& line : lines)
        width = std::max({width, line[0].x, line[1].x});
    Silhouette bare;
    const std::size_t columns = static_cast<std::size_t>(width) + 1;
    bare.bottom.assign(columns, std::numeric_limits<int>::max() / 2);
    bare.top.assign(columns, 0);
    for (const auto& line : lines)
        addLine(bare, line[0], line[1]);
    Silhouette all;
    const auto reach = static_cast<std::size_t>(gutter);
    for (std::size_t x = 0; x < columns + 2 * reach; ++x)
    {
        const std::size_t first = x >= 2 * reach ? x - 2 * reach : 0, last = std::min(x, columns - 1);
        // A column of the box is `gutter` to the right of the bare one; columns up to `gutter` beside count.
        int bottom = bare.bottom[first], top = bare.top[first];
        for (std::size_t c = first; c <= last; ++c)
        {
            bottom = std::min(bottom, bare.bottom[c]);
            top = std::max(top, bare.top[c]);
        }
        all.bottom.push_back(bottom);
        all.top.push_back(top + 2 * gutter);
        all.height = std::max(all.height, top + 2 * gutter);
    }
    return all;
}

int Skyline::restsAt(const Silhouette& chart, int x, int most) const
{
    int y = 0;
    for (std::size_t c = 0; c < chart.bottom.size() && y < most; ++c)
        y = std::max(y, _heights[static_cast<std::size_t>(x) + c] - chart.bottom[c]);
    return y;
}

glm::ivec2 Skyline::place(const Silhouette& chart)
{
    glm::ivec2 best(-1, _size - chart.height + 1);
    const int width = static_cast<int>(chart.bottom.size());
    for (int x = 0; x + width <= _size; ++x)
        if (const int y = restsAt(chart, x, best.y); y < best.y) best = {x, y};
    if (best.x < 0) return best;
    for (std::size_t c = 0; c < chart.top.size(); ++c)
    {
        int& height = _heights[static_cast<std::size_t>(best.x) + c];
        height = std::max(height, best.y + chart.top[c]);
    }
    return best;
}

} // namespace osgPMObjects::core
