# SPDX-License-Identifier: Apache-2.0
# The target osgTrainer::osg from what CMake's FindOpenSceneGraph found. Included by this tree and, installed,
# by the package config: an imported target, so that no exported library carries a path of the build machine.
if(NOT TARGET osgTrainer::osg)
    add_library(osgTrainer::osg INTERFACE IMPORTED GLOBAL)
    target_include_directories(osgTrainer::osg SYSTEM INTERFACE ${OPENSCENEGRAPH_INCLUDE_DIRS})
    target_link_libraries(osgTrainer::osg INTERFACE ${OPENSCENEGRAPH_LIBRARIES})
endif()
