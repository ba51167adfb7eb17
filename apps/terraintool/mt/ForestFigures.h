// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include <osgMultiTriangulation/core/split/BuildForest.h>

namespace terraintool
{

/// Adds what the build of a forest came to, to a row of a table.
inline void addForestFigures(nlohmann::ordered_json& row,
                             const osgMultiTriangulation::core::ForestReport& built)
{
    row["trees"] = built.trees;
    row["rectangles"] = built.rectangles;
    row["largestTree"] = built.largestTree;
    row["smallestTree"] = built.smallestTree;
    row["mainPart"] = built.mainPart;
    row["borderPoints"] = built.borderPoints;
}

} // namespace terraintool
