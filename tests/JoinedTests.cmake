# SPDX-License-Identifier: Apache-2.0
# Which tests are one program in a build of large units: each program reads the headers of the standard library, GLM and OSG once more, 150 000 to
# 200 000 lines beside some hundreds of its own (decision 88). What is joined has one label and one kind of optimisation, and needs about the
# same libraries: a process that loads GDAL takes a tenth of a second to begin, so tests of what needs none stay without it.
# A test with a fuzzer in it, or whose `using namespace` makes names of others ambiguous, stays alone.
osgtrainer_joined_tests(objects_core_tests
    bake_test field_test foundation_test gltf_test mesh_test order_test polish_test polygons_test removal_test selection_test tessellate_test viewlod_test)
osgtrainer_joined_tests(objects_optimised_tests progressive_test simplification_error_test simplify_test)
osgtrainer_joined_tests(terrain_core_tests
    bisection_test cover_test edit_test features_test heightfield_test joined_test method_test roamfile_test terrain_generator_test vdpm_test)
osgtrainer_joined_tests(terrain_optimised_tests blocks_test multitriangulation_test roam_test)
osgtrainer_joined_tests(simulation_core_tests clouds_test light_test recorded_scenario_test session_core_test sound_test)
osgtrainer_joined_tests(world_core_tests buildings_test lights_test reference_test road_things_test)
if(OSGTRAINER_WITH_OSG)
    osgtrainer_joined_tests(terrain_osg_tests shader_test sky_osg_test technique_osg_test traversal_osg_test)
    osgtrainer_joined_tests(compare_osg_tests compare_order_test pmtool_test support_command_test)
    osgtrainer_joined_tests(compare_optimised_tests build_test compare_simplify_test)
endif()
