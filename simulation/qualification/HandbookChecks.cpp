// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <foundation/Angle.h>

#include "simulation/qualification/FlightChecks.h"
#include "simulation/vehicle/StandardAtmosphere.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/flight/Aircraft.h"
#include "simulation/vehicle/flight/MassProperties.h"
#include "simulation/vehicle/flight/Trim.h"

namespace simulation
{

namespace
{

constexpr double kKnot = 1852.0 / 3600.0;
constexpr double kFootPerMinute = 0.3048 / 60.0;
constexpr double kHandbookKg = 2300.0 * 0.45359237;
constexpr double kRedlineRadps = 2700.0 * std::numbers::pi / 30.0;
constexpr double kRearLimitM = 47.3 * 0.0254; ///< behind the firewall, which is the datum of the file too
constexpr const char* kHandbook =
    "Cessna 172N Pilot's Operating Handbook, 1978, performance at 2300 lb, sea level, standard day";

/// The aircraft with a load that brings it to the handbook's weight and its centre to the rear limit, where
/// the handbook's stalls are.
AircraftData loaded(const AircraftData& aircraft)
{
    AircraftData copy = aircraft;
    std::vector<double> fuelKg;
    for (const FuelTank& tank : copy.tanks)
        fuelKg.push_back(tank.contentsKg);
    const MassProperties mass = massProperties(copy, fuelKg);
    const double loadKg = std::max(1.0, kHandbookKg - mass.massKg);
    glm::dvec3 place = mass.centre;
    place.x += (kRearLimitM - mass.centre.x) * (mass.massKg + loadKg) / loadKg;
    copy.loads.push_back({"to the handbook's weight", loadKg, place});
    return copy;
}

/// Steady flights at sea level.
class SeaLevel
{
public:
    explicit SeaLevel(const AircraftData& aircraft)
        : _aircraft(aircraft), _earth({45.0, 0.0, 0.0}), _air(WeatherAir().at(glm::dvec3(0.0), 0.0, 0.0))
    {
    }

    std::optional<TrimmedFlight> flight(double knots, std::optional<double> throttle, double flapDeg = 0.0,
                                        double bankDeg = 0.0) const
    {
        TrimTarget target;
        target.trueAirspeedMps = knots * kKnot;
        target.throttle = throttle;
        target.flapDeg = flapDeg;
        target.bankDeg = bankDeg;
        const foundation::Result<TrimmedFlight> found = trim(_aircraft, _earth, _air, target);
        return found ? std::optional<TrimmedFlight>(*found) : std::nullopt;
    }

    /// The slowest steady glide, to 0.1 kt, from 80 kt downwards.
    double stallKnots(double flapDeg) const
    {
        double knots = 80.0;
        for (const double step : {2.0, 0.5, 0.1})
            while (knots > step && flight(knots - step, 0.0, flapDeg))
                knots -= step;
        return flight(knots, 0.0, flapDeg) ? knots : std::nan("");
    }

    /// The rate of climb at a speed with the throttle open as far as the limit of the engine's speed lets it.
    /// Units: m/s.
    double climbMps(double knots) const
    {
        const auto isWithin = [](const std::optional<TrimmedFlight>& found)
        { return found && found->state.engineRadps <= kRedlineRadps; };
        std::optional<TrimmedFlight> climb = flight(knots, 1.0);
        double low = 0.5, high = 1.0;
        for (int i = 0; i < 12 && !isWithin(climb); ++i)
        {
            const double middle = 0.5 * (low + high);
            const std::optional<TrimmedFlight> found = flight(knots, middle);
            (isWithin(found) ? low : high) = middle;
            if (i == 11) climb = flight(knots, low);
        }
        return climb ? knots * kKnot * std::sin(foundation::radiansOf(climb->pathDeg)) : std::nan("");
    }

private:
    const AircraftData& _aircraft;
    EarthFrame _earth;
    AirSample _air;
};

/// The rate of a turn that is flown for five seconds. Units: °/s.
double turnRate(const AircraftData& aircraft, const SeaLevel& sea, double knots, double bankDeg)
{
    const auto turn = sea.flight(knots, std::nullopt, 0.0, bankDeg);
    if (!turn) return std::nan("");
    Aircraft flying(std::make_shared<const AircraftData>(aircraft),
                    std::make_shared<const EarthFrame>(Geodetic{45.0, 0.0, 0.0}));
    flying.place(turn->state);
    std::copy(turn->inputs.begin(), turn->inputs.end(), flying.inputs().begin());
    const double before = flying.readings().headingDeg;
    for (int i = 0; i < 600; ++i)
        flying.step(LevelGround(-1000.0), WeatherAir());
    return foundation::wrappedDeg(flying.readings().headingDeg - before) / 5.0;
}

} // namespace

QualificationChecks handbookChecks(const AircraftData& aircraft)
{
    const AircraftData heavy = loaded(aircraft);
    const SeaLevel sea(heavy);
    QualificationChecks checks;
    checks.push_back({"stall, flaps up", sea.stallKnots(0.0), "kt", 50.0, 5.0, kHandbook});
    checks.push_back({"stall, flaps down", sea.stallKnots(heavy.flaps.fullDeg), "kt", 44.0, 4.4, kHandbook});
    checks.push_back(
        {"climb at 73 kt, 2700 rpm", sea.climbMps(73.0) / kFootPerMinute, "ft/min", 770.0, 154.0, kHandbook});
    const auto glide = sea.flight(65.0, 0.0);
    checks.push_back({"glide ratio at 65 kt",
                      glide ? -1.0 / std::tan(foundation::radiansOf(glide->pathDeg)) : std::nan(""), "1", 9.1,
                      0.9, kHandbook});
    const double expected = foundation::degreesOf(foundation::kStandardGravityMps2 *
                                                  std::tan(foundation::radiansOf(30.0)) / (100.0 * kKnot));
    checks.push_back({"rate of turn at 100 kt and 30 deg of bank", turnRate(heavy, sea, 100.0, 30.0), "deg/s",
                      expected, 0.02 * expected, "g tan(bank) / V"});
    return checks;
}

} // namespace simulation
