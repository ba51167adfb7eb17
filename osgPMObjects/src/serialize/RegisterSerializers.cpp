// SPDX-License-Identifier: Apache-2.0
#include <osgDB/Registry>

#include <osgPMObjects/Serializers>

#include "AddSerializers.h"

namespace osgPMObjects
{

bool registerSerializers()
{
    osgDB::ObjectWrapperManager& manager = *osgDB::Registry::instance()->getObjectWrapperManager();
    addShapeSerializer(manager);
    addNodeSerializer(manager);
    addDrawableSerializer(manager);
    addFieldSerializer(manager);
    return true;
}

} // namespace osgPMObjects
