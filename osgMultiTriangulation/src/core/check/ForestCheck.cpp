// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osgMultiTriangulation/core/check/ErrorCheck.h>
#include <osgMultiTriangulation/core/check/ForestCheck.h>
#include <osgMultiTriangulation/core/check/SurfaceCheck.h>
#include <osgMultiTriangulation/core/extract/Extraction.h>

namespace osgMultiTriangulation::core
{

namespace
{

constexpr double kRounding = 1e-6;

std::optional<std::string> checkFrame(const Extraction& extraction, const std::vector<OutlineSide>& outline,
                                      const PointCells* cells, double& worstExcess)
{
    const SurfaceMesh drawn = extraction.mesh();
    if (auto fault = checkSurface(drawn, outline)) return fault;
    if (!cells) return std::nullopt;
    std::vector<float> bounds;
    for (const InTree& at : extraction.active())
        bounds.push_back(extraction.part(at.tree).errors[at.number]);
    const double excess = cells->greatestExcess(drawn, bounds);
    worstExcess = std::max(worstExcess, excess);
    if (excess > kRounding) return "a point is " + std::to_string(excess) + " m beyond its bound";
    return std::nullopt;
}

} // namespace

std::vector<SurfacePoint> pointsOf(const Forest& forest)
{
    std::vector<SurfacePoint> points;
    for (const ForestTree& tree : forest.trees)
    {
        const std::uint32_t first = tree.parent == kNone ? 0 : tree.part.rootPoints;
        points.insert(points.end(), tree.part.points.begin() + first, tree.part.points.end());
    }
    return points;
}

ForestFlight flyOver(const Forest& forest, int frames)
{
    const std::vector<SurfacePoint> points = pointsOf(forest);
    const PointCells cells(points);
    Extraction extraction(forest.trees[0]);
    const std::vector<OutlineSide> outline = outlineOf(extraction.mesh());
    for (std::uint32_t t = 1; t < forest.trees.size(); ++t)
        extraction.attach(t, forest.trees[t]);
    SurfacePoint low = points[0], high = points[0];
    for (const SurfacePoint& p : points)
    {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.height, p.height)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.height, p.height)};
    }
    const double extent = std::hypot(high.x - low.x, high.y - low.y), relief = high.height - low.height;
    ForestFlight flight;
    for (int frame = 0; frame < frames && !flight.fault; ++frame)
    {
        const double along = (frame + 0.5) / frames;
        const double x = low.x + along * (high.x - low.x), y = low.y + along * (high.y - low.y);
        const double share = relief / extent * std::pow(0.01, along);
        extraction.update(
            [&](const MultiTriangulation& tree, std::uint32_t t)
            {
                const Triangle& c = tree.corners[t];
                double nearest = extent;
                for (const std::uint32_t corner : c)
                    nearest =
                        std::min(nearest, std::hypot(tree.points[corner].x - x, tree.points[corner].y - y));
                return tree.errors[t] > share * (nearest + 0.01 * extent);
            });
        const bool isMeasured = frame % 10 == 0 || frame + 1 == frames;
        flight.fault = checkFrame(extraction, outline, isMeasured ? &cells : nullptr, flight.worstExcessM);
        if (flight.fault) *flight.fault = "frame " + std::to_string(frame) + ": " + *flight.fault;
        flight.mostTriangles = std::max(flight.mostTriangles, extraction.active().size());
        flight.checkedFrames += isMeasured;
        ++flight.frames;
    }
    return flight;
}

} // namespace osgMultiTriangulation::core
