// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>

#include "FaceArrangement.h"
#include "Lifetimes.h"

namespace osgPMObjects::core
{

namespace
{

/// Implements Arrangement::plain.
class PlainArrangement : public FaceArrangement
{
public:
    void begin(const LevelWalk& walk, SlotTable& slots) override
    {
        const Lifetimes lifetimes(walk.split());
        std::uint32_t material = 0;
        for (std::vector<std::uint32_t>& faces : liveFacesByMaterial(walk))
        {
            std::stable_sort(faces.begin(), faces.end(),
                             [&](std::uint32_t a, std::uint32_t b)
                             { return lifetimes.end(a) > lifetimes.end(b); });
            slots.append(material++, faces, walk.faceCount());
        }
    }

    void afterStep(const LevelWalk&, SlotTable& slots) override
    {
        for (const std::uint32_t block : slots.blocksWithRemovals())
            slots.fillHoles(block); // the holes are the last slots
    }
};

} // namespace

std::unique_ptr<FaceArrangement> plainArrangement()
{
    return std::make_unique<PlainArrangement>();
}

} // namespace osgPMObjects::core
