// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <foundation/NearestOnSegment.h>

#include <osgTerrainROAM/core/features/FeatureCover.h>

namespace osgTerrainROAM::core
{

namespace
{

using Texel = std::array<float, 4>;

/// The share of a filter centred on x that lies within low … high.
float covered(float x, float width, float low, float high)
{
    return std::max(std::min(x + 0.5f * width, high) - std::max(x - 0.5f * width, low), 0.0f) / width;
}

struct Nearest
{
    float distanceM;
    bool inside;
};

/// Even-odd test by a ray to the east, and distance to the nearest edge.
Nearest nearestEdge(const Texel* edges, int count, const glm::vec2& at)
{
    float nearest2 = 1e12f;
    bool inside = false;
    for (int i = 0; i < count; ++i)
    {
        const glm::vec2 a(edges[i][0], edges[i][1]), b(edges[i][2], edges[i][3]);
        const glm::vec2 way = b - a;
        const glm::vec2 away = at - a - foundation::nearestShare(at, a, b) * way;
        nearest2 = std::min(nearest2, glm::dot(away, away));
        if ((a.y > at.y) != (b.y > at.y) && a.x + (at.y - a.y) / (b.y - a.y) * way.x > at.x) inside = !inside;
    }
    return {std::sqrt(nearest2), inside};
}

void addArea(FeatureCover& cover, const Texel& head, const Nearest& edge, float filterM)
{
    const float share =
        std::clamp(0.5f + (edge.inside ? edge.distanceM : -edge.distanceM) / filterM, 0.0f, 1.0f);
    switch (static_cast<FeatureKind>(static_cast<int>(head[1])))
    {
    case FeatureKind::field:
        for (float& crop : cover.crops)
            crop *= 1.0f - share;
        cover.crops[static_cast<std::size_t>(head[2])] += share;
        cover.shade += share * (head[3] / 63.0f - cover.shade);
        break;
    case FeatureKind::river:
        cover.river = std::max(cover.river, share);
        cover.riverEdgeM = std::min(cover.riverEdgeM, edge.inside ? -edge.distanceM : edge.distanceM);
        break;
    case FeatureKind::road:
        cover.asphalt = std::max(cover.asphalt, share);
        break;
    case FeatureKind::runway:
        cover.runway = std::max(cover.runway, share);
        break;
    }
}

void addLine(FeatureCover& cover, const Texel& ends, const Texel& style, const glm::vec2& at, float filterM)
{
    const glm::vec2 a(ends[0], ends[1]), b(ends[2], ends[3]);
    const float share = foundation::nearestShare(at, a, b);
    const float distance = glm::length(at - a - share * (b - a));
    const float part = covered(distance, filterM, -style[0], style[0]);
    const int code = static_cast<int>(style[2]);
    const bool isRiver = (code & 3) == static_cast<int>(FeatureKind::river);
    float& edge = isRiver ? cover.riverEdgeM : cover.roadEdgeM;
    edge = std::min(edge, distance - style[0]);
    float& bed = isRiver ? cover.river : ((code >> 2) & 3) == 0 ? cover.asphalt : cover.gravel;
    bed = std::max(bed, part);
}

void addStroke(FeatureCover& cover, const Texel& ends, const Texel& style, const glm::vec2& at, float filterM)
{
    if (static_cast<int>(style[1]) != FeatureCells::asphalt) return;
    const glm::vec2 a(ends[0], ends[1]), b(ends[2], ends[3]);
    const float length = glm::distance(a, b);
    const glm::vec2 along = (b - a) / length, from = at - 0.5f * (a + b);
    const float ahead = glm::dot(from, along), across = along.x * from.y - along.y * from.x;
    cover.runway = std::max(cover.runway, covered(ahead, filterM, -0.5f * length, 0.5f * length) *
                                              covered(across, filterM, -style[0], style[0]));
}

} // namespace

FeatureCover featureCover(const FeatureCells& cells, const glm::dvec2& place, double filterM)
{
    FeatureCover cover;
    const FeatureCells::Cell* cell = cells.cellAt(place);
    if (!cell) return cover;
    const auto width = static_cast<float>(std::clamp(filterM, 1e-3, 2.0 * FeatureCells::kReachM));
    const glm::vec2 at(cells.inCell(place));
    const Texel* record = cells.records.data() + cell->first;
    for (std::uint32_t i = 0; i < cell->areas; ++i)
    {
        const int edges = static_cast<int>((*record)[0]);
        addArea(cover, *record, nearestEdge(record + 2, edges, at), width);
        record += 2 + edges;
    }
    for (std::uint32_t i = 0; i < cell->lines; ++i, record += 2)
        addLine(cover, record[0], record[1], at, width);
    for (std::uint32_t i = 0; i < cell->strokes; ++i, record += 2)
        addStroke(cover, record[0], record[1], at, width);
    return cover;
}

} // namespace osgTerrainROAM::core
