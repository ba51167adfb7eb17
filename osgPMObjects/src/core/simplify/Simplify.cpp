// SPDX-License-Identifier: Apache-2.0
#include <thread>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "CollapseState.h"
#include "Collapser.h"
#include "PartShares.h"
#include "SequenceMerge.h"

namespace osgPMObjects::core
{

CollapseSequence simplify(const Mesh& mesh, const SimplifySettings& settings)
{
    CollapseState state(mesh, settings);
    const auto shares = partShares(state, std::thread::hardware_concurrency());
    std::vector<PartialSequence> partial(shares.size());
    parallelShares(shares.size(), 1,
                   [&](std::size_t first, std::size_t last, std::size_t)
                   {
                       for (std::size_t i = first; i < last; ++i)
                           partial[i] = Collapser(state).run(shares[i]);
                   });
    return mergedSequence(partial, state.frame, state.stars.faceCount());
}

} // namespace osgPMObjects::core
