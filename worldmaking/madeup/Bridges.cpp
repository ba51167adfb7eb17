// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/madeup/Bridges.h"

#include <algorithm>
#include <utility>

namespace worldmaking
{

namespace
{

constexpr double kBankStepM = 3.0, kKnotRoomM = 30.0, kBridgesApartM = 20.0;

/// A line with the distance of its points from its start.
class MeasuredLine
{
public:
    explicit MeasuredLine(const std::vector<glm::dvec2>& points) : _points(points)
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            _at.push_back(i == 0 ? 0.0 : _at.back() + glm::distance(points[i - 1], points[i]));
    }

    double lengthM() const { return _at.back(); }
    double at(std::size_t i) const { return _at[i]; }

    glm::dvec2 place(double m) const
    {
        const std::size_t i = segment(m);
        return glm::mix(_points[i], _points[i + 1],
                        std::clamp((m - _at[i]) / std::max(_at[i + 1] - _at[i], 1e-9), 0.0, 1.0));
    }

    std::vector<glm::dvec2> part(double from, double to) const
    {
        std::vector<glm::dvec2> part{from <= 0.0 ? _points.front() : place(from)};
        for (std::size_t i = 0; i < _points.size(); ++i)
            if (_at[i] > from + 0.01 && _at[i] < to - 0.01) part.push_back(_points[i]);
        part.push_back(to >= lengthM() ? _points.back() : place(to));
        return part;
    }

private:
    std::size_t segment(double m) const
    {
        const auto next = std::upper_bound(_at.begin(), _at.end(), m) - _at.begin();
        return static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(next - 1, 0, static_cast<std::ptrdiff_t>(_at.size()) - 2));
    }

    const std::vector<glm::dvec2>& _points;
    std::vector<double> _at;
};

std::vector<double> crossingsOf(const MadeWay& way, const MeasuredLine& measured,
                                const std::vector<Stream>& streams)
{
    std::vector<double> crossings;
    const MapBox box = boxOf(way.points);
    for (const Stream& stream : streams)
    {
        if (!box.meets(boxOf(stream.points))) continue;
        for (std::size_t i = 0; i + 1 < stream.points.size(); ++i)
            for (std::size_t j = 0; j + 1 < way.points.size(); ++j)
                if (const auto place =
                        crossingOf(way.points[j], way.points[j + 1], stream.points[i], stream.points[i + 1]))
                    crossings.push_back(measured.at(j) + glm::distance(way.points[j], *place));
    }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
}

} // namespace

std::vector<WayPart> bridgedParts(const MadeWay& way, const std::vector<Stream>& streams,
                                  const GroundGrid& ground, const std::vector<glm::dvec2>& knots)
{
    const MeasuredLine measured(way.points);
    std::vector<std::pair<double, double>> bridges;
    for (const double crossing : crossingsOf(way, measured, streams))
    {
        const auto bed = ground.heightM(measured.place(crossing));
        if (!bed) continue;
        const auto bank = [&](double step)
        {
            double at = crossing + (step > 0.0 ? 0.5 : -0.5) * kLeastBridgeM;
            while (std::abs(at - crossing) < 0.5 * kMostBridgeM && at > 0.0 && at < measured.lengthM() &&
                   ground.heightM(measured.place(at)).value_or(1e9) < *bed + kBankM)
                at += step;
            return at;
        };
        const double from = bank(-kBankStepM), to = bank(kBankStepM);
        const bool hasRoom = from > kKnotRoomM && to < measured.lengthM() - kKnotRoomM &&
                             (bridges.empty() || from > bridges.back().second + kBridgesApartM);
        const glm::dvec2 middle = measured.place(0.5 * (from + to));
        const bool isClear =
            std::none_of(knots.begin(), knots.end(),
                         [&](const glm::dvec2& knot)
                         { return glm::distance(knot, middle) < 0.5 * (to - from) + kKnotRoomM; });
        if (hasRoom && isClear) bridges.emplace_back(from, to);
    }
    std::vector<WayPart> parts;
    double at = 0.0;
    for (const auto& [from, to] : bridges)
    {
        parts.push_back({measured.part(at, from), false});
        parts.push_back({measured.part(from, to), true});
        at = to;
    }
    parts.push_back({measured.part(at, measured.lengthM()), false});
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) // the same point, to the last bit
        parts[i + 1].points.front() = parts[i].points.back();
    return parts;
}

} // namespace worldmaking
