// SPDX-License-Identifier: Apache-2.0
#include "RideRequest.h"

namespace trainer
{

bool RideRequest::hasWindow() const
{
    if (isHeadless) return false;
    if (play.window.isWanted) return true;
    const OutputRequest& output = play.output;
    return output.captureFolder.empty() && output.statsFile.empty() && output.reportFile.empty() &&
           output.motionFile.empty() && play.sound.file.empty() && play.frames.viewFile.empty() &&
           !play.frames.count && inputs.empty() && recordInputs.empty();
}

} // namespace trainer
