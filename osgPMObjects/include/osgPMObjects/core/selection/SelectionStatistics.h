// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include <osgPMObjects/core/selection/LevelSelector.h>
#include <osgPMObjects/core/selection/SceneBudget.h>

namespace osgPMObjects::core
{

/// Counts of one method in a frame. Units: objects, except triangles.
struct MethodStatistics
{
    std::uint32_t objects = 0; ///< all objects with the method
    std::uint32_t switched = 0;
    std::uint32_t clamped = 0;
    std::uint32_t fullArea = 0;
    std::uint32_t faded = 0;     ///< drawn with an alpha below 1
    std::uint32_t gone = 0;      ///< beyond the alpha range, not drawn
    std::uint64_t triangles = 0; ///< of the chosen levels that are drawn

    void count(const Selection& selection, std::uint32_t drawnTriangles);
    MethodStatistics& operator+=(const MethodStatistics& other);
    bool operator==(const MethodStatistics&) const = default;
};

/// Counts of a frame's selection, by method.
struct SelectionStatistics
{
    std::array<MethodStatistics, kSelectionMethods> byMethod{};
    BudgetResult budget; ///< of all objects with the method `budget`

    MethodStatistics& of(SelectionMethod method) { return byMethod[static_cast<std::size_t>(method)]; }
    const MethodStatistics& of(SelectionMethod method) const
    {
        return byMethod[static_cast<std::size_t>(method)];
    }
    MethodStatistics all() const;
};

} // namespace osgPMObjects::core
