// SPDX-License-Identifier: Apache-2.0
#include <osgMultiTriangulation/core/split/PartSchedule.h>

namespace osgMultiTriangulation::core
{

PartSchedule::PartSchedule(const Partition& partition, const std::vector<bool>& isDone)
    : _partition(partition), _missing(partition.parts.size(), 0)
{
    for (std::uint32_t p = all(); p-- > 0;)
    {
        if (!isDone.empty() && isDone[p])
        {
            ++_done;
            continue;
        }
        for (const std::uint32_t half : partition.parts[p].halves)
            if (half != kNone && (isDone.empty() || !isDone[half])) ++_missing[p];
        if (_missing[p] == 0) _ready.push_back(p);
    }
}

std::uint32_t PartSchedule::take()
{
    if (_ready.empty()) return kNone;
    const std::uint32_t part = _ready.back();
    _ready.pop_back();
    return part;
}

void PartSchedule::finish(std::uint32_t part)
{
    ++_done;
    const std::uint32_t parent = _partition.parts[part].parent;
    if (parent != kNone && --_missing[parent] == 0) _ready.push_back(parent);
}

} // namespace osgMultiTriangulation::core
