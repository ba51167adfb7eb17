// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>

#include <osgMultiTriangulation/core/input/PointSet.h>

namespace osgMultiTriangulation::core
{

namespace
{

constexpr double kMostNumber =
    1e15; ///< greater ones are no lengths; extents and steps of all others are finite
constexpr double kMostPerStep = 1e15;

std::optional<MeasuredPoint> pointOf(std::string_view line)
{
    MeasuredPoint point{};
    for (double& value : point)
    {
        const std::size_t first = line.find_first_not_of(" \t,;\r");
        if (first == std::string_view::npos) return std::nullopt;
        line.remove_prefix(first);
        if (line.front() == '+') line.remove_prefix(1);
        const auto [end, failed] = std::from_chars(line.data(), line.data() + line.size(), value);
        if (failed != std::errc() || !(std::abs(value) <= kMostNumber)) return std::nullopt;
        line.remove_prefix(static_cast<std::size_t>(end - line.data()));
        if (!line.empty() && std::string_view(" \t,;\r").find(line.front()) == std::string_view::npos)
            return std::nullopt;
    }
    return point;
}

/// Whether a number is a multiple of a step, but for the rounding of its decimals.
bool isMultiple(double value, double perStep)
{
    const double steps = value * perStep;
    return std::abs(steps - std::round(steps)) <= 1e-6 && std::abs(steps) < 0x1p52;
}

} // namespace

foundation::Outcome streamPointFile(const std::filesystem::path& file,
                                    const std::function<void(const MeasuredPoint&)>& visit)
{
    std::ifstream stream(file);
    if (!stream)
        return foundation::Error{file.string(), "cannot be opened", "check the path and its permissions"};
    return streamPoints(stream, file.string(), visit);
}

foundation::Outcome streamPoints(std::istream& stream, const std::string& place,
                                 const std::function<void(const MeasuredPoint&)>& visit)
{
    bool hasPoints = false;
    std::string line;
    for (std::size_t number = 1; std::getline(stream, line); ++number)
    {
        const std::size_t first = line.find_first_not_of(" \t\r");
        if (first == std::string::npos || line[first] == '#') continue;
        if (const auto point = pointOf(line))
        {
            visit(*point);
            hasPoints = true;
        }
        else if (number > 1 || std::string_view("+-.0123456789").find(line[first]) != std::string_view::npos)
            return foundation::Error{place + ":" + std::to_string(number), "has no three numbers",
                                     "write x, y and height, divided by commas or blanks"};
    }
    if (hasPoints) return foundation::success();
    return foundation::Error{place, "has no points", "write a point on each line"};
}

foundation::Result<std::vector<MeasuredPoint>> readPointFile(const std::filesystem::path& file)
{
    std::vector<MeasuredPoint> points;
    const auto read =
        streamPointFile(file, [&points](const MeasuredPoint& point) { points.push_back(point); });
    if (!read) return read.error();
    return points;
}

void LatticeFinder::add(const MeasuredPoint& point)
{
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
        _low[axis] = _isEmpty ? point[axis] : std::min(_low[axis], point[axis]);
        _high[axis] = _isEmpty ? point[axis] : std::max(_high[axis], point[axis]);
        while (_perStep > 0.0 && !isMultiple(point[axis], _perStep))
            _perStep = _perStep < 1e6 ? _perStep * 10.0 : 0.0;
    }
    _isEmpty = false;
}

PlanFrame LatticeFinder::frame() const
{
    if (_isEmpty) return {};
    const double most = std::max(extent(0), extent(1));
    double perStep = _perStep;
    if (perStep == 0.0 || most * perStep > kMostPlan)
        perStep = most > 0.0 ? std::min(kMostPlan / most, kMostPerStep) : 1.0;
    return {_low[0], _low[1], 1.0 / perStep, 1.0 / perStep};
}

PlanFrame latticeFor(std::span<const MeasuredPoint> points)
{
    LatticeFinder finder;
    for (const MeasuredPoint& point : points)
        finder.add(point);
    return finder.frame();
}

SurfacePoint onLattice(const PlanFrame& frame, const MeasuredPoint& point, double& mostMoved)
{
    const double low[2] = {frame.originX, frame.originY}, step[2] = {frame.stepX, frame.stepY};
    std::int32_t at[2];
    for (int axis = 0; axis < 2; ++axis)
    {
        const double steps = std::round((point[axis] - low[axis]) / step[axis]);
        at[axis] = static_cast<std::int32_t>(std::clamp(steps, 0.0, double(kMostPlan)));
        mostMoved = std::max(mostMoved, std::abs(low[axis] + at[axis] * step[axis] - point[axis]));
    }
    return {at[0], at[1], point[2]};
}

PlacedPoints placeOnLattice(std::span<const MeasuredPoint> points)
{
    PlacedPoints placed;
    placed.frame = latticeFor(points);
    std::unordered_set<std::uint64_t> taken;
    taken.reserve(points.size());
    for (const MeasuredPoint& p : points)
    {
        const SurfacePoint point = onLattice(placed.frame, p, placed.mostMoved);
        if (taken.insert(std::uint64_t(std::uint32_t(point.x)) << 32 | std::uint32_t(point.y)).second)
            placed.points.push_back(point);
        else
            ++placed.repeated;
    }
    return placed;
}

} // namespace osgMultiTriangulation::core
