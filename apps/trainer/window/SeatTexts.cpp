// SPDX-License-Identifier: Apache-2.0
#include "window/SeatTexts.h"

#include <cstdio>

namespace trainer
{

namespace
{

constexpr double kToldS = 4.0; ///< how long a message stands

std::string paceText(const simulation::RealTimePace& pace, std::string_view phase)
{
    if (pace.isPaused()) return "pause";
    if (pace.rate() == 1.0) return phase == "parked" ? "parking brake on: throttle drives off" : "";
    char text[40];
    std::snprintf(text, sizeof text, "%g times real time", pace.rate());
    return text;
}

} // namespace

void SeatTexts::show(TextOverlay& overlay, double wallS, const simulation::RealTimePace& pace,
                     const PictureTimes& times, double tolerancePx, std::string_view phase) const
{
    const bool isTelling = wallS - _toldAtS < kToldS && !_told.empty();
    const std::string standing = _standing.empty() ? paceText(pace, phase) : _standing;
    overlay.setMessage(isTelling ? _told : standing.empty() ? _owner : standing);
    if (!overlay.areStatisticsShown()) return;
    char text[300];
    std::snprintf(text, sizeof text,
                  "time     %8.2f s\npicture  %8.1f ms\nmean     %8.1f ms\nworst    %8.1f ms\n"
                  "steps    %8lld\ncut      %8.2f s\nprocessor%8.1f ms\nerror    %8.2f px\n%s",
                  pace.timeS(), times.lastMs(), times.meanMs(), times.worstMs(),
                  static_cast<long long>(pace.steps()), pace.cutS(), times.meanProcessorMs(), tolerancePx,
                  std::string(phase).c_str());
    overlay.setStatistics(text);
}

void printEnd(const simulation::RealTimePace& pace, const PictureTimes& times)
{
    std::printf("shown %.2f s in %.2f s of the clock, %d pictures of %.1f ms, %.1f ms at most; %.1f ms of "
                "processor time\n",
                pace.timeS(), pace.wallS(), times.count(), times.meanMs(), times.worstMs(),
                times.meanProcessorMs());
    if (pace.cutS() > 0.0)
        std::printf("note: %.2f s were lost in pictures that took longer than a second\n", pace.cutS());
}

} // namespace trainer
