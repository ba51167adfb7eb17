// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/DistanceChart.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <osgPMObjects/core/selection/ContinuousRule.h>

#include "compare/objects/ChartSvg.h"

namespace pmtool
{

using namespace osgPMObjects;

namespace
{

constexpr double kFarthest = 16.0, kLeastShare = 1.0 / 256.0; // at the right and the lower border
constexpr int kPoints = 96;

double xOf(double farther)
{
    return ChartBox::kLeft +
           std::log(farther) / std::log(kFarthest) * (ChartBox::kWidth - ChartBox::kLeft - ChartBox::kRight);
}

double yOf(double share)
{
    return ChartBox::kTop + std::log(std::max(share, kLeastShare)) / std::log(kLeastShare) *
                                (ChartBox::kHeight - ChartBox::kTop - ChartBox::kBottom);
}

double shareDrawn(const core::RemovalSequence& removals, double farther)
{
    const auto positions = static_cast<std::uint32_t>(removals.positionCount);
    const auto most = static_cast<std::uint32_t>(removals.steps.size());
    const std::uint32_t steps = core::removalAt(1.0, farther, positions, most).steps;
    return static_cast<double>(removals.facesAfter(steps)) / static_cast<double>(removals.faceCount);
}

} // namespace

std::string distancePanel(const std::string& title, const std::vector<DistanceLine>& lines)
{
    std::string out = svgLabel(ChartBox::kWidth / 2, 18, "middle", escaped(title), "#000000");
    for (const double share : {1.0, 0.25, 1.0 / 16, 1.0 / 64, kLeastShare})
        out +=
            svgLine(xOf(1.0), yOf(share), xOf(kFarthest), yOf(share), "#dddddd") +
            svgLabel(ChartBox::kLeft - 4, yOf(share) + 3, "end", decimals(100 * share, 1) + "%", "#000000");
    for (const double farther : {1.0, 2.0, 4.0, 8.0, 16.0})
        out += svgLabel(xOf(farther), ChartBox::kHeight - ChartBox::kBottom + 13, "middle",
                        decimals(farther, 0) + " z1", "#000000");
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        const char* colour = ChartBox::kColours[std::min(i, ChartBox::kColours.size() - 1)];
        std::vector<std::pair<double, double>> points;
        for (int p = 0; p <= kPoints; ++p)
        {
            const double farther = std::pow(kFarthest, static_cast<double>(p) / kPoints);
            points.emplace_back(xOf(farther), yOf(shareDrawn(lines[i].removals, farther)));
        }
        const double at = ChartBox::kLeft + (0.05 + 0.24 * static_cast<double>(i)) *
                                                (ChartBox::kWidth - ChartBox::kLeft - ChartBox::kRight);
        out += svgCurve(points, colour) +
               svgLabel(at, ChartBox::kHeight - 5, "start", escaped(lines[i].name), colour);
    }
    return out + svgLine(xOf(1.0), yOf(1.0), xOf(kFarthest), yOf(kLeastShare), "#999999",
                         " stroke-dasharray=\"3 3\"");
}

} // namespace pmtool
