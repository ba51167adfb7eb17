// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgPMObjects/core/field/Field.h>
#include <osgPMObjects/core/field/FieldPicture.h>

namespace osgPMObjects::core
{

/// Sorts what is shown by model, pass and rung, by counting. For one picture.
class FieldSorter
{
public:
    explicit FieldSorter(const Field& field);

    void add(std::uint32_t object, FieldPass pass, std::uint32_t rung, const ShownInstance& instance);

    /// Fills in instances, runs, batches and triangles.
    void fill(FieldPicture& picture) const;

private:
    struct Shown
    {
        std::uint32_t bucket = 0, object = 0;
        ShownInstance instance;
    };

    const Field& _field;
    std::vector<std::uint32_t> _firstBucket; ///< by model and pass
    std::vector<std::uint32_t> _counts;      ///< by bucket
    std::vector<Shown> _shown;
};

} // namespace osgPMObjects::core
