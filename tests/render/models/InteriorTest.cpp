// SPDX-License-Identifier: Apache-2.0
// The inside of vehicles as it is drawn: needles where their scales have the value, mirrors, light of day, dusk and night.
#include <gtest/gtest.h>

#include <osgOffscreen/OffscreenContext>
#include <osgOffscreen/OffscreenViewer>

#include "RenderedGolden.h"
#include "RenderedView.h"
#include "scenery/models/cockpit/InstrumentParts.h"
#include "scenery/models/entities/UsualSize.h"
#include "scenery/nodes/InteriorNode.h"
#include "scenery/nodes/MirrorCamera.h"

namespace
{

using namespace scenery;
using models::EntityKind;
using models::Reading;
using models::Readings;

constexpr int kWidePx = 640, kHighPx = 360; // from the seat
constexpr double kCloseDeg = 18.0;
constexpr int kCloseWidePx = 240, kCloseHighPx = 200; // of one instrument
const glm::dvec3 kEyeOfCar(1.2, 0.36, 1.2), kEyeOfAircraft(0.45, 0.27, 1.75);

models::InteriorModel interiorOf(EntityKind kind, const glm::dvec3& eye)
{
    models::EntityShape shape;
    shape.kind = kind;
    models::setUsualSize(shape);
    return *models::makeInterior(shape, eye);
}

/// In normalised device coordinates: -1 to 1 within the mirror.
glm::dvec3 inMirror(const MirrorView& view, const glm::dvec3& world)
{
    const glm::dvec4 clip = view.projection * view.view * glm::dvec4(world, 1.0);
    return glm::dvec3(clip) / clip.w;
}

TEST(Mirrors, ShowWhatTheirNormalReflects)
{
    const auto interior = interiorOf(EntityKind::car, kEyeOfCar);
    ASSERT_EQ(interior.mirrors.size(), 3U);
    // Turned and moved somewhere: mirrors go with the vehicle.
    Pose vehicle{{1000.0, -2000.0, 30.0}, glm::dmat3({0.6, 0.8, 0.0}, {-0.8, 0.6, 0.0}, {0.0, 0.0, 1.0})};
    const glm::dvec3 eye = vehicle.worldFromBodyPoint(kEyeOfCar);
    for (const models::InteriorMirror& mirror : interior.mirrors)
    {
        const MirrorView view = mirrorView(mirror, vehicle, eye, 1e4);
        ASSERT_TRUE(view.isSeen) << mirror.name;
        const glm::dvec3 low = vehicle.worldFromBodyPoint(mirror.lowLeft),
                         right = vehicle.worldFromBodyPoint(mirror.lowRight) - low,
                         up = vehicle.worldFromBodyPoint(mirror.topLeft) - low;
        const glm::dvec3 normal = glm::normalize(glm::cross(right, up));
        for (const auto& [u, v] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.5, 0.5}, {0.2, 0.9}, {1.0, 1.0}})
        {
            const glm::dvec3 at = low + u * right + v * up;
            const glm::dvec3 seen = at + 50.0 * glm::reflect(glm::normalize(at - eye), normal);
            const glm::dvec3 shown = inMirror(view, seen);
            EXPECT_NEAR(shown.x, 1.0 - 2.0 * u, 1e-9) << mirror.name;
            EXPECT_NEAR(shown.y, 2.0 * v - 1.0, 1e-9) << mirror.name;
            EXPECT_LT(shown.z, 1.0);
        }
    }
    // From behind it shows nothing.
    EXPECT_FALSE(
        mirrorView(interior.mirrors.front(), vehicle, vehicle.worldFromBodyPoint({9.0, 0.0, 1.0}), 1e4)
            .isSeen);
}

TEST(Mirrors, OfACarShowTheRoadBehindIt)
{
    const auto interior = interiorOf(EntityKind::car, kEyeOfCar);
    const Pose vehicle;
    // A car 30 m behind in the same lane, in the inner mirror; one that overtakes on the left, in the left one; on the right, in the right one.
    const std::pair<std::size_t, glm::dvec3> cars[] = {
        {2, {-30.0, 0.0, 0.8}}, {0, {-15.0, 3.5, 0.8}}, {1, {-15.0, -3.5, 0.8}}};
    for (const auto& [mirror, car] : cars)
    {
        const glm::dvec3 shown = inMirror(mirrorView(interior.mirrors[mirror], vehicle, kEyeOfCar, 1e4), car);
        EXPECT_LT(std::abs(shown.x), 1.0) << interior.mirrors[mirror].name;
        EXPECT_LT(std::abs(shown.y), 1.0) << interior.mirrors[mirror].name;
    }
}

/// The panel of an interior straight before a camera, or the whole from its eye.
class InteriorStudio
{
public:
    InteriorStudio(EntityKind kind, const glm::dvec3& eye, int width, int height,
                   const osgTerrainROAM::AtmosphereSettings& air = {})
        : scene(air), interior(interiorOf(kind, eye)), widePx(width), highPx(height)
    {
        scene.root->addChild(interior.node());
        auto made =
            osgOffscreen::OffscreenViewer::create({.widthPx = widePx, .heightPx = highPx, .samples = 4});
        if (!made) return;
        viewer = std::move(*made);
        viewer->viewer().setSceneData(scene.root);
    }

    osg::ref_ptr<osg::Image> picture(const Pose& eye, double highDeg)
    {
        viewer->camera().setProjectionMatrixAsPerspective(highDeg, static_cast<double>(widePx) / highPx, 0.05,
                                                          2e4);
        const glm::dmat4 view = viewFromWorld(eye);
        viewer->camera().setViewMatrix(osg::Matrixd(&view[0][0]));
        return viewer->picture();
    }

    /// Where a point of the scene lies in the last picture. Units: pixels from its lower left corner.
    glm::dvec2 pixelOf(const glm::dvec3& world) const
    {
        const osg::Vec3d seen = osg::Vec3d(world.x, world.y, world.z) * viewer->camera().getViewMatrix() *
                                viewer->camera().getProjectionMatrix();
        return {0.5 * (seen.x() + 1.0) * widePx, 0.5 * (seen.y() + 1.0) * highPx};
    }

    /// Hides the part of a name, or shows it again, until the next show().
    void mask(const std::string& name, bool isShown)
    {
        for (unsigned i = 0; i < interior.node()->asGroup()->getNumChildren(); ++i)
            if (osg::Node& part = *interior.node()->asGroup()->getChild(i); part.getName() == name)
                part.setNodeMask(isShown ? ~0U : 0U);
    }

    rendered::ViewScene scene;
    InteriorNode interior;
    int widePx, highPx;
    std::unique_ptr<osgOffscreen::OffscreenViewer> viewer;
};

double levelAt(const osg::Image& image, int x, int y)
{
    const osg::Vec4 colour = image.getColor(x, y);
    return colour.r() + colour.g() + colour.b();
}

/// Where two pictures differ farthest from `middle` within `reachPx`: the mean of the last pixels of that, weighted by their difference, so
/// that it is better than a pixel's raster.
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

/// Draws the panel with an instrument at values over its scale, and returns how far the tip of its first needle is from where its
/// scale has the value, at most. `errorShare`: of the scale, by which the drawn value is wrong. Units: pixels.
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
    for (int y = static_cast<int>(wanted.y) + 20; y > static_cast<int>(wanted.y) - 20; --y)
        if (const osg::Vec4 colour = image->getColor(x + 12, y); colour.r() > colour.b() + 0.1F)
            return {y + 1.0, wanted.y};
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

Readings someFlight()
{
    Readings readings;
    readings[Reading::airspeedKt] = 92.0;
    readings[Reading::pitchDeg] = 4.0;
    readings[Reading::rollDeg] = -15.0;
    readings[Reading::altitudeFt] = 3460.0;
    readings[Reading::altimeterHpa] = 1017.0;
    readings[Reading::turnDegps] = -3.0;
    readings[Reading::slip] = 0.4;
    readings[Reading::headingDeg] = 297.0;
    readings[Reading::climbFpm] = 430.0;
    readings[Reading::engineRpm] = 2350.0;
    readings[Reading::fuelLeft] = 0.6;
    readings[Reading::fuelRight] = 0.3;
    readings[Reading::flapDeg] = 10.0;
    readings[Reading::trim] = 0.25;
    readings[Reading::propellerRadps] = 246.0;
    return readings;
}

Readings someDrive()
{
    Readings readings;
    readings[Reading::speedKmh] = 83.0;
    readings[Reading::engineRpm] = 2650.0;
    readings[Reading::gear] = 4.0;
    readings[Reading::fuel] = 0.75;
    readings[Reading::steeringWheelDeg] = 38.0;
    readings[Reading::indicatorLeft] = 1.0;
    readings[Reading::headLamps] = 1.0;
    return readings;
}

/// Somebody's view who sits in a vehicle in the light of a sun.
class Seat
{
public:
    Seat(EntityKind kind, const glm::dvec3& eye, double sunDeg)
        : _eye(eye), _isDark(sunDeg < 2.0), _studio(kind, eye, kWidePx, kHighPx, airAt(sunDeg))
    {
    }

    osg::ref_ptr<osg::Image> picture(const Readings& readings)
    {
        _studio.interior.show({}, readings, _isDark);
        const double down = std::sin(0.12), level = std::cos(0.12);
        return _studio.picture({_eye, glm::dmat3({level, 0.0, -down}, {0.0, 1.0, 0.0}, {down, 0.0, level})},
                               55.0);
    }

private:
    static osgTerrainROAM::AtmosphereSettings airAt(double sunDeg)
    {
        osgTerrainROAM::AtmosphereSettings air;
        air.sunDirectionWorld = osgTerrainROAM::sunDirectionFromAngles(120.0, sunDeg);
        return air;
    }

    glm::dvec3 _eye;
    bool _isDark;
    InteriorStudio _studio;
};

const std::string& rendererName()
{
    static const std::string kName = []
    {
        const auto context = osgOffscreen::OffscreenContext::create({.widthPx = 16, .heightPx = 16});
        return context ? (*context)->rendererName() : std::string();
    }();
    return kName;
}

TEST(Interior, LooksAsItDidByDayAtDuskAndAtNight)
{
    for (const auto& [name, sunDeg] : {std::pair{"day", 40.0}, {"dusk", 1.0}, {"night", -20.0}})
    {
        const auto cockpit = Seat(EntityKind::lightAircraft, kEyeOfAircraft, sunDeg).picture(someFlight());
        EXPECT_TRUE(rendered::matchesGolden(*cockpit, std::string("cockpit-") + name, rendererName()))
            << name;
        const auto car = Seat(EntityKind::car, kEyeOfCar, sunDeg).picture(someDrive());
        EXPECT_TRUE(rendered::matchesGolden(*car, std::string("car-interior-") + name, rendererName()))
            << name;
    }
}

/// The comparison can fail: each instrument alone, a little off, is seen.
TEST(Interior, AnInstrumentThatIsOffIsSeen)
{
    if (rendered::writesGoldens()) GTEST_SKIP() << "goldens are being written";
    Seat pilot(EntityKind::lightAircraft, kEyeOfAircraft, -20.0), driver(EntityKind::car, kEyeOfCar, -20.0);
    for (const auto& [reading, off] : {std::pair{Reading::airspeedKt, 4.0},
                                       {Reading::pitchDeg, 2.0},
                                       {Reading::rollDeg, 3.0},
                                       {Reading::altitudeFt, 30.0},
                                       {Reading::altimeterHpa, 1.0},
                                       {Reading::turnDegps, 0.6},
                                       {Reading::slip, 0.3},
                                       {Reading::headingDeg, 3.0},
                                       {Reading::climbFpm, 60.0},
                                       {Reading::engineRpm, 60.0},
                                       {Reading::fuelLeft, 0.08},
                                       {Reading::fuelRight, 0.08},
                                       {Reading::flapDeg, 3.0},
                                       {Reading::trim, 0.15}})
    {
        Readings readings = someFlight();
        readings[reading] += off;
        const auto cockpit = pilot.picture(readings);
        EXPECT_FALSE(rendered::matchesGolden(*cockpit, "cockpit-night", rendererName()))
            << static_cast<int>(reading);
    }
    for (const auto& [reading, off] : {std::pair{Reading::speedKmh, 4.0},
                                       {Reading::engineRpm, 120.0},
                                       {Reading::gear, -1.0},
                                       {Reading::fuel, 0.1},
                                       {Reading::steeringWheelDeg, 4.0},
                                       {Reading::indicatorLeft, -1.0},
                                       {Reading::indicatorRight, 1.0},
                                       {Reading::headLamps, -1.0},
                                       {Reading::handbrake, 1.0}})
    {
        Readings readings = someDrive();
        readings[reading] += off;
        const auto car = driver.picture(readings);
        EXPECT_FALSE(rendered::matchesGolden(*car, "car-interior-night", rendererName()))
            << static_cast<int>(reading);
    }
}

} // namespace
