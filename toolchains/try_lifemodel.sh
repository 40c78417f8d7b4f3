#!/usr/bin/env bash
# Uses lifemodel alone in each way that others can, with the examples: installed, found by CMake and by
# pkg-config; as a folder, by FetchContent and as a subproject of Meson. Needs build/host-release.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
project="$PWD"
work="$project/build/package"
rm -rf "$work"
mkdir -p "$work"
host_sim="$project/build/host-release/host_sim/host_sim"
"$host_sim" pack host_sim/examples/upper_arm.toml --out "$work/block"

# runs FOLDER: both examples, built there, count what they are given, and the one in C drops no extension.
runs() {
  "$1/control_loop" | grep '^life used: 0\.[0-9]*[1-9]'
  "$1/control_loop_c" "$work/block" | grep '^life used: [1-9][0-9]* ppb$'
  if "$1/control_loop_c" tests/linux/bench/drive.block 2> "$work/refusal"; then
    echo "control_loop_c takes a block with an extension" >&2
    return 1
  fi
  grep -q 'parameter block refused: it has an extension' "$work/refusal"
}

echo "-- installed, find_package"
cmake --install build/host-release --prefix "$work/prefix" --component lifemodel
mkdir "$work/found"
for example in control_loop control_loop_c; do
  cmake -G Ninja -S "lifemodel/examples/$example" -B "$work/find_package/$example" \
    -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_BUILD_TYPE=Release
  cmake --build "$work/find_package/$example"
  cp "$work/find_package/$example/$example" "$work/found"
done
runs "$work/found"

echo "-- installed, pkg-config"
mkdir "$work/pkg_config"
export PKG_CONFIG_PATH
PKG_CONFIG_PATH="$(dirname "$(find "$work/prefix" -name lifemodel.pc)")"
g++ -std=c++20 lifemodel/examples/control_loop/control_loop.cpp -o "$work/pkg_config/control_loop" \
  $(pkg-config --cflags --libs lifemodel)
gcc lifemodel/examples/control_loop_c/control_loop.c -o "$work/pkg_config/control_loop_c" \
  $(pkg-config --cflags --libs lifemodel-c) -lstdc++
runs "$work/pkg_config"
unset PKG_CONFIG_PATH

echo "-- FetchContent"
mkdir "$work/fetch"
cat > "$work/fetch/CMakeLists.txt" << END
cmake_minimum_required(VERSION 3.25)
project(fetch LANGUAGES C CXX)
include(FetchContent)
FetchContent_Declare(tendonlife SOURCE_DIR "$project")
FetchContent_MakeAvailable(tendonlife)
add_executable(control_loop "$project/lifemodel/examples/control_loop/control_loop.cpp")
target_link_libraries(control_loop PRIVATE lifemodel::lifemodel)
add_executable(control_loop_c "$project/lifemodel/examples/control_loop_c/control_loop.c")
target_link_libraries(control_loop_c PRIVATE lifemodel::c)
END
cmake -G Ninja -S "$work/fetch" -B "$work/fetch/build" --install-prefix "$work/fetch/prefix"
cmake --build "$work/fetch/build"
runs "$work/fetch/build"
# It leaves alone what is not its own: the type of the build, tests, what is installed.
grep '^CMAKE_BUILD_TYPE:STRING=$' "$work/fetch/build/CMakeCache.txt"
cmake --install "$work/fetch/build"
[ ! -e "$work/fetch/prefix" ]

echo "-- Meson"
mkdir -p "$work/meson/subprojects"
cp -r lifemodel "$work/meson/subprojects"
cp lifemodel/examples/control_loop/control_loop.cpp lifemodel/examples/control_loop_c/control_loop.c \
  "$work/meson"
cat > "$work/meson/meson.build" << 'END'
project('meson', 'c', 'cpp', default_options: ['cpp_std=c++20'])
executable('control_loop', 'control_loop.cpp', dependencies: dependency('lifemodel'))
executable('control_loop_c', 'control_loop.c', dependencies: dependency('lifemodel-c'))
END
cat > "$work/meson/subprojects/lifemodel.wrap" << 'END'
[wrap-file]
directory = lifemodel
[provide]
dependency_names = lifemodel, lifemodel-c
END
meson setup "$work/meson/build" "$work/meson"
ninja -C "$work/meson/build"
runs "$work/meson/build"

echo "-- versions and files of the other systems"
version="$(sed -n 's/^project(tendonlife VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)"
grep -q "version: '$version'" lifemodel/meson.build
python3 - "$version" << 'END'
import json, pathlib, sys
library = json.load(open("lifemodel/library.json"))
assert library["version"] == sys.argv[1], library["version"]
lifemodel = pathlib.Path("lifemodel")
assert (lifemodel / library["build"]["includeDir"] / library["headers"]).is_file()
assert list((lifemodel / library["build"]["srcDir"]).glob("*.cpp"))
module = dict(line.strip().split(": ") for line in open("lifemodel/zephyr/module.yml") if ": " in line)
assert (lifemodel / module["cmake"] / "CMakeLists.txt").is_file()
assert (lifemodel / module["kconfig"]).is_file()
END
