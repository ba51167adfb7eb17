// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace trainer
{

/// The code of a key, as windows tell it: that of X11 (keysymdef), which OSG uses on every system. "a", "5",
/// "F1", "PageUp", "Comma". Letters are those of the lower case. Returns nothing for an unknown name.
std::optional<int> keyOf(std::string_view name);

/// The name of a key that keyOf() knows, else "key CODE".
std::string keyName(int code);

} // namespace trainer
