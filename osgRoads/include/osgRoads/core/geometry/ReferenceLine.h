// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/geometry/Cubic.h>
#include <osgRoads/core/geometry/PlanElement.h>

namespace osgRoads::core
{

/// The reference line of a road in the plan view: elements one behind the other.
class ReferenceLine
{
public:
    ReferenceLine() = default;

    /// `elements`: ascending by s, the first at 0.
    explicit ReferenceLine(std::vector<PlanElement> elements) : _elements(std::move(elements)) {}

    /// Returns the point at s. Before the start and beyond the end the line goes on as its first or last
    /// element.
    /// Errors: a line without elements is a broken contract.
    PlanPoint at(double s) const
    {
        const PlanElement& element = elementAt(s);
        return element.at(s - element.s);
    }

    const PlanElement& elementAt(double s) const
    {
        const int index = lastStartingBy(_elements, s);
        return _elements[index < 0 ? 0 : static_cast<std::size_t>(index)];
    }

    bool isEmpty() const { return _elements.empty(); }
    const std::vector<PlanElement>& elements() const { return _elements; }

private:
    std::vector<PlanElement> _elements;
};

} // namespace osgRoads::core
