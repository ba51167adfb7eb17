// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace osgPMObjects
{

/// Each registers one class with OSG's scene files, unless a program or a plugin already has.
void addShapeSerializer();
void addNodeSerializer();
void addDrawableSerializer();
void addFieldSerializer();

} // namespace osgPMObjects
