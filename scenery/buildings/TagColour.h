// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include <glm/vec3.hpp>

namespace scenery
{

/// Reads a colour of a map: #rgb, #rrggbb, or one of some forty names of CSS. Nothing: another text. Units:
/// display values 0 … 1.
std::optional<glm::vec3> colourOfTag(std::string_view text);

} // namespace scenery
