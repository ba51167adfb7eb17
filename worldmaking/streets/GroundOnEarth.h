// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

namespace worldmaking
{

/// Returns the height of the ground at a place on the Earth, metres; nothing beyond the data.
using GroundOnEarth = std::function<std::optional<double>(double latitudeDeg, double longitudeDeg)>;

} // namespace worldmaking
