// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgPMObjects/core/field/Field.h>

#include <osgPMObjects/ProgressiveField>

#include "FieldMesh.h"

namespace osgPMObjects
{

/// The meshes by kind. Kinds of one shape share a mesh, which is taken from `known` if it is there.
std::vector<osg::ref_ptr<FieldMesh>> meshesOf(const std::vector<FieldKind>& kinds,
                                              const std::vector<osg::ref_ptr<FieldMesh>>& known);

/// The kinds and instances as the core takes them; its tables are those of the shapes and meshes.
std::vector<core::FieldModel> modelsOf(const std::vector<FieldKind>& kinds,
                                       const std::vector<osg::ref_ptr<FieldMesh>>& meshes);
std::vector<core::FieldObject> objectsOf(const std::vector<FieldInstance>& instances);

/// The inverse of objectsOf(), in the order in which the objects were given.
std::vector<FieldInstance> instancesOf(const core::Field& field);

} // namespace osgPMObjects
