// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/road/Tyre.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

namespace
{

constexpr double kSlidingFrom = 1.0;   ///< slip over the one at which the whole contact slides
constexpr double kSlidingTo = 4.0;     ///< where friction has fallen to its sliding share
constexpr double kMostBend = 6.0;      ///< bound of that slip
constexpr double kSlowMps = 2.5;       ///< below it the standstill damper works
constexpr double kDampingShare = 0.01; ///< s: damping over stiffness of the bend

/// Share of the peak friction that a brush model reaches, over its slip.
double brushShare(double slip, double slidingShare)
{
    if (slip < kSlidingFrom) return slip * (3.0 - slip * (3.0 - slip));
    const double beyond = std::min((slip - kSlidingFrom) / (kSlidingTo - kSlidingFrom), 1.0);
    return 1.0 - (1.0 - slidingShare) * beyond;
}

/// What is left of a quantity at a load, when `loss` of it is lost at twice the reference load.
double left(double loss, double ratio)
{
    return std::clamp(1.0 - loss * (ratio - 1.0), 0.3, 1.5);
}

} // namespace

glm::dvec2 tyreStiffness(const RoadTyreData& tyre, double loadN)
{
    const double share = loadN * left(tyre.stiffnessLoss, loadN / tyre.referenceLoadN);
    return share * glm::dvec2(tyre.slipStiffness, tyre.cornerStiffness);
}

glm::dvec2 tyreFriction(const RoadTyreData& tyre, double loadN, double gripFactor)
{
    const double share = gripFactor * left(tyre.frictionLoss, loadN / tyre.referenceLoadN);
    return share * glm::dvec2(tyre.frictionAlong, tyre.frictionAcross);
}

TyreForce tyreForce(const RoadTyreData& tyre, double loadN, double gripFactor, const TyreMotion& motion,
                    double stepS, glm::dvec2& bend)
{
    if (loadN <= 0.0)
    {
        bend = glm::dvec2(0.0);
        return {};
    }
    const glm::dvec2 relaxation(tyre.relaxationAlongM, tyre.relaxationAcrossM);
    const glm::dvec2 sliding(motion.slidingAlongMps, motion.slidingAcrossMps);
    const double rolling = std::abs(motion.rollingMps);
    // Implicit in the straightening, which is stiff at speed.
    bend = (bend - sliding * stepS) / (1.0 + rolling * stepS / relaxation);

    const glm::dvec2 stiffness = tyreStiffness(tyre, loadN);
    const glm::dvec2 friction = loadN * tyreFriction(tyre, loadN, std::max(gripFactor, 1e-3));
    const glm::dvec2 toBrush = stiffness / (3.0 * friction * relaxation);
    glm::dvec2 slip = toBrush * bend;
    double whole = glm::length(slip);
    if (whole > kMostBend)
    {
        bend *= kMostBend / whole;
        slip *= kMostBend / whole;
        whole = kMostBend;
    }
    const double share = brushShare(whole, tyre.slidingShare);
    glm::dvec2 force = whole > 1e-12 ? friction * slip * (share / whole) : glm::dvec2(0.0);
    if (rolling < kSlowMps)
    {
        // The damper holds only while the tread does.
        const glm::dvec2 damper = stiffness / relaxation * (kDampingShare * (1.0 - rolling / kSlowMps));
        force -= damper * sliding * std::max(0.0, 1.0 - whole);
    }
    const double most = glm::length(force / friction);
    return {most > 1.0 ? force / most : force, whole};
}

} // namespace simulation
