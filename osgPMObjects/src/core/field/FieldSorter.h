// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/field/Field.h>
#include <osgPMObjects/core/field/FieldDrawList.h>

namespace osgPMObjects::core
{

/// Sorts the instances of one FieldDrawList by model, pass and rung, with a counting sort.
class FieldSorter
{
public:
    explicit FieldSorter(const Field& field);

    void add(std::uint32_t object, FieldPass pass, std::uint32_t rung, const InstanceAttributes& instance);

    /// Fills the draw list's instances, runs, batches and triangles.
    void fill(FieldDrawList& drawList) const;

private:
    struct Shown
    {
        std::uint32_t bucket = 0, object = 0;
        InstanceAttributes instance;
    };

    const Field& _field;
    std::vector<std::uint32_t> _firstBucket; ///< by model and pass; a bucket is a rung in a pass
    std::vector<std::uint32_t> _counts;      ///< instances by bucket
    std::vector<Shown> _shown;
};

} // namespace osgPMObjects::core
