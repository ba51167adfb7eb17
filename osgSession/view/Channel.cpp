// SPDX-License-Identifier: Apache-2.0
#include "view/Channel.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

namespace trainer
{

namespace
{

/// Returns the half angle of the other axis for square pixels.
double scaledHalfDeg(double halfDeg, double scale)
{
    return foundation::degreesOf(std::atan(std::tan(foundation::radiansOf(halfDeg)) * scale));
}

} // namespace

FrustumAngles symmetricFrustumX(double horizontalDeg, int widthPx, int heightPx)
{
    const double x = 0.5 * horizontalDeg;
    const double y = scaledHalfDeg(x, static_cast<double>(heightPx) / widthPx);
    return {-x, x, -y, y};
}

FrustumAngles symmetricFrustumY(double verticalDeg, int widthPx, int heightPx)
{
    const double y = 0.5 * verticalDeg;
    const double x = scaledHalfDeg(y, static_cast<double>(widthPx) / heightPx);
    return {-x, x, -y, y};
}

double zoomedDeg(double verticalDeg, double factor)
{
    if (factor == 1.0) return verticalDeg; // to the last bit
    return 2.0 * scaledHalfDeg(0.5 * verticalDeg, 1.0 / factor);
}

ViewSetup singleChannel(int widthPx, int heightPx, double verticalDeg)
{
    Channel channel;
    channel.name = "view";
    channel.widthPx = widthPx;
    channel.heightPx = heightPx;
    channel.frustum = symmetricFrustumY(verticalDeg, widthPx, heightPx);
    ViewSetup setup;
    setup.channels.push_back(channel);
    return setup;
}

scenery::Pose channelEye(const Channel& channel, const scenery::Pose& eye)
{
    // To the right is negative about z (up), upwards negative about y (left), right side down positive about
    // x.
    const double cy = std::cos(foundation::radiansOf(-channel.yawDeg));
    const double sy = std::sin(foundation::radiansOf(-channel.yawDeg));
    const double cp = std::cos(foundation::radiansOf(-channel.pitchDeg));
    const double sp = std::sin(foundation::radiansOf(-channel.pitchDeg));
    const double cr = std::cos(foundation::radiansOf(channel.rollDeg));
    const double sr = std::sin(foundation::radiansOf(channel.rollDeg));
    const glm::dmat3 yaw(cy, sy, 0.0, -sy, cy, 0.0, 0.0, 0.0, 1.0);
    const glm::dmat3 pitch(cp, 0.0, -sp, 0.0, 1.0, 0.0, sp, 0.0, cp);
    const glm::dmat3 roll(1.0, 0.0, 0.0, 0.0, cr, sr, 0.0, -sr, cr);
    return {eye.worldFromBodyPoint(channel.positionM), eye.worldFromBody * yaw * pitch * roll};
}

glm::dmat4 channelProjection(const Channel& channel, double nearM, double farM)
{
    const double left = std::tan(foundation::radiansOf(channel.frustum.leftDeg));
    const double right = std::tan(foundation::radiansOf(channel.frustum.rightDeg));
    const double bottom = std::tan(foundation::radiansOf(channel.frustum.bottomDeg));
    const double top = std::tan(foundation::radiansOf(channel.frustum.topDeg));
    glm::dmat4 projection(0.0);
    projection[0][0] = 2.0 / (right - left);
    projection[1][1] = 2.0 / (top - bottom);
    projection[2][0] = (right + left) / (right - left);
    projection[2][1] = (top + bottom) / (top - bottom);
    projection[2][2] = -(farM + nearM) / (farM - nearM);
    projection[2][3] = -1.0;
    projection[3][2] = -2.0 * farM * nearM / (farM - nearM);
    return projection;
}

std::vector<PictureShape> picturesOf(const ViewSetup& setup)
{
    std::vector<PictureShape> pictures;
    for (const Channel& channel : setup.channels)
    {
        if (setup.layout == ViewSetup::Layout::separate || pictures.empty())
        {
            const bool isTiled = setup.layout == ViewSetup::Layout::tiled;
            pictures.push_back({isTiled ? "view" : channel.name, channel.widthPx, channel.heightPx});
            continue;
        }
        pictures.front().widthPx += channel.widthPx;
        pictures.front().heightPx = std::max(pictures.front().heightPx, channel.heightPx);
    }
    return pictures;
}

} // namespace trainer
