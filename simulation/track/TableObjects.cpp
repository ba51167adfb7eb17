// SPDX-License-Identifier: Apache-2.0
#include "simulation/track/TableObjects.h"

#include <set>
#include <string_view>

namespace simulation
{

std::optional<std::size_t> partingId(const std::vector<RowIds>& rows)
{
    const std::size_t columns = rows.empty() ? 0 : rows.front().size();
    for (std::size_t column = 0; column < columns; ++column)
    {
        std::set<std::string_view> values;
        std::size_t told = 0;
        for (const RowIds& row : rows)
        {
            if (row[column].empty()) continue;
            values.insert(row[column]);
            ++told;
        }
        if (values.empty() || (values.size() > 1 && told < 2 * values.size())) continue;
        const bool isTold = 2 * told > rows.size(); // most rows have it
        if (values.size() == 1 && isTold) return std::nullopt;
        if (values.size() > 1 && isTold) return column;
    }
    return std::nullopt;
}

} // namespace simulation
