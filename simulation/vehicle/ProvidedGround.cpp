// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/ProvidedGround.h"

namespace simulation
{

namespace
{

constexpr double kAroundM = 0.5;    ///< from the point to the heights that its normal is made of
constexpr double kClimbableM = 0.5; ///< above a point, up to which a surface carries it

} // namespace

GroundPoint ProvidedGround::at(const glm::dvec3& point) const
{
    const auto heightAt = [&](double eastM, double northM)
    { return _provider(point.x + eastM, point.y + northM, point.z + kClimbableM); };
    const auto here = heightAt(0.0, 0.0);
    const auto east = heightAt(kAroundM, 0.0), west = heightAt(-kAroundM, 0.0);
    const auto north = heightAt(0.0, kAroundM), south = heightAt(0.0, -kAroundM);
    if (!here || !east || !west || !north || !south) return {};
    const glm::dvec3 across(west->heightM - east->heightM, south->heightM - north->heightM, 2.0 * kAroundM);
    return {here->heightM, glm::normalize(across), _kind, true};
}

void ProvidedGround::below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const
{
    for (std::size_t i = 0; i < points.size(); ++i)
        answers[i] = _provider ? at(points[i]) : GroundPoint{};
}

void ProvidedGround::heightsBelow(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const
{
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        answers[i] = {};
        if (!_provider) continue;
        const auto sample = _provider(points[i].x, points[i].y, points[i].z + kClimbableM);
        if (sample) answers[i] = {sample->heightM, {0.0, 0.0, 1.0}, _kind, true};
    }
}

} // namespace simulation
