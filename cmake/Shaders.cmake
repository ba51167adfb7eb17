# SPDX-License-Identifier: Apache-2.0
# Shader files and texts become C++ constants: no program reads them from a file at run time.
set(OSGTRAINER_EMBED_SHADERS ${CMAKE_CURRENT_LIST_DIR}/EmbedShaders.cmake)

# osgtrainer_shaders(TARGET NAMESPACE FILE…): embeds the files in the target. Its sources include <shaders/NAMESPACE.h>,
# which declares NAMESPACE::shaders::kName for each Name.glsl, kNameVert for Name.vert, kNameFrag for Name.frag.
# A changed file makes the build embed and compile again; docs/guide/shaders.md describes the files.
function(osgtrainer_shaders target namespace)
    osgtrainer_embed(${target} shaders ${namespace} ${ARGN})
endfunction()

# osgtrainer_texts(TARGET NAMESPACE FILE…): the same for files of data. <texts/NAMESPACE.h> declares NAMESPACE::texts::kName for each name.json.
function(osgtrainer_texts target namespace)
    osgtrainer_embed(${target} texts ${namespace} ${ARGN})
endfunction()

function(osgtrainer_embed target kind namespace)
    set(files ${ARGN})
    list(TRANSFORM files PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ REGEX "^[^/]")
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}-${kind})
    set(output ${folder}/${kind}/${namespace})
    # Declared in the uppermost folder, whose commands ninja takes first: all that includes a header would wait for the command otherwise.
    cmake_language(EVAL CODE "cmake_language(DEFER DIRECTORY [[${PROJECT_SOURCE_DIR}]] CALL
        osgtrainer_embed_files [[${target}_${namespace}_${kind}]] [[${kind}]] [[${namespace}]] [[${output}]] [[${files}]])")
    set_source_files_properties(${output}.cpp ${output}.h PROPERTIES GENERATED ON)
    add_dependencies(${target} ${target}_${namespace}_${kind})
    # Outside the unity files, so that a changed file compiles this source alone.
    set_source_files_properties(${output}.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    target_sources(${target} PRIVATE ${output}.cpp ${output}.h)
    target_include_directories(${target} PRIVATE ${folder})
endfunction()

# The target NAME makes output.cpp and output.h of the files. It links nothing, so it waits for no library.
function(osgtrainer_embed_files name kind namespace output files)
    add_custom_command(OUTPUT ${output}.cpp ${output}.h
        COMMAND ${CMAKE_COMMAND} "-DKIND=${kind}" "-DNAMESPACE=${namespace}" "-DOUTPUT=${output}" "-DFILES=${files}"
            -P ${OSGTRAINER_EMBED_SHADERS}
        DEPENDS ${files} ${OSGTRAINER_EMBED_SHADERS}
        COMMENT "Embedding the ${kind} ${name}" VERBATIM)
    add_custom_target(${name} DEPENDS ${output}.cpp ${output}.h)
endfunction()
