// SPDX-License-Identifier: Apache-2.0
#include "FlightStarts.h"

#include <cmath>

#include <foundation/Angle.h>

namespace trainer
{

namespace
{

constexpr double kStartHeightM = 300.0, kStartSpeedMps = 50.0;
constexpr double kBehindThresholdM = 20.0; ///< where a take-off begins on its strip

/// A place beside a strip. `alongM`, `leftM`: from its threshold.
glm::dvec2 besideStrip(const StripRequest& strip, double alongM, double leftM)
{
    const double course = foundation::radiansOf(strip.courseDeg);
    const glm::dvec2 ahead(std::sin(course), std::cos(course));
    return strip.threshold + alongM * ahead + leftM * glm::dvec2(-ahead.y, ahead.x);
}

} // namespace

std::vector<FlightStart> startsOf(const FlyRequest& request)
{
    const auto& strip = request.play.terrain.strip;
    std::vector<FlightStart> starts;
    if (!request.start.empty())
        starts.push_back({"the start",
                          {request.start[0], request.start[1]},
                          request.start[2],
                          request.start[3],
                          request.start[4]});
    else if (!strip)
        starts.push_back({"the start", {0.0, 0.0}, kStartHeightM, 0.0, kStartSpeedMps});
    const glm::dvec2 middle = starts.empty() ? glm::dvec2(0.0) : starts.front().place;
    if (!strip)
    {
        starts.push_back({"high above", middle, 1500.0, 0.0, kStartSpeedMps});
        return starts;
    }
    const double course = strip->courseDeg;
    starts.push_back({"on the runway", besideStrip(*strip, kBehindThresholdM, 0.0), 0.0, course, 0.0});
    starts.push_back({"on final", besideStrip(*strip, -2500.0, 0.0), 140.0, course, 33.0});
    starts.push_back({"downwind", besideStrip(*strip, 0.5 * strip->lengthM, 1200.0), 300.0,
                      std::fmod(course + 180.0, 360.0), 45.0});
    return starts;
}

} // namespace trainer
