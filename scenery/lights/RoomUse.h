// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace scenery
{

/// What a room behind a window is for: when it is lit.
enum class RoomUse : std::uint8_t
{
    dwelling,
    work,
    shop,
    unused, ///< barns, sheds, churches by night
};

} // namespace scenery
