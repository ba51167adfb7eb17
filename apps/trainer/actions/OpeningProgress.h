// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "view/OpeningClock.h"

namespace trainer
{

/// Makes the watch that tells on the terminal how far the opening of a scene is, and about how long the rest
/// will take.
std::shared_ptr<OpeningWatch> showOpening(const std::string& work);

} // namespace trainer
