// SPDX-License-Identifier: Apache-2.0
// The ball of an attitude indicator: it turns as the Earth does seen from the aircraft, behind a ring that
// leaves its middle in sight, and before a fixed aeroplane.
#include <cmath>
#include <numbers>

#include <foundation/Angle.h>
#include <glm/gtc/matrix_transform.hpp>

#include "scenery/models/cockpit/InstrumentParts.h"
#include "scenery/models/roads/RoadModelParts.h"

namespace scenery::models
{

namespace
{

constexpr double kBallShare = 1.45; ///< radius of the ball over that of the instrument
constexpr int kMeridians = 48, kParallels = 24, kRingSides = 40;
const glm::vec3 kRing(0.09F, 0.09F, 0.10F), kBird(1.0F, 0.62F, 0.1F);

Model ballModel(double radiusM)
{
    const InstrumentCell cell = cellOf(Instrument::attitude);
    ModelBuilder builder;
    builder.begin("ball", kInstrumentSurface);
    std::vector<std::vector<Corner>> rows;
    for (int p = 0; p <= kParallels; ++p)
    {
        const double up = std::numbers::pi * (static_cast<double>(p) / kParallels - 0.5);
        std::vector<Corner>& row = rows.emplace_back();
        for (int m = 0; m <= kMeridians; ++m)
        {
            const double aside = 2.0 * std::numbers::pi * (m % kMeridians) / kMeridians;
            const glm::dvec3 out(std::cos(up) * std::sin(aside), std::sin(up),
                                 std::cos(up) * std::cos(aside));
            row.push_back({radiusM * out, cell.uvAt({std::sin(aside), up / (0.5 * std::numbers::pi)}), out});
        }
    }
    builder.grid(rows);
    return builder.finish();
}

/// From the ball's edge to the rim of the instrument, `liftM` before the panel.
Model ringModel(double radiusM, double liftM)
{
    ModelBuilder builder;
    builder.begin("ring", kPlain, kRing);
    std::vector<std::vector<Corner>> rows;
    for (const auto& [share, up] : {std::pair{1.14, 0.0}, {1.12, liftM}, {0.90, liftM}, {0.86, 0.3 * liftM}})
    {
        std::vector<Corner>& row = rows.emplace_back();
        for (int i = 0; i <= kRingSides; ++i)
        {
            const double turn = -2.0 * std::numbers::pi * (i % kRingSides) / kRingSides;
            row.push_back(
                {{share * radiusM * std::sin(turn), share * radiusM * std::cos(turn), up}, plainUv()});
        }
    }
    builder.grid(rows);
    return builder.finish(30.0);
}

Model birdModel(double radiusM)
{
    ModelBuilder builder;
    builder.begin("aeroplane", kPlain, kBird);
    const auto rectangle = [&](double x0, double y0, double x1, double y1)
    {
        const auto at = [&](double x, double y) {
            return Corner{{radiusM * x, radiusM * y, 0.0}, plainUv(), {0.0F, 0.0F, 1.0F}};
        };
        builder.quad(at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1));
    };
    rectangle(-0.60, -0.025, -0.22, 0.025);
    rectangle(0.22, -0.025, 0.60, 0.025);
    rectangle(-0.03, -0.03, 0.03, 0.03);
    return builder.finish();
}

} // namespace

glm::dmat4 attitudeTurn(double pitchDeg, double rollDeg)
{
    const glm::dmat4 rolled = glm::rotate(
        glm::dmat4(1.0), foundation::radiansOf(std::isfinite(rollDeg) ? rollDeg : 0.0), {0.0, 0.0, 1.0});
    return glm::rotate(rolled, foundation::radiansOf(std::isfinite(pitchDeg) ? pitchDeg : 0.0),
                       {1.0, 0.0, 0.0});
}

void addAttitude(InteriorModel& interior, const PlacedInstrument& placed, const glm::dmat4& entityFromDial)
{
    const double radiusM = kBallShare * placed.radiusM;
    // The ball comes through the panel within 0.9 of the instrument's radius.
    const double capM = radiusM - std::sqrt(radiusM * radiusM - 0.81 * placed.radiusM * placed.radiusM);
    const glm::dmat4 middle = glm::translate(entityFromDial, {0.0, 0.0, capM - radiusM});
    interior.parts.push_back(
        {"attitude ball", ballModel(radiusM), InteriorCoat::dial, [=](const Readings& readings) {
             return middle * attitudeTurn(readings[Reading::pitchDeg], readings[Reading::rollDeg]);
         }});
    interior.parts.push_back({"attitude ring", ringModel(placed.radiusM, 0.008), InteriorCoat::inside,
                              [=](const Readings&) { return entityFromDial; }});
    interior.parts.push_back(
        {"attitude aeroplane", birdModel(placed.radiusM), InteriorCoat::dial, [=](const Readings&) {
             return glm::translate(entityFromDial, {0.0, 0.0, capM + kHandLiftM});
         }});
}

} // namespace scenery::models
