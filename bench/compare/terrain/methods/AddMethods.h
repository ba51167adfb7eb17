// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/terrain/Chosen.h"

namespace CLI
{
class App;
}

namespace terraintool
{

/// Declares `methods`: compares all methods of level of detail. The callback sets `chosen.work`.
void addMethods(CLI::App& app, Chosen& chosen);

} // namespace terraintool
