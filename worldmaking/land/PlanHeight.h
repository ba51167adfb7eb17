// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include <glm/vec2.hpp>

namespace worldmaking
{

/// Returns the height of the ground at a place of the plane; nothing beyond it.
using PlanHeight = std::function<std::optional<double>(const glm::dvec2& plan)>;

} // namespace worldmaking
