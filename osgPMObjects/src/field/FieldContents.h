// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <osgPMObjects/core/field/Field.h>

#include <osgPMObjects/ProgressiveField>

#include "FieldMesh.h"

namespace osgPMObjects
{

/// What ProgressiveField::setContents() refuses. `name`: the field's.
foundation::Outcome checkContents(const std::string& name, const std::vector<FieldKind>& kinds,
                                  const std::vector<FieldInstance>& instances);

/// By kind; of one shape there is one, which is taken from `known` if it is there.
std::vector<osg::ref_ptr<FieldMesh>> meshesOf(const std::vector<FieldKind>& kinds,
                                              const std::vector<osg::ref_ptr<FieldMesh>>& known);

/// The same for the core; the tables stay those of the shapes and meshes.
std::vector<core::FieldModel> modelsOf(const std::vector<FieldKind>& kinds,
                                       const std::vector<osg::ref_ptr<FieldMesh>>& meshes);
std::vector<core::FieldObject> objectsOf(const std::vector<FieldInstance>& instances);

} // namespace osgPMObjects
