// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <foundation/Heights.h>

#include "scenery/structures/Structure.h"

namespace scenery
{

/// Where the supports of a power line stand. Frame: the scene's. Units: metres.
struct Support
{
    glm::dvec3 foot{0.0};
    glm::dvec2 along{1.0, 0.0}; ///< unit direction of the line there
    double heightM = 0.0;
};

/// Where wires hang: beside the middle of a support, and below its top.
struct WirePlace
{
    double leftM, share; ///< of the height
    bool isEarth = false;
};

/// The supports of a line: one at each of its points, more where a span would be longer than usual; as high
/// as its structure says, or higher where wires would come nearer to the ground than kClearanceM. Nothing: a
/// support has no ground.
std::vector<Support> supportsOf(const Structure& line, const foundation::HeightInPlan& ground);

/// The wires of a kind of line.
const std::vector<WirePlace>& wiresOf(StructureKind kind);

/// The place of a wire at a support.
glm::dvec3 wireAt(const Support& support, const WirePlace& wire);

inline constexpr double kClearanceM = 6.0;

} // namespace scenery
