// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/GroundContacts.h"

#include <algorithm>
#include <cmath>

#include <foundation/Angle.h>

namespace simulation
{

namespace
{

constexpr double kNearM = 5.0;         ///< above the ground, up to which contacts are computed
constexpr double kDeepestPressM = 0.5; ///< deeper, no spring grows stronger

double depthOf(const glm::dvec3& point, const GroundPoint& ground)
{
    return ground.isKnown ? (ground.heightM - point.z) * ground.normal.z : -kNearM;
}

/// The directions of a wheel on the ground: along, across to its right. Scene axes.
struct WheelAxes
{
    glm::dvec3 along, across;
};

WheelAxes wheelAxes(const glm::dquat& attitude, double steering, const glm::dvec3& normal)
{
    glm::dvec3 along = attitude * glm::dvec3(std::cos(steering), std::sin(steering), 0.0);
    along -= glm::dot(along, normal) * normal;
    const double length = glm::length(along);
    if (length < 1e-3)
        along = glm::normalize(glm::cross(normal, glm::dvec3(0.6, 0.8, 0.0)));
    else
        along /= length;
    return {along, glm::cross(along, normal)};
}

/// The largest forces of a tyre along and across, for each newton of load.
glm::dvec2 gripOf(const ContactData& data, const GroundControls& controls, const GroundPoint& point)
{
    const GroundFriction ground = frictionOf(point.kind);
    const double grip = data.friction * ground.gripFactor * point.gripScale;
    if (!data.isWheel || controls.isBroken) return glm::dvec2(std::max(grip, 0.1));
    const double brake = data.brake == Brake::left    ? controls.leftBrake
                         : data.brake == Brake::right ? controls.rightBrake
                                                      : 0.0;
    return {std::min(ground.rollingResistance + brake * grip, std::max(grip, ground.rollingResistance)),
            grip};
}

constexpr double kRollsMps = 1.0;

/// How fast a rolling wheel takes its bend sideways out of the contact: after the relaxation length the force
/// is that of the slip angle, corneringPerRad times the load.
double carriedOut(const Contact& contact, const ContactData& data, double rollingMps, double stepS)
{
    constexpr double kLeastRelaxationM = 0.05;
    const double relaxationM =
        std::max(kLeastRelaxationM, data.corneringPerRad * contact.loadN / data.springNPerM);
    return contact.slip.y * std::min(rollingMps / relaxationM, 1.0 / stepS);
}

} // namespace

GroundContacts::GroundContacts(const AircraftData& aircraft)
    : _aircraft(aircraft),
      _contacts(aircraft.contacts.size()),
      _points(aircraft.contacts.size()),
      _answers(aircraft.contacts.size())
{
}

bool GroundContacts::look(const BodyMotion& motion, const glm::dvec3& centre, const Ground& ground)
{
    for (std::size_t i = 0; i < _contacts.size(); ++i)
    {
        _contacts[i].arm = bodyPlace(_aircraft.contacts[i].place, centre);
        _points[i] = motion.position + motion.attitude * _contacts[i].arm;
    }
    ground.below(_points, _answers);
    bool isNear = false;
    for (std::size_t i = 0; i < _contacts.size(); ++i)
    {
        // The ground as a plane through this point: within one step that is the surface.
        _contacts[i].ground = _answers[i];
        _contacts[i].waterM.reset();
        if (_answers[i].isKnown && _answers[i].kind == GroundKind::water)
        {
            _contacts[i].waterM = _answers[i].heightM;
            _contacts[i].ground.heightM -= _answers[i].depthM;
            _contacts[i].ground.kind = GroundKind::gravel;
        }
        isNear = isNear || depthOf(_points[i], _answers[i]) > -kNearM;
    }
    return isNear;
}

void GroundContacts::mend()
{
    for (Contact& contact : _contacts)
        contact.isGone = false;
}

ForceMoment GroundContacts::pressOne(std::size_t index, const BodyMotion& motion, const glm::dvec3& rates,
                                     const GroundControls& controls, double stepS)
{
    const ContactData& data = _aircraft.contacts[index];
    Contact& contact = _contacts[index];
    const glm::dvec3 normal = contact.ground.normal;
    const glm::dvec3 point = motion.position + motion.attitude * contact.arm;
    const glm::dvec3 plane(_points[index].x, _points[index].y, contact.ground.heightM);
    contact.depthM = contact.ground.isKnown ? glm::dot(plane - point, normal) : -kNearM;
    contact.loadN = 0.0;
    contact.closingMps = 0.0;
    if (contact.depthM <= 0.0 || contact.isGone)
    {
        contact.depthM = std::min(contact.depthM, 0.0);
        contact.slip = glm::dvec2(0.0);
        return {};
    }
    const glm::dvec3 velocity = motion.velocity + motion.attitude * glm::cross(rates, contact.arm);
    contact.closingMps = -glm::dot(velocity, normal);
    contact.loadN = std::max(0.0, data.springNPerM * std::min(contact.depthM, kDeepestPressM) +
                                      data.dampingNsPerM * contact.closingMps);
    const double steering = foundation::radiansOf(data.steeringDeg) * controls.steering;
    const WheelAxes axes = wheelAxes(motion.attitude, steering, normal);
    const glm::dvec2 sliding(glm::dot(velocity, axes.along), glm::dot(velocity, axes.across));
    glm::dvec2 bristleDamping(0.5 * data.dampingNsPerM);
    glm::dvec2 bending = sliding;
    if (data.isWheel && !controls.isBroken)
    {
        bending.y -= carriedOut(contact, data, std::abs(sliding.x), stepS);
        // Rolling damps by itself.
        bristleDamping.y *= std::max(0.0, 1.0 - std::abs(sliding.x) / kRollsMps);
    }
    contact.slip += bending * stepS;
    glm::dvec2 force = -data.springNPerM * contact.slip - bristleDamping * bending;
    const glm::dvec2 most = gripOf(data, controls, contact.ground) * contact.loadN;
    force = glm::clamp(force, -most, most);
    const double whole = glm::length(force), round = std::max(most.x, most.y);
    if (whole > round) force *= round / whole;
    contact.slip = -(force + bristleDamping * bending) / data.springNPerM;
    const glm::dvec3 onBody = glm::conjugate(motion.attitude) *
                              (contact.loadN * normal + force.x * axes.along + force.y * axes.across);
    return {onBody, glm::cross(contact.arm, onBody)};
}

ForceMoment GroundContacts::press(const BodyMotion& motion, const glm::dvec3& earthRate,
                                  const GroundControls& controls, double stepS)
{
    const glm::dvec3 rates = motion.rates - glm::conjugate(motion.attitude) * earthRate;
    ForceMoment sum;
    for (std::size_t i = 0; i < _contacts.size(); ++i)
        sum += pressOne(i, motion, rates, controls, stepS);
    return sum;
}

double GroundContacts::deepestM(const BodyMotion& motion, glm::dvec3& normal) const
{
    double deepest = 0.0;
    for (const Contact& contact : _contacts)
    {
        if (contact.isGone) continue;
        const double depth = depthOf(motion.position + motion.attitude * contact.arm, contact.ground);
        if (depth <= deepest) continue;
        deepest = depth;
        normal = contact.ground.normal;
    }
    return deepest;
}

} // namespace simulation
