// SPDX-License-Identifier: Apache-2.0
// Instruments as they are drawn: needles where their scales have the value, the ball at its pitch.
#include <gtest/gtest.h>

#include "InteriorStudio.h"
#include "scenery/models/cockpit/InstrumentParts.h"

namespace
{

using namespace scenery;
using models::EntityKind;
using models::Reading;
using models::Readings;
using seat::InteriorStudio;
using seat::kEyeOfAircraft;
using seat::kEyeOfCar;

constexpr double kCloseDeg = 18.0;
constexpr int kCloseWidePx = 240, kCloseHighPx = 200; // of one instrument

double levelAt(const osg::Image& image, int x, int y)
{
    const osg::Vec4 colour = image.getColor(x, y);
    return colour.r() + colour.g() + colour.b();
}

/// Where two pictures differ farthest from `middle` within `reachPx`: the mean of the last pixels of that,
/// weighted by their difference, so that it is better than a pixel's raster.
glm::dvec2 farthestDifference(const osg::Image& a, const osg::Image& b, const glm::dvec2& middle,
                              double reachPx)
{
    constexpr double kDiffers = 0.25, kTipPx = 4.0;
    const auto each = [&](const auto& use)
    {
        for (int y = 0; y < a.t(); ++y)
            for (int x = 0; x < a.s(); ++x)
                if (const glm::dvec2 at(x + 0.5, y + 0.5); glm::distance(at, middle) <= reachPx)
                    use(at, std::abs(levelAt(a, x, y) - levelAt(b, x, y)));
    };
    glm::dvec2 farthest = middle, sum(0.0);
    each(
        [&](const glm::dvec2& at, double difference)
        {
            if (difference >= kDiffers && glm::distance(at, middle) >= glm::distance(farthest, middle))
                farthest = at;
        });
    double weight = 0.0;
    each(
        [&](const glm::dvec2& at, double difference)
        {
            if (glm::distance(at, farthest) > kTipPx) return;
            sum += difference * at;
            weight += difference;
        });
    return weight > 0.0 ? sum / weight : middle;
}

/// Draws the panel with an instrument at values over its scale, and returns how far the tip of its first
/// needle is from where its scale has the value, at most. `errorShare`: of the scale, by which the drawn
/// value is wrong. Units: pixels.
double worstTipPx(InteriorStudio& studio, const glm::dvec3& eye, double panelXM,
                  const models::PlacedInstrument& placed, std::initializer_list<double> shares,
                  double errorShare)
{
    const models::Dial& dial = models::dialOf(placed.instrument);
    const models::DialHand& hand = dial.hands.front();
    const double least = hand.scale.front().value, most = hand.motion == models::DialMotion::round
                                                              ? hand.scale[1].value
                                                              : hand.scale.back().value;
    const glm::dvec3 dialAt = eye + glm::dvec3(panelXM, -placed.middle.x, placed.middle.y);
    const Pose camera{dialAt - glm::dvec3(0.30, 0.0, 0.0), glm::dmat3(1.0)};
    double worstPx = 0.0;
    for (const double share : shares)
    {
        Readings readings;
        readings[hand.reading] = least + (share + errorShare) * (most - least);
        studio.interior.show({}, readings, true);
        studio.mask("steering wheel", false);
        const std::string name = std::string(dial.label) + " hand";
        const auto with = studio.picture(camera, kCloseDeg);
        studio.mask(name, false);
        const auto without = studio.picture(camera, kCloseDeg);
        const glm::dvec3 tip = models::needleTip(hand, placed.radiusM, least + share * (most - least));
        const glm::dvec2 wanted = studio.pixelOf(dialAt + glm::dvec3(-tip.z, -tip.x, tip.y)),
                         middle = studio.pixelOf(dialAt),
                         rim = studio.pixelOf(dialAt + glm::dvec3(0.0, 0.0, placed.radiusM));
        const glm::dvec2 found = farthestDifference(*with, *without, middle, glm::distance(rim, middle));
        // Across the needle: its tip is a point that fades into the face.
        const glm::dvec2 along = glm::normalize(wanted - middle), off = found - middle;
        worstPx = std::max(worstPx, std::abs(along.x * off.y - along.y * off.x));
        if (glm::dot(along, off) < 0.8 * glm::distance(wanted, middle)) worstPx = std::max(worstPx, 99.0);
    }
    return worstPx;
}

/// A pixel of a panel seen from 30 cm is half a millimetre; from the seat it is a whole one.
TEST(Instruments, NeedlesAreDrawnWithinAPixelOfTheirScale)
{
    struct Case
    {
        EntityKind kind;
        glm::dvec3 eye;
        double panelXM;
        std::span<const models::PlacedInstrument> panel;
    };
    for (const Case& of : {Case{EntityKind::lightAircraft, kEyeOfAircraft, 0.64, models::aircraftPanel()},
                           Case{EntityKind::car, kEyeOfCar, 0.66, models::carPanel()}})
    {
        InteriorStudio studio(of.kind, of.eye, kCloseWidePx, kCloseHighPx);
        ASSERT_TRUE(studio.viewer);
        for (const models::PlacedInstrument& placed : of.panel)
        {
            if (placed.instrument >= models::Instrument::dials) continue;
            if (models::dialOf(placed.instrument).hands.front().shape != models::DialHand::Shape::needle)
                continue;
            const std::string_view label = models::dialOf(placed.instrument).label;
            EXPECT_LT(
                worstTipPx(studio, of.eye, of.panelXM, placed, {0.0, 0.13, 0.3, 0.5, 0.72, 0.9, 1.0}, 0.0),
                1.0)
                << label;
            // The control: a value that is wrong by three hundredths of the scale.
            EXPECT_GT(worstTipPx(studio, of.eye, of.panelXM, placed, {0.3}, 0.03), 1.0) << label;
        }
    }
}

/// The height of the horizon in the middle of the attitude indicator, and where it should be. Units: pixels.
std::pair<double, double> horizonPx(InteriorStudio& studio, double pitchDeg)
{
    const models::PlacedInstrument placed = models::aircraftPanel()[1];
    const glm::dvec3 dialAt = kEyeOfAircraft + glm::dvec3(0.64, -placed.middle.x, placed.middle.y);
    Readings readings;
    readings[Reading::pitchDeg] = pitchDeg;
    studio.interior.show({}, readings, true);
    studio.mask("attitude aeroplane", false);
    const auto image = studio.picture({dialAt - glm::dvec3(0.30, 0.0, 0.0), glm::dmat3(1.0)}, kCloseDeg);
    const double radiusM = 1.45 * placed.radiusM,
                 capM = radiusM - std::sqrt(radiusM * radiusM - 0.81 * placed.radiusM * placed.radiusM);
    const glm::dvec3 on = models::attitudeTurn(pitchDeg, 0.0) * glm::dvec4(0.0, 0.0, radiusM, 0.0);
    const glm::dvec2 wanted = studio.pixelOf(dialAt + glm::dvec3(-(on.z + capM - radiusM), -on.x, on.y));
    const int x = static_cast<int>(wanted.x);
    const auto isBrown = [&](int y)
    {
        const osg::Vec4 colour = image->getColor(x + 12, y);
        return colour.r() > colour.b() + 0.1F;
    };
    for (int y = static_cast<int>(wanted.y) + 20; y > static_cast<int>(wanted.y) - 20; --y)
        if (isBrown(y) && isBrown(y - 5)) return {y + 1.0, wanted.y}; // a cream pitch line is 3 px wide
    return {-1.0, wanted.y};
}

TEST(Instruments, TheBallShowsThePitchWithinAPixel)
{
    InteriorStudio studio(EntityKind::lightAircraft, kEyeOfAircraft, kCloseWidePx, kCloseHighPx);
    ASSERT_TRUE(studio.viewer);
    for (const double pitchDeg : {-20.0, -7.0, 0.0, 3.0, 12.0, 25.0})
    {
        const auto [found, wanted] = horizonPx(studio, pitchDeg);
        EXPECT_NEAR(found, wanted, 2.0) << pitchDeg; // the lower edge of a line that is 2 px wide
    }
}

} // namespace
