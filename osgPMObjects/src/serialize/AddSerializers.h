// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace osgDB
{
class ObjectWrapperManager;
}

namespace osgPMObjects
{

/// Each adds what a class needs, unless somebody else (a program, a plugin) has: it is the same code.
void addShapeSerializer(osgDB::ObjectWrapperManager& manager);
void addNodeSerializer(osgDB::ObjectWrapperManager& manager);

} // namespace osgPMObjects
