// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/terrain/Chosen.h"

namespace CLI
{
class App;
}

namespace terraintool
{

/// Declares `drivers`: measures the drivers of refinement. The callback sets `chosen.work`.
void addDrivers(CLI::App& app, Chosen& chosen);

} // namespace terraintool
