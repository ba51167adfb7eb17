# SPDX-License-Identifier: Apache-2.0
# Proves that EmbedShaders.cmake embeds the text below the head of a file, and refuses each kind of faulty file.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE "${SCRATCH}")

# Embeds one file; `expected` is pass, or a part of the message of the error.
function(expect expected name text)
    file(WRITE "${SCRATCH}/${name}" "${text}")
    execute_process(COMMAND ${CMAKE_COMMAND} -DNAMESPACE=scratch -DOUTPUT=${SCRATCH}/out "-DFILES=${SCRATCH}/${name}" -P ${SCRIPT}
        RESULT_VARIABLE failed OUTPUT_VARIABLE said ERROR_VARIABLE said)
    string(REGEX REPLACE "[ \n]+" " " said "${said}")
    if(expected STREQUAL "pass")
        if(failed)
            message(SEND_ERROR "${name}: refused: ${said}")
        endif()
    elseif(NOT failed OR NOT said MATCHES "${expected}")
        message(SEND_ERROR "${name}: no error that says '${expected}': ${said}")
    endif()
endfunction()

set(body "#version 120\nvoid main() { int i[2]; i[0] = 1; \\\n}\n")
expect(pass Sky.vert "// Licence\n// Purpose\n\n${body}")
file(READ "${SCRATCH}/out.cpp" source)
string(FIND "${source}" "const char kSkyVert[] = R\"glsl(${body})glsl\";" place)
if(place EQUAL -1)
    message(SEND_ERROR "the embedded text differs from the file: ${source}")
endif()

expect("no head" NoHead.glsl "${body}")
expect("no head" NoBlankLine.glsl "// Licence\n${body}")
expect("not ASCII" Letters.glsl "// Licence\n\n// Größe\n${body}")
expect("not that of a shader" Text.txt "// Licence\n\n${body}")
