// SPDX-License-Identifier: Apache-2.0
#include "RunwayStrokes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>

#include <foundation/Random.h>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kShortestM = 200.0; ///< with markings; a shorter runway is a strip of asphalt

/// Coordinates along and across a runway, seen from one of its ends.
struct Axis
{
    glm::dvec2 origin, along;
    glm::dvec2 right() const { return {along.y, -along.x}; }
    glm::dvec2 at(double s, double across) const { return origin + s * along + across * right(); }
};

class Painter
{
public:
    explicit Painter(const RunwayFrame& frame)
        : _frame(frame), _lengthM(glm::distance(frame.a, frame.b)), _widthM(frame.widthM)
    {
    }

    std::vector<Stroke> strokes()
    {
        if (!_frame.isPaved) return boards();
        if (_frame.hasBed) add(_frame.a, _frame.b, 0.5 * _widthM, FeatureCells::asphalt);
        if (_lengthM < kShortestM || _widthM < 8.0) return _strokes;
        const Axis first{_frame.a, (_frame.b - _frame.a) / _lengthM};
        const Axis second{_frame.b, -first.along};
        edges(first);
        centreLine(first);
        for (const Axis& end : {first, second})
        {
            threshold(end);
            if (_lengthM <= 800.0) continue;
            aimingPoints(end);
            rubber(end);
        }
        const auto [name, opposite] = designatorsOf(_frame);
        write(first, name);
        write(second, opposite);
        return _strokes;
    }

private:
    void add(const glm::dvec2& a, const glm::dvec2& b, double halfWidthM, FeatureCells::Paint paint)
    {
        _strokes.push_back({a, b, halfWidthM, paint});
    }

    void white(const Axis& axis, double from, double to, double across, double widthM)
    {
        add(axis.at(from, across), axis.at(to, across), 0.5 * widthM, FeatureCells::white);
    }

    /// White boards of 3 m by 1 m, 90 m apart at most, two at each corner.
    std::vector<Stroke> boards()
    {
        const Axis axis{_frame.a, (_frame.b - _frame.a) / std::max(_lengthM, 1.0)};
        const int count = std::max(1, static_cast<int>(std::ceil(_lengthM / 90.0)));
        for (int i = 0; i <= count; ++i)
            for (const double side : {-0.5, 0.5})
            {
                const double s = std::clamp(_lengthM * i / count, 1.5, std::max(_lengthM - 1.5, 1.5));
                white(axis, s - 1.5, s + 1.5, side * _widthM, 1.0);
                if (i > 0 && i < count) continue;
                const double end = i == 0 ? 0.5 : _lengthM - 0.5;
                add(axis.at(end, side * (_widthM - 3.0)), axis.at(end, side * _widthM), 0.5,
                    FeatureCells::white);
            }
        return _strokes;
    }

    void edges(const Axis& axis)
    {
        const double lineM = _widthM >= 30.0 ? 0.9 : 0.45;
        for (const double side : {-0.5, 0.5})
            white(axis, 0.0, _lengthM, side * (_widthM - lineM), lineM);
        const int lights = static_cast<int>(_lengthM / 60.0);
        for (int i = 0; i <= lights; ++i)
            for (const double side : {-0.5, 0.5})
            {
                const double s = _lengthM * i / lights;
                const double across = side * (_widthM + 3.0);
                add(axis.at(s - 0.15, across), axis.at(s + 0.15, across), 0.15, FeatureCells::edgeLight);
            }
    }

    void centreLine(const Axis& axis)
    {
        // 30 m of line and 20 m of gap, between the designators.
        const double from = digitsFromM() + 9.0 + 12.0;
        const double free = _lengthM - 2.0 * from;
        const int dashes = static_cast<int>((free + 20.0) / 50.0);
        const double begin = 0.5 * (_lengthM - (50.0 * dashes - 20.0));
        for (int i = 0; i < dashes; ++i)
            white(axis, begin + 50.0 * i, begin + 50.0 * i + 30.0, 0.0, _widthM >= 30.0 ? 0.9 : 0.3);
    }

    void threshold(const Axis& end)
    {
        // 4, 6, 8, 12 or 16 bars for widths of 18, 23, 30, 45 and 60 m; 1.8 m wide with gaps of as much.
        const int each = _widthM < 20.0   ? 2
                         : _widthM < 26.0 ? 3
                         : _widthM < 37.0 ? 4
                         : _widthM < 52.0 ? 6
                                          : 8;
        for (int i = 0; i < each; ++i)
            for (const double side : {-1.0, 1.0})
                white(end, 6.0, 36.0,
                      side * (1.8 + 0.9 * (_widthM < 37.0 ? 0 : 1) + 3.6 * i * gapScale(each)),
                      1.8 * gapScale(each));
    }

    /// The bars must end before the edge lines.
    double gapScale(int each) const { return std::min(1.0, (0.5 * _widthM - 2.0) / (3.6 * each)); }

    double aimingPointM() const { return _lengthM < 1200.0 ? 250.0 : _lengthM < 2400.0 ? 300.0 : 400.0; }

    void aimingPoints(const Axis& end)
    {
        const double from = aimingPointM();
        const double length = _lengthM < 1200.0 ? 30.0 : 45.0;
        const double wide = _lengthM < 1200.0 ? 4.0 : 6.0;
        const double between = std::min(0.3 * _widthM, 18.0);
        for (const double side : {-1.0, 1.0})
            white(end, from, from + length, side * 0.5 * (between + wide), wide);
    }

    /// Streaks of pairs of tyres around the aiming point, more and wider apart on a longer runway.
    void rubber(const Axis& end)
    {
        foundation::SplitMix64 bits(static_cast<std::uint64_t>(std::llround(end.origin.x)) * 0x1f1f1f1fU ^
                                    static_cast<std::uint64_t>(std::llround(end.origin.y)));
        const auto between = [&](double low, double high)
        { return low + (high - low) * static_cast<double>(bits() >> 11U) * 0x1p-53; };
        const int landings = std::clamp(static_cast<int>(_lengthM / 70.0), 10, 36);
        const double gearM = _lengthM < 1800.0 ? 1.3 : 2.8; // from the middle
        for (int i = 0; i < landings; ++i)
        {
            const double from = aimingPointM() + between(-100.0, 80.0) + between(0.0, 60.0);
            const double to = from + between(25.0, 110.0);
            const double aside = between(-1.2, 1.2) + between(-1.2, 1.2);
            for (const double side : {-1.0, 1.0})
                add(end.at(from, aside + side * gearM), end.at(to + between(-8.0, 8.0), aside + side * gearM),
                    between(0.12, 0.24), FeatureCells::rubber);
        }
    }

    double digitsFromM() const { return 36.0 + 12.0; }

    /// Digits of seven strokes, 9 m high and 3 m wide; letters (L, C, R) of the same.
    void write(const Axis& end, const std::string& name)
    {
        const double pitchM = 4.8;
        const double half = 0.5 * (static_cast<double>(name.size()) - 1.0) * pitchM;
        for (std::size_t i = 0; i < name.size(); ++i)
            glyph(end, name[i], static_cast<double>(i) * pitchM - half);
    }

    void glyph(const Axis& end, char letter, double across)
    {
        // Strokes: top, upper left, upper right, middle, lower left, lower right, bottom.
        static constexpr std::array<const char*, 10> kDigits{"1110111", "0010010", "1011101", "1011011",
                                                             "0111010", "1101011", "1101111", "1010010",
                                                             "1111111", "1111011"};
        const char* strokes = "0000000";
        if (std::isdigit(static_cast<unsigned char>(letter)))
            strokes = kDigits[static_cast<std::size_t>(letter - '0')];
        else if (letter == 'L')
            strokes = "0100101";
        else if (letter == 'C')
            strokes = "1100101";
        else if (letter == 'R')
            strokes = "1111110";
        constexpr double kLineM = 0.8, kHighM = 9.0, kHalfWideM = 1.5 - 0.5 * kLineM;
        const double low = digitsFromM(), mid = low + 0.5 * kHighM, high = low + kHighM;
        const auto upright = [&](int index, double from, double to, double side)
        {
            if (strokes[index] == '1') white(end, from, to, across + side * kHalfWideM, kLineM);
        };
        const auto level = [&](int index, double s)
        {
            if (strokes[index] == '1')
                add(end.at(s, across - 1.5), end.at(s, across + 1.5), 0.5 * kLineM, FeatureCells::white);
        };
        level(0, high - 0.5 * kLineM);
        upright(1, mid, high, -1.0);
        upright(2, mid, high, 1.0);
        level(3, mid);
        upright(4, low, mid, -1.0);
        upright(5, low, mid, 1.0);
        level(6, low + 0.5 * kLineM);
    }

    const RunwayFrame& _frame;
    double _lengthM, _widthM;
    std::vector<Stroke> _strokes;
};

} // namespace

std::vector<Stroke> runwayStrokes(const RunwayFrame& frame)
{
    return Painter(frame).strokes();
}

} // namespace osgTerrainROAM::core
