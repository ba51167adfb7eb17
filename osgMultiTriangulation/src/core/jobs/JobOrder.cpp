// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgMultiTriangulation/core/jobs/JobOrder.h>

namespace osgMultiTriangulation::core
{

JobOrder jobOrder(const Partition& partition)
{
    const auto count = static_cast<std::uint32_t>(partition.parts.size());
    std::vector<std::uint32_t> stepOf(count, 0);
    for (std::uint32_t p = count; p-- > 1;)
    {
        std::uint32_t& above = stepOf[partition.parts[p].parent];
        above = std::max(above, stepOf[p] + 1);
    }
    JobOrder order;
    order.jobOf.resize(count);
    for (std::uint32_t step = 0; count > 0 && step <= stepOf[0]; ++step)
    {
        const auto first = static_cast<std::uint32_t>(order.partOf.size());
        for (std::uint32_t p = 0; p < count; ++p)
        {
            if (stepOf[p] != step) continue;
            order.jobOf[p] = static_cast<std::uint32_t>(order.partOf.size());
            order.partOf.push_back(p);
        }
        order.steps.push_back({first, static_cast<std::uint32_t>(order.partOf.size()) - first});
    }
    return order;
}

} // namespace osgMultiTriangulation::core
