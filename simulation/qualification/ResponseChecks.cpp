// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "simulation/qualification/FlightChecks.h"
#include "simulation/qualification/FlightReplay.h"
#include "simulation/qualification/FreeOscillation.h"

namespace simulation
{

namespace
{

constexpr double kMixture = 0.87; ///< of all recorded flights
constexpr const char* kSource =
    "JSBSim c172p, recorded flight, replayed from its state at the window's start";

/// A recorded flight and what is judged of it.
struct ResponseCase
{
    const char* file;
    const char* name;
    FlightWindow window;
    double tolerancePercent;
    std::vector<FlightChannel> channels;
};

const std::array<ResponseCase, 6>& responseCases()
{
    using C = FlightChannel;
    static const std::array<ResponseCase, 6> cases{
        {{"elevator_doublet",
          "elevator doublet",
          {5.0, 10.0},
          10.0,
          {C::pitch, C::pitchRate, C::alpha, C::airspeed, C::climb, C::height, C::loadFactor}},
         {"phugoid",
          "phugoid",
          {5.0, 120.0},
          10.0,
          {C::pitch, C::pitchRate, C::airspeed, C::climb, C::height}},
         {"aileron_step",
          "aileron step",
          {5.0, 9.0},
          15.0,
          {C::roll, C::rollRate, C::yawRate, C::heading, C::beta}},
         {"rudder_kick",
          "rudder kick",
          {5.0, 18.0},
          15.0,
          {C::roll, C::rollRate, C::yawRate, C::heading, C::beta}},
         {"idle_glide",
          "idle glide",
          {5.0, 60.0},
          10.0,
          {C::pitch, C::airspeed, C::climb, C::height, C::rpm, C::thrust}},
         {"full_throttle",
          "full throttle",
          {5.0, 15.0},
          10.0,
          {C::pitch, C::alpha, C::airspeed, C::climb, C::height, C::loadFactor, C::rpm, C::thrust}}}};
    return cases;
}

/// RMS difference over the largest excursion of the reference from its first row, in per cent. A flight that
/// ended early is not a number.
double differencePercent(const Flight& flown, const Flight& reference, FlightChannel channel)
{
    if (flown.size() != reference.size() || flown.empty()) return std::numeric_limits<double>::quiet_NaN();
    double sum = 0.0, excursion = 0.0;
    for (std::size_t i = 0; i < flown.size(); ++i)
    {
        const double difference = flown[i][channel] - reference[i][channel];
        sum += difference * difference;
        excursion = std::max(excursion, std::abs(reference[i][channel] - reference.front()[channel]));
    }
    return 100.0 * std::sqrt(sum / static_cast<double>(flown.size())) / excursion;
}

/// The aircraft with the gyroscopic sign of the reference (docs/algorithms/flight.md).
std::shared_ptr<const AircraftData> likeReference(const AircraftData& aircraft)
{
    auto copy = std::make_shared<AircraftData>(aircraft);
    copy->propeller.gyroscopicFactor = -1.0;
    return copy;
}

foundation::Result<Flight> readCase(const std::filesystem::path& folder, const char* file)
{
    return readReferenceFlight(folder / (std::string(file) + ".csv.gz"));
}

/// An oscillation of a recorded flight, and how far ours may differ, as shares of period and damping.
struct OscillationCase
{
    const char* file;
    const char* name;
    FlightChannel channel;
    FlightWindow window;
    double periodShare, dampingShare;
};

foundation::Result<QualificationChecks>
compareOscillation(const std::shared_ptr<const AircraftData>& aircraft, const std::filesystem::path& folder,
                   const OscillationCase& one)
{
    const foundation::Result<Flight> reference = readCase(folder, one.file);
    if (!reference) return reference.error();
    const auto theirs = freeOscillation(*reference, one.channel, one.window);
    if (!theirs)
        return foundation::Error{(folder / one.file).string(), "does not oscillate", "copy the flight again"};
    const Flight flown = replay(likeReference(*aircraft), *reference, {5.0, one.window.endS}, kMixture);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const FreeOscillation own =
        freeOscillation(flown, one.channel, one.window).value_or(FreeOscillation{nan, nan});
    const std::string name = one.name;
    return QualificationChecks{
        {name + ": period", own.periodS, "s", theirs->periodS, one.periodShare * theirs->periodS, kSource},
        {name + ": damping", own.damping, "1", theirs->damping, one.dampingShare * theirs->damping, kSource}};
}

} // namespace

foundation::Result<QualificationChecks> responseChecks(const std::shared_ptr<const AircraftData>& aircraft,
                                                       const std::filesystem::path& folder)
{
    QualificationChecks checks;
    const std::shared_ptr<const AircraftData> flying = likeReference(*aircraft);
    for (const ResponseCase& one : responseCases())
    {
        const foundation::Result<Flight> reference = readCase(folder, one.file);
        if (!reference) return reference.error();
        const Flight rows = rowsOf(*reference, one.window);
        const Flight flown = replay(flying, *reference, one.window, kMixture);
        for (const FlightChannel channel : one.channels)
            checks.push_back({std::string(one.name) + ": " +
                                  std::string(kFlightChannelNames[static_cast<std::size_t>(channel)]),
                              differencePercent(flown, rows, channel), "%", 0.0, one.tolerancePercent,
                              kSource});
    }
    return checks;
}

foundation::Result<QualificationChecks> oscillationChecks(const std::shared_ptr<const AircraftData>& aircraft,
                                                          const std::filesystem::path& folder)
{
    auto phugoid = compareOscillation(
        aircraft, folder, {"phugoid", "phugoid", FlightChannel::airspeed, {10.0, 120.0}, 0.05, 0.2});
    if (!phugoid) return phugoid.error();
    auto dutchRoll = compareOscillation(
        aircraft, folder, {"rudder_kick", "Dutch roll", FlightChannel::beta, {6.0, 14.0}, 0.1, 0.25});
    if (!dutchRoll) return dutchRoll.error();
    phugoid->insert(phugoid->end(), dutchRoll->begin(), dutchRoll->end());
    return phugoid;
}

} // namespace simulation
