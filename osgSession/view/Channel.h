// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "scenery/nodes/Pose.h"

namespace trainer
{

/// The field of view of a channel as angles from its viewing direction; off-axis when not symmetric. Units:
/// degrees; left and bottom are usually negative. Invariant: −89 ≤ left < right ≤ 89, likewise bottom and
/// top.
struct FrustumAngles
{
    double leftDeg = 0.0;
    double rightDeg = 0.0;
    double bottomDeg = 0.0;
    double topDeg = 0.0;
};

/// One image of the surroundings: a projector, a screen, a window pane.
/// Frame: relative to the eye point with x forward, y left, z up. The channel looks along x turned by yaw
/// (positive to the right), then pitch (positive up), then roll (positive right side down), as in the Common
/// Image Generator Interface (CIGI). Units: degrees, metres, pixels.
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

/// All channels of one eye point.
struct ViewSetup
{
    enum class Layout
    {
        separate, ///< one image per channel
        tiled     ///< all channels side by side in one image, in order from the left
    };

    Layout layout = Layout::separate;
    double nearM = 0.5;
    double farM = 200'000.0;
    std::vector<Channel> channels;
    std::vector<std::string> notes; ///< what is unusual in the view file
};

/// Returns a symmetric field of view for square pixels, from the horizontal or the vertical angle.
FrustumAngles symmetricFrustumX(double horizontalDeg, int widthPx, int heightPx);
FrustumAngles symmetricFrustumY(double verticalDeg, int widthPx, int heightPx);

/// Returns the angle of the middle part of a picture that is shown `factor` times as large.
double zoomedDeg(double verticalDeg, double factor);

inline constexpr double kPictureDeg = 40.0; ///< the height of a picture, unless something else is said

/// Returns a setup with one channel that looks straight ahead.
ViewSetup singleChannel(int widthPx, int heightPx, double verticalDeg = kPictureDeg);

/// Returns the camera pose of a channel.
scenery::Pose channelEye(const Channel& channel, const scenery::Pose& eye);

/// Returns the projection matrix of OpenGL.
glm::dmat4 channelProjection(const Channel& channel, double nearM, double farM);

/// An image to be drawn: the name and the size of its offscreen context.
struct PictureShape
{
    std::string name; ///< of its channel; "view" for a tiled image
    int widthPx = 0;
    int heightPx = 0;
};

/// Returns one image per channel, or one for all when they are tiled.
std::vector<PictureShape> picturesOf(const ViewSetup& setup);

} // namespace trainer
