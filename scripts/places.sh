# SPDX-License-Identifier: Apache-2.0
# Shell functions of the sheets of the default world: they put one car from place to place, a second at each. To be sourced by a script that has set
# $trainer, $world (its folder), $out and $places, a line each: a name, then `lane ROAD[/LANE/OFFSET] FROM TO` (metres along a road, on its first lane to the
# right unless told), or latitude and longitude of where the car stands and how far ahead of it, in degrees, lies what it looks at.
# Where it has set $before to the folder OUT of another build, its pictures stand to the left of these.

position() { # lane road[/lane/offset] s | latitude longitude
    local road lane offset
    if [ "$1" = lane ]; then
        IFS=/ read -r road lane offset <<< "$2"
        echo "<LanePosition roadId=\"$road\" laneId=\"${lane:--1}\" offset=\"${offset:-0}\" s=\"$3\"/>"
    else echo "<GeoPosition latitudeDeg=\"$1\" longitudeDeg=\"$2\"/>"; fi
}

scenario() { # hour of the day, UTC; $day: of the year, in June unless told; $scene: instead of the world's own
    local second=0 from to
    sed -n '1,/<\/Entities>/p' "$world/drive.xosc" | sed '/name="aircraft">/,/<\/ScenarioObject>/d; /<ObjectController>.*Driver/d' |
        sed "s|\"roads.xodr\"|\"$world/roads.xodr\"|; s|\"world.roam\"|\"${scene:-$world/world.roam}\"|"
    echo "<Storyboard><Init><Actions><GlobalAction><EnvironmentAction><Environment name=\"day\"><TimeOfDay animation=\"false\" dateTime=\"${day:-2024-06-21}T$1:00:00Z\"/>
        <Weather fractionalCloudCover=\"zeroOktas\"><Fog visualRange=\"60000\"/></Weather></Environment></EnvironmentAction></GlobalAction>
        <Private entityRef=\"car\"><PrivateAction><TeleportAction><Position>$(position lane 70 550)</Position></TeleportAction></PrivateAction><PrivateAction><RoutingAction><FollowTrajectoryAction><TrajectoryRef><Trajectory name=\"places\" closed=\"false\"><Shape><Polyline>"
    while read -r _ a b c d; do
        [ -n "$a" ] || continue
        if [ "$a" = lane ]; then from=$(position lane "$b" "$c"); to=$(position lane "$b" "$d")
        else from=$(position "$a" "$b"); to=$(position "$(awk "BEGIN{printf \"%.8f\", $a + $c}")" "$(awk "BEGIN{printf \"%.8f\", $b + $d}")"); fi
        echo "<Vertex time=\"$second.0\"><Position>$from</Position></Vertex><Vertex time=\"$second.9\"><Position>$to</Position></Vertex>"
        second=$((second + 1))
    done <<< "$places"
    echo "</Polyline></Shape></Trajectory></TrajectoryRef><TimeReference><Timing domainAbsoluteRelative=\"relative\" scale=\"1\" offset=\"0\"/></TimeReference>
        <TrajectoryFollowingMode followingMode=\"follow\"/></FollowTrajectoryAction></RoutingAction></PrivateAction></Private></Actions></Init>
        <StopTrigger><ConditionGroup><Condition name=\"end\" delay=\"0\" conditionEdge=\"none\"><ByValueCondition><SimulationTimeCondition value=\"$second\" rule=\"greaterOrEqual\"/>
        </ByValueCondition></Condition></ConditionGroup></StopTrigger></Storyboard></OpenSCENARIO>"
}

count=$(grep -c . <<< "$places")
pictures() { # name, hour, options
    local name=$1 hour=$2
    shift 2
    scenario "$hour" > "$out/frames/$name.xosc"
    # Every second picture of two a second is in the middle of a place.
    "$trainer" play "$out/frames/$name.xosc" --fps 2 --frames $((2 * count)) --size 480x270 --samples 1 "$@" --capture "$out/frames/$name" > "$out/frames/$name.log" 2>&1 ||
        { cat "$out/frames/$name.log" >&2; exit 1; }
}

sheet() { # file, columns
    local file=$1 list=() filter="" rows="" n=0 row folders=() width=${sheetWidth:-320}
    shift
    for name in "$@"; do folders+=(${before:+"$before/frames/$name"} "$out/frames/$name"); done
    set -- "${folders[@]}"
    for ((row = 0; row < count; ++row)); do
        for name in "$@"; do
            list+=(-i "$name/frame_$(printf %05d $((2 * row + 1))).png")
            filter+="[$n]scale=$width:-2:flags=area[s$n];"
            n=$((n + 1))
        done
        local first=$((n - $#)) part=""
        for ((i = first; i < n; ++i)); do part+="[s$i]"; done
        filter+="${part}hstack=inputs=$#[r$row];"
        rows+="[r$row]"
    done
    ffmpeg -v error -y "${list[@]}" -filter_complex "$filter${rows}vstack=inputs=$count" -q:v 5 "$file"
    echo "$file"
}
