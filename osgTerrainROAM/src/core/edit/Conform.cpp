// SPDX-License-Identifier: Apache-2.0
// The ground takes the shape of a platform or a ribbon: level with its surface, and beside it a cutting or an
// embankment at a given slope down or up to the ground as it was.
#include <algorithm>
#include <cmath>
#include <shared_mutex>

#include <osgTerrainROAM/core/edit/GroundEditor.h>
#include <osgTerrainROAM/core/edit/NearestPlane.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kFarthestM = 500.0; ///< reach of cuttings and embankments

/// New height of the ground `outM` beyond an edge of height `edgeM`.
double besides(double edgeM, double outM, double slope, double groundM)
{
    return std::clamp(groundM, edgeM - slope * outM, edgeM + slope * outM);
}

/// The reach of a slope for a height, with a margin for ground that falls away.
double reachM(double heightM, double slope)
{
    return std::min(2.0 * heightM / slope + 10.0, kFarthestM);
}

/// Interpolates linearly between values along a line.
double linear(const std::vector<double>& alongM, const std::vector<double>& values, double atM)
{
    const auto next = std::upper_bound(alongM.begin() + 1, alongM.end() - 1, atM);
    const auto i = static_cast<std::size_t>(next - alongM.begin());
    const double lengthM = alongM[i] - alongM[i - 1];
    const double share = lengthM > 0.0 ? std::clamp((atM - alongM[i - 1]) / lengthM, 0.0, 1.0) : 0.0;
    return std::lerp(values[i - 1], values[i], share);
}

} // namespace

foundation::Result<EditReport> GroundEditor::conform(const Platform& platform)
{
    std::vector<glm::dvec2> corners;
    NearestPlane plane;
    double highestM = 0.0;
    for (const glm::dvec3& corner : platform.corners)
    {
        corners.emplace_back(corner);
        plane.add(corner, corner.z);
    }
    if (corners.size() < 3 || !(platform.slope > 0.0))
        return refusal("the platform has no extent or no slope", "give three corners and a slope above zero");
    plane.fit();
    for (const glm::dvec2& corner : corners)
        highestM = std::max(highestM, std::abs(plane.heightM(corner) - groundM(corner)));
    const Region region = Region::polygon(std::move(corners));
    const double flatM = 1.5 * placeM(); // then triangles across the edge are level, too
    const PlanBox box = region.box().grownBy(reachM(highestM, platform.slope) + flatM);
    return apply(
        [&](const glm::dvec2& place, double heightM)
        {
            const double outM = std::max(-region.insideM(place) - flatM, 0.0);
            return besides(plane.heightM(place), outM, platform.slope, heightM);
        },
        {&box, 1});
}

/// Weighted means of the ground over the smoothing length, at stations closer than that.
std::vector<double> GroundEditor::profile(const Ribbon& ribbon, const std::vector<double>& alongM) const
{
    const std::shared_lock lock(_tile->mutex());
    const PlanLine line(ribbon.points);
    const double stationM = std::max(std::min(0.1 * ribbon.smoothM, ribbon.widthM), 0.5);
    const double halfM = 0.5 * std::max(ribbon.smoothM, stationM);
    std::vector<double> heightsM;
    for (const double at : alongM)
    {
        double sum = 0.0, weights = 0.0;
        for (double offM = -halfM; offM <= halfM; offM += stationM)
        {
            const double weight = 1.0 + std::cos(offM / halfM * 3.14159265358979);
            sum += weight * groundM(line.at(std::clamp(at + offM, 0.0, line.lengthM())));
            weights += weight;
        }
        heightsM.push_back(sum / weights);
    }
    return heightsM;
}

foundation::Result<EditReport> GroundEditor::conform(const Ribbon& ribbon)
{
    const bool hasHeights = !ribbon.heightsM.empty();
    if (ribbon.points.size() < 2 || !(ribbon.widthM > 0.0) || !(ribbon.slope > 0.0))
        return refusal("the ribbon has no extent or no slope",
                       "give two points, a width and a slope above zero");
    if (hasHeights && ribbon.heightsM.size() != ribbon.points.size())
        return refusal("the ribbon has not as many heights as points", "give one for each point, or none");
    const PlanLine line(ribbon.points);
    std::vector<double> alongM, heightsM = ribbon.heightsM;
    for (std::size_t i = 0; hasHeights && i < line.size(); ++i)
        alongM.push_back(line.alongM(i));
    if (!hasHeights)
    {
        const int stations =
            std::max(static_cast<int>(line.lengthM() / std::max(0.1 * ribbon.smoothM, 1.0)), 1);
        for (int i = 0; i <= stations; ++i)
            alongM.push_back(line.lengthM() * i / stations);
        heightsM = profile(ribbon, alongM);
    }

    double highestM = 0.0;
    for (double at = 0.0; at <= line.lengthM(); at += std::max(placeM(), 1.0))
        highestM = std::max(highestM, std::abs(linear(alongM, heightsM, at) - groundM(line.at(at))));
    const double halfM = 0.5 * ribbon.widthM, flatM = 1.5 * placeM();
    const std::vector<PlanBox> boxes = line.boxes(halfM + flatM + reachM(highestM, ribbon.slope));
    return apply(
        [&](const glm::dvec2& place, double heightM)
        {
            const PlanLine::Foot foot = line.footOf(place);
            const double atM = linear(alongM, heightsM, foot.alongM);
            const double edgeM = atM - ribbon.crossfall * std::min(foot.distanceM, halfM);
            return besides(edgeM, std::max(foot.distanceM - halfM - flatM, 0.0), ribbon.slope, heightM);
        },
        boxes);
}

} // namespace osgTerrainROAM::core
