// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace osgDB
{
class ObjectWrapperManager;
}

namespace osgPMObjects
{

/// Each registers one class with OSG's scene files, unless a program or a plugin already has.
void addShapeSerializer(osgDB::ObjectWrapperManager& manager);
void addNodeSerializer(osgDB::ObjectWrapperManager& manager);
void addDrawableSerializer(osgDB::ObjectWrapperManager& manager);
void addFieldSerializer(osgDB::ObjectWrapperManager& manager);

} // namespace osgPMObjects
