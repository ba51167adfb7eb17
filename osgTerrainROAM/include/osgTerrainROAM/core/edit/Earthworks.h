// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <foundation/Heights.h>
#include <glm/vec2.hpp>

#include <osgTerrainROAM/core/edit/PlanShape.h>

namespace osgTerrainROAM::core
{

/// An area or a line to whose heights the ground is cut and filled: a lake, a river, a runway with its strip,
/// an apron.
/// Frame: any horizontal plane. Units: metres; heights in the samples' datum.
struct Earthwork
{
    bool isArea = false;
    std::vector<std::vector<glm::dvec2>> paths; ///< an outline and its holes, or one line
    std::vector<std::vector<double>> heightsM;  ///< of each point; an area takes their least-squares plane
    double widthM = 10.0;                       ///< of a line's bed
    double crossfall = 0.0;                     ///< of the bed from its middle to either side, metres a metre
    double stripM = 0.0;                        ///< of graded ground beside the bed
    double stripFall = 0.0;                     ///< of that, away from the bed
    double slope = 0.5;                         ///< of cuttings and embankments
    int river = 0;      ///< lines of one river have one number above 0, and one bed: see Earthworks
    double riseM = 0.0; ///< of a shore: the ground rises by a tenth, up to this height, before it may fall
};

/// Tells the height of ground that earthworks have shaped. A place within beds has the height of the last of
/// them, but of beds of rivers that of the nearest line of one river, and that of the lowest of several; one
/// beside beds lies between their slopes: at least as high as their embankments, at most as high as their
/// cuttings.
/// Invariant: within a bed the height does not depend on the ground.
/// Cost: some microseconds a place that works are near, else 0.1. Threads: const, any.
class Earthworks
{
public:
    /// `flatM`: beds are wider by this much, so that triangles across their edges are level. `ground` tells
    /// how far the slopes reach, kFarthestM at most. Works with too few points, or without heights, count as
    /// none.
    Earthworks(const std::vector<Earthwork>& works, double flatM, const foundation::HeightInPlan& ground);
    ~Earthworks();
    Earthworks(Earthworks&&) noexcept;
    Earthworks& operator=(Earthworks&&) noexcept;

    /// Returns the new height of a place whose ground is `groundM` high.
    double heightM(const glm::dvec2& place, double groundM) const;

    /// Returns the height of the bed that a place lies in; nothing beside beds.
    std::optional<double> bedM(const glm::dvec2& place) const;

    /// Boxes around everything that changes. `inside`: also the middle of areas, which is level or sloping
    /// evenly.
    std::vector<PlanBox> boxes(bool inside) const;

    bool isEmpty() const;

    static constexpr double kFarthestM = 300.0;

private:
    struct Works;
    std::unique_ptr<Works> _works;
};

} // namespace osgTerrainROAM::core
