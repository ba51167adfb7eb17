// SPDX-License-Identifier: Apache-2.0
#include "compare/objects/ChosenLevel.h"

#include <osgPMObjects/core/selection/LevelSelector.h>

namespace pmtool
{

ChosenLevel levelShownAt(const osgPMObjects::core::LevelTable& table, double radius, double acrossPx)
{
    using namespace osgPMObjects::core;
    SelectionView view;
    view.pixelsPerTangent = view.guaranteedPixelsPerTangent = 5000.0; // a narrow view
    const SelectionSettings settings;
    SelectableObject object;
    object.sphere = {{0.0, 0.0, -2.0 * radius * view.pixelsPerTangent / acrossPx}, radius};
    object.table = &table;
    object.settings = &settings;
    const LevelSelector selector(view);
    HeldLevel held;
    const std::uint32_t steps = selector.select(object, held).steps;
    return {steps, table.faces[steps], selector.toleranceOf(object, 1.0)};
}

} // namespace pmtool
