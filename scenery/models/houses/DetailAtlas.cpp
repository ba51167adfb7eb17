// SPDX-License-Identifier: Apache-2.0
#include "scenery/models/houses/DetailAtlas.h"

namespace scenery::models
{

CellUv uvOf(Detail detail)
{
    constexpr float kInset = 0.004F; // a sixtieth of a cell: two mip-maps without colours of neighbours
    const glm::vec2 cell(static_cast<float>(static_cast<int>(detail) % kDetailColumns),
                         static_cast<float>(static_cast<int>(detail) / kDetailColumns));
    const glm::vec2 low = cell / static_cast<float>(kDetailColumns);
    return {low + kInset, low + 1.0F / kDetailColumns - kInset};
}

} // namespace scenery::models
