// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pmtool
{

/// A line of a chart: shares of the faces and of the area, in the order of removal.
struct AreaLine
{
    std::string name;
    std::vector<std::pair<double, double>> points;
};

/// A chart of area against faces, after Sadykov & Zakharov, *Choosing the level of detail in continuous
/// simplification of polygonal objects* (2002), figure 14.
struct AreaPanel
{
    std::string title;
    std::vector<AreaLine> lines;
};

/// Returns the charts as one SVG image, two in a row. Faces run from all (right) to a hundredth (left), by
/// their logarithm; the area from the least of the panel to the most. The dashed line is at a quarter of the
/// faces.
std::string areaChart(const std::vector<AreaPanel>& panels);

} // namespace pmtool
