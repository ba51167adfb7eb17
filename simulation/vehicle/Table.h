// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <foundation/Result.h>

namespace simulation
{

/// A function of one or two numbers, given at points: linear between them, constant beyond the first and the
/// last.
/// Cost: about 10 ns a look-up.
class Table
{
public:
    /// The same value everywhere.
    explicit Table(double value = 0.0) : Table({0.0}, {0.0}, {value}) {}

    /// `values`: row by row, one for each pair of `rows` and `columns`.
    /// Errors (without a place): a wrong number of values, arguments that do not rise, a number that is not
    /// finite.
    static foundation::Result<Table> of(std::vector<double> rows, std::vector<double> columns,
                                        std::vector<double> values);

    double at(double row, double column = 0.0) const;

    /// The table with all values multiplied.
    Table scaled(double factor) const;

    double firstRow() const { return _rows.front(); }
    double lastRow() const { return _rows.back(); }

private:
    Table(std::vector<double> rows, std::vector<double> columns, std::vector<double> values)
        : _rows(std::move(rows)), _columns(std::move(columns)), _values(std::move(values))
    {
    }

    std::vector<double> _rows, _columns, _values;
};

} // namespace simulation
