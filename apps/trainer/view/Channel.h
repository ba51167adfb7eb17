// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scenery/nodes/Pose.h"

namespace trainer
{

/// The edges of what a channel shows, as angles from the direction it looks in. Off the axis when they are not
/// symmetrical. Units: degrees; left and bottom are usually negative. Invariant: −89 ≤ left < right ≤ 89, likewise
/// bottom and top.
struct FrustumAngles
{
    double leftDeg = 0.0;
    double rightDeg = 0.0;
    double bottomDeg = 0.0;
    double topDeg = 0.0;
};

/// One picture of the surroundings: a projector, a screen, a window pane.
/// Frame: relative to the eye point, whose axes are x forward, y left, z up. The channel looks along x turned by yaw
/// (positive to the right), then pitch (positive up), then roll (positive right side down), as a host of image
/// generators says it (CIGI). Units: degrees, metres, pixels.
struct Channel
{
    std::string name;
    int widthPx = 0;
    int heightPx = 0;
    double yawDeg = 0.0;
    double pitchDeg = 0.0;
    double rollDeg = 0.0;
    glm::dvec3 positionM{0.0};
    FrustumAngles frustum;
};

/// All that is seen from one eye point.
struct ViewSetup
{
    enum class Layout
    {
        separate, ///< one picture per channel
        tiled     ///< all channels side by side in one picture, in their order from the left
    };

    Layout layout = Layout::separate;
    double nearM = 0.5;
    double farM = 200'000.0;
    std::vector<Channel> channels;
};

/// Symmetrical edges for square pixels, from the horizontal or the vertical field of view.
FrustumAngles symmetricFrustumX(double horizontalDeg, int widthPx, int heightPx);
FrustumAngles symmetricFrustumY(double verticalDeg, int widthPx, int heightPx);

/// One channel that looks straight ahead.
ViewSetup singleChannel(int widthPx, int heightPx, double verticalDeg = 40.0);

/// The channel's own eye.
scenery::Pose channelEye(const Channel& channel, const scenery::Pose& eye);

/// OpenGL's projection matrix.
glm::dmat4 channelProjection(const Channel& channel, double nearM, double farM);

/// A picture to be drawn: a window or an offscreen context of that size.
struct PictureShape
{
    std::string name; ///< of its channel; "view" for a tiled picture
    int widthPx = 0;
    int heightPx = 0;
};

/// One per channel, or one for all when they are tiled.
std::vector<PictureShape> picturesOf(const ViewSetup& setup);

} // namespace trainer
