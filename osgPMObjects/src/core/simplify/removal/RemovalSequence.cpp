// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <numeric>

#include <osgPMObjects/core/simplify/RemovalSequence.h>

#include "../sequence/StepShare.h"

namespace osgPMObjects::core
{

const char* nameOf(RemovalRefusal refusal)
{
    switch (refusal)
    {
    case RemovalRefusal::none:
        return "none";
    case RemovalRefusal::support:
        return "support";
    case RemovalRefusal::crowdedStar:
        return "crowdedStar";
    case RemovalRefusal::nonManifold:
        return "nonManifold";
    case RemovalRefusal::seamCorner:
        return "seamCorner";
    case RemovalRefusal::folds:
        return "folds";
    case RemovalRefusal::joins:
        return "joins";
    case RemovalRefusal::isolates:
        return "isolates";
    case RemovalRefusal::lastOfMaterial:
        return "lastOfMaterial";
    }
    return "none";
}

std::span<const std::uint32_t> RemovalSequence::removedBy(std::size_t step) const
{
    return shareOf(steps, &RemovalStep::firstRemoved, removedFaces, step);
}

std::span<const Face> RemovalSequence::addedBy(std::size_t step) const
{
    return shareOf(steps, &RemovalStep::firstAdded, addedFaces, step);
}

std::size_t RemovalSequence::facesAfter(std::size_t count) const
{
    if (count >= steps.size()) return faceCount - removedFaces.size() + addedFaces.size();
    return faceCount - steps[count].firstRemoved + steps[count].firstAdded;
}

std::size_t RemovalSequence::stepsToFaces(std::size_t faces) const
{
    std::size_t low = 0, high = steps.size();
    while (low < high)
    {
        const std::size_t middle = low + (high - low) / 2;
        if (facesAfter(middle) <= faces)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

RemovalLevel meshAfter(const Mesh& mesh, const RemovalSequence& sequence, std::size_t removals)
{
    RemovalLevel level{mesh, std::min(removals, sequence.steps.size()), removals > sequence.steps.size()};
    if (level.removed == 0) return level;
    const std::size_t last = level.removed - 1;
    const auto removed = sequence.removedBy(last);
    const auto added = sequence.addedBy(last);
    std::vector<Face>& faces = level.mesh.faces;
    faces.insert(faces.end(), sequence.addedFaces.data(), added.data() + added.size());
    std::vector<bool> isGone(faces.size(), false);
    for (const std::uint32_t* face = sequence.removedFaces.data(); face != removed.data() + removed.size();
         ++face)
        isGone[*face] = true;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (!isGone[i]) faces[kept++] = faces[i];
    faces.resize(kept);
    return level;
}

} // namespace osgPMObjects::core
