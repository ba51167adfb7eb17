# SPDX-License-Identifier: Apache-2.0
# cmake -DOUT=folder "-DPLAYS=flight;drive" -P join-stats.cmake: folder/stats.json out of folder/<play>/stats.json, as the
# trainer writes them: the frames of all plays, each with its "scenario", and their summaries by scenario.
# A script of CMake because it reads JSON and is there wherever this was built.
cmake_minimum_required(VERSION 3.25)
set(frames)
set(summaries "{}")
foreach(play IN LISTS PLAYS)
    file(READ "${OUT}/${play}/stats.json" stats)
    string(JSON list GET "${stats}" frames)
    string(JSON summary GET "${stats}" summary)
    string(JSON summaries SET "${summaries}" ${play} "${summary}")
    string(JSON count LENGTH "${list}")
    math(EXPR last "${count} - 1")
    foreach(index RANGE ${last})
        string(JSON frame GET "${list}" ${index})
        string(JSON frame SET "${frame}" scenario "\"${play}\"")
        string(REGEX REPLACE "[ \t]*\n[ \t]*" " " frame "${frame}")
        list(APPEND frames "  ${frame}")
    endforeach()
endforeach()
list(JOIN frames ",\n" frames)
file(WRITE "${OUT}/stats.json.partial" "{\n \"frames\": [\n${frames}\n ],\n \"summary\": ${summaries}\n}\n")
file(RENAME "${OUT}/stats.json.partial" "${OUT}/stats.json")
