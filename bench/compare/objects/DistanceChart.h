// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <osgPMObjects/core/simplify/RemovalSequence.h>

namespace pmtool
{

/// The removals of one line of a chart.
struct DistanceLine
{
    std::string name;
    const osgPMObjects::core::RemovalSequence& removals;
};

/// Returns one panel as SVG: the share of the faces that is drawn, against the distance as a multiple of that
/// at which all are drawn, from 1 to 16. Dashed: the formula F2 = F1 (z1/z2)²; lines: the levels that the
/// continuous rule T chooses.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 5, formula 5 and figure 16.
std::string distancePanel(const std::string& title, const std::vector<DistanceLine>& lines);

} // namespace pmtool
