// SPDX-License-Identifier: Apache-2.0
#include "LeafClosing.h"

#include <algorithm>
#include <array>
#include <utility>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

LeafClosing closingOf(const LeafCard& card, bool isTurned)
{
    LeafClosing closing;
    std::vector<LeafCard::Corners> faces = card.faces;
    std::uint32_t gone = 0;
    while (!faces.empty())
    {
        std::array<std::array<std::uint32_t, LeafCard::kMostCorners>, LeafCard::kMostCorners> counts{};
        LeafClosing::Step best;
        for (const LeafCard::Corners& f : faces)
            for (int c = 0; c < 3; ++c)
            {
                const std::uint8_t low = std::min(f[c], f[(c + 1) % 3]),
                                   high = std::max(f[c], f[(c + 1) % 3]);
                if (++counts[low][high] > best.faces) best = {high, low, counts[low][high]};
            }
        if (isTurned && closing.steps.empty()) std::swap(best.from, best.to);
        for (LeafCard::Corners& f : faces)
            std::replace(f.begin(), f.end(), best.from, best.to);
        std::erase_if(faces, [](const LeafCard::Corners& f) { return repeatsCorner({f[0], f[1], f[2]}); });
        closing.steps.push_back(best);
        gone |= 1u << best.from;
    }
    for (std::size_t c = 0; c < card.corners.size(); ++c)
        if ((gone >> c & 1u) == 0) closing.left.push_back(static_cast<std::uint8_t>(c));
    return closing;
}

} // namespace osgPMObjects::core
