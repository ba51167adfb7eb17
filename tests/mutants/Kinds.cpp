// SPDX-License-Identifier: Apache-2.0
#include "Kinds.h"

std::vector<InputKind> inputKinds(const MutantFolders& folders)
{
    std::vector<InputKind> kinds;
    for (const auto make : {worldKinds, rideKinds, modelKinds, triangulationKinds, formatKinds})
        for (InputKind& kind : make(folders))
            kinds.push_back(std::move(kind));
    return kinds;
}
