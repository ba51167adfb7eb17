// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/AircraftHull.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/vehicle/road/HullMeeting.h"
#include "simulation/vehicle/road/HullWater.h"

namespace simulation
{

namespace
{

/// From the axes of a hull (forward, left, up) to those of flight (forward, right, down), and back.
const glm::dquat kHalfRoll(0.0, 1.0, 0.0, 0.0);

SolidMotion solidOf(const BodyMotion& motion, const glm::dvec3& earthRate)
{
    return {motion.position, motion.attitude * kHalfRoll, motion.velocity,
            motion.attitude * motion.rates - earthRate};
}

RoadMassProperties solidMass(const MassProperties& mass)
{
    return {mass.massKg, hullPlace(mass.centre),
            glm::dvec3(mass.inertia[0][0], mass.inertia[1][1], mass.inertia[2][2])};
}

} // namespace

HullData hullOfMeasures(const AircraftData& aircraft)
{
    constexpr double kThicknessShare = 0.12, kBodyShare = 0.1; // of the chord, of the span
    const double span = aircraft.wingSpanM, chord = aircraft.meanChordM;
    double foremost = std::min(aircraft.propeller.place.x, aircraft.aerodynamicPoint.x - chord);
    double rearmost = aircraft.aerodynamicPoint.x + 2.0 * chord;
    for (const ContactData& contact : aircraft.contacts)
        if (!contact.isWheel) rearmost = std::max(rearmost, contact.place.x);
    foremost = std::min(foremost, rearmost - chord);
    const glm::dvec3 middle(0.5 * (foremost + rearmost), aircraft.empty.place.y, aircraft.empty.place.z);
    const double thick = std::max(0.1, kThicknessShare * chord), body = std::max(0.1, kBodyShare * span);
    HullData hull;
    hull.friction = 0.5;
    hull.crashesAtMps = 3.0;
    hull.boxes = {{"body", {rearmost - foremost, body, body}, hullPlace(middle)},
                  {"wing", {chord, span, thick}, hullPlace(aircraft.aerodynamicPoint)}};
    return hull;
}

/// The world of bodies is made when it is needed first, and anew when fuel has moved the centre of mass.
struct AircraftHull::Parts
{
    HullMeeting meeting;
    std::shared_ptr<BodyWorld> world;
    RoadMassProperties solid;
    int body = 0;

    void fit(const AircraftData& aircraft, const MassProperties& mass)
    {
        constexpr double kSameKg = 2.0;
        if (world && std::abs(solid.massKg - mass.massKg) < kSameKg) return;
        world = std::make_shared<BodyWorld>();
        solid = solidMass(mass);
        body = world->add(solid, aircraft.hull);
        world->setGravity(body, glm::dvec3(0.0)); // forces act before contacts do
        meeting.setBody({world, body, &aircraft.hull, solid.centre, solid.massKg});
    }
};

AircraftHull::AircraftHull(std::shared_ptr<const AircraftData> aircraft)
    : _aircraft(std::move(aircraft)), _parts(std::make_unique<Parts>())
{
}

AircraftHull::~AircraftHull() = default;
AircraftHull::AircraftHull(AircraftHull&&) noexcept = default;
AircraftHull& AircraftHull::operator=(AircraftHull&&) noexcept = default;

void AircraftHull::meet(std::shared_ptr<const ObstacleMap> obstacles)
{
    _parts->world.reset(); // things of another map stand in it
    _parts->meeting.obstacles().meet(std::move(obstacles));
}

void AircraftHull::meetMovers(std::span<const MovingObstacle> movers)
{
    _parts->meeting.obstacles().meetMovers(movers);
}

std::span<const int> AircraftHull::touchedMovers() const
{
    return _parts->meeting.touchedMovers();
}

std::span<const Impact> AircraftHull::impacts() const
{
    return _parts->meeting.obstacles().impacts();
}

void AircraftHull::forget()
{
    _parts->meeting.obstacles().forget();
    _parts->world.reset();
    _airShare = 1.0;
}

bool AircraftHull::isNear() const
{
    return _parts->meeting.isNear();
}

bool AircraftHull::hasMovers() const
{
    return _parts->meeting.hasMovers();
}

void AircraftHull::look(BodyMotion& motion, const MassProperties& mass, const glm::dvec3& earthRate,
                        double timeS, double stepS)
{
    HullMeeting& meeting = _parts->meeting;
    if (!meeting.obstacles().hasMap() && meeting.obstacles().movers().empty() && !meeting.hasMovers()) return;
    _parts->fit(*_aircraft, mass);
    const SolidMotion solid = solidOf(motion, earthRate);
    _parts->world->place(_parts->body, solid);
    if (!meeting.look(solid, timeS, stepS)) return;
    const SolidMotion struck = _parts->world->motion(_parts->body);
    if (struck.velocity == solid.velocity && struck.rates == solid.rates) return;
    motion.velocity = struck.velocity;
    motion.rates = glm::conjugate(motion.attitude) * (struck.rates + earthRate);
}

std::optional<std::uint32_t> AircraftHull::inPropeller(const BodyMotion& motion,
                                                       const MassProperties& mass) const
{
    constexpr double kThickM = 0.15;
    const ObstacleMeeting& obstacles = _parts->meeting.obstacles();
    if (!obstacles.hasMap()) return std::nullopt;
    const double across = _aircraft->propeller.diameterM;
    const HullBox disc{"propeller", {kThickM, across, across}, hullPlace(_aircraft->propeller.place)};
    const HullPlan plan = hullPlanOf(disc, hullPlace(mass.centre), solidOf(motion, glm::dvec3(0.0)));
    for (const std::span<const std::uint32_t> things : {obstacles.fast(), obstacles.giving()})
        for (const std::uint32_t number : things)
            if (obstacles.map().at(number).kind != ObstacleKind::hedge &&
                overlaps(plan, obstacles.map().at(number)))
                return number;
    return std::nullopt;
}

void AircraftHull::layGround(const BodyMotion& motion, const MassProperties& mass, const Ground& ground)
{
    _parts->fit(*_aircraft, mass);
    _parts->world->place(_parts->body, solidOf(motion, glm::dvec3(0.0)));
    double reachM = 1.0;
    for (const HullBox& box : _aircraft->hull.boxes)
        reachM =
            std::max(reachM, glm::length(box.place - _parts->solid.centre) + 0.5 * glm::length(box.sizeM));
    _parts->world->layGround(_parts->body, ground, reachM + 1.0);
}

double AircraftHull::deepestM(const BodyMotion& motion, const MassProperties& mass,
                              const Ground& ground) const
{
    const SolidMotion solid = solidOf(motion, glm::dvec3(0.0));
    std::vector<glm::dvec3> corners;
    for (const HullBox& box : _aircraft->hull.boxes)
        for (const double x : {-0.5, 0.5})
            for (const double y : {-0.5, 0.5})
                for (const double z : {-0.5, 0.5})
                    corners.push_back(solid.position +
                                      solid.bodyToScene * (box.place - hullPlace(mass.centre) +
                                                           box.sizeM * glm::dvec3(x, y, z)));
    std::vector<GroundPoint> below(corners.size());
    ground.heightsBelow(corners, below);
    double deepest = -1e9;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (below[i].isKnown) deepest = std::max(deepest, below[i].heightM - corners[i].z);
    return deepest;
}

HullContact AircraftHull::resolve(const BodyMotion& before, BodyMotion& motion, const MassProperties& mass,
                                  const glm::dvec3& earthRate, double timeS, double stepS)
{
    _parts->fit(*_aircraft, mass);
    BodyMotion moved = motion;
    moved.position = before.position;
    moved.attitude = before.attitude;
    SolidMotion solid = solidOf(moved, earthRate);
    solid.rates = motion.attitude * motion.rates - earthRate;
    _parts->world->place(_parts->body, solid);
    _parts->world->step(stepS);
    const SolidHit hit = _parts->world->hit(_parts->body);
    if (!hit.touches && hit.closingMps <= 0.0) return {};
    const SolidMotion after = _parts->world->motion(_parts->body);
    motion.position = after.position;
    motion.attitude = glm::normalize(after.bodyToScene * glm::conjugate(kHalfRoll));
    motion.velocity = after.velocity;
    motion.rates = glm::conjugate(motion.attitude) * (after.rates + earthRate);
    _parts->meeting.note(hit, timeS, before.velocity);
    HullContact contact{hit.touches, hit.closingMps, 0.0, {}, motion.position, ObstacleMeeting::kGround};
    const ObstacleMeeting& obstacles = _parts->meeting.obstacles();
    if (hit.obstacle && hit.obstacleMps == hit.closingMps)
    {
        contact.thing = *hit.obstacle;
        contact.place = hit.place;
    }
    else if (hit.mover && hit.moverMps == hit.closingMps)
    {
        contact.thing = ObstacleMeeting::numberOf(*hit.mover);
        contact.place = hit.moverPlace;
    }
    else
        contact.groundMps = hit.closingMps;
    contact.reason = obstacles.reason(contact.thing);
    return contact;
}

void AircraftHull::fill(const BodyMotion& motion, const MassProperties& mass, double levelM, double stepS)
{
    constexpr double kFillS = 90.0;   // in which it fills, while its lowest box is under water: chosen
    constexpr double kDryShare = 0.1; // of the hull's volume that water does not fill
    const HullPlan lowest =
        hullPlanOf(_aircraft->hull.boxes.front(), hullPlace(mass.centre), solidOf(motion, glm::dvec3(0.0)));
    const double under = std::clamp((levelM - lowest.lowM) / (lowest.highM - lowest.lowM), 0.0, 1.0);
    _airShare = std::max(kDryShare, _airShare - under * stepS / kFillS);
}

ForceMoment AircraftHull::swim(const BodyMotion& motion, const MassProperties& mass,
                               const BodySurroundings& around, double levelM, double stepS) const
{
    constexpr double kMostShare = 0.2; // of a point's speed that drag takes in a short step
    const auto points = static_cast<double>(4 * _aircraft->hull.boxes.size());
    const HullWater water{levelM, _airShare, kMostShare * mass.massKg / (points * stepS), around.gravity};
    const glm::dquat toBody = glm::conjugate(motion.attitude);
    ForceMoment sum;
    pressByWater(_aircraft->hull, hullPlace(mass.centre), solidOf(motion, around.earthRate), water,
                 [&](const glm::dvec3& force, const glm::dvec3& arm)
                 {
                     const glm::dvec3 inBody = toBody * force;
                     sum += {inBody, glm::cross(toBody * arm, inBody)};
                 });
    return sum;
}

void AircraftHull::note(const ObstacleTouch& touch)
{
    _parts->meeting.obstacles().note(touch);
}

} // namespace simulation
