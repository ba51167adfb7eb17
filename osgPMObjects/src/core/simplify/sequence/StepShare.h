// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace osgPMObjects::core
{

/// Returns a step's elements of a list that all steps share: from its `first` to the next step's.
template<class Step, class Value>
std::span<const Value> shareOf(const std::vector<Step>& steps, std::uint32_t Step::*first,
                               const std::vector<Value>& values, std::size_t step)
{
    const std::size_t begin = steps[step].*first;
    const std::size_t end = step + 1 < steps.size() ? steps[step + 1].*first : values.size();
    return {values.data() + begin, end - begin};
}

} // namespace osgPMObjects::core
