// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include <foundation/Heights.h>

namespace simulation
{

/// The ground at a point. Frame: the scene's.
struct GroundSample
{
    double heightM = 0.0; ///< z of the surface
};

/// Answers what something stands on at (east, north), from which height `fromM` it comes: where surfaces lie
/// over each other (a bridge and the road below it), the one that something at that height rests on. A
/// provider with one surface may be made of a function without the height. The same question must always get
/// the same answer.
/// Frame: the scene's. Units: metres.
class GroundProvider
{
public:
    /// For something whose height is not known.
    static constexpr double kAnyHeightM = std::numeric_limits<double>::infinity();

    /// A scene without ground.
    GroundProvider() = default;

    /// `ground`: (east, north) or (east, north, from) to a GroundSample, or to an optional one that is empty
    /// outside the data.
    template<class Ground>
    requires(!std::same_as<std::remove_cvref_t<Ground>, GroundProvider>) GroundProvider(Ground ground)
    {
        if constexpr (std::invocable<Ground&, double, double, double>)
            _query = std::move(ground);
        else
            _query = [ground = std::move(ground)](double eastM, double northM,
                                                  double) -> std::optional<GroundSample>
            { return ground(eastM, northM); };
    }

    /// Whether the scene has ground.
    explicit operator bool() const { return static_cast<bool>(_query); }

    /// Returns the ground there, or nothing outside the data. Precondition: the scene has ground.
    std::optional<GroundSample> operator()(double eastM, double northM, double fromM = kAnyHeightM) const
    {
        return _query(eastM, northM, fromM);
    }

    /// Returns the heights of the uppermost surfaces alone. Precondition: the scene has ground.
    foundation::HeightInPlan heights() const
    {
        return [query = _query](const glm::dvec2& plan) -> std::optional<double>
        {
            const auto sample = query(plan.x, plan.y, kAnyHeightM);
            return sample ? std::optional(sample->heightM) : std::nullopt;
        };
    }

private:
    std::function<std::optional<GroundSample>(double eastM, double northM, double fromM)> _query;
};

} // namespace simulation
