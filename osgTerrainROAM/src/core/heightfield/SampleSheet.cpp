// SPDX-License-Identifier: Apache-2.0
#include <cassert>

#include <osgTerrainROAM/core/heightfield/SampleSheet.h>

namespace osgTerrainROAM::core
{

SampleSheet::SampleSheet(const DensePart& part, int gridExponent, Storage storage)
    : _rect{part.west << gridExponent, part.south << gridExponent, (part.west + part.columns) << gridExponent,
            (part.south + part.rows) << gridExponent},
      _shift(gridExponent - part.exponent),
      _columns((part.columns << part.exponent) + 1),
      _table(part.heightsM, storage, kEditHeadroom)
{
    assert(_shift >= 0 && part.exponent > 0);
    assert(_table.size() ==
           static_cast<std::size_t>(_columns) * ((static_cast<std::size_t>(part.rows) << part.exponent) + 1));
}

} // namespace osgTerrainROAM::core
