// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "collapse/CollapseState.h"
#include "collapse/Collapser.h"
#include "collapse/PartShares.h"
#include "collapse/SequenceMerge.h"
#include "leaves/LeafCollapser.h"

namespace osgPMObjects::core
{

CollapseSequence simplify(const Mesh& mesh, const SimplifySettings& settings)
{
    CollapseState state(mesh, settings);
    // One for each material of foliage, the other parts share the rest.
    const std::size_t threads = foundation::processors();
    const auto shares = partShares(state, threads - std::min(threads, state.foliage.size()));
    std::vector<PartialSequence> partial(shares.size() + state.foliage.size());
    const auto part = [&](std::size_t i)
    {
        return i < shares.size() ? Collapser(state).run(shares[i])
                                 : LeafCollapser(state).run(std::move(state.foliage[i - shares.size()]));
    };
    parallelShares(partial.size(), 1,
                   [&](std::size_t first, std::size_t last, std::size_t)
                   {
                       for (std::size_t i = first; i < last; ++i)
                           partial[i] = part(i);
                   });
    return mergedSequence(partial, state.frame, state.stars.faceCount());
}

} // namespace osgPMObjects::core
