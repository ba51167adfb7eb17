// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include <foundation/Result.h>

#include "view/Channel.h"

namespace trainer
{

/// Reads a view file. Example, with everything that can be said:
///   <View layout="tiled" nearM="0.5" farM="200000">
///     <Channel name="left" widthPx="640" heightPx="480" yawDeg="-60" pitchDeg="0" rollDeg="0"
///              xM="0" yM="0" zM="0" fovXDeg="60"/>
///     <Channel name="right" widthPx="640" heightPx="480" yawDeg="60">
///       <Frustum leftDeg="-20" rightDeg="35" bottomDeg="-15" topDeg="25"/>
///     </Channel>
///   </View>
/// layout: separate (default) or tiled. A channel has fovXDeg, fovYDeg or a Frustum; see Channel for the
/// meanings. Errors, as `file:line`: not readable, not XML, an element or attribute that is not above, a
/// number that is none or out of its range, no channel or more than 16, a name given twice, tiled channels of
/// different heights.
foundation::Result<ViewSetup> readView(const std::filesystem::path& file);

/// Reads a view from memory; `name` replaces the file in messages.
foundation::Result<ViewSetup> parseView(std::string_view text, const std::string& name);

} // namespace trainer
