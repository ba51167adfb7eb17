// SPDX-License-Identifier: Apache-2.0
#include <osgPMObjects/Serializers>

#include "AddSerializers.h"

namespace osgPMObjects
{

bool registerSerializers()
{
    addShapeSerializer();
    addNodeSerializer();
    addDrawableSerializer();
    addFieldSerializer();
    return true;
}

} // namespace osgPMObjects
