// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace simulation
{

/// What becomes of a scenario that names a LogicFile which is not there.
enum class WithoutRoads
{
    refused, ///< but for the name of a map that another program brings along (`Town01`), which is no path
    played,
};

} // namespace simulation
