#!/usr/bin/env bash
# What `cmake --install` puts into a folder is all that the programs and a desktop need. Arguments: the project's
# folder and the one that it was built in.
set -euo pipefail

source=$1 build=$2
# shellcheck source=tests/packaging/rows.sh
. "$source/tests/packaging/rows.sh"
work=$(mktemp -d /tmp/furrow-install.XXXXXX)
trap 'rm -rf "$work"' EXIT
DESTDIR="$work" cmake --install "$build" >"$work/log" || { cat "$work/log" >&2; exit 1; }
prefix=$work$(sed -n 's/^CMAKE_INSTALL_PREFIX:PATH=//p' "$build/CMakeCache.txt")
share=$prefix/share
entry=$share/applications/org.furrow.furrow.desktop
metainfo=$share/metainfo/org.furrow.furrow.metainfo.xml
cli=$prefix/bin/furrow-cli

# value KEY: of the desktop entry.
value() { sed -n "s/^$1=//p" "$entry"; }

# xpath FILE EXPRESSION: on any element, whatever its namespace.
xpath() { xmllint --xpath "$2" "$1" 2>/dev/null; }

# missing FOLDER NAME...: the names that are not there.
missing() {
    local name
    for name in "${@:2}"; do [ -e "$1/$name" ] || printf '%s ' "$name"; done
}

commands() { "$cli" "$@" --help | sed -n '/^Subcommands:/,/^$/s/^  \([a-z]*\) .*/\1/p'; }
long_options() { "$cli" "$@" --help | grep -oE '^  [^ ]+' | grep -oE -- '--[a-z-]+' | sort -u; }

installs_every_part() {
    expect programs "$(cd "$prefix" && find bin libexec -type f | sort | xargs)" \
        'bin/furrow bin/furrow-cli libexec/furrow/furrow-report'
    expect folders "$(cd "$share" && find . -mindepth 1 -maxdepth 1 | sort | xargs)" \
        './applications ./bash-completion ./doc ./icons ./man ./metainfo ./mime ./zsh'
    # Nothing of libraries and headers that the build makes for itself.
    expect nothingElse "$(cd "$prefix" && find . -mindepth 1 -maxdepth 1 | sort | xargs)" './bin ./libexec ./share'
}

entry_leads_to_the_program() {
    expect startsTheProgram "$(value Exec)" 'furrow %f'
    expect hasItsIcon "$(find "$share/icons/hicolor" -path "*/apps/$(value Icon).*" | wc -l)" 8
    if command -v desktop-file-validate >/dev/null; then
        expect entryIsValid "$(desktop-file-validate "$entry")" ''
    fi
}

kinds_are_told_apart() {
    XDG_DATA_DIRS=$share update-mime-database "$share/mime" 2>"$work/mime" || true
    expect kindsAreValid "$(cat "$work/mime")" ''
    expect projectsByName "$(grep -h 'x-furrow-project:' "$share/mime/globs2")" '50:application/x-furrow-project:*.furrow'
    expect projectsAreGeoJson "$(grep -h '^application/x-furrow-project ' "$share/mime/subclasses")" \
        'application/x-furrow-project application/geo+json'
    expect taskDataByElement "$(grep -h ISO11783 "$share/mime/XMLnamespaces" | xargs)" \
        'ISO11783_TaskData application/x-isoxml-taskdata'
    # Kinds of files that neither this package nor the system describes never lead here.
    local kind unknown=
    for kind in $(value MimeType | tr ';' ' '); do
        [ -e "$share/mime/$kind.xml" ] || [ -e "/usr/share/mime/$kind.xml" ] || unknown+="$kind "
    done
    expect kindsAreKnown "$unknown" ''
    expect projectsHaveAnIcon "$(missing "$share/icons/hicolor/scalable/mimetypes" application-x-furrow-project.svg)" ''
}

description_is_true() {
    expect namesTheEntry "$(xpath "$metainfo" 'string(//launchable[@type="desktop-id"])')" "$(basename "$entry")"
    expect hasTheVersion "furrow $(xpath "$metainfo" 'string(//release[1]/@version)')" "$("$cli" --version)"
    local picture size seen=
    for picture in $(xpath "$metainfo" '//image/text()'); do
        size="$(xpath "$metainfo" "string(//image[text()='$picture']/@width)") "
        size+=$(xpath "$metainfo" "string(//image[text()='$picture']/@height)")
        # They stand in the bytes 17 to 24 of a PNG.
        [ "$(od -An -tx1 -j16 -N8 "$source/resources/screenshots/${picture##*/}" | tr -d ' ')" = \
            "$(printf %08x%08x "${size% *}" "${size#* }")" ] && seen+="${picture##*/} "
    done
    expect picturesAreAsTold "$seen" 'window.png obstacles.png work-order.png '
    if command -v appstreamcli >/dev/null; then
        expect descriptionIsValid "$(appstreamcli validate --no-net "$metainfo" >"$work/appstream" 2>&1 || cat "$work/appstream")" ''
    fi
}

manual_tells_everything() {
    local command option untold='' pages='furrow.1 furrow-cli.1 '
    for command in $(commands); do
        pages+="furrow-cli-$command.1 "
        for option in $(long_options "$command"); do
            grep -qF -- "${option//-/\\-}" "$share/man/man1/furrow-cli-$command.1" || untold+="$command $option "
        done
    done
    expect pagesOfAllCommands "$(cd "$share/man/man1" && find . -type f -printf '%f\n' | sort | xargs)" \
        "$(tr ' ' '\n' <<<"$pages" | sort | xargs)"
    expect pagesOfAllOptions "$untold" ''
}

# offered PROGRAM WORD...: what the shell offers for the last word.
offered() {
    # shellcheck source=/dev/null
    (. "$share/bash-completion/completions/$1"
     COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
     "_${1//-/_}" 2>/dev/null  # compopt works in a completion only
     printf '%s\n' "${COMPREPLY[@]}")
}

shells_complete() {
    expect completesCommands "$(offered furrow-cli '' | xargs)" "$(commands | xargs)"
    expect completesNestedCommands "$(offered furrow-cli list '' | xargs)" "$(commands list | xargs)"
    expect completesOptions "$(offered furrow-cli plan f -- | sort)" "$(long_options plan)"
    expect completesMachines "$(cd "$work" && offered furrow-cli plan f --machine tr | xargs)" trailed-sprayer
    expect completesKeys "$(offered furrow-cli plan f --set headland.wi)" headland.width_m=
    expect completesValues "$(offered furrow-cli plan f --set route.objective = f)" fuel
    expect completesLists "$(offered furrow-cli plan f --format geojson,km | xargs)" 'geojson,kml geojson,kmz'
    expect completesAfterEquals "$(offered furrow-cli report f --paper = l)" letter
    expect completesTheWindow "$(offered furrow --colours s)" sunlight
}

programs_work() {
    local status=0
    "$cli" plan "$share/doc/furrow/examples/home_field.geojson" --out "$work/plan" --quiet || status=$?
    expect plans "$status" 0
    # The program that prints is found from where the other one is.
    "$cli" report "$work/plan" --out "$work/order.pdf" >/dev/null || status=$?
    expect prints "$status $(head -c 5 "$work/order.pdf")" '0 %PDF-'
    expect versionIsTold "$("$prefix/bin/furrow" --version)" "Furrow $("$cli" --version | cut -d' ' -f2)"
    # Over ssh there is no display.
    expect wordsNeedNoDisplay "$(env -u DISPLAY -u WAYLAND_DISPLAY "$prefix/bin/furrow" --help 2>&1 | head -n 1)" "Usage: $prefix/bin/furrow [options] [FILE]"
    for option in --version --help; do
        expect "nothingIsWrongWith$option" "$(QT_QPA_PLATFORM=offscreen "$prefix/bin/furrow" "$option" 2>&1 >/dev/null)" ''
    done
    status=0
    QT_QPA_PLATFORM=offscreen "$prefix/bin/furrow" --colour 2>"$work/wrong.txt" || status=$?
    expect tellsWhatIsWrong "$status $(cat "$work/wrong.txt")" "1 furrow: Unknown option 'colour'."
    # The next start of the user is as the last one was.
    status=0
    XDG_CONFIG_HOME="$work/config" QT_QPA_PLATFORM=offscreen "$prefix/bin/furrow" --size 900x700 \
        --screenshot "$work/window.png" 2>/dev/null || status=$?
    expect picturesLeaveSettingsAlone "$status $(find "$work/config" -type f 2>/dev/null | wc -l) $(head -c 4 "$work/window.png" | tail -c 3)" '0 0 PNG'
}

installs_every_part
if command -v update-mime-database >/dev/null; then
    kinds_are_told_apart
else
    row 'SKIP   ' kindsAreValid "needs shared-mime-info"
fi
entry_leads_to_the_program
description_is_true
manual_tells_everything
shells_complete
programs_work
exit "$failed"
