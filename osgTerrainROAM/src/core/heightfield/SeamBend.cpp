// SPDX-License-Identifier: Apache-2.0
#include "SeamBend.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "NearestSample.h"
#include "VoidFill.h"

namespace osgTerrainROAM::core
{

namespace
{

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// The bending of ground along the outline of a sheet.
class Seam
{
public:
    Seam(HeightSheet& ground, const HeightSheet& sheet, int reach)
        : _ground(ground), _sheet(sheet), _reach(reach)
    {
        _difference.rect = sheet.rect.grownBy(reach + 2).cutTo(ground.rect);
        _difference.heightsM.assign(places(), 0.0f);
    }

    SeamReport bend()
    {
        SeamReport report;
        std::vector<std::uint8_t> isOutline(places(), 0);
        forEachPlace(
            [&](int column, int row, std::size_t i)
            {
                if (!isSheet(column, row)) return;
                const float differenceM = differenceAt(column, row);
                if (std::isnan(differenceM)) return;
                isOutline[i] = 1;
                _difference.heightsM[i] = differenceM;
                report.largestM = std::max<double>(report.largestM, std::abs(differenceM));
            });
        if (report.largestM == 0.0) return report;
        solve(isOutline);
        forEachPlace(
            [&](int column, int row, std::size_t i)
            {
                if (isSheet(column, row) || !isGround(column, row) || _difference.heightsM[i] == 0.0f) return;
                _ground.at(column, row) += _difference.heightsM[i];
                ++report.bent;
            });
        return report;
    }

private:
    std::size_t places() const
    {
        return static_cast<std::size_t>(_difference.columns()) * static_cast<std::size_t>(_difference.rows());
    }

    template<class Visit>
    void forEachPlace(const Visit& visit) const
    {
        std::size_t i = 0;
        for (int row = _difference.rect.south; row <= _difference.rect.north; ++row)
            for (int column = _difference.rect.west; column <= _difference.rect.east; ++column, ++i)
                visit(column, row, i);
    }

    bool isSheet(int column, int row) const
    {
        return _sheet.holds(column, row) && !std::isnan(_sheet.at(column, row));
    }
    bool isGround(int column, int row) const
    {
        return _ground.holds(column, row) && !std::isnan(_ground.at(column, row));
    }

    /// Height of sheet minus ground at a point of the sheet next to visible ground; NaN elsewhere.
    float differenceAt(int column, int row) const
    {
        double continuedM = 0.0;
        int count = 0;
        for (int k = 0; k < 9; ++k)
        {
            const int east = k % 3 - 1, north = k / 3 - 1;
            const int c = column + east, r = row + north;
            if (isSheet(c, r) || !isGround(c, r)) continue;
            const float nextM = _ground.at(c, r);
            const bool goesOn = isGround(c + east, r + north) && !isSheet(c + east, r + north);
            continuedM += goesOn ? 2.0 * nextM - _ground.at(c + east, r + north) : nextM;
            ++count;
        }
        if (count == 0) return kUnknown;
        const double groundM = isGround(column, row) ? _ground.at(column, row) : continuedM / count;
        return static_cast<float>(_sheet.at(column, row) - groundM);
    }

    /// The known values: the difference on the outline, the same inside it (of the nearest outline point),
    /// zero out of reach.
    void solve(const std::vector<std::uint8_t>& isOutline)
    {
        const NearestSample outline(isOutline, _difference.columns(), _difference.rows());
        forEachPlace(
            [&](int column, int row, std::size_t i)
            {
                if (isOutline[i]) return;
                const int c = column - _difference.rect.west, r = row - _difference.rect.south;
                if (isSheet(column, row))
                    _difference.heightsM[i] = _difference.heightsM[outline.nearest(c, r)];
                else if (outline.distance(c, r) < _reach)
                    _difference.heightsM[i] = kUnknown;
            });
        fillVoids(_difference.heightsM, _difference.columns(), _difference.rows());
    }

    HeightSheet& _ground;
    const HeightSheet& _sheet;
    const int _reach;
    HeightSheet _difference;
};

} // namespace

SeamReport bendTowards(HeightSheet& ground, const HeightSheet& sheet, int reach)
{
    return Seam(ground, sheet, reach).bend();
}

} // namespace osgTerrainROAM::core
