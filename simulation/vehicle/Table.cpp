// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/Table.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

namespace
{

/// A place between two points of an axis.
struct Between
{
    std::size_t first = 0, second = 0;
    double share = 0.0; ///< of the second
};

Between findBetween(const std::vector<double>& axis, double value)
{
    if (!(value > axis.front())) return {0, 0, 0.0};
    if (value >= axis.back()) return {axis.size() - 1, axis.size() - 1, 0.0};
    const std::size_t above =
        static_cast<std::size_t>(std::upper_bound(axis.begin(), axis.end(), value) - axis.begin());
    return {above - 1, above, (value - axis[above - 1]) / (axis[above] - axis[above - 1])};
}

bool doesRise(const std::vector<double>& axis)
{
    return std::adjacent_find(axis.begin(), axis.end(), std::greater_equal<>()) == axis.end();
}

bool isFinite(const std::vector<double>& numbers)
{
    return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

} // namespace

foundation::Result<Table> Table::of(std::vector<double> rows, std::vector<double> columns,
                                    std::vector<double> values)
{
    if (rows.empty() || columns.empty() || values.size() != rows.size() * columns.size())
        return foundation::Error{{},
                                 "has " + std::to_string(values.size()) + " values for " +
                                     std::to_string(rows.size()) + " rows of " +
                                     std::to_string(columns.size()),
                                 "give each row its argument and one value for each column"};
    if (!isFinite(rows) || !isFinite(columns) || !isFinite(values))
        return foundation::Error{{}, "has a number that is not finite", "correct it"};
    if (!doesRise(rows) || !doesRise(columns))
        return foundation::Error{{}, "has arguments that do not rise", "sort rows and columns, each once"};
    return Table(std::move(rows), std::move(columns), std::move(values));
}

Table Table::scaled(double factor) const
{
    Table copy = *this;
    for (double& value : copy._values)
        value *= factor;
    return copy;
}

double Table::at(double row, double column) const
{
    const Between down = findBetween(_rows, row), across = findBetween(_columns, column);
    const auto alongRow = [&](std::size_t index)
    {
        const double* values = _values.data() + index * _columns.size();
        return values[across.first] + across.share * (values[across.second] - values[across.first]);
    };
    const double first = alongRow(down.first);
    return down.share == 0.0 ? first : first + down.share * (alongRow(down.second) - first);
}

} // namespace simulation
