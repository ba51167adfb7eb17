// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include "terminal/Report.h"

namespace trainer
{

/// Measures air, sky, lamps and clouds as they are drawn, against laws and oracles, and prints a line for
/// each figure and for each goal that has none. Sound where no figure fails. Errors: no offscreen context.
foundation::Result<terminal::Report> lightReport();

} // namespace trainer
