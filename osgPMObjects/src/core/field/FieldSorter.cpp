// SPDX-License-Identifier: Apache-2.0
#include "FieldSorter.h"

#include <algorithm>

namespace osgPMObjects::core
{

FieldSorter::FieldSorter(const Field& field) : _field(field)
{
    std::uint32_t buckets = 0;
    for (const FieldModel& model : field.models())
        for (std::uint32_t pass = 0; pass < kFieldPasses; ++pass)
        {
            _firstBucket.push_back(buckets);
            buckets += static_cast<std::uint32_t>(model.ladder->rungs.size());
        }
    _firstBucket.push_back(buckets);
    _counts.assign(buckets, 0);
}

void FieldSorter::add(std::uint32_t object, FieldPass pass, std::uint32_t rung,
                      const InstanceAttributes& instance)
{
    const std::uint32_t model = _field.objects()[object].model;
    const std::uint32_t bucket = _firstBucket[model * kFieldPasses + static_cast<std::uint32_t>(pass)] + rung;
    ++_counts[bucket];
    _shown.push_back({bucket, object, instance});
}

void FieldSorter::fill(FieldDrawList& drawList) const
{
    std::vector<std::uint32_t> next(_counts.size()), batch(_counts.size());
    std::uint32_t first = 0;
    for (std::uint32_t kind = 0; kind + 1 < _firstBucket.size(); ++kind)
    {
        FieldBatch made;
        made.model = kind / kFieldPasses;
        made.pass = static_cast<FieldPass>(kind % kFieldPasses);
        made.firstRun = static_cast<std::uint32_t>(drawList.runs.size());
        made.low.fill(1e300);
        made.high.fill(-1e300);
        for (std::uint32_t bucket = _firstBucket[kind]; bucket < _firstBucket[kind + 1]; ++bucket)
        {
            next[bucket] = first;
            batch[bucket] = static_cast<std::uint32_t>(drawList.batches.size());
            if (_counts[bucket] == 0) continue;
            const std::uint32_t rung = bucket - _firstBucket[kind];
            drawList.runs.push_back({rung, first, _counts[bucket]});
            drawList.triangles +=
                std::uint64_t{_counts[bucket]} * _field.models()[made.model].ladder->rungs[rung].faces;
            first += _counts[bucket];
        }
        made.endRun = static_cast<std::uint32_t>(drawList.runs.size());
        if (made.endRun > made.firstRun) drawList.batches.push_back(made);
    }
    drawList.instances.resize(_shown.size());
    for (const Shown& shown : _shown)
    {
        drawList.instances[next[shown.bucket]++] = shown.instance;
        FieldBatch& within = drawList.batches[batch[shown.bucket]];
        const BoundingSphere& sphere = _field.spheres()[shown.object];
        for (int axis = 0; axis < 3; ++axis)
        {
            within.low[axis] = std::min(within.low[axis], sphere.centre[axis] - sphere.radius);
            within.high[axis] = std::max(within.high[axis], sphere.centre[axis] + sphere.radius);
        }
    }
}

} // namespace osgPMObjects::core
